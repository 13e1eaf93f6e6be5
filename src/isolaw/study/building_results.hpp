// The rows (results.hpp: name, unit and meaning) from which building.json, the page and the tables print a building's
// analyses. building::quantities() lists the responses of the building. A test compares docs/building-json.md with
// these rows.
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
    {"lower", own_unit, "lower bound", "response in the lower bound analysis", get<&building::Distribution::lower>},
    {"upper", own_unit, "upper bound", "response in the upper bound analysis", get<&building::Distribution::upper>},
    {"p16", own_unit, "16 %", "16 % fractile of the draws", fractile_of<0>},
    {"p50", own_unit, "50 %", "median of the draws", fractile_of<1>},
    {"p84", own_unit, "84 %", "84 % fractile of the draws", fractile_of<2>},
    {"p95", own_unit, "95 %", "95 % fractile of the draws", fractile_of<3>},
    {"motion_std_ln", "-", "std ln motions",
     "spread from motion to motion, a standard deviation of ln(response): 0.24 is about 24 %",
     get<&building::Distribution::motion_std_ln>},
    {"lot_std_ln", "-", "std ln lot", "spread from draw to draw under one motion, a standard deviation of ln(response)",
     get<&building::Distribution::lot_std_ln>},
    {"lot_share", "-", "lot's share",
     "share of the total variance of ln(response) that is due to the lot: `lot_std_ln`² / (`lot_std_ln`² + `motion_std_ln`²)",
     get<&building::Distribution::lot_share>},
    {"uncertain_std_ln", "-", "std ln populations",
     "how uncertain the median of the draws is, because the lot is known from few tests: a standard deviation of ln(median)",
     get<&building::Distribution::uncertain_std_ln>},
    {"histogram", "", "",
     "histogram of the draws that have finite numbers: `from`, where its first bin begins; `width` of a bin; `counts`, the number of draws in each bin. Null if no draw has finite numbers",
     nested<building::Distribution>},
    {"by_motion", "", "", "for each motion: the response of the nominal building and the fractiles of the draws",
     nested<building::Distribution>},
};

inline constexpr Result<building::Coverage> coverage_results[]{
    {"inside", "-", "inside", "share of the draws whose response lies between the responses of the two bound analyses",
     get<&building::Coverage::share_inside>},
    {"lower", "-", "interval lower", "lower end of the 95 % confidence interval of `inside` (Clopper and Pearson)",
     get<&building::Coverage::interval_low>},
    {"upper", "-", "interval upper", "upper end of the 95 % confidence interval of `inside`",
     get<&building::Coverage::interval_high>},
    {"below", "-", "below", "share of the draws whose response is smaller than in both bound analyses",
     get<&building::Coverage::share_below>},
    {"above", "-", "above", "share of the draws whose response is larger than in both bound analyses",
     get<&building::Coverage::share_above>},
    {"factor_low", "-", "factor lower",
     "1 - a, where a is the smallest number with which the factors 1 - a and 1 + a on the forces cover the share `enough` of the draws",
     get<&building::Coverage::factor_low>},
    {"factor_high", "-", "factor upper", "1 + a, with the same a as in `factor_low`",
     get<&building::Coverage::factor_high>},
    {"not_monotonic", "", "not monotonic",
     "a sentence if the response of the nominal building does not lie between the responses of the bound analyses, so that `inside` says nothing about the factors; otherwise null",
     word<&building::Coverage::not_monotonic, building::Coverage>},
};

