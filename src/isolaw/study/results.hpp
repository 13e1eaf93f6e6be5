// Defines every result once: its key in JSON, its unit, its heading in tables and its meaning. summary.json, the page's
// data and the tables are written from these rows, in this order. A test compares docs/summary-json.md with them.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct Ends {
  std::optional<double> lower, upper;
};
struct Nested {};  // an object or array that the renderer writes itself

using Value = std::variant<std::monostate, bool, int, std::uint64_t, double, std::string_view,
                           std::vector<std::string> const*, Statistic, Ends, Nested>;  // monostate: an undefined value

template <class T>
Value value_of(T const& from) {
  if constexpr (requires { from.has_value(); })
    return from ? value_of(*from) : Value();
  else if constexpr (std::is_enum_v<T>)
    return std::string_view(name(from));
  else if constexpr (std::same_as<T, std::vector<std::string>>)
    return &from;
  else if constexpr (std::convertible_to<T const&, std::string_view>)
    return std::string_view(from);
  else if constexpr (std::unsigned_integral<T> && !std::same_as<T, bool>)
    return std::uint64_t{from};
  else
    return from;
}

// Applies members or functions to the object one after another: get<&ParameterFit::value, &Statistic::mean>.
template <auto first, auto... rest, class Object>
Value get(Object const& object) {
  if constexpr (sizeof...(rest) > 0)
    return get<rest...>(std::invoke(first, object));
  else
    return value_of(std::invoke(first, object));
}
template <auto lower, auto upper, class Object>
Value ends(Object const& object) {
  return Ends{object.*lower, object.*upper};
}
// Reads a text that counts as undefined if it is empty.
template <auto member, class Object>
Value word(Object const& object) {
  return (object.*member).empty() ? Value() : value_of(object.*member);
}
template <class Object>
Value nested(Object const&) {
  return Nested{};
}

// The unit of a result that has another unit in each object, such as a parameter's value. Another row gives that unit.
inline constexpr std::string_view own_unit = "its own";

struct PrintFormat {
  std::optional<int> decimals, significant;
};
constexpr PrintFormat decimals(int count) {
  return {.decimals = count, .significant = {}};
}
constexpr PrintFormat significant(int count) {
  return {.decimals = {}, .significant = count};
}

template <class Object>
struct Result {
  // unit: "-" for a number without a unit, "" for other values. heading: "" if no table and no page shows the result.
  std::string_view key, unit, heading, meaning;
  Value (*value)(Object const&) = nullptr;
  PrintFormat printed{};
  int digits = 9;  // significant digits in the page's data, for numbers that are only plotted
};

inline std::string_view fit_message(DeviceFit const& fit) {
  return fit.refusal.empty() ? fit.failure : fit.refusal;
}

inline std::optional<double> measured_energy_fall(DeviceFit const& fit) {
  return fit.energy_fall ? std::optional(fit.energy_fall->measured_percent) : std::nullopt;
}
inline std::optional<double> energy_fall_of_law(DeviceFit const& fit) {
  return fit.energy_fall ? std::optional(fit.energy_fall->percent) : std::nullopt;
}

template <double BeyondTests::*member>
Value beyond(LawResult const& law) {
  return law.beyond_tests ? value_of((*law.beyond_tests).*member) : Value();
}

