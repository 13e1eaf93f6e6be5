// The laws' kernels compute a block of candidates at once. They are compiled once for each instruction set.
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

// One test of a record, on which a law is computed, in the law's units.
struct KernelRecord {
  laws::Path const& path;
  std::span<double const> measured, weight;  // measured force of each sample, and its weight LawOnRecord::weight_
};

// The functions for one law. `parameters` holds the first parameter of all candidates, then their second one, etc.
struct Kernel {
  // Computes the sum of |measured - computed| * weight for each candidate; not finite if one of its forces is not.
  using Objectives = void (*)(double const* parameters, KernelRecord const& record, laws::Integration integration,
                              double* objectives);
  Objectives wide = nullptr, narrow = nullptr;  // for wide_block and for narrow_block candidates at once
  // Computes (measured - computed) * scale: sample j of candidate i is rows[j * stride + i].
  using Residuals = void (*)(double const* parameters, laws::Path const& path, laws::Integration integration,
                             double const* measured, double scale, double* rows, std::size_t stride);
  Residuals residuals = nullptr, narrow_residuals = nullptr;  // for residual_block and narrow_block candidates at once
};
inline constexpr std::size_t wide_block = 32, residual_block = 16, narrow_block = 8;
// Returns the kernel for the law with this index in the catalogue. InstructionSet::scalar has no kernels.
Kernel kernel(InstructionSet set, std::size_t law);

}  // namespace isolaw::fit
