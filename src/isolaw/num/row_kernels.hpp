// Sums over tables of residuals, with a row for each residual and a column for each candidate. Besides the law itself,
// these take most of a descent's time, so they are compiled once for every instruction set.
#pragma once

#include <cstddef>
#include <span>

#include "isolaw/num/instruction_set.hpp"

namespace isolaw::num {

// Columns computed together. A table's stride is a multiple of it; columns after the last candidate may hold anything.
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
  // values[c] = sum of weight * |r|, rounded[c] = sum of weight * sqrt(r^2 + delta^2) in column c. Both are padded.
  void (*sizes)(RowTable const& table, std::size_t columns, double delta, double* values, double* rounded);
  // For `cautious` the curvature is weight / size, from the parabola that touches `size` from above. For `bold` it is
  // cautious_share times this plus bold_share times the true curvature, weight * delta^2 / size^3. The arrays of `sums`
  // are for padded(columns) columns, at most most_columns.
  void (*normal)(RowTable const& table, std::size_t columns, double delta, double cautious_share, double bold_share,
                 NormalSums const& sums);
};
inline constexpr std::size_t most_columns = 64;

RowKernels const& row_kernels();  // for the instruction set in use; `scalar` uses the portable ones

}  // namespace isolaw::num