inline constexpr Result<LawResult> law_results[]{
    {"id", "", "law", "short name, as on the command line", get<&LawResult::id>},
    {"objective", "-", "OF",
     "mean misfit of the force (see below the table). `mean`: mean of the device means; `std`, `best`: standard deviation and smallest value over all devices and runs",
     get<&LawResult::objective>},
    {"beta", "-", "beta",
     "robustness index, Eq. (31) of Cucuzza et al. 2025. For each calibrated parameter isolaw takes the largest relative difference of a device from the lot's mean; `beta` is the mean of these. Smaller is more robust",
     get<&LawResult::beta>},
    {"on_front", "", "on front",
     "true: no other law is at least as good in both `objective.mean` and `beta`, and better in one of them",
     get<&LawResult::on_front>},
    {"devices", "", "", "the fits: one object for each device on which the law was tried", nested<LawResult>},
    {"beta_note", "", "note", "why `beta` is null; empty otherwise", get<&LawResult::beta_note>},
    {"name", "", "", "common name of the law, such as `\"Abe (constant yield)\"`",
     [](LawResult const& law) { return value_of(laws::display_name(law.id)); }},
    {"title", "", "", "longer name that says what kind of law it is", get<&LawResult::title>},
    {"notes", "", "", "how isolaw reads the source of the law where the source leaves something open",
     get<&LawResult::notes>},
    {"success_share", "-", "success share",
     "share (0 to 1) of the usable runs that ended within 0.1 % of the smallest objective that any run or analysis of the campaign found",
     get<&LawResult::success_share>},
    {"success_reference", "", "success refers to",
     "what the runs were compared with for `success_share`: always the text \"best of this campaign\"; empty if `success_share` is null",
     get<&LawResult::success_reference>},
    {"objective_converged", "-", "mean least OF",
     "mean over the devices of the smallest objective found on each (`optimum`)", get<&LawResult::objective_converged>},
    {"beta_converged", "-", "beta, converged",
     "`beta` computed from the parameters with the smallest objective on each device. Parameters that the tests do not determine are left out",
     get<&LawResult::beta_converged>},
    {"beta_converged_note", "", "note", "why `beta_converged` is null; empty otherwise",
     get<&LawResult::beta_converged_note>},
    {"left_out_of_beta", "", "left out of beta",
     "parameters that `beta_converged` leaves out, because on most devices the test does not determine them or the search box decides their value",
     get<&LawResult::left_out_of_beta>},
    {"reduced", "", "", "true: the law has a redundant parameter, and `beta_converged` was computed without it",
     get<&LawResult::reduced>},
    {"on_front_converged", "", "on front, converged",
     "true: no other law is at least as good in both `objective_converged` and `beta_converged`, and better in one of them",
     get<&LawResult::on_front_converged>},
    {"loo_objective", "-", "OF, device left out",
     "objective on a device if the law is fitted to all other devices, mean over the devices",
     get<&LawResult::loo_objective>},
    {"loo_worst", "-", "OF, worst device left out", "the largest objective on a device that was left out of the fit",
     get<&LawResult::loo_worst>},
    {"loo_worst_device", "", "worst device left out", "the device with the objective `loo_worst`",
     get<&LawResult::loo_worst_device>},
    {"on_front_loo", "", "on front, left out",
     "true: no other law is at least as good in both `objective_converged` and `loo_objective`, and better in one of them",
     get<&LawResult::on_front_loo>},
    {"larger_swings_objective", "-", "OF, larger swings",
     "objective on the large swings of a test if the law is fitted only to its small swings ([decision](decision.md)), mean over the devices whose tests allow this",
     get<&LawResult::larger_swings_objective>},
    {"larger_swings_least", "-", "OF, larger swings, least",
     "as `larger_swings_objective`, but if several fits to the small swings are equally good, the one that predicts best counts on each device",
     get<&LawResult::larger_swings_least>},
    {"larger_swings_worst", "-", "OF, larger swings, worst device",
     "the largest objective on the large swings of any device", get<&LawResult::larger_swings_worst>},
    {"tested_mm", "mm", "tested to", "largest displacement of the tests", beyond<&BeyondTests::tested_mm>},
    {"asked_mm", "mm", "asked for",
     "the displacement stated in the design values, but at least `tested_mm`; twice `tested_mm` if none is stated",
     beyond<&BeyondTests::asked_mm>},
    {"K_at_asked_kN_per_mm", "kN/mm", "stiffness there",
     "effective stiffness of the law in a steady cycle of amplitude `asked_mm`", beyond<&BeyondTests::K_kN_per_mm>},
    {"energy_at_asked_kN_mm", "kN mm", "energy there",
     "energy that the law dissipates in a steady cycle of amplitude `asked_mm`", beyond<&BeyondTests::energy_kN_mm>},
    {"stiffness_ratio", "-", "stiffness ratio",
     "effective stiffness of the law at `asked_mm`, divided by that at `tested_mm`",
     beyond<&BeyondTests::stiffness_ratio>},
    {"damping_ratio", "-", "damping ratio",
     "equivalent viscous damping of the law at `asked_mm`, divided by that at `tested_mm`",
     beyond<&BeyondTests::damping_ratio>},
    {"lot", "", "", "the law of the lot: one parameter vector for all devices", nested<LawResult>},
    {"population", "", "",
     "how the parameters of the law are distributed over all devices, as estimated from the tested ones",
     nested<LawResult>},
    {"fitted_objective", "-", "OF, blocks fitted",
     "objective on the blocks to which the law was fitted, mean over blocks and devices",
     get<&LawResult::fitted_objective>},
    {"predicted_objective", "-", "OF, blocks predicted",
     "objective on the blocks that the law had to predict, mean over blocks and devices",
     get<&LawResult::predicted_objective>},
    {"worst_predicted", "-", "", "the largest objective on a predicted block", get<&LawResult::worst_predicted>},
    {"prediction_collapses", "", "", "true if `prediction_grade` is `unusable`", get<&LawResult::prediction_unusable>},
    {"prediction_grade", "", "prediction",
     "how well the law predicts: `good`, `fair`, `poor` or `unusable`, from `predicted_objective` and the worst block ([decision](decision.md))",
     get<&LawResult::prediction_grade>},
    {"reduced_form", "", "",
     "the value of the option `--set` with which the law is fitted without its redundant parameter; empty if the law has none",
     get<&LawResult::reduced_form>},
};

