// Sums over tables of residuals: one row for each of them, one column for each candidate. What a descent spends its
// time on beside the law itself, compiled once for every instruction set.
#pragma once

#include <cstddef>
#include <span>

#include "isolaw/num/instruction_set.hpp"

namespace isolaw::num {

// Columns that are computed together: the stride of a table is a multiple of it, and columns beyond the last candidate
// hold anything that can be computed with.
inline constexpr std::size_t row_lanes = 8;
constexpr std::size_t padded(std::size_t columns) {
  return (columns + row_lanes - 1) / row_lanes * row_lanes;
}

struct RowTable {
  double const* values;
  std::size_t stride;
  std::span<double const> weights;  // of each row
};

// What a step from the point of column 0 needs of a table whose other columns are its neighbours: sums over the rows of
// weight * differences of the columns from column 0, by the curvatures of sqrt(r^2 + delta^2), r being column 0's.
// Where a column is not finite, all sums that it has a part in are not.
struct NormalSums {
  double* gradient;         // [columns] of difference * r / size, size being that root
  double *cautious, *bold;  // [columns][columns], lower triangle, of products of two differences
  double* value;            // sum of weight * size
};

struct RowKernels {
  // values[c] = sum of weight * |r|, rounded[c] = sum of weight * sqrt(r^2 + delta^2), for padded(columns) of them.
  void (*sizes)(RowTable const& table, std::size_t columns, double delta, double* values, double* rounded);

  // `cautious` by weight / size, the parabola that lies above; `bold` by cautious_share of that and bold_share of the
  // curvature itself, weight * delta^2 / size^3. Columns up to padded(columns); at most most_columns.
  void (*normal)(RowTable const& table, std::size_t columns, double delta, double cautious_share, double bold_share,
                 NormalSums const& sums);
};
inline constexpr std::size_t most_columns = 64;

// Of the instruction set in use; `scalar` takes the portable ones.
RowKernels const& row_kernels();

}  // namespace isolaw::num
