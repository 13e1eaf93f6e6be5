// Smooth curves through what tests showed, for drawing. No factor is taken from them: between tests isolaw follows
// straight lines (contrast.hpp).
#pragma once

#include <optional>
#include <span>

#include "isolaw/conditions/contrast.hpp"

namespace isolaw::conditions {

// The exponent b of exp(b (T - T_ref)) for temperature [1/K], or of (f/f_ref)^b for rate. Fitted by least squares to
// the means of all levels; the curve goes through the reference. nullopt for other effects, and if the reference is the
// only level.
std::optional<double> exponent(Response const& response);

// Stiffness K_0 (1 - (N/N_cr)^2) as a function of the vertical load N. It would vanish at N_cr.
struct LoadCurve {
  double unloaded = 0.0, critical_kN = 0.0;  // K_0 divided by the stiffness at reference; N_cr

  double at(double load_kN) const;
};
// Fits the curve to the means of all levels by least squares, linearly in N^2. nullopt with fewer than two levels, and
// if the stiffness does not fall with the load.
std::optional<LoadCurve> load_curve(Response const& load);

// P_n = last + (first - last) n^-p for the cycle n = 1, 2, ... No test has shown the limit `last`.
struct Softening {
  double first = 0.0, last = 0.0, p = 0.0;

  double at(double cycle) const;
};
inline constexpr std::size_t fewest_cycles = 5;
// Fits the curve to the values of cycles 1, 2, ... by least squares, with p from 0.2 to 3. nullopt with fewer than
// `fewest_cycles` values.
std::optional<Softening> softening(std::span<double const> values);

}  // namespace isolaw::conditions