inline constexpr Result<building::LimitCheck> judged_results[]{
    {"limit", "", "limit",
     "name of the limit: a key of `[limits]` of the building file, or `tested_mm` for the largest displacement of the tests",
     get<&building::LimitCheck::limit>},
    {"quantity", "", "quantity", "key of the response that is limited", get<&building::LimitCheck::quantity>},
    {"unit", "", "unit", "unit of this response",
     [](building::LimitCheck const& judged) { return Value(building::quantity(judged.quantity).unit); }},
    {"allowed", own_unit, "allowed", "largest value that the limit allows", get<&building::LimitCheck::allowed>},
    {"nominal", own_unit, "nominal", "response of the nominal building", get<&building::LimitCheck::nominal>},
    {"bound", own_unit, "bounds",
     "the larger of the responses in the two bound analyses; null if one of them gave no finite numbers",
     get<&building::LimitCheck::bound>},
    {"p95", own_unit, "95 %", "95 % fractile of the draws; null if no bearing is drawn",
     get<&building::LimitCheck::p95>},
    {"kept", "-", "kept by", "share of the draws that keep the limit; null if no bearing is drawn",
     get<&building::LimitCheck::share_kept>},
    {"kept_low", "-", "interval lower", "lower end of the 95 % confidence interval of `kept` (Clopper and Pearson)",
     get<&building::LimitCheck::share_kept_low>},
    {"kept_high", "-", "interval upper", "upper end of the 95 % confidence interval of `kept`",
     get<&building::LimitCheck::share_kept_high>},
    {"keeps", "", "keeps",
     "`no`: the nominal building or a bound analysis exceeds the limit, or fewer than `enough` of the draws keep it; `open`: there are too few draws to tell; `yes`: the limit is kept",
     [](building::LimitCheck const& judged) { return Value(name(judged.limit_kept)); }},
    {"broken_by", "", "broken by",
     "what breaks the limit: the first of `nominal`, `bounds` and `draws` that does not keep it, or `nominal failed` or `bounds failed` if this analysis gave no finite numbers; null if the limit is kept or open",
     word<&building::LimitCheck::broken_by, building::LimitCheck>},
    {"draws_wanted", "", "draws wanted",
     "if `keeps` is `open`: how many draws would be enough to tell, if the share of the draws that keep the limit stays the same",
     get<&building::LimitCheck::draws_wanted>},
};

inline constexpr Result<building::MotionCheck> checked_results[]{
    {"outcome", "", "outcome", "`completed`, or what went wrong and at what time",
     get<&building::MotionCheck::outcome>},
    {"form", "", "form",
     "how the law acts under this motion: `coupled`, `springs` or, if the motion is along x alone or the force of the law is not the same in both directions, `separate`",
     [](building::MotionCheck const& checked) { return Value(name(checked.coupling)); }},
    {"isolator_mm", "mm", "implicit", "largest displacement of any bearing, by the implicit integration",
     get<&building::MotionCheck::isolator_mm>},
    {"energy_error", "-", "energy error",
     "error of the energy balance: the missing energy divided by the input energy or by the work of the bearings, whichever is larger",
     get<&building::MotionCheck::balance>},
    {"step_s", "s", "step", "step of integration", get<&building::MotionCheck::step_s>},
    {"missed_mm", "mm", "missed",
     "error of `isolator_mm` due to the step: four thirds of its change when the step is halved",
     get<&building::MotionCheck::missed_mm>},
    {"lanes_off_percent", "%", "draws' path",
     "difference of `isolator_mm` by the method that is used for the draws from that by the implicit integration",
     get<&building::MotionCheck::draws_error_percent>},
    {"equivalent_mm", "mm", "equivalent linear", "displacement of the centre of mass by equivalent linear analysis",
     get<&building::MotionCheck::equivalent_mm>},
    {"equivalent_error_percent", "%", "its error",
     "difference of `equivalent_mm` from the displacement by implicit integration",
     get<&building::MotionCheck::equivalent_error_percent>},
    {"equivalent_period_s", "s", "effective period", "effective period in the equivalent linear analysis",
     get<&building::MotionCheck::equivalent_period_s>},
    {"equivalent_damping", "-", "effective damping", "effective damping in the equivalent linear analysis",
     get<&building::MotionCheck::equivalent_damping>},
};

