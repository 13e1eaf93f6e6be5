// What the analyses of a building say, each number under one name with its unit and meaning: building.json, the page
// and the tables are written from these rows; docs/building-json.md is checked against them. What is measured of a
// building is a row of building::quantities().
#pragma once

#include "isolaw/building/answers.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::study {

template <std::size_t place>
Value fractile_of(building::Distribution const& of) {
  return value_of(of.fractiles[place]);
}

inline constexpr Result<building::Distribution> distribution_results[]{
    {"nominal", own_unit, "nominal", "of the analysis without draws", get<&building::Distribution::nominal>},
    {"lower", own_unit, "lower bound", "of the lower bound analysis", get<&building::Distribution::lower>},
    {"upper", own_unit, "upper bound", "of the upper bound analysis", get<&building::Distribution::upper>},
    {"p16", own_unit, "16 %", "of the draws", fractile_of<0>},
    {"p50", own_unit, "50 %", "of the draws", fractile_of<1>},
    {"p84", own_unit, "84 %", "of the draws", fractile_of<2>},
    {"p95", own_unit, "95 %", "of the draws", fractile_of<3>},
    {"motion_std_ln", "-", "std ln motions", "standard deviation of ln between motions, of their means",
     get<&building::Distribution::motion_std_ln>},
    {"lot_std_ln", "-", "std ln lot", "within a motion, between draws", get<&building::Distribution::lot_std_ln>},
    {"lot_share", "-", "lot's share", "of the variance of ln, the two together",
     get<&building::Distribution::lot_share>},
    {"uncertain_std_ln", "-", "std ln populations",
     "of ln of the medians, between populations as uncertain as the tests leave them",
     get<&building::Distribution::uncertain_std_ln>},
    {"histogram", "", "", "of the draws: `from`, `width` of a bin, `counts`", nested<building::Distribution>},
    {"by_motion", "", "", "the nominal analysis and the fractiles of the draws under each motion",
     nested<building::Distribution>},
};

inline constexpr Result<building::Coverage> coverage_results[]{
    {"inside", "-", "inside", "share of the draws between the two bound analyses", get<&building::Coverage::inside>},
    {"lower", "-", "interval lower", "of its 95 % interval, Clopper and Pearson",
     get<&building::Coverage::interval_low>},
    {"upper", "-", "interval upper", "of the same", get<&building::Coverage::interval_high>},
    {"below", "-", "below", "share of the draws below both", get<&building::Coverage::below>},
    {"above", "-", "above", "share of the draws above both", get<&building::Coverage::above>},
    {"factor_low", "-", "factor lower",
     "with the next the least symmetric factors on forces, of a grid, whose analyses would cover `enough`",
     get<&building::Coverage::factor_low>},
    {"factor_high", "-", "factor upper", "of the same", get<&building::Coverage::factor_high>},
    {"not_monotonic", "", "not monotonic",
     "why a small share says nothing of the factors: both bounds are on one side of the nominal building; null where they are not",
     word<&building::Coverage::not_monotonic, building::Coverage>},
};

inline constexpr Result<building::Checked> checked_results[]{
    {"outcome", "", "outcome", "`completed`, or what went wrong and when", get<&building::Checked::outcome>},
    {"isolator_mm", "mm", "implicit", "largest displacement of any bearing by the implicit path",
     get<&building::Checked::isolator_mm>},
    {"energy_error", "-", "energy error", "energy that is missing, of the input", get<&building::Checked::balance>},
    {"step_s", "s", "step", "of integration", get<&building::Checked::step_s>},
    {"missed_mm", "mm", "missed", "a third of the difference to half the step", get<&building::Checked::missed_mm>},
    {"lanes_off_percent", "%", "draws' path", "the path that draws take, from it",
     get<&building::Checked::lanes_off_percent>},
    {"equivalent_mm", "mm", "equivalent linear", "of the centre, by equivalent linear analysis",
     get<&building::Checked::equivalent_mm>},
    {"equivalent_error_percent", "%", "its error", "against the implicit path, of the centre",
     get<&building::Checked::equivalent_error_percent>},
    {"equivalent_period_s", "s", "effective period", "of it", get<&building::Checked::equivalent_period_s>},
    {"equivalent_damping", "-", "effective damping", "of it", get<&building::Checked::equivalent_damping>},
};

// Of one motion.
inline constexpr Result<building::NominalHistory> history_results[]{
    {"step_s", "s", "", "between the points of the arrays", get<&building::NominalHistory::step_s>},
    {"x_mm", "", "", "displacement of the base's centre of mass along x, mm", nested<building::NominalHistory>},
    {"y_mm", "", "", "and along y", nested<building::NominalHistory>},
    {"shear_x_kN", "", "", "sum of the bearings' forces on the base along x, kN", nested<building::NominalHistory>},
    {"shear_y_kN", "", "", "and along y", nested<building::NominalHistory>},
};

inline constexpr Result<building::LawAnswer> answer_results[]{
    {"id", "", "law", "as on the command line", get<&building::LawAnswer::law>},
    {"name", "", "", "as people call the law",
     [](building::LawAnswer const& law) { return value_of(laws::called(law.law)); }},
    {"form", "", "form",
     "`coupled`; `springs` around the circle, fitted as such; `springs as given`, with the parameters of the law along one direction; `separate`, once along each axis, under motions along x alone",
     [](building::LawAnswer const& law) { return Value(form(law)); }},
    {"draws", "", "draws", "buildings drawn", get<&building::LawAnswer::draws>},
    {"failed", "", "failed", "runs without finite numbers, left out", get<&building::LawAnswer::failed>},
    {"peak_mm", "", "", "`p16`, `p50`, `p84`, `p95` of `isolator_mm`", nested<building::LawAnswer>},
    {"coverage", "", "", "of `isolator_mm`, as below; `of`: of each quantity that is covered",
     nested<building::LawAnswer>},
    {"energy_error", "-", "energy error", "largest of all runs: energy that is missing, of the input",
     get<&building::LawAnswer::worst_balance>},
    {"quantities", "", "", "by key, each as below", nested<building::LawAnswer>},
    {"bearings", "", "",
     "in the order of the plan, means over draws and motions: `displacement_mm`, the largest; `energy_share`, of the work on all",
     nested<building::LawAnswer>},
    {"doubts", "", "", "what is known against its calibration, a sentence each", nested<building::LawAnswer>},
    {"floor_spectra", "", "",
     "of the nominal building, 5 % damped pseudo-accelerations, means over the motions: `periods_s`; `floors_g`, of every slab from the base",
     nested<building::LawAnswer>},
    {"loops", "", "",
     "of every bearing under the motion that moves the nominal building most: `motion` its place, `of` the first draw or the nominal building, `step_s`; of the base's centre of mass `x_mm`, `y_mm`, `rotation_rad`; `bearings` with `x_kN`, `y_kN`; at most 500 points",
     nested<building::LawAnswer>},
    {"checked", "", "", "the nominal building under each motion, as below", nested<building::LawAnswer>},
    {"histories", "", "", "of the nominal building under each motion, as below", nested<building::LawAnswer>},
};

}  // namespace isolaw::study
