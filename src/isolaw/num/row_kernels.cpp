// Compiled once for every instruction set, with ISOLAW_ROW_KERNELS the name of what it defines; as fit/kernels.cpp.
#include "isolaw/num/row_kernels.hpp"

#include <algorithm>
#include <array>

#include "isolaw/num/batch.hpp"

namespace isolaw::num {
namespace {

template <class T>
void sizes(RowTable const& table, std::size_t columns, double delta, double* sums) {
  std::size_t const rows = table.weights.size();
  double const *weights = table.weights.data(), square = delta * delta;
  for (std::size_t first = 0; first < columns; first += row_lanes) {
    double const* row = table.values + first;
    T sum(0.0);
    if (delta == 0.0)
      for (std::size_t j = 0; j < rows; ++j, row += table.stride) sum += T(weights[j]) * abs(T::load(row));
    else
      for (std::size_t j = 0; j < rows; ++j, row += table.stride) {
        T const r = T::load(row);
        sum += T(weights[j]) * sqrt(r * r + T(square));
      }
    sum.store(sums + first);
  }
}

// The differences of some rows and these times their weights, small enough to stay close to the processor.
constexpr std::size_t chunk = 32, tile = 4;
struct Chunk {
  alignas(64) double difference[chunk][most_columns], cautious[chunk][most_columns], bold[chunk][most_columns];
};

template <class T>
void add_products(double const (&left)[chunk][most_columns], double const (&right)[chunk][most_columns],
                  std::size_t rows, std::size_t first_left, std::size_t first_right, std::size_t columns,
                  double* sums) {
  T a[tile];
  for (std::size_t i = 0; i < tile; ++i) a[i] = T::load(sums + (first_left + i) * columns + first_right);
  for (std::size_t j = 0; j < rows; ++j) {
    T const r = T::load(right[j] + first_right);
    for (std::size_t i = 0; i < tile; ++i) a[i] += T(left[j][first_left + i]) * r;
  }
  for (std::size_t i = 0; i < tile; ++i) a[i].store(sums + (first_left + i) * columns + first_right);
}

template <class T>
void normal(RowTable const& table, std::size_t columns, double const* counts, double delta, double cautious_share,
            double bold_share, NormalSums const& sums) {
  columns = padded(columns);
  std::size_t const rows = table.weights.size();
  double const square = delta * delta;
  std::fill_n(sums.gradient, columns, 0.0);
  std::fill_n(sums.cautious, columns * columns, 0.0);
  std::fill_n(sums.bold, columns * columns, 0.0);
  double value = 0.0;
  Chunk some;
  for (std::size_t begin = 0; begin < rows; begin += chunk) {
    std::size_t const count = std::min(chunk, rows - begin);
    for (std::size_t j = 0; j < count; ++j) {
      double const* row = table.values + (begin + j) * table.stride;
      double const weight = table.weights[begin + j], r = row[0];
      double const size = __builtin_sqrt(r * r + square), above = weight / size;
      double const own = above * square / (size * size), both = cautious_share * above + bold_share * own;
      value += weight * size;
      for (std::size_t c = 0; c < columns; c += row_lanes) {
        T const d = select(T::load(counts + c) > T(0.0), T::load(row + c) - T(r), T(0.0));
        d.store(some.difference[j] + c);
        (T(above) * d).store(some.cautious[j] + c);
        (T(both) * d).store(some.bold[j] + c);
        (T::load(sums.gradient + c) + T(above * r) * d).store(sums.gradient + c);
      }
    }
    for (std::size_t i = 0; i < columns; i += tile)
      for (std::size_t c = 0; c <= i; c += row_lanes) {
        add_products<T>(some.cautious, some.difference, count, i, c, columns, sums.cautious);
        add_products<T>(some.bold, some.difference, count, i, c, columns, sums.bold);
      }
  }
  *sums.value = value;
}

}  // namespace

extern RowKernels const ISOLAW_ROW_KERNELS;
constinit RowKernels const ISOLAW_ROW_KERNELS{sizes<Batch<row_lanes>>, normal<Batch<row_lanes>>};

}  // namespace isolaw::num