inline constexpr Result<building::NominalHistory> history_results[]{
    {"step_s", "s", "", "time between the points of the arrays", get<&building::NominalHistory::step_s>},
    {"x_mm", "", "", "displacement of the base's centre of mass along x, mm", nested<building::NominalHistory>},
    {"y_mm", "", "", "displacement of the base's centre of mass along y, mm", nested<building::NominalHistory>},
    {"shear_x_kN", "", "", "sum of the bearings' forces on the base along x, kN", nested<building::NominalHistory>},
    {"shear_y_kN", "", "", "sum of the bearings' forces on the base along y, kN", nested<building::NominalHistory>},
};

inline constexpr Result<building::LawAnswer> answer_results[]{
    {"id", "", "law", "short name of the law, as on the command line", get<&building::LawAnswer::law>},
    {"name", "", "", "common name of the law",
     [](building::LawAnswer const& law) { return value_of(laws::display_name(law.law)); }},
    {"form", "", "form",
     "how the law acts in plan. `coupled`: in both directions together; `springs`: as springs around a circle whose parameters were fitted for springs; `springs as given`: as springs around a circle that have the law's own parameters; `separate`: once along each axis, if all motions are along x or if the force of the law is not the same in both directions",
     [](building::LawAnswer const& law) { return Value(form(law)); }},
    {"draws", "", "draws", "number of drawn buildings; null if no bearing is drawn from the lot",
     [](building::LawAnswer const& law) { return law.draws > 0 ? Value(std::uint64_t{law.draws}) : Value(); }},
    {"failed", "", "failed", "number of analyses that gave no finite numbers", get<&building::LawAnswer::failed>},
    {"collapsed", "", "collapsed",
     "number of drawn buildings for which an analysis gave no finite numbers; they count as outside of the bounds",
     get<&building::LawAnswer::collapsed>},
    {"limits", "", "", "one object for each limit: whether the buildings keep it ([keys](#lawslimits))",
     nested<building::LawAnswer>},
    {"peak_mm", "", "", "`p16`, `p50`, `p84` and `p95` of the response `isolator_mm`", nested<building::LawAnswer>},
    {"coverage", "", "",
     "how many draws the bound analyses cover in `isolator_mm` ([keys](#lawscoverage)). Its member `of` has the same keys for each response by which the bounds are judged. Null if no bearing is drawn",
     nested<building::LawAnswer>},
    {"energy_error", "-", "energy error",
     "error of the energy balance in the worst analysis: the missing energy divided by the input energy or by the work of the bearings, whichever is larger",
     get<&building::LawAnswer::worst_balance>},
    {"quantities", "", "", "one object for each response ([keys](#lawsquantities))", nested<building::LawAnswer>},
    {"bearings", "", "",
     "two arrays with a number for each bearing, in the order of `plan`. `displacement_mm`: its largest displacement; `energy_share`: its share of the work of all bearings. Both are means over draws and motions, or over the motions if no bearing is drawn; a number is null if fewer than 95 % of these analyses gave finite numbers",
     nested<building::LawAnswer>},
    {"doubts", "", "", "doubts about the law's calibration, a sentence each", nested<building::LawAnswer>},
    {"floor_spectra", "", "",
     "response spectra of the floors in the nominal building: pseudo-accelerations with 5 % damping, means over the motions. `periods_s`: the periods; `floors_g`: a curve for every slab, the base first",
     nested<building::LawAnswer>},
    {"loops", "", "",
     "the loop of every bearing under the motion that moves the nominal building most. `motion`: number of this motion, from 0; `of`: the building that moves (`draw 1` or `nominal`); `step_s`: time between two points, of which there are at most 500; `x_mm`, `y_mm`, `rotation_rad`: motion of the base's centre of mass; `bearings`: forces `x_kN`, `y_kN` of each bearing",
     nested<building::LawAnswer>},
    {"checked", "", "", "checks of the nominal building: one object for each motion ([keys](#lawschecked))",
     nested<building::LawAnswer>},
    {"histories", "", "", "histories of the nominal building: one object for each motion ([keys](#lawshistories))",
     nested<building::LawAnswer>},
};

}  // namespace isolaw::study