inline constexpr Result<LotLaw> lot_law_results[]{
    {"parameters", "", "", "the parameters with the smallest mean objective over the devices: values by name",
     nested<LotLaw>},
    {"mean_objective", "-", "OF, law of the lot", "mean objective over the devices with `parameters`",
     get<&LotLaw::mean>},
    {"worst_objective", "-", "OF, law of the lot, worst device", "largest objective on any device with `parameters`",
     get<&LotLaw::worst>},
    {"worst_device", "", "worst device", "the device with the objective `worst_objective`", get<&LotLaw::worst_device>},
    {"least_worst_parameters", "", "",
     "the parameters with which the objective on the worst device is as small as possible: values by name",
     nested<LotLaw>},
    {"least_worst_objective", "-", "least OF of the worst device",
     "largest objective on any device with `least_worst_parameters`", get<&LotLaw::least_worst>},
    {"least_worst_bound", "-", "least possible where descents are global",
     "lower bound: with any parameters, the largest objective on any device is at least this value",
     get<&LotLaw::least_worst_bound>},
};

inline constexpr Result<DeviceFit> fit_results[]{
    {"name", "", "device", "name of the device", get<&DeviceFit::device>},
    {"objective", "-", "OF", "objective of the law on this device: statistics over the usable runs",
     get<&DeviceFit::objective>},
    {"objective_by_time", "-", "OF by time",
     "objective of the best run with all times counted alike, as in Eq. (27) of Cucuzza et al. 2025",
     get<&DeviceFit::objective_by_time>},
    {"K_eff_error_percent", "%", "K_eff error",
     "error of the effective stiffness: how much larger it is in the best fit than in the record, in percent of the record's value. Both are taken from the cycle that is named above the table",
     get<&DeviceFit::K_eff_error_percent>},
    {"energy_error_percent", "%", "energy error",
     "error of the dissipated energy: how much larger it is in the best fit than in the record, in percent of the record's value",
     get<&DeviceFit::energy_error_percent>},
    {"damping_error_percent", "%", "damping error",
     "error of the equivalent viscous damping: how much larger it is in the best fit than in the record, in percent of the record's value",
     get<&DeviceFit::damping_error_percent>},
    {"integration_shift", "-", "integration shift of OF",
     "estimate of how much the best objective would still change with a finer integration step",
     get<&DeviceFit::integration_shift>},
    {"parameters", "", "", "the parameters by name, in the law's order; empty if there is no fit", nested<DeviceFit>},
    {"counts", "", "counts",
     "false: the record is a copy of another device's, and statements about several devices leave it out",
     get<&DeviceFit::counts>},
    {"status", "", "status",
     "refused: the law does not apply to the record; failed: the law was tried, but no run was usable",
     get<fit_status>},
    {"message", "", "message",
     "why the law was refused, why its first failed run failed, or that no run has finished yet; empty otherwise",
     get<fit_message>},
    {"runs", "", "runs", "number of independent searches that have finished", get<&DeviceFit::runs>},
    {"failed_runs", "", "failed runs", "number of searches without a usable result", get<&DeviceFit::failed_runs>},
    {"evaluations", "", "evaluations",
     "number of parameter sets tried in all runs. A set that was tried on a third of the samples counts as a third of a set",
     get<&DeviceFit::evaluations>},
    {"failed_evaluations", "", "failed evaluations",
     "number of parameter sets that were passed over because they gave no finite force: the law is not defined there, or its force overflowed",
     get<&DeviceFit::failed_evaluations>},
    {"refinement", "", "", "integration steps per sample of the best run", get<&DeviceFit::refinement>},
    {"success_share", "-", "success share", "as `success_share` of `laws[]`, for the runs on this device",
     get<&DeviceFit::success_share>},
    {"success_reference", "", "", "what the runs were compared with, as in `laws[]`",
     get<&DeviceFit::success_reference>},
    {"optimum", "-", "least OF", "the smallest objective that any run or analysis found on this device",
     get<&DeviceFit::optimum>},
    {"rise", "-", "",
     "the limit for an equally good fit: a parameter value fits as well as the best one if the objective rises by no more than `rise`",
     get<&DeviceFit::rise>},
    {"trade_offs", "", "", "combinations of parameters that can change together while the loop hardly changes",
     get<&DeviceFit::trade_offs>},
    {"intervals", "", "",
     "the intervals of the parameters: `level`, scored `samples`, `block` (in samples), bootstrap `replicates`",
     nested<DeviceFit>},
    {"lot_objective", "-", "the lot, least mean", "objective on this device with `parameters` of the law of the lot",
     get<&DeviceFit::lot_objective>},
    {"worst_objective", "-", "the lot, least worst",
     "objective on this device with `least_worst_parameters` of the law of the lot", get<&DeviceFit::worst_objective>},
    {"left_out_objective", "-", "all other devices",
     "objective on this device if the law is fitted to all other devices", get<&DeviceFit::left_out_objective>},
    {"larger_swings_objective", "-", "larger swings",
     "objective on the large swings of the test if the law is fitted only to its small swings. If several fits to the small swings are equally good, the one that predicts worst counts",
     get<&DeviceFit::larger_swings_objective>},
    {"larger_swings_least", "-", "larger swings, least",
     "as `larger_swings_objective`, but if several fits to the small swings are equally good, the one that predicts best counts",
     get<&DeviceFit::larger_swings_least>},
    {"springs_objective", "-", "as springs",
     "objective on the test if springs around a circle, with parameters fitted to the test, replace the law (option `--bidirectional springs`). `isolaw building` uses these springs",
     get<&DeviceFit::springs_objective>},
    {"springs_given_objective", "-", "as springs, given",
     "objective on the test if springs around a circle, with the parameters of the law itself, replace the law",
     get<&DeviceFit::springs_given_objective>},
    {"blocks", "", "",
     "`block`, `fitted` (false: predicted) and `objective` of each block; empty if no block is predicted",
     nested<DeviceFit>},
    {"tests", "", "",
     "one object for each test of a device that has several: `test` (its name), `objective`, `K_eff_error_percent`, `energy_error_percent` and `damping_error_percent`. The device itself has their mean objective and their largest errors",
     nested<DeviceFit>},
    {"measured_energy_fall_percent", "%", "energy lost, measured",
     "how much less energy the device dissipates in the last counted cycle of a block than in the third, in the block where it loses most",
     get<measured_energy_fall>},
    {"energy_fall_percent", "%", "energy lost, law",
     "how much less energy the law dissipates in the last counted cycle than in the third, in the block of `measured_energy_fall_percent`",
     get<energy_fall_of_law>},
};

