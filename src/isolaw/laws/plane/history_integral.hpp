// History integral in the plane: each memory q, of length D, obeys q' = (n - q)/D along the path, where n is the
// direction of motion. The elastic force softens with the largest distance so far, or each of its two components with
// the largest displacement along that component's axis (Softening). Step: exact along a straight path.
#pragma once

#include "isolaw/laws/history_integral.hpp"
#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::laws::plane {

template <Softening softening>
struct HistoryIntegralOf {
  using OneDirection = laws::HistoryIntegral;
  static constexpr LawInfo const& info = OneDirection::info;
  template <class T>
  using Params = OneDirection::Params<T>;

  template <class T>
  struct State {
    Vector<T> slow{T(0.0), T(0.0)}, quick{T(0.0), T(0.0)};
    // With Softening::by_axis these are the largest |x| and the largest |y| so far. With by_distance both are the
    // largest distance from the origin so far.
    Vector<T> peaks{T(0.0), T(0.0)};
  };

  template <class T>
  static State<T> start(Params<T> const&) {
    return {};
  }

  template <class T>
  static Vector<T> step(Params<T> const& p, State<T>& state, Vector<T> const& from, Vector<T> const& to, double) {
    T const one(1.0), tiny(num::smallest_power_base), reference(reference_mm);
    Straight<T> const way(from, to);
    T const per_slow = one / max(p.D, tiny), per_quick = per_slow / max(p.u, tiny);
    state.slow = fading(state.slow, way, per_slow);
    state.quick = fading(state.quick, way, per_quick);
    constexpr bool by_axis = softening == Softening::by_axis;
    Vector<T> const size = by_axis ? Vector<T>{abs(to.x), abs(to.y)} : Vector<T>{norm(to), norm(to)};
    state.peaks = {max(state.peaks.x, size.x), max(state.peaks.y, size.y)};
    // The elastic stiffness for this peak. For g < 1 it grows without bound towards peak 0, where it is set to 0.
    auto const stiffness = [&](T const& peak) {
      return select(peak > T(0.0), p.K / reference * power(peak / reference, p.g - one), T(0.0));
    };
    Vector<T> const elastic{stiffness(state.peaks.x) * to.x, stiffness(state.peaks.y) * to.y};
    return elastic + (p.S * (one - p.s)) * state.slow + (p.S * p.s) * state.quick;
  }
};

using HistoryIntegral = HistoryIntegralOf<Softening::by_distance>;

}  // namespace isolaw::laws::plane
