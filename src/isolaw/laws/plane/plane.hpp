// Laws in two directions. Each takes the parameters of a law in one direction. If the device moves on a straight line
// through the origin only, the force is that of the law in one direction. A law of the plane is a struct with
//   OneDirection                           the law in one direction, which gives info and Params<T>
//   State<T>                               nothing but numbers T: a trial copies it, numbers_as() converts them
//   start<T>(params) -> State<T>           at rest at the origin
//   step<T>(params, state, from, to, dt)   advances the state over the straight step between two displacements, returns
//                                          the force at its end; in the law's units, dt in seconds
//   joint_limits                           where needed, conditions on the parameters for a form in the plane
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <tuple>

#include "isolaw/laws/plane/abe.hpp"
#include "isolaw/laws/plane/bilinear.hpp"
#include "isolaw/laws/plane/bouc_wen.hpp"
#include "isolaw/laws/plane/history_integral.hpp"
#include "isolaw/laws/plane/vaiana.hpp"
#include "isolaw/num/dual.hpp"

namespace isolaw::laws::plane {

using AllLaws = std::tuple<Bilinear, BoucWen, Abe, AbeY0, Vaiana, HistoryIntegral>;

// The laws whose force softens with the peak, in the variant with a separate peak along each axis.
using LawsByAxis = std::tuple<AbeOf<laws::Abe, Softening::by_axis>, AbeOf<laws::AbeY0, Softening::by_axis>,
                              HistoryIntegralOf<Softening::by_axis>>;

// Applies one() to every number of parameters or of a state, to convert them to another scalar type or back.
template <class To, class From, class T = double, class U>
To numbers_as(From const& from, U&& one) {
  std::array<T, sizeof(From) / sizeof(T)> const values = std::bit_cast<std::array<T, sizeof(From) / sizeof(T)>>(from);
  std::array<decltype(one(values[0])), sizeof(From) / sizeof(T)> changed;
  for (std::size_t i = 0; i < changed.size(); ++i) changed[i] = one(values[i]);
  return std::bit_cast<To>(changed);
}

// The result of a trial. The caller accepts it by taking `after` as the state.
template <class Law>
struct Trial {
  Vector<double> force;
  // Derivatives of the force by the displacement at the end of the step: rows are the x and y of the force, columns the
  // x and y of the displacement.
  std::array<std::array<double, 2>, 2> tangent;
  typename Law::template State<double> after;
};

template <class Law>
Trial<Law> force_and_tangent(Law const&, typename Law::template Params<double> const& params,
                             typename Law::template State<double> const& state, Vector<double> const& from,
                             Vector<double> const& to, double dt) {
  using T = num::Dual<2>;
  auto const as_dual = [](double value) { return T(value); };
  auto const p = numbers_as<typename Law::template Params<T>>(params, as_dual);
  auto s = numbers_as<typename Law::template State<T>>(state, as_dual);
  Vector<T> const force = Law::template step<T>(p, s, {T(from.x), T(from.y)}, {T(to.x, 0), T(to.y, 1)}, dt);
  auto const after =
      numbers_as<typename Law::template State<double>, decltype(s), T>(s, [](T const& x) { return x.value; });
  return {{force.x.value, force.y.value}, {force.x.slope, force.y.slope}, after};
}

}  // namespace isolaw::laws::plane
