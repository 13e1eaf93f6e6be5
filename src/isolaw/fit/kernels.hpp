// The laws compiled for blocks of candidates, once per instruction set, and the choice among them.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "isolaw/laws/law.hpp"

namespace isolaw::fit {

// Which code evaluates populations. `scalar` is the law on plain doubles, one candidate at a time, the same on every
// machine; it also gives every number that is reported. The others agree with it within rounding. avx2 and avx512 give
// the same bits; sse2 (on other processors: portable) lacks the fused multiply-add and differs from them in the last.
enum class InstructionSet { scalar, portable, avx2, avx512 };
std::string_view name(InstructionSet set);

// What this program holds and this processor can run, slowest first.
std::vector<InstructionSet> available_instruction_sets();

// The fastest of them, or the one that the environment variable ISOLAW_SIMD names; decided at the first call.
// Throws Error: an unknown name, or one this processor lacks.
InstructionSet instruction_set();
InstructionSet parse_instruction_set(std::string_view text);

// What a kernel needs of a record, in the law's units; see LawOnRecord.
struct KernelRecord {
  laws::Path const& path;
  std::span<double const> measured, weight;
};

// The sums of |measured - computed| * weight of `width` candidates; not finite where a force is not. `parameters` holds
// the values of the first parameter for every candidate, then those of the second, and so on.
struct Kernel {
  using Objectives = void (*)(double const* parameters, KernelRecord const& record, laws::Integration integration,
                              double* objectives);
  Objectives wide = nullptr, narrow = nullptr;  // of wide_block and narrow_block candidates

  // Computed forces of narrow_block candidates: those of the first sample, then those of the second, and so on.
  using Forces = void (*)(double const* parameters, laws::Path const& path, laws::Integration integration,
                          double* forces);
  Forces forces = nullptr;
};
inline constexpr std::size_t wide_block = 32, narrow_block = 8;

// Of the law with this index in the catalogue; not for `scalar`.
Kernel kernel(InstructionSet set, std::size_t law);

}  // namespace isolaw::fit