inline constexpr Result<TestFit> test_results[]{
    {"test", "", "test", "name of the test", get<&TestFit::test>},
    {"objective", "-", "OF", "objective on this test", get<&TestFit::objective>},
    {"K_eff_error_percent", "%", "K_eff error", "error of the effective stiffness on this test",
     get<&TestFit::K_eff_error_percent>},
    {"energy_error_percent", "%", "energy error", "error of the dissipated energy on this test",
     get<&TestFit::energy_error_percent>},
    {"damping_error_percent", "%", "damping error", "error of the equivalent viscous damping on this test",
     get<&TestFit::damping_error_percent>},
};

inline constexpr Result<BlockScore> score_results[]{
    {"block", "", "block", "number of the block", get<&BlockScore::block>},
    {"fitted", "", "fitted", "true: the law was fitted to this block; false: it predicted it",
     get<&BlockScore::fitted>},
    {"objective", "-", "OF", "objective on this block", get<&BlockScore::objective>},
};

inline constexpr Result<DeviceFit> interval_results[]{
    {"level", "-", "", "confidence level", get<&DeviceFit::interval_level>},
    {"samples", "", "", "number of samples by which the law was judged", get<&DeviceFit::interval_samples>},
    {"block", "", "", "length, in samples, of the stretches that the bootstrap draws", get<&DeviceFit::interval_block>},
    {"replicates", "", "", "number of bootstrap fits", get<&DeviceFit::interval_replicates>},
};

