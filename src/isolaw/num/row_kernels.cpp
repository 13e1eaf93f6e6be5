// Sums over tables of residuals, compiled once per instruction set. Each compilation defines one variable, whose name
// is the macro ISOLAW_ROW_KERNELS. A function that is not inlined needs a batch among its template arguments, so that
// its mangled name contains the instruction set.
#include "isolaw/num/row_kernels.hpp"

#include <algorithm>

#include "isolaw/num/batch.hpp"

namespace isolaw::num {
namespace {

template <class T>
void sizes(RowTable const& table, std::size_t columns, double delta, double* values, double* rounded) {
  std::size_t const rows = table.weights.size();
  double const *weights = table.weights.data(), square = delta * delta;
  for (std::size_t first = 0; first < columns; first += row_lanes) {
    double const* row = table.values + first;
    T value(0.0), size(0.0);
    for (std::size_t j = 0; j < rows; ++j, row += table.stride) {
      T const r = T::load(row), weight(weights[j]);
      value += weight * abs(r);
      size += weight * sqrt(r * r + T(square));
    }
    value.store(values + first);
    size.store(rounded + first);
  }
}

// Some rows of the table, few enough to stay in the cache. `difference` holds each column minus column 0; `cautious`
// and `bold` hold this difference times the row's curvature of that name (row_kernels.hpp).
constexpr std::size_t chunk = 32, tile = 4;
struct Chunk {
  alignas(64) double difference[chunk * most_columns], cautious[chunk * most_columns], bold[chunk * most_columns];
};

template <class T>
void add_products(double const* left, double const* right, std::size_t rows, std::size_t columns, double* sums) {
  T a[tile];
  for (std::size_t i = 0; i < tile; ++i) a[i] = T::load(sums + i * columns);
  for (std::size_t j = 0; j < rows; ++j) {
    T const r = T::load(right + j * columns);
    for (std::size_t i = 0; i < tile; ++i) a[i] += T(left[j * columns + i]) * r;
  }
  for (std::size_t i = 0; i < tile; ++i) a[i].store(sums + i * columns);
}

template <class T>
void normal(RowTable const& table, std::size_t columns, double delta, double cautious_share, double bold_share,
            NormalSums const& sums) {
  columns = padded(columns);
  std::size_t const rows = table.weights.size();
  double const square = delta * delta;
  std::fill_n(sums.gradient, columns, 0.0);
  std::fill_n(sums.cautious, columns * columns, 0.0);
  std::fill_n(sums.bold, columns * columns, 0.0);
  double value = 0.0;
  Chunk part;
  for (std::size_t begin = 0; begin < rows; begin += chunk) {
    std::size_t const count = std::min(chunk, rows - begin);
    for (std::size_t j = 0; j < count; ++j) {
      double const* row = table.values + (begin + j) * table.stride;
      double const weight = table.weights[begin + j], r = row[0];
      double const size = __builtin_sqrt(r * r + square), above = weight / size;
      double const own = above * square / (size * size), both = cautious_share * above + bold_share * own;
      value += weight * size;
      for (std::size_t c = 0; c < columns; c += row_lanes) {
        std::size_t const at = j * columns + c;
        T const d = T::load(row + c) - T(r);
        d.store(part.difference + at);
        (T(above) * d).store(part.cautious + at);
        (T(both) * d).store(part.bold + at);
        (T::load(sums.gradient + c) + T(above * r) * d).store(sums.gradient + c);
      }
    }
    for (std::size_t i = 0; i < columns; i += tile)
      for (std::size_t c = 0; c <= i; c += row_lanes) {
        std::size_t const at = i * columns + c;
        add_products<T>(part.cautious + i, part.difference + c, count, columns, sums.cautious + at);
        add_products<T>(part.bold + i, part.difference + c, count, columns, sums.bold + at);
      }
  }
  *sums.value = value;
}

}  // namespace

extern RowKernels const ISOLAW_ROW_KERNELS;
constinit RowKernels const ISOLAW_ROW_KERNELS{sizes<Batch<row_lanes>>, normal<Batch<row_lanes>>};

}  // namespace isolaw::num
