// Cyclic properties of a force-displacement history: cycles, effective stiffness, energy, equivalent viscous damping.
// Formulas of EN 15129 and NTC 2018 (11.9.7).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isolaw::data {

// One closed cycle, cut at zero crossings of displacement in the direction of the first motion, interpolated. A
// crossing counts once displacement has been beyond a band of 2 % of its half range on the other side, so that noise
// and tremor about zero cut nothing. A record that starts, or comes to rest, inside the band is cut there.
struct Cycle {
  int number = 0;      // from 1
  double first = 0.0;  // start and end as fractional sample indices
  double last = 0.0;
  double amplitude_mm = 0.0;     // (largest - smallest displacement) / 2
  double K_eff_kN_per_mm = 0.0;  // (force at largest x - force at smallest x) / (largest x - smallest x)
  double energy_kN_mm = 0.0;     // trapezoid of F dx over the cycle, closed by a straight line
  double damping_percent = 0.0;  // energy / (2 pi K_eff amplitude^2)
};

struct Properties {
  std::vector<Cycle> cycles;                // complete cycles, in order
  std::optional<Cycle> reported;            // the third, or the last where there are fewer; empty when refused
  std::string refusal;                      // why there is none: less than one cycle, fewer than 20 samples per cycle
  std::optional<double> samples_per_cycle;  // median over complete cycles, so that a hold before the test counts little
};

// disp_mm and force_kN of equal length; the axis is the sample index, so no time is needed.
Properties cyclic_properties(std::span<double const> disp_mm, std::span<double const> force_kN);

// The properties of another force on the same cycle (a law's computed force at the same samples).
Cycle properties_on(Cycle const& cycle, std::span<double const> disp_mm, std::span<double const> force_kN);

}  // namespace isolaw::data
