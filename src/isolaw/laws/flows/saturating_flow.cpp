// The matrices that fit the flow's polynomials. They are not in the header, because every instruction set would then
// have its own copy of this code.
#include "isolaw/laws/flows/saturating_flow.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isolaw::laws::flow_parts {
namespace {

// Zeros of the Jacobi polynomial of degree 17 for the weight (1 - y)^(-1/2) (1 + y)^(15/2). The flow is the hysteretic
// variable u as a function of travel. The header writes it as |u| = x G(v), with v = x^(1/5) and a polynomial G; y is
// 2 v - 1, from -1 to 1. If G interpolates at these zeros, the error of |u| is spread evenly over y, that of G is not.
constexpr Nodes::Values jacobi_zeros{
    -0.8482704490830196,  -0.7392800838264653,  -0.6169071342523251, -0.4823317952843121, -0.33811348743513536,
    -0.18729277640369482, -0.03315075851919065, 0.12091734632512882, 0.27149840143588966, 0.4152466151456183,
    0.5489627083391597,   0.6696677314400188,   0.7746709342528856,  0.8616306552991432,  0.9286071082791034,
    0.9741060103410049,   0.9971121446778988};

// The value at y of the polynomial that is 1 at the zero with index zeros[j] and 0 at the others in `zeros`.
template <std::size_t Count>
long double lagrange(std::array<std::size_t, Count> const& zeros, std::size_t j, long double y) {
  auto const zero = [&](std::size_t i) { return static_cast<long double>(jacobi_zeros[zeros[i]]); };
  long double product = 1.0L;
  for (std::size_t i = 0; i < Count; ++i)
    if (i != j) product *= (y - zero(i)) / (zero(j) - zero(i));
  return product;
}
constexpr auto all = [] {
  std::array<std::size_t, terms> indices{};
  for (std::size_t i = 0; i < terms; ++i) indices[i] = i;
  return indices;
}();

// Coefficient k of the Chebyshev series of lagrange(zeros, j, y), by an exact sum over y = cos(pi (m + 1/2) / terms).
template <std::size_t Count>
double chebyshev(std::array<std::size_t, Count> const& zeros, std::size_t k, std::size_t j) {
  long double sum = 0.0L;
  for (std::size_t m = 0; m < terms; ++m) {
    long double const angle = std::numbers::pi_v<long double> * (static_cast<long double>(m) + 0.5L) / terms;
    sum += std::cos(angle * k) * lagrange(zeros, j, std::cos(angle));
  }
  return static_cast<double>(sum * (k == 0 ? 1.0L : 2.0L) / terms);
}

// Returns the integral of f over [0, 1]. It is exact for polynomials of degree 32 (Clenshaw and Curtis).
template <class F>
long double integral(F&& f) {
  constexpr int n = 32;
  long double sum = 0.0L;
  for (int k = 0; k <= n; ++k) {
    long double const angle = std::numbers::pi_v<long double> * k / n;
    long double weight = 1.0L;
    for (int j = 1; j <= n / 2; ++j)
      weight -= (j == n / 2 ? 1.0L : 2.0L) / (4.0L * j * j - 1.0L) * std::cos(2.0L * j * angle);
    sum += (k == 0 || k == n ? 0.5L : 1.0L) * weight / n * f(0.5L * (1.0L + std::cos(angle)));
  }
  return sum;
}

Nodes make() {
  Nodes nodes;
  for (std::size_t i = 0; i < terms; ++i) {
    double const place = 0.5 * (1.0 + jacobi_zeros[i]);
    nodes.place[i] = place;
    nodes.inverse_place[i] = 1.0 / place;
    nodes.fifth[i] = std::pow(place, 5.0);
    nodes.log2_fifth[i] = 5.0 * std::log2(place);
  }
  for (std::size_t i = 0; i < terms; ++i)
    for (std::size_t j = 0; j < terms; ++j)
      nodes.mean[i][j] =
          static_cast<double>(integral([&, place = static_cast<long double>(nodes.place[i])](long double s) {
            return 5.0L * s * s * s * s * lagrange(all, j, 2.0L * place * s - 1.0L);
          }));
  // power[i][k] is the coefficient of y^i in the Chebyshev polynomial T_k(y) = 2 y T_(k-1) - T_(k-2).
  for (std::size_t k = 0; k < terms; ++k)
    for (std::size_t i = 0; i < terms; ++i)
      nodes.power[i][k] =
          k < 2 ? (i == k ? 1.0 : 0.0) : (i > 0 ? 2.0 * nodes.power[i - 1][k - 1] : 0.0) - nodes.power[i][k - 2];
  for (std::size_t k = 0; k < terms; ++k)
    for (std::size_t j = 0; j < terms; ++j) nodes.chebyshev[k][j] = chebyshev(all, k, j);
  for (std::size_t k = 0; k < Nodes::few.size(); ++k) {
    for (std::size_t j = 0; j < Nodes::few.size(); ++j) nodes.chebyshev_of_few[k][j] = chebyshev(Nodes::few, k, j);
    for (std::size_t i = 0; i < terms; ++i)
      nodes.at_places[i][k] = static_cast<double>(std::cos(k * std::acos(static_cast<long double>(jacobi_zeros[i]))));
  }
  auto const above = [&](std::size_t i) { return i < terms ? nodes.place[i] : 1.0; };
  for (std::size_t i = 0; i < terms; ++i) {
    std::size_t const count = std::min(guesses, terms - i);
    for (std::size_t a = 0; a < count; ++a) {
      double weight = 1.0;
      for (std::size_t b = 0; b < count; ++b)
        if (a != b) weight *= (above(i) - above(i + 1 + b)) / (above(i + 1 + a) - above(i + 1 + b));
      nodes.guess[i][a] = weight;
    }
  }
  return nodes;
}

}  // namespace

Nodes const& Nodes::get() {
  static Nodes const nodes = make();
  return nodes;
}

}  // namespace isolaw::laws::flow_parts
