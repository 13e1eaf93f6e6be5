// The rows that building.json, the page and the tables take from a building's analyses: name, unit and meaning.
// building::quantities() lists the responses of the building. A test compares docs/building-json.md with these rows.
#pragma once

#include "isolaw/building/answers.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::study {

template <std::size_t place>
Value fractile_of(building::Distribution const& distribution) {
  return value_of(distribution.fractiles[place]);
}

inline constexpr Result<building::Distribution> distribution_results[]{
    {"nominal", own_unit, "nominal", "response of the nominal building", get<&building::Distribution::nominal>},
    {"lower", own_unit, "lower bound", "in the lower bound analysis", get<&building::Distribution::lower>},
    {"upper", own_unit, "upper bound", "in the upper bound analysis", get<&building::Distribution::upper>},
    {"p16", own_unit, "16 %", "16 % fractile of the draws", fractile_of<0>},
    {"p50", own_unit, "50 %", "median of the draws", fractile_of<1>},
    {"p84", own_unit, "84 %", "84 % fractile of the draws", fractile_of<2>},
    {"p95", own_unit, "95 %", "95 % fractile of the draws", fractile_of<3>},
    {"motion_std_ln", "-", "std ln motions", "standard deviation of ln between the motions' means: 0.24 is about 24 %",
     get<&building::Distribution::motion_std_ln>},
    {"lot_std_ln", "-", "std ln lot", "standard deviation of ln between draws under one motion",
     get<&building::Distribution::lot_std_ln>},
    {"lot_share", "-", "lot's share", "share of the lot in the variance of ln, motions and lot together",
     get<&building::Distribution::lot_share>},
    {"uncertain_std_ln", "-", "std ln populations",
     "standard deviation of ln of the medians, between populations as uncertain as the tests leave them",
     get<&building::Distribution::uncertain_std_ln>},
    {"histogram", "", "", "histogram of the draws with numbers: `from`, `width` of a bin, `counts`; null without any",
     nested<building::Distribution>},
    {"by_motion", "", "", "for each motion the nominal response and the fractiles of the draws",
     nested<building::Distribution>},
};

inline constexpr Result<building::Coverage> coverage_results[]{
    {"inside", "-", "inside", "share of the draws between the two bound analyses", get<&building::Coverage::inside>},
    {"lower", "-", "interval lower", "lower end of its 95 % interval (Clopper and Pearson)",
     get<&building::Coverage::interval_low>},
    {"upper", "-", "interval upper", "upper end", get<&building::Coverage::interval_high>},
    {"below", "-", "below", "share of the draws below both analyses", get<&building::Coverage::below>},
    {"above", "-", "above", "share of the draws above both", get<&building::Coverage::above>},
    {"factor_low", "-", "factor lower",
     "lower of the two factors on forces that would cover `enough`: symmetric about 1, the closest on a grid",
     get<&building::Coverage::factor_low>},
    {"factor_high", "-", "factor upper", "the upper one", get<&building::Coverage::factor_high>},
    {"not_monotonic", "", "not monotonic",
     "why a small share does not judge the factors: both bounds lie on one side of the nominal building; null where they do not",
     word<&building::Coverage::not_monotonic, building::Coverage>},
};

inline constexpr Result<building::Judged> judged_results[]{
    {"limit", "", "limit", "key of `[limits]` of the building file, or `tested_mm`, how far the bearings were tested",
     get<&building::Judged::limit>},
    {"quantity", "", "quantity", "key of the response that it limits", get<&building::Judged::quantity>},
    {"unit", "", "unit", "its unit",
     [](building::Judged const& judged) { return Value(building::quantity(judged.quantity).unit); }},
    {"allowed", own_unit, "allowed", "the limit", get<&building::Judged::allowed>},
    {"nominal", own_unit, "nominal", "response of the nominal building", get<&building::Judged::nominal>},
    {"bound", own_unit, "bounds", "the larger of those of the two bound analyses; null if one gave no finite numbers",
     get<&building::Judged::bound>},
    {"p95", own_unit, "95 %", "95 % fractile of the draws; null if no bearing is drawn", get<&building::Judged::p95>},
    {"kept", "-", "kept by", "share of the draws that keep the limit; null if no bearing is drawn",
     get<&building::Judged::kept>},
    {"kept_low", "-", "interval lower", "lower end of its 95 % interval (Clopper and Pearson)",
     get<&building::Judged::kept_low>},
    {"kept_high", "-", "interval upper", "upper end", get<&building::Judged::kept_high>},
    {"keeps", "", "keeps",
     "`no`: the nominal building or a bound analysis exceeds the limit, or fewer than `enough` of the draws keep it; `open`: the draws are too few to tell; else `yes`",
     [](building::Judged const& judged) { return Value(name(judged.keeps)); }},
    {"broken_by", "", "broken by",
     "what does not keep it, the first of `nominal`, `bounds`, `draws`; `nominal failed` or `bounds failed` if this analysis gave no finite numbers; null if it is kept or open",
     word<&building::Judged::broken_by, building::Judged>},
    {"draws_wanted", "", "draws wanted",
     "if it is open: the number of draws that would tell, if the share of those that keep it stays as it is",
     get<&building::Judged::draws_wanted>},
};

