// The choice of the instruction set for code that is compiled once for each: populations and sums over residuals.
#pragma once

#include <string_view>
#include <vector>

namespace isolaw::num {

// `scalar` computes a law on plain doubles, one candidate at a time, the same on every machine; every reported number
// comes from it. The others agree with it within rounding. avx2 and avx512 give the same bits; `portable` (called sse2
// on x86) lacks the fused multiply-add and differs from them in the last bits.
enum class InstructionSet { scalar, portable, avx2, avx512 };
std::string_view name(InstructionSet set);

std::vector<InstructionSet> available_instruction_sets();  // built into this program and run by this processor
// The fastest available set, or the one that the environment variable ISOLAW_SIMD names, chosen at the first call.
// Throws Error for an unknown name or a set that this processor cannot run.
InstructionSet instruction_set();
InstructionSet parse_instruction_set(std::string_view text);

}  // namespace isolaw::num
