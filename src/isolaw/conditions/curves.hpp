// Smooth curves through what tests showed, for drawing. No factor is taken from them: between tests isolaw follows
// straight lines (contrast.hpp).
#pragma once

#include <optional>
#include <span>

#include "isolaw/conditions/contrast.hpp"

namespace isolaw::conditions {

// The exponent b of exp(b (T - T_ref)) in 1/K, or of (f/f_ref)^b, by least squares of the means of all levels through
// the reference. Empty for other effects, and without a level beside the reference.
std::optional<double> exponent(Response const& response);

// K_0 (1 - (N/N_cr)^2) over the vertical load N. The stiffness would vanish at N_cr.
struct LoadCurve {
  double unloaded = 0.0, critical_kN = 0.0;  // K_0, over the stiffness at reference, and N_cr

  double at(double load_kN) const;
};
// By least squares in N^2 of the means of all levels. Empty with fewer than two levels, and if the stiffness does not
// fall with the load.
std::optional<LoadCurve> load_curve(Response const& load);

// P_n = last + (first - last) n^-p for the cycle n = 1, 2, ...; `last` is no limit that tests have shown.
struct Softening {
  double first = 0.0, last = 0.0, p = 0.0;

  double at(double cycle) const;
};
inline constexpr std::size_t fewest_cycles = 5;
// By least squares of the values of cycles 1, 2, ..., with p from 0.2 to 3. Empty with fewer than `fewest_cycles`.
std::optional<Softening> softening(std::span<double const> values);

}  // namespace isolaw::conditions
