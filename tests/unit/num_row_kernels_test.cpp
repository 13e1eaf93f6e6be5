// Tests sums over tables of residuals: they must equal those of plain loops for any number of columns.
#include "isolaw/num/row_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "isolaw/num/random.hpp"

namespace isolaw::num {
namespace {

struct Table {
  std::size_t rows, columns, stride = padded(columns);
  std::vector<double> values = std::vector<double>(rows * stride, std::nan("")), weights = std::vector<double>(rows);

  Table(std::size_t rows_, std::size_t columns_) : rows(rows_), columns(columns_) {
    Draws draws(Stream(5), 0, 0);
    for (std::size_t j = 0; j < rows; ++j) {
      weights[j] = j % 5 == 0 ? 0.0 : draws.uniform();
      for (std::size_t c = 0; c < columns; ++c) values[j * stride + c] = draws.normal();
    }
  }
  double at(std::size_t j, std::size_t c) const { return values[j * stride + c]; }
  RowTable view() const { return {values.data(), stride, weights}; }
};

std::vector<std::size_t> const numbers{1, 4, 8, 9, 13, 16, 17, 24};

TEST(RowKernels, SizesAreThoseOfALoop) {
  for (std::size_t const columns : numbers) {
    Table const table(77, columns);
    for (double const delta : {0.0, 0.3}) {
      std::vector<double> values(table.stride, -1.0), rounded(table.stride, -1.0);
      row_kernels().sizes(table.view(), columns, delta, values.data(), rounded.data());
      for (std::size_t c = 0; c < columns; ++c) {
        double expected = 0.0, rounded_expected = 0.0;
        for (std::size_t j = 0; j < table.rows; ++j) {
          expected += table.weights[j] * std::abs(table.at(j, c));
          rounded_expected += table.weights[j] * std::hypot(table.at(j, c), delta);
        }
        EXPECT_NEAR(values[c], expected, 1e-13 * expected) << columns << " columns, " << c;
        EXPECT_NEAR(rounded[c], rounded_expected, 1e-13 * rounded_expected) << columns << " columns, " << c;
      }
    }
  }
}

TEST(RowKernels, NormalSumsAreThoseOfALoop) {
  constexpr double delta = 0.4, cautious_share = 0.1, bold_share = 0.9;
  for (std::size_t const columns : numbers) {
    Table table(77, columns);
    // A column that holds NaN must change no sums but its own.
    auto const failed = [](std::size_t c) { return c % 4 == 3; };
    for (std::size_t c = 3; c < columns; c += 4) table.values[5 * table.stride + c] = std::nan("");
    std::size_t const n = table.stride;
    std::vector<double> gradient(n, 7.0), cautious(n * n, 7.0), bold(n * n, 7.0);
    double value = -1.0;
    row_kernels().normal(table.view(), columns, delta, cautious_share, bold_share,
                         {gradient.data(), cautious.data(), bold.data(), &value});
    std::vector<double> g(n, 0.0), a(n * n, 0.0), b(n * n, 0.0);
    double v = 0.0;
    for (std::size_t j = 0; j < table.rows; ++j) {
      double const r = table.at(j, 0), w = table.weights[j], size = std::hypot(r, delta);
      v += w * size;
      for (std::size_t c = 1; c < columns; ++c) {
        if (failed(c)) continue;
        double const d = table.at(j, c) - r;
        g[c] += w / size * r * d;
        for (std::size_t e = 1; e <= c; ++e) {
          if (failed(e)) continue;
          double const product = d * (table.at(j, e) - r), above = w / size;
          a[c * n + e] += above * product;
          b[c * n + e] += (cautious_share * above + bold_share * above * delta * delta / (size * size)) * product;
        }
      }
    }
    EXPECT_NEAR(value, v, 1e-13 * v);
    for (std::size_t c = 1; c < columns; ++c) {
      if (failed(c)) {
        EXPECT_FALSE(std::isfinite(cautious[c * n + c]));
        continue;
      }
      EXPECT_NEAR(gradient[c], g[c], 1e-12) << columns << " columns, " << c;
      for (std::size_t e = 1; e <= c; ++e) {
        if (failed(e)) continue;
        EXPECT_NEAR(cautious[c * n + e], a[c * n + e], 1e-11) << columns << " columns, " << c << ", " << e;
        EXPECT_NEAR(bold[c * n + e], b[c * n + e], 1e-11) << columns << " columns, " << c << ", " << e;
      }
    }
  }
}

}  // namespace
}  // namespace isolaw::num