inline constexpr Result<building::Checked> checked_results[]{
    {"outcome", "", "outcome", "`completed`, or what went wrong and when", get<&building::Checked::outcome>},
    {"form", "", "form", "how the law acts under the motion: `coupled`, `springs` or, along x alone, `separate`",
     [](building::Checked const& checked) { return Value(name(checked.coupling)); }},
    {"isolator_mm", "mm", "implicit", "largest displacement of any bearing, by the implicit integration",
     get<&building::Checked::isolator_mm>},
    {"energy_error", "-", "energy error", "missing energy over the larger of input energy and work of the bearings",
     get<&building::Checked::balance>},
    {"step_s", "s", "step", "step of integration", get<&building::Checked::step_s>},
    {"missed_mm", "mm", "missed", "step error of `isolator_mm`: four thirds of its change with half the step",
     get<&building::Checked::missed_mm>},
    {"lanes_off_percent", "%", "draws' path", "error of the draws' integration in `isolator_mm`",
     get<&building::Checked::draws_error_percent>},
    {"equivalent_mm", "mm", "equivalent linear", "displacement of the centre by equivalent linear analysis",
     get<&building::Checked::equivalent_mm>},
    {"equivalent_error_percent", "%", "its error", "its error against the implicit integration",
     get<&building::Checked::equivalent_error_percent>},
    {"equivalent_period_s", "s", "effective period", "its period", get<&building::Checked::equivalent_period_s>},
    {"equivalent_damping", "-", "effective damping", "its damping", get<&building::Checked::equivalent_damping>},
};

inline constexpr Result<building::NominalHistory> history_results[]{
    {"step_s", "s", "", "time between the points of the arrays", get<&building::NominalHistory::step_s>},
    {"x_mm", "", "", "displacement of the base's centre of mass along x, mm", nested<building::NominalHistory>},
    {"y_mm", "", "", "the same along y", nested<building::NominalHistory>},
    {"shear_x_kN", "", "", "sum of the bearings' forces on the base along x, kN", nested<building::NominalHistory>},
    {"shear_y_kN", "", "", "the same along y", nested<building::NominalHistory>},
};

inline constexpr Result<building::LawAnswer> answer_results[]{
    {"id", "", "law", "as on the command line", get<&building::LawAnswer::law>},
    {"name", "", "", "common name of the law",
     [](building::LawAnswer const& law) { return value_of(laws::called(law.law)); }},
    {"form", "", "form",
     "how the law acts in plan: `coupled`; `springs` around the circle, fitted as such; `springs as given`, with the parameters of the law along one direction; `separate`, once along each axis, where all motions are along x",
     [](building::LawAnswer const& law) { return Value(form(law)); }},
    {"draws", "", "draws", "buildings drawn; null if no bearing is drawn from the lot",
     [](building::LawAnswer const& law) { return law.draws > 0 ? Value(std::uint64_t{law.draws}) : Value(); }},
    {"failed", "", "failed", "runs that gave no finite numbers", get<&building::LawAnswer::failed>},
    {"collapsed", "", "collapsed", "drawn buildings with such a run; they count as outside of the bounds",
     get<&building::LawAnswer::collapsed>},
    {"limits", "", "", "how its buildings keep each limit, as below", nested<building::LawAnswer>},
    {"peak_mm", "", "", "`p16`, `p50`, `p84`, `p95` of `isolator_mm`", nested<building::LawAnswer>},
    {"coverage", "", "",
     "coverage in `isolator_mm`, as below; `of`: the same for each covered quantity; null if no bearing is drawn",
     nested<building::LawAnswer>},
    {"energy_error", "-", "energy error",
     "missing energy over the larger of input energy and work of the bearings, largest of all runs",
     get<&building::LawAnswer::worst_balance>},
    {"quantities", "", "", "each quantity by its key, as below", nested<building::LawAnswer>},
    {"bearings", "", "",
     "in the order of the plan, means over draws and motions (without draws over the motions): `displacement_mm`, its largest displacement; `energy_share`, its share of the work on all; null if fewer than 95 % of these runs have numbers",
     nested<building::LawAnswer>},
    {"doubts", "", "", "doubts about the law's calibration, a sentence each", nested<building::LawAnswer>},
    {"floor_spectra", "", "",
     "5 % damped pseudo-accelerations in the nominal building, means over the motions: `periods_s`; `floors_g`, a curve for every slab from the base up",
     nested<building::LawAnswer>},
    {"loops", "", "",
     "loops of every bearing under the motion that moves the nominal building most: `motion` (its index, from 0), `of` (`draw 1` or `nominal`), `step_s`; `x_mm`, `y_mm`, `rotation_rad` of the base's centre of mass; `bearings` with `x_kN`, `y_kN`; at most 500 points",
     nested<building::LawAnswer>},
    {"checked", "", "", "checks of the nominal building under each motion, as below", nested<building::LawAnswer>},
    {"histories", "", "", "histories of the nominal building under each motion, as below", nested<building::LawAnswer>},
};

}  // namespace isolaw::study
