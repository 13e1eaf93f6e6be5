// The laws compiled for blocks of candidates, once per instruction set, and the choice among them.
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

  // (measured - computed) * scale of every sample, one row of `stride` values each: the candidates' stand side by side.
  using Residuals = void (*)(double const* parameters, laws::Path const& path, laws::Integration integration,
                             double const* measured, double scale, double* rows, std::size_t stride);
  Residuals residuals = nullptr, narrow_residuals = nullptr;  // of residual_block and narrow_block candidates
};
inline constexpr std::size_t wide_block = 32, residual_block = 16, narrow_block = 8;

// Of the law with this index in the catalogue; not for `scalar`.
Kernel kernel(InstructionSet set, std::size_t law);

}  // namespace isolaw::fit
