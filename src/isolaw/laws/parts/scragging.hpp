// Parts that power-masing and power-scragging share, with their parameters: an elastic force that softens with the
// amplitude, its hardening towards the peak, and scragging, the loss of the virgin stiffness with travel. Each side,
// x >= 0 and x < 0, has a peak and a travel of its own. Source: this project; docs/laws.md. Units kN, mm.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/memory/sides.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/parts/reference.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
template <class N>
struct Scragging {
  N elastic[2] = {N(0.0), N(0.0)};  // K (m/100)^(g-1) [kN] for x >= 0 and x < 0; m is the largest |x| on that side

  // Returns (x/100) (K (m/100)^(g-1) + w H (m/100) (|x|/m)^6 + w^2 C (1 + N)^(-1/3)), w = (1 + sgn(x) share)/2. m is
  // the peak of the side of x, and N the travel on that side divided by m. `share`, from -1 to 1, is the hysteretic
  // force divided by its strength. Must be called at every step. When the motion first enters a side, the slope of
  // |x|^g has no bound. The tangent is then limited to the slope of the secant from 0 to the displacement `rounding`.
  template <class T, class X, class PathMemory, class Params>
  N force(Params const& p, X const& at, PathMemory const& memory, N const& share, T const& rounding) {
    auto const steepest = [&] { return p.K * power(rounding / T(reference_mm), p.g - T(1.0)) / T(reference_mm); };
    X const x = at / reference_mm, m = memory.side_peak / reference_mm;
    if (!(m > 0.0)) return slope_alone(at, N(steepest()));
    N& now = elastic[memory.side];
    if (memory.side_peak_grows) now = p.K * power(N(m), p.g - T(1.0));
    N const w = N(0.5) + N(memory.side == 0 ? 0.5 : -0.5) * share;
    X const ratio = x / m, cubed = ratio * ratio * ratio;
    N all = N(x) * (now + w * (p.H * N(m * cubed * cubed) + w * p.C * N(memory.virgin_share)));
    limit_slope(
        all, [&] { return N(x) * now; }, steepest);
    return all;
  }
  template <class Each>
  void members(Each& each) {
    each(elastic[0], elastic[1]);
  }
};
// [end]

// The parameter table's rows for g, K, H and C, for the laws that share these parameters.
template <class T, class Params>
constexpr auto scragging_rows = std::to_array<Row<T, Params>>({
    {&Params::g, parameter("g", "1", "exponent of softening with amplitude", positive, std::nullopt, {0.05, 1.0, one})},
    {&Params::K,
     parameter("K", "kN", "elastic force at 100 mm", any_value, std::nullopt, {0.0, 1.5, force_at_reference})},
    {&Params::H,
     parameter("H", "kN",
               "hardening force towards the peak, at 100 mm; if it is negative, reloading has negative slopes",
               any_value, std::nullopt, {0.0, 1.0, force_at_reference})},
    {&Params::C, parameter("C", "kN", "elastic force of the virgin device at 100 mm, which cycling removes", any_value,
                           std::nullopt, {0.0, 1.5, force_at_reference})},
});

}  // namespace isolaw::laws
