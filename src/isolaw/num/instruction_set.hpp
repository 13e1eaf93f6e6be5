// Which code computes populations and sums over their residuals: what is compiled once per instruction set, and the
// choice among it.
#pragma once

#include <string_view>
#include <vector>

namespace isolaw::num {

// `scalar` is the law on plain doubles, one candidate at a time, the same on every machine; it also gives every number
// that is reported. The others agree with it within rounding. avx2 and avx512 give the same bits; sse2 (on other
// processors: portable) lacks the fused multiply-add and differs from them in the last.
enum class InstructionSet { scalar, portable, avx2, avx512 };
std::string_view name(InstructionSet set);

// What this program holds and this processor can run, slowest first.
std::vector<InstructionSet> available_instruction_sets();

// The fastest of them, or the one that the environment variable ISOLAW_SIMD names; decided at the first call.
// Throws Error: an unknown name, or one this processor lacks.
InstructionSet instruction_set();
InstructionSet parse_instruction_set(std::string_view text);

}  // namespace isolaw::num