inline constexpr Result<ParameterFit> parameter_results[]{
    {"unit", "", "unit", "unit of `mean`, `std`, `best`, `lower` and `upper`, in the unit system of the law",
     get<&ParameterFit::unit>},
    {"mean", own_unit, "mean", "mean over the usable runs", get<&ParameterFit::value, &Statistic::mean>},
    {"std", own_unit, "std", "standard deviation over the usable runs (divisor n - 1); 0 for a fixed parameter",
     get<&ParameterFit::value, &Statistic::std>},
    {"best", own_unit, "best", "value in the run with the smallest objective",
     get<&ParameterFit::value, &Statistic::best>},
    {"at_bound", "", "at bound",
     "the bound of the search box to which `best` lies closer than 0.1 % of the width of the box. The box, not the record, then decided the value",
     [](ParameterFit const& fit) { return fit.at_bound == fit::AtBound::no ? Value() : value_of(fit.at_bound); }},
    {"free", "", "calibrated", "true: the parameter was searched; false: it was fixed, by default or by the user",
     get<&ParameterFit::free>},
    {"lower", own_unit, "lower bound",
     "lower bound of the search; for a fixed parameter its value or the bound that the law declares",
     get<&ParameterFit::lower>},
    {"upper", own_unit, "upper bound",
     "upper bound of the search; for a fixed parameter its value or the bound that the law declares",
     get<&ParameterFit::upper>},
    {"percent_of_lot", "%", "difference from lot",
     "difference of `mean` on this device from the mean of `mean` over the devices, in percent of the latter; positive if the value on this device is farther from zero",
     get<&ParameterFit::percent_of_lot>},
    {"tied_to", "", "", "the parameter whose value this one takes (option `--set`)", word<&ParameterFit::tied_to>},
    {"paper_name", "", "in the paper", "name of the parameter in Tables 4 and A.5 of Cucuzza et al. 2025",
     word<&ParameterFit::paper_name>},
};

