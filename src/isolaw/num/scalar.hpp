// The operations that a law's step may use, here for plain doubles. Dual and Batch offer the same ones, so the same
// code computes a law on all three. Laws call them unqualified: law.hpp makes the overloads for double visible, and
// argument-dependent lookup finds the others.
//   abs exp exp2 log2 sqrt min max        as in <cmath>
//   expm1(x), fifth_root(x)               e^x - 1 and, for x >= 0, x^(1/5)
//   any(condition)                        whether the condition is true in at least one lane
//   select(condition, a, b)               a where true, b elsewhere, lane by lane; a and b are always computed
//   rounded(x)                            x as a rounded double. In a sum of two products it marks the one that the
//                                         compiler must not fuse with the addition, so that it always fuses the other
//   cell_of(nodes, x)                     index i of the cell nodes[i] <= x < nodes[i+1], clamped to 0 .. count-2
//   at(values, index)                     values[index], lane by lane
//   Rows8                                 a table of rows of eight values, read with an index from cell_of
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "isolaw/num/elementary.hpp"

namespace isolaw::num {

inline double abs(double x) {
  return std::abs(x);
}
inline double exp(double x) {
  return std::exp(x);
}
inline double exp2(double x) {
  return std::exp2(x);
}
inline double expm1(double x) {
  return std::expm1(x);
}
inline double fifth_root(double x) {
  return fast_fifth_root(x);  // doubles and lanes use the same function, so they agree
}
inline bool any(bool condition) {
  return condition;
}
inline double log2(double x) {
  return std::log2(x);
}
inline double sqrt(double x) {
  return std::sqrt(x);
}
inline double min(double a, double b) {
  return b < a ? b : a;
}
inline double max(double a, double b) {
  return a < b ? b : a;
}
inline double select(bool condition, double a, double b) {
  return condition ? a : b;
}
template <class T>
T const& rounded(T const& x) {
  return x;
}

// Finds the cell of x by bisection without branches. The number of steps depends only on the size of the table.
template <std::size_t Count>
std::size_t cell_of(std::array<double, Count> const& nodes, double x) {
  static_assert(Count >= 2);
  std::size_t first = 0;
  for (std::size_t length = Count - 1; length > 1;) {
    std::size_t const half = length / 2;
    first += nodes[first + half] <= x ? half : 0;
    length -= half;
  }
  return first;
}

template <class T, std::size_t Count>
T const& at(std::array<T, Count> const& values, std::size_t index) {
  return values[index];
}

// A table of rows of eight values that are always read together. A row of doubles fills one cache line.
template <class T, std::size_t Count>
class Rows8 {
 public:
  void set(std::size_t row, std::array<T, 8> const& values) { rows_[row] = values; }
  std::array<T, 8> const& get(std::size_t row) const { return rows_[row]; }

 private:
  std::array<std::array<T, 8>, Count> rows_;
};

// x^p for x >= 0, computed as 2^(p log2 x) without the special cases of pow. x = 0 is replaced by smallest_power_base.
inline constexpr double smallest_power_base = 1e-290;
inline constexpr double log2_e = 1.44269504088896340736;
template <class T>
T power(T const& x, T const& p) {
  return exp2(p * log2(max(x, T(smallest_power_base))));
}

// 1 / cosh^2(u), computed from exp(-2|u|), which cannot overflow.
template <class T>
T sech_squared(T const& u) {
  T const e = exp(T(-2.0) * abs(u));
  T const one_plus = T(1.0) + e;
  return T(4.0) * e / (one_plus * one_plus);
}

}  // namespace isolaw::num
