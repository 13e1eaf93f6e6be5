// Linear oscillators: the equivalent linear model of an isolated building, and the spectra of its floors.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

// Effective stiffness and damping ratio of a bearing in its third sine cycle of this amplitude and period along x.
struct Effective {
  double stiffness_kN_mm = 0.0, damping = 0.0;
};
Effective effective(std::string_view law, std::span<double const> parameters, double amplitude_mm, double period_s,
                    Coupling coupling);

// The sum of the stiffnesses of all bearings, and the mean of their damping, weighted by stiffness. `bearings` holds
// the parameters of all bearings, one after the other.
Effective effective(Devices const& devices, std::span<double const> bearings, double amplitude_mm, double period_s);

// The linear oscillator whose stiffness and damping equal the effective stiffness and damping that the bearings have at
// the oscillator's own peak displacement.
struct EquivalentLinear {
  double displacement_mm = 0.0, period_s = 0.0, damping = 0.0;
};
// `bearings` is as for effective(); `mass` is that of the building in kN s2/mm. Returns nullopt if the search comes to
// a displacement at which the effective stiffness is not above 0, because then there is no such oscillator.
std::optional<EquivalentLinear> equivalent_linear(Devices const& devices, Motion const& motion,
                                                  std::vector<double> const& bearings, double mass);

// Floor spectra: the largest pseudo-acceleration in plan of linear oscillators along x and y on a diaphragm of the
// nominal building, with the periods of spectrum_periods_s() and 5 % damping. The spectra are means over the motions.
inline constexpr double spectrum_damping = 0.05;
std::vector<double> const& spectrum_periods_s();
// Computes the spectra of a run in g, multiplies them by `share` and adds them to `to`, [diaphragm][period].
void add_spectra(std::vector<std::vector<double>>& to, Response const& run, double share);

}  // namespace isolaw::building
