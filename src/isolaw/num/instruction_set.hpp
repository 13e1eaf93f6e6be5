// Chooses the instruction set for code that is compiled once per instruction set: the laws, and sums over residuals.
#pragma once

#include <string_view>
#include <vector>

namespace isolaw::num {

// `scalar` computes a law on plain doubles, one parameter set at a time. The objective and the forces in the report of
// a fit come from `scalar`; the other sets agree with it within rounding. avx2 and avx512 give the same bits.
// `portable` (called sse2 on x86) has no fused multiply-add and therefore gives other last bits.
enum class InstructionSet { scalar, portable, avx2, avx512 };
std::string_view name(InstructionSet set);

// The instruction sets that this program contains code for and that this processor has.
std::vector<InstructionSet> available_instruction_sets();
// Returns the fastest available set, or the set that the environment variable ISOLAW_SIMD names. Later calls return the
// same set as the first. Throws Error for an unknown name or a set that this processor cannot run.
InstructionSet instruction_set();
InstructionSet parse_instruction_set(std::string_view text);

}  // namespace isolaw::num
