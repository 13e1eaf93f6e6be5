// Sums over tables of residuals, with a row for each residual and a column for each candidate. Besides the law itself,
// these take most of a descent's time, so they are compiled once for every instruction set.
#pragma once

#include <cstddef>
#include <span>

#include "isolaw/num/instruction_set.hpp"

namespace isolaw::num {

// Columns computed together. A stride is a multiple of it; columns beyond the last candidate may hold any numbers.
inline constexpr std::size_t row_lanes = 8;
constexpr std::size_t padded(std::size_t columns) {
  return (columns + row_lanes - 1) / row_lanes * row_lanes;
}

struct RowTable {
  double const* values;
  std::size_t stride;
  std::span<double const> weights;  // one for each row
};

// The sums for a Newton step from column 0 of a table whose other columns are its neighbours. In each row r is the
// value of column 0, size = sqrt(r^2 + delta^2), and a column's difference is its value minus r. A column that is not
// finite makes all sums that it enters not finite.
struct NormalSums {
  double* gradient;         // [columns]: sum of weight * difference * r / size
  double *cautious, *bold;  // [columns][columns], lower triangle: sums of curvature * product of two differences
  double* value;            // sum of weight * size
};

struct RowKernels {
  // values[c] = sum of weight * |r|, rounded[c] = sum of weight * sqrt(r^2 + delta^2) in column c; each padded.
  void (*sizes)(RowTable const& table, std::size_t columns, double delta, double* values, double* rounded);
  // The curvature of `cautious` is weight / size, that of the parabola that touches `size` from above. The curvature of
  // `bold` is cautious_share of that plus bold_share of the true one, weight * delta^2 / size^3. The arrays of `sums`
  // are for padded(columns) columns, at most most_columns.
  void (*normal)(RowTable const& table, std::size_t columns, double delta, double cautious_share, double bold_share,
                 NormalSums const& sums);
};
inline constexpr std::size_t most_columns = 64;

RowKernels const& row_kernels();  // those of the instruction set in use; portable ones for `scalar`

}  // namespace isolaw::num
