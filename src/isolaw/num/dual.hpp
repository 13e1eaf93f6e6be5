// A number for forward-mode differentiation: a value and its derivatives with respect to N independent variables, after
// Ceres' Jet. Comparisons and selections use the value alone. At a kink the derivative is that of the selected branch.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "isolaw/num/scalar.hpp"

namespace isolaw::num {

template <std::size_t N>
struct Dual {
  double value = 0.0;
  std::array<double, N> slope{};

  Dual() = default;
  explicit Dual(double v) : value(v) {}
  Dual(double v, std::size_t i) : value(v) { slope[i] = 1.0; }  // independent variable i, which has the value v

  // f(u) with its derivatives by the chain rule: `f` is the value of f at u and `derivative` is df/du.
  static Dual chain(Dual const& u, double f, double derivative) {
    Dual out(f);
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = derivative * u.slope[i];
    return out;
  }
  static Dual chain(Dual const& u, Dual const& w, double f, double df_du, double df_dw) {
    Dual out(f);
    for (std::size_t i = 0; i < N; ++i) out.slope[i] = df_du * u.slope[i] + df_dw * w.slope[i];
    return out;
  }

  friend Dual operator-(Dual const& u) { return chain(u, -u.value, -1.0); }
  friend Dual operator+(Dual const& u, Dual const& w) { return chain(u, w, u.value + w.value, 1.0, 1.0); }
  friend Dual operator-(Dual const& u, Dual const& w) { return chain(u, w, u.value - w.value, 1.0, -1.0); }
  friend Dual operator*(Dual const& u, Dual const& w) { return chain(u, w, u.value * w.value, w.value, u.value); }
  friend Dual operator/(Dual const& u, Dual const& w) {
    double const q = u.value / w.value;
    return chain(u, w, q, 1.0 / w.value, -q / w.value);
  }
  Dual& operator+=(Dual const& w) { return *this = *this + w; }

  friend bool operator<(Dual const& u, Dual const& w) { return u.value < w.value; }
  friend bool operator<=(Dual const& u, Dual const& w) { return u.value <= w.value; }
  friend bool operator>(Dual const& u, Dual const& w) { return u.value > w.value; }
  friend bool operator>=(Dual const& u, Dual const& w) { return u.value >= w.value; }
};

template <std::size_t N>
Dual<N> abs(Dual<N> const& u) {
  return u.value < 0.0 ? -u : u;
}
template <std::size_t N>
Dual<N> exp(Dual<N> const& u) {
  double const f = std::exp(u.value);
  return Dual<N>::chain(u, f, f);
}
template <std::size_t N>
Dual<N> exp2(Dual<N> const& u) {
  double const f = std::exp2(u.value);
  return Dual<N>::chain(u, f, f * 0.69314718055994530942);
}
template <std::size_t N>
Dual<N> expm1(Dual<N> const& u) {
  return Dual<N>::chain(u, std::expm1(u.value), std::exp(u.value));
}
// The derivative of x^(1/5) is infinite at 0. This function gives 0 there.
template <std::size_t N>
Dual<N> fifth_root(Dual<N> const& u) {
  double const f = fifth_root(u.value);
  return Dual<N>::chain(u, f, u.value > 0.0 ? 0.2 * f / u.value : 0.0);
}
template <std::size_t N>
Dual<N> log2(Dual<N> const& u) {
  return Dual<N>::chain(u, std::log2(u.value), 1.44269504088896340736 / u.value);
}
template <std::size_t N>
Dual<N> sqrt(Dual<N> const& u) {
  double const f = std::sqrt(u.value);
  return Dual<N>::chain(u, f, f > 0.0 ? 0.5 / f : 0.0);
}
template <std::size_t N>
Dual<N> min(Dual<N> const& u, Dual<N> const& w) {
  return w < u ? w : u;
}
template <std::size_t N>
Dual<N> max(Dual<N> const& u, Dual<N> const& w) {
  return u < w ? w : u;
}
template <std::size_t N>
Dual<N> select(bool condition, Dual<N> const& u, Dual<N> const& w) {
  return condition ? u : w;
}
template <std::size_t N, std::size_t Count>
std::size_t cell_of(std::array<Dual<N>, Count> const& nodes, Dual<N> const& x) {
  std::size_t first = 0;
  for (std::size_t length = Count - 1; length > 1;) {
    std::size_t const half = length / 2;
    if (nodes[first + half].value <= x.value) first += half;
    length -= half;
  }
  return first;
}
// cell_of() for nodes without derivatives: nodes that do not depend on the candidate parameter set.
template <std::size_t N, std::size_t Count>
std::size_t cell_of(std::array<double, Count> const& nodes, Dual<N> const& x) {
  return cell_of(nodes, x.value);
}

}  // namespace isolaw::num
