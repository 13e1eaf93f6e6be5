#include "isolaw/num/instruction_set.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <ranges>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"

#if defined(ISOLAW_X86_KERNELS) && !defined(ISOLAW_CPU_LEVELS)
#include <cpuid.h>
#endif

namespace isolaw::num {
namespace {

struct Candidate {
  InstructionSet set;
  std::string_view name;
  bool (*runs_here)();
};

bool always() {
  return true;
}

#if defined(ISOLAW_X86_KERNELS)
// With -march=x86-64-v3 or -v4 a compiler may use every instruction of this level, not only the vector instructions.
// All extensions of a level are therefore checked.
#if defined(ISOLAW_CPU_LEVELS)
bool has_x86_64_v3() {
  return __builtin_cpu_supports("x86-64-v3") != 0;
}
bool has_x86_64_v4() {
  return __builtin_cpu_supports("x86-64-v4") != 0;
}
#else
// A compiler that does not know these levels does not know lzcnt, movbe, f16c, cmpxchg16b and lahf by name either, so
// we ask the processor for them. We check older extensions too, because a virtual machine may hide any of them.
bool has_x86_64_v3() {
  unsigned a = 0, b = 0, basic = 0, extended = 0, d = 0;
  __get_cpuid(1, &a, &b, &basic, &d);
  __get_cpuid(0x80000001, &a, &b, &extended, &d);
  constexpr unsigned of_basic = bit_CMPXCHG16B | bit_MOVBE | bit_F16C, of_extended = bit_LAHF_LM | bit_LZCNT;
  return (basic & of_basic) == of_basic && (extended & of_extended) == of_extended &&
         __builtin_cpu_supports("popcnt") != 0 && __builtin_cpu_supports("sse3") != 0 &&
         __builtin_cpu_supports("ssse3") != 0 && __builtin_cpu_supports("sse4.1") != 0 &&
         __builtin_cpu_supports("sse4.2") != 0 && __builtin_cpu_supports("avx") != 0 &&
         __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
         __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0;
}
bool has_x86_64_v4() {
  return has_x86_64_v3() && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
         __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
         __builtin_cpu_supports("avx512vl") != 0;
}
#endif
#endif

// The instruction sets, from the slowest to the fastest.
constexpr std::array candidates {
  Candidate{InstructionSet::scalar, "scalar", always},
#if defined(ISOLAW_X86_KERNELS)
      Candidate{InstructionSet::portable, "sse2", always}, Candidate{InstructionSet::avx2, "avx2", has_x86_64_v3},
      Candidate{InstructionSet::avx512, "avx512", has_x86_64_v4},
#else
      Candidate{InstructionSet::portable, "portable", always},
#endif
};

}  // namespace

std::string_view name(InstructionSet set) {
  auto const found = std::ranges::find(candidates, set, &Candidate::set);
  return found == candidates.end() ? "not built" : found->name;
}

std::vector<InstructionSet> available_instruction_sets() {
  std::vector<InstructionSet> sets;
  for (auto const& c : candidates)
    if (c.runs_here()) sets.push_back(c.set);
  return sets;
}

InstructionSet parse_instruction_set(std::string_view text) {
  auto const sets = available_instruction_sets();
  if (auto const found = std::ranges::find(sets, text, name); found != sets.end()) return *found;
  bool const known = std::ranges::find(candidates, text, &Candidate::name) != candidates.end();
  throw Error({.where = "ISOLAW_SIMD",
               .found = "'" + std::string(text) + "', " +
                        (known ? "which this processor cannot run" : "which is no instruction set"),
               .allowed = joined(sets | std::views::transform(name)),
               .advice = "leave it unset: the fastest is chosen"});
}

InstructionSet instruction_set() {
  static InstructionSet const chosen = [] {
    char const* const asked = std::getenv("ISOLAW_SIMD");
    return asked == nullptr || *asked == '\0' ? available_instruction_sets().back() : parse_instruction_set(asked);
  }();
  return chosen;
}

}  // namespace isolaw::num
