// What power-masing and power-scragging share: the elastic force that the amplitude softens, its hardening towards the
// peak, and the virgin stiffness that travel removes, each by side, with the rows of their parameters.
// Source: this project; docs/laws.md. Units kN, mm.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/limits.hpp"

namespace isolaw::laws {

inline constexpr double reference_mm = 100.0;

// The force at 100 mm of a device whose force grows with the power .4 of the amplitude, as high damping rubber's about
// does.
inline double force_at_reference(RecordScales const& s) {
  return s.force * std::pow(reference_mm / s.disp, 0.4);
}

template <class T>
class Scragging {
 public:
  // (x/100) (K (m/100)^(g-1) + w H (m/100) (|x|/m)^6 + w^2 C (1 + N)^(-1/3)), w = (1 + sgn(x) share)/2 with the
  // hysteretic force's share of its strength, -1 to 1. Called at every step.
  template <class Params>
  T force(Params const& p, Step const& step, Memory const& memory, T const& share) {
    double const x = step.x1 / reference_mm, m = memory.side_peak / reference_mm;
    if (x == 0.0) return T(0.0);
    auto& elastic = elastic_[memory.side];
    if (memory.side_peak_grows) elastic = p.K * power(T(m), p.g - T(1.0));
    T const w = T(0.5) + T(x > 0.0 ? 0.5 : -0.5) * share;
    double const ratio = x / m, cubed = ratio * ratio * ratio;
    return T(x) * (elastic + w * (p.H * T(m * cubed * cubed) + w * p.C * T(memory.virgin)));
  }

 private:
  std::array<T, 2> elastic_ = {};  // K (m/100)^(g-1) of each side
};

// g, K, H, C of a law's Params.
template <class T, class Params>
constexpr auto scragging_rows = std::to_array<Row<T, Params>>({
    {&Params::g, parameter("g", "1", "exponent of softening with amplitude", positive, std::nullopt, {0.05, 1.0, one})},
    {&Params::K,
     parameter("K", "kN", "elastic force at 100 mm", any_value, std::nullopt, {0.0, 1.5, force_at_reference})},
    {&Params::H, parameter("H", "kN", "hardening towards the peak; below 0 reloading has negative slopes", any_value,
                           std::nullopt, {0.0, 1.0, force_at_reference})},
    {&Params::C, parameter("C", "kN", "virgin stiffness that cycles remove", any_value, std::nullopt,
                           {0.0, 1.5, force_at_reference})},
});

}  // namespace isolaw::laws
