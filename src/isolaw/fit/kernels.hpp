// Access to the laws' kernels: code that computes a block of candidates at once, compiled once per instruction set.
#pragma once

#include <cstddef>
#include <span>

#include "isolaw/laws/law.hpp"
#include "isolaw/num/instruction_set.hpp"

namespace isolaw::fit {

using num::available_instruction_sets;
using num::instruction_set;
using num::InstructionSet;
using num::name;
using num::parse_instruction_set;

struct KernelRecord {  // a record in the law's units; see LawOnRecord
  laws::Path const& path;
  std::span<double const> measured, weight;
};

// `parameters` holds the first parameter's values for every candidate of the block, then the second's, and so on.
struct Kernel {
  // For each candidate the sum of |measured - computed| * weight; not finite if a force is not.
  using Objectives = void (*)(double const* parameters, KernelRecord const& record, laws::Integration integration,
                              double* objectives);
  Objectives wide = nullptr, narrow = nullptr;  // for wide_block and narrow_block candidates
  // (measured - computed) * scale: a row of `stride` values for each sample, with the candidates side by side.
  using Residuals = void (*)(double const* parameters, laws::Path const& path, laws::Integration integration,
                             double const* measured, double scale, double* rows, std::size_t stride);
  Residuals residuals = nullptr, narrow_residuals = nullptr;  // for residual_block and narrow_block candidates
};
inline constexpr std::size_t wide_block = 32, residual_block = 16, narrow_block = 8;
// The kernel of the law with this index in the catalogue. There is none for InstructionSet::scalar.
Kernel kernel(InstructionSet set, std::size_t law);

}  // namespace isolaw::fit
