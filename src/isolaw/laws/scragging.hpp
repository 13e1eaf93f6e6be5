// Shared by power-masing and power-scragging: the elastic force that softens with the amplitude, its hardening towards
// the peak, and the virgin stiffness that travel removes. Each side has its own. Also the rows of their parameters.
// Source: this project; docs/laws.md. Units kN, mm.
#pragma once

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/limits.hpp"

namespace isolaw::laws {

inline constexpr double reference_mm = 100.0;
// The record's largest force, scaled to 100 mm with the power 0.4 of the amplitude, about that of high damping rubber.
inline double force_at_reference(RecordScales const& s) {
  return s.force * std::pow(reference_mm / s.disp, 0.4);
}

template <class T>
class Scragging {
 public:
  // (x/100) (K (m/100)^(g-1) + w H (m/100) (|x|/m)^6 + w^2 C (1 + N)^(-1/3)) with w = (1 + sgn(x) share)/2. `share` is
  // the hysteretic force over its strength, -1 to 1. Must be called at every step.
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

// The parameter table's rows for g, K, H and C, for the laws that share these parameters.
template <class T, class Params>
constexpr auto scragging_rows = std::to_array<Row<T, Params>>({
    {&Params::g, parameter("g", "1", "exponent of softening with amplitude", positive, std::nullopt, {0.05, 1.0, one})},
    {&Params::K,
     parameter("K", "kN", "elastic force at 100 mm", any_value, std::nullopt, {0.0, 1.5, force_at_reference})},
    {&Params::H, parameter("H", "kN", "hardening towards the peak; a negative value gives reloading negative slopes",
                           any_value, std::nullopt, {0.0, 1.0, force_at_reference})},
    {&Params::C, parameter("C", "kN", "virgin stiffness that cycles remove", any_value, std::nullopt,
                           {0.0, 1.5, force_at_reference})},
});

}  // namespace isolaw::laws
