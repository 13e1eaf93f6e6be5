// Sums over tables of residuals, with a row for each residual and a column for each candidate point. A descent of the
// search spends most of its time in the law and in these sums, so they are compiled once for every instruction set.
#pragma once

#include <cstddef>
#include <span>

#include "isolaw/num/instruction_set.hpp"

namespace isolaw::num {

// A kernel computes this many columns together, so a table's stride is a multiple of it. The columns behind the last
// candidate, which fill up the multiple, may hold anything.
inline constexpr std::size_t row_lanes = 8;
constexpr std::size_t padded(std::size_t columns) {
  return (columns + row_lanes - 1) / row_lanes * row_lanes;
}

struct RowTable {
  double const* values;
  std::size_t stride;
  std::span<double const> weights;  // weight of each row's residual in the sums
};

// The sums for a Newton step. Column 0 of the table holds the residuals at the present point, the other columns those
// at neighbouring points. In each row, r is the value of column 0, size = sqrt(r^2 + delta^2), and the difference of a
// column is its value minus r. A column that is not finite makes every sum that contains it not finite.
struct NormalSums {
  double* gradient;  // [columns]: sum of weight * difference * r / size
  // [columns][columns], lower triangle: sum of curvature * difference of one column * difference of the other. The two
  // matrices differ in the curvature that they take for a row (see RowKernels::normal).
  double *cautious, *bold;
  double* value;  // sum of weight * size
};

struct RowKernels {
  // For each column c, with r its value in a row: values[c] is the sum of weight * |r| over the rows, and rounded[c] is
  // the sum of weight * sqrt(r^2 + delta^2). Both arrays have room for padded(columns) values.
  void (*sizes)(RowTable const& table, std::size_t columns, double delta, double* values, double* rounded);
  // The curvature of a row in `cautious` is weight / size: a parabola with this curvature touches the row's term,
  // weight * size, from above. In `bold` it is cautious_share times weight / size plus bold_share times the term's true
  // curvature, weight * delta^2 / size^3. The arrays of `sums` have room for padded(columns) columns; columns <=
  // most_columns.
  void (*normal)(RowTable const& table, std::size_t columns, double delta, double cautious_share, double bold_share,
                 NormalSums const& sums);
};
inline constexpr std::size_t most_columns = 64;

// The kernels for the instruction set that instruction_set() returns. For `scalar` they are those of `portable`.
RowKernels const& row_kernels();

}  // namespace isolaw::num
