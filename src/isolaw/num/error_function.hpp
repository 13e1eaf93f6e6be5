// The error function erf(u) for doubles, for numbers with derivatives (Dual) and for batches. Its absolute error is
// below 4e-16; so is its relative error for |u| < 1/2. It is exactly odd and gives NaN for NaN. Source: Cody 1969; his
// program calerf has one rational function for |u| <= 0.46875 and a second one for larger |u| up to 4. Departure: here
// the second one is used up to |u| = 6, where erf rounds to 1. From 4 to 6 it gives the tiny 1 - erf to eight digits,
// which is enough for erf.
#pragma once

#include <cstddef>
#include <utility>

#include "isolaw/num/scalar.hpp"

namespace isolaw::num {

namespace error_function {

// Coefficients of the numerators and denominators, highest power first.
inline constexpr double inner_top[] = {1.85777706184603153e-1, 3.16112374387056560e0, 1.13864154151050156e2,
                                       3.77485237685302021e2, 3.20937758913846947e3};
inline constexpr double inner_bottom[] = {1.0, 2.36012909523441209e1, 2.44024637934444173e2, 1.28261652607737228e3,
                                          2.84423683343917062e3};
inline constexpr double outer_top[] = {2.15311535474403846e-8, 5.64188496988670089e-1, 8.88314979438837594e0,
                                       6.61191906371416295e1,  2.98635138197400131e2,  8.81952221241769090e2,
                                       1.71204761263407058e3,  2.05107837782607147e3,  1.23033935479799725e3};
inline constexpr double outer_bottom[] = {1.0,
                                          1.57449261107098347e1,
                                          1.17693950891312499e2,
                                          5.37181101862009858e2,
                                          1.62138957456669019e3,
                                          3.29079923573345963e3,
                                          4.36261909014324716e3,
                                          3.43936767414372164e3,
                                          1.23033935480374942e3};

// horner() is always inlined, so that the coefficients become constants in the code. Otherwise they would be a table
// with one name, which the code of all instruction sets would share.
template <class T, std::size_t Count, std::size_t... I>
[[gnu::always_inline]] inline T horner(double const (&terms)[Count], T const& x, std::index_sequence<I...>) {
  T sum(terms[0]);
  ((sum = sum * x + T(terms[I + 1])), ...);
  return sum;
}
template <class T, std::size_t Count>
[[gnu::always_inline]] inline T polynomial(double const (&terms)[Count], T const& x) {
  return horner(terms, x, std::make_index_sequence<Count - 1>());
}

}  // namespace error_function

template <class T>
T erf(T const& u) {
  using namespace error_function;
  // min() returns its first argument if that is NaN, so a NaN in u reaches the result.
  T const y = min(abs(u), T(6.0)), square = y * y;
  auto const inner = y < T(0.46875);
  T const top = select(inner, y * polynomial(inner_top, square), polynomial(outer_top, y));
  T const ratio = top / select(inner, polynomial(inner_bottom, square), polynomial(outer_bottom, y));
  T const size = select(inner, ratio, T(1.0) - exp(-square) * ratio);
  return select(u < T(0.0), -size, size);
}

}  // namespace isolaw::num