inline constexpr Result<ParameterAnalysis> analysis_results[]{
    {"identifiability", "", "identifiability",
     "how well the test determines the parameter, in the words above. If this is null, the keys below are absent",
     get<&ParameterAnalysis::identifiability>},
    {"optimum", own_unit, "optimum", "value of the parameter at the smallest objective",
     get<&ParameterAnalysis::optimum>},
    {"open_range",
     own_unit,
     "open range",
     "the values that fit as well as the best one: the objective rises by no more than `rise` if the parameter has such a value and the others are fitted again",
     ends<&ParameterAnalysis::open_lower, &ParameterAnalysis::open_upper>,
     {},
     6},
    {"open_below", "", "range ends at the box below", "true: `open_range` reaches the lower bound of the search",
     get<&ParameterAnalysis::open_below>},
    {"open_above", "", "range ends at the box above", "true: `open_range` reaches the upper bound of the search",
     get<&ParameterAnalysis::open_above>},
    {"linear_interval",
     own_unit,
     "linear interval",
     "confidence interval of `intervals.level` by linearisation; for a parameter at its bound, both ends are that bound",
     ends<&ParameterAnalysis::linear_lower, &ParameterAnalysis::linear_upper>,
     {},
     6},
    {"bootstrap_interval",
     own_unit,
     "bootstrap interval",
     "confidence interval of `intervals.level` by the bootstrap",
     ends<&ParameterAnalysis::bootstrap_lower, &ParameterAnalysis::bootstrap_upper>,
     {},
     6},
    {"profile",
     "",
     "",
     "`value`, `objective`: the values at which the parameter was held, and the smallest objective when the other parameters were fitted again",
     nested<ParameterAnalysis>,
     {},
     6},
};

inline constexpr Result<OutlyingDevice> outlier_results[]{
    {"device", "", "device", "name of the device", get<&OutlyingDevice::device>},
    {"property", "", "property", "the property by which the device stands apart", get<&OutlyingDevice::property>},
    {"unit", "", "unit", "unit of `value` and `median`", get<&OutlyingDevice::unit>},
    {"value", own_unit, "value", "value of the property on this device", get<&OutlyingDevice::value>},
    {"median", own_unit, "median", "median of the property over the devices", get<&OutlyingDevice::median>},
    {"score", "-", "score", "modified z-score of `value`", get<&OutlyingDevice::score>},
    {"percent", "%", "difference", "difference of `value` from `median`, in percent of `median`",
     get<&OutlyingDevice::percent>},
};

// Selects rows by keys, in the order of `keys`. "key: heading" changes the heading. An unknown key does not compile.
template <class Object, std::size_t all, std::size_t count>
consteval std::array<Result<Object>, count> columns(Result<Object> const (&rows)[all],
                                                    std::string_view const (&keys)[count]) {
  std::array<Result<Object>, count> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    auto const colon = keys[i].find(": ");
    std::size_t row = 0;
    while (rows[row].key != keys[i].substr(0, colon)) ++row;
    chosen[i] = rows[row];
    if (colon != std::string_view::npos) chosen[i].heading = keys[i].substr(colon + 2);
  }
  return chosen;
}

// The heading of one column. A row has one column for each number of its value: three for a Statistic.
struct Heading {
  std::string title, unit;   // unit: empty if the row has no fixed unit
  std::string text() const;  // "title [unit]"
};
std::vector<Heading> headings(std::string_view heading, std::string_view unit, Value const& example);
template <class Object>
std::vector<Heading> headings(Result<Object> const& row) {
  if constexpr (std::default_initializable<Object>)
    return headings(row.heading, row.unit, row.value(Object{}));
  else
    return headings(row.heading, row.unit, {});
}

}  // namespace isolaw::study
