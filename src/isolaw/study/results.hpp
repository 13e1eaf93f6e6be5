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

// Stands in place of a unit that differs between objects, such as a parameter's; another row gives that unit.
inline constexpr std::string_view own_unit = "its own";

struct Printed {
  std::optional<int> decimals, significant;
};
constexpr Printed decimals(int count) {
  return {.decimals = count, .significant = {}};
}
constexpr Printed significant(int count) {
  return {.decimals = {}, .significant = count};
}

template <class Object>
struct Result {
  // unit: "-" for a number without a unit, "" for other values. heading: "" if no table and no page shows the result.
  std::string_view key, unit, heading, meaning;
  Value (*of)(Object const&) = nullptr;
  Printed printed{};
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
  return law.beyond ? value_of((*law.beyond).*member) : Value();
}

inline constexpr Result<LawResult> law_results[]{
    {"id", "", "law", "short name, as on the command line", get<&LawResult::id>},
    {"objective", "-", "OF",
     "`mean`: mean of the device means; `std`, `best`: standard deviation and smallest value over all devices and runs",
     get<&LawResult::objective>},
    {"beta", "-", "beta",
     "robustness index, Eq. (31) of Cucuzza et al. 2025: mean over the calibrated parameters of the largest relative difference of a device from the lot's mean; smaller is more robust",
     get<&LawResult::beta>},
    {"on_front", "", "on front",
     "true: no other law is at least as good in both `objective.mean` and `beta`, and better in one",
     get<&LawResult::on_front>},
    {"devices", "", "", "the fits: one object for each device the law was tried on", nested<LawResult>},
    {"beta_note", "", "note", "why `beta` is null; empty otherwise", get<&LawResult::beta_note>},
    {"name", "", "", "common name: `\"Abe (constant yield)\"`",
     [](LawResult const& law) { return value_of(laws::called(law.id)); }},
    {"title", "", "", "longer name that says what kind of law it is", get<&LawResult::title>},
    {"notes", "", "", "how isolaw reads the law's source where the source is incomplete", get<&LawResult::notes>},
    {"success_share", "-", "success share",
     "share (0 to 1) of the usable runs that ended within 0.1 % of the least objective that the campaign found, in runs or analysis",
     get<&LawResult::success_share>},
    {"success_reference", "", "success refers to",
     "where that least objective comes from: best of this campaign; empty where `success_share` is null",
     get<&LawResult::success_reference>},
    {"objective_converged", "-", "mean least OF", "mean over the devices of their least objectives (`optimum`)",
     get<&LawResult::objective_converged>},
    {"beta_converged", "-", "beta, converged", "`beta` from the least objectives; undetermined parameters are left out",
     get<&LawResult::beta_converged>},
    {"beta_converged_note", "", "note", "why `beta_converged` is null; empty otherwise",
     get<&LawResult::beta_converged_note>},
    {"left_out_of_beta", "", "left out of beta", "parameters that most devices leave undetermined or whose box decides",
     get<&LawResult::left_out_of_beta>},
    {"reduced", "", "", "`beta_converged` was computed without the redundant parameter", get<&LawResult::reduced>},
    {"on_front_converged", "", "on front, converged",
     "the law is on the front of `objective_converged` against `beta_converged`", get<&LawResult::on_front_converged>},
    {"loo_objective", "-", "OF, device left out",
     "objective on a device with the law fitted to all others, mean over the devices", get<&LawResult::loo_objective>},
    {"loo_worst", "-", "OF, worst device left out", "the largest of these objectives", get<&LawResult::loo_worst>},
    {"loo_worst_device", "", "worst device left out", "the device that has it", get<&LawResult::loo_worst_device>},
    {"on_front_loo", "", "on front, left out",
     "the law is on the front of `objective_converged` against `loo_objective`", get<&LawResult::on_front_loo>},
    {"larger_swings_objective", "-", "OF, larger swings",
     "objective on the large swings of a test with the law fitted to its small ones ([decision](decision.md)), mean over the devices whose tests tell",
     get<&LawResult::larger_swings_objective>},
    {"larger_swings_least", "-", "OF, larger swings, least",
     "the same with the fit that predicts best among equally good fits", get<&LawResult::larger_swings_least>},
    {"larger_swings_worst", "-", "OF, larger swings, worst device", "largest of any device",
     get<&LawResult::larger_swings_worst>},
    {"tested_mm", "mm", "tested to", "largest displacement of the tests", beyond<&BeyondTests::tested_mm>},
    {"asked_mm", "mm", "asked for",
     "displacement of the design, at least `tested_mm`; twice `tested_mm` if none is stated. The four keys below are of steady cycles with it",
     beyond<&BeyondTests::asked_mm>},
    {"K_at_asked_kN_per_mm", "kN/mm", "stiffness there", "stiffness of the law", beyond<&BeyondTests::K_kN_per_mm>},
    {"energy_at_asked_kN_mm", "kN mm", "energy there", "energy of a cycle", beyond<&BeyondTests::energy_kN_mm>},
    {"stiffness_ratio", "-", "stiffness ratio", "stiffness there over that at `tested_mm`",
     beyond<&BeyondTests::stiffness_ratio>},
    {"damping_ratio", "-", "damping ratio", "damping there over that at `tested_mm`",
     beyond<&BeyondTests::damping_ratio>},
    {"lot", "", "", "the law of the lot: one parameter vector for all devices", nested<LawResult>},
    {"population", "", "", "the population that the devices come from, as estimated", nested<LawResult>},
    {"fitted_objective", "-", "OF, blocks fitted", "objective on the blocks fitted, mean over blocks and devices",
     get<&LawResult::fitted_objective>},
    {"predicted_objective", "-", "OF, blocks predicted",
     "objective on the blocks predicted, mean over blocks and devices", get<&LawResult::predicted_objective>},
    {"worst_predicted", "-", "", "the largest objective on a predicted block", get<&LawResult::worst_predicted>},
    {"prediction_collapses", "", "", "`prediction_grade` is `unusable`", get<&LawResult::prediction_unusable>},
    {"prediction_grade", "", "prediction",
     "`good`, `fair`, `poor` or `unusable`, from `predicted_objective` and the worst block: [decision](decision.md)",
     get<&LawResult::prediction_grade>},
    {"reduced_form", "", "",
     "the `--set` that fits the form without the redundant parameter; empty where there is none to offer",
     get<&LawResult::reduced_form>},
};

inline constexpr Result<LotLaw> lot_law_results[]{
    {"parameters", "", "", "their values by name", nested<LotLaw>},
    {"mean_objective", "-", "OF, law of the lot", "least mean objective over the devices", get<&LotLaw::mean>},
    {"worst_objective", "-", "OF, law of the lot, worst device", "largest of any device", get<&LotLaw::worst>},
    {"worst_device", "", "worst device", "that device", get<&LotLaw::worst_device>},
    {"least_worst_parameters", "", "", "values of the law that is least bad for the worst device", nested<LotLaw>},
    {"least_worst_objective", "-", "least OF of the worst device", "objective of that law on the worst device",
     get<&LotLaw::least_worst>},
    {"least_worst_bound", "-", "least possible where descents are global",
     "lower limit: no parameters give less on the worst device", get<&LotLaw::least_worst_bound>},
};

inline constexpr Result<DeviceFit> fit_results[]{
    {"name", "", "device", "name of the device", get<&DeviceFit::device>},
    {"objective", "-", "OF", "statistics over the usable runs", get<&DeviceFit::objective>},
    {"objective_by_time", "-", "OF by time", "mean over time, Eq. (27) of Cucuzza et al. 2025, of the best run",
     get<&DeviceFit::objective_by_time>},
    {"K_eff_error_percent", "%", "K_eff error",
     "error of the effective stiffness: that of the best fit less that of the record it was fitted to, relative to the record, on the reported cycle; where part of the record is scored (`fit-blocks`, `fit-cycles`), on that part's third counted cycle, or its last, in the block of largest amplitude; without a counted cycle, on the largest swings",
     get<&DeviceFit::K_eff_error_percent>},
    {"energy_error_percent", "%", "energy error", "the same error for the dissipated energy",
     get<&DeviceFit::energy_error_percent>},
    {"damping_error_percent", "%", "damping error", "the same error for the equivalent viscous damping",
     get<&DeviceFit::damping_error_percent>},
    {"integration_shift", "-", "integration shift of OF",
     "estimate of how far a finer integration step would still move the best objective",
     get<&DeviceFit::integration_shift>},
    {"parameters", "", "", "the parameters by name, in the law's order; empty when there is no fit", nested<DeviceFit>},
    {"counts", "", "counts",
     "false: the record is a copy of another device's, and all that is said of several devices leaves it out",
     get<&DeviceFit::counts>},
    {"status", "", "status",
     "refused: the law does not apply to the record; failed: it was tried, but no run was usable", get<fit_status>},
    {"message", "", "message",
     "why it was refused, the reason of the first failed run, or that no run has finished yet; empty otherwise",
     get<fit_message>},
    {"runs", "", "runs", "independent searches that have finished", get<&DeviceFit::runs>},
    {"failed_runs", "", "failed runs", "searches without a usable result", get<&DeviceFit::failed_runs>},
    {"evaluations", "", "evaluations",
     "parameter sets tried in all runs; one tried on a share of the samples counts as that share",
     get<&DeviceFit::evaluations>},
    {"failed_evaluations", "", "failed evaluations",
     "parameter sets that were passed over, since they gave no finite force (the law has none there, or it overflowed)",
     get<&DeviceFit::failed_evaluations>},
    {"refinement", "", "", "integration steps per sample of the best run", get<&DeviceFit::refinement>},
    {"success_share", "-", "success share", "as for the law", get<&DeviceFit::success_share>},
    {"success_reference", "", "", "as for the law", get<&DeviceFit::success_reference>},
    {"optimum", "-", "least OF", "least objective of runs and analysis", get<&DeviceFit::optimum>},
    {"rise", "-", "", "how far the objective may rise within an open range", get<&DeviceFit::rise>},
    {"trade_offs", "", "", "parameters that can change together without the loop showing it",
     get<&DeviceFit::trade_offs>},
    {"intervals", "", "", "`level`, scored `samples`, `block` (in samples), bootstrap `replicates`", nested<DeviceFit>},
    {"lot_objective", "-", "the lot, least mean", "objective on this device with the lot's law of least mean",
     get<&DeviceFit::lot_objective>},
    {"worst_objective", "-", "the lot, least worst",
     "objective on this device with the lot's law that is least bad for the worst", get<&DeviceFit::worst_objective>},
    {"left_out_objective", "-", "all other devices", "objective on this device with the law fitted to all others",
     get<&DeviceFit::left_out_objective>},
    {"larger_swings_objective", "-", "larger swings",
     "objective on the large swings of the test with the law fitted to its small ones: the largest among equally good fits",
     get<&DeviceFit::larger_swings_objective>},
    {"larger_swings_least", "-", "larger swings, least", "the least among these fits",
     get<&DeviceFit::larger_swings_least>},
    {"springs_objective", "-", "as springs",
     "objective along the test of springs around the circle, fitted as such (`bidirectional`); buildings use these springs",
     get<&DeviceFit::springs_objective>},
    {"springs_given_objective", "-", "as springs, given", "the same for springs that have the law's own parameters",
     get<&DeviceFit::springs_given_objective>},
    {"blocks", "", "", "`block`, `fitted` (false: predicted), `objective`; only where blocks are predicted",
     nested<DeviceFit>},
    {"tests", "", "",
     "`test` (its name), `objective`, `K_eff_error_percent`, `energy_error_percent` and `damping_error_percent` of each of the device's tests; the device has their mean objective and their largest errors; empty where it has one test",
     nested<DeviceFit>},
    {"measured_energy_fall_percent", "%", "energy lost, measured",
     "measured loss of energy per cycle, from the third counted cycle to the last, in the block that loses most; only where it falls steadily by a tenth or more through eight cycles or more",
     get<measured_energy_fall>},
    {"energy_fall_percent", "%", "energy lost, law", "the same loss by the law", get<energy_fall_of_law>},
};

inline constexpr Result<TestFit> test_results[]{
    {"test", "", "test", "by its name", get<&TestFit::test>},
    {"objective", "-", "OF", "on this test", get<&TestFit::objective>},
    {"K_eff_error_percent", "%", "K_eff error", "as for the device", get<&TestFit::K_eff_error_percent>},
    {"energy_error_percent", "%", "energy error", "the same for the dissipated energy",
     get<&TestFit::energy_error_percent>},
    {"damping_error_percent", "%", "damping error", "the same for the damping", get<&TestFit::damping_error_percent>},
};

inline constexpr Result<BlockScore> score_results[]{
    {"block", "", "block", "by its number", get<&BlockScore::block>},
    {"fitted", "", "fitted", "false: predicted", get<&BlockScore::fitted>},
    {"objective", "-", "OF", "on this block", get<&BlockScore::objective>},
};

inline constexpr Result<DeviceFit> interval_results[]{
    {"level", "-", "", "confidence", get<&DeviceFit::interval_level>},
    {"samples", "", "", "that were judged", get<&DeviceFit::interval_samples>},
    {"block", "", "", "length in samples", get<&DeviceFit::interval_block>},
    {"replicates", "", "", "of the bootstrap", get<&DeviceFit::interval_replicates>},
};

inline constexpr Result<ParameterFit> parameter_results[]{
    {"unit", "", "unit", "unit of `mean`, `std`, `best`, `lower`, `upper`, in the unit system of the law's source",
     get<&ParameterFit::unit>},
    {"mean", own_unit, "mean", "mean over the usable runs", get<&ParameterFit::value, &Statistic::mean>},
    {"std", own_unit, "std", "standard deviation over the usable runs, sample form; 0 for a fixed parameter",
     get<&ParameterFit::value, &Statistic::std>},
    {"best", own_unit, "best", "value in the run of least objective", get<&ParameterFit::value, &Statistic::best>},
    {"at_bound", "", "at bound",
     "`best` lies within 0.1 % of the search box's width of this bound: the box, not the record, decided the value",
     [](ParameterFit const& fit) { return fit.at_bound == fit::AtBound::no ? Value() : value_of(fit.at_bound); }},
    {"free", "", "calibrated", "false: fixed by default or by the user, not calibrated", get<&ParameterFit::free>},
    {"lower", own_unit, "lower bound", "lower end of the box; of a fixed parameter its value, or as declared",
     get<&ParameterFit::lower>},
    {"upper", own_unit, "upper bound", "upper end, likewise", get<&ParameterFit::upper>},
    {"percent_of_lot", "%", "difference from lot",
     "difference of `mean` from the mean of the device means, relative to the magnitude that `beta` uses",
     get<&ParameterFit::percent_of_lot>},
    {"tied_to", "", "", "the parameter whose value this one takes", word<&ParameterFit::tied_to>},
    {"paper_name", "", "in the paper", "its name in Tables 4 and A.5 of Cucuzza et al. 2025",
     word<&ParameterFit::paper_name>},
};

inline constexpr Result<ParameterAnalysis> analysis_results[]{
    {"identifiability", "", "identifiability", "the verdict; without it the keys below are absent",
     get<&ParameterAnalysis::identifiability>},
    {"optimum", own_unit, "optimum", "value at the least objective", get<&ParameterAnalysis::optimum>},
    {"open_range",
     own_unit,
     "open range",
     "values at which the objective, all others fitted again, rises by no more than `rise`",
     ends<&ParameterAnalysis::open_lower, &ParameterAnalysis::open_upper>,
     {},
     6},
    {"open_below", "", "range ends at the box below", "the range reaches the lower end of the box",
     get<&ParameterAnalysis::open_below>},
    {"open_above", "", "range ends at the box above", "and its upper end", get<&ParameterAnalysis::open_above>},
    {"linear_interval",
     own_unit,
     "linear interval",
     "linearised interval of `intervals.level`; of a parameter at its bound that one value",
     ends<&ParameterAnalysis::linear_lower, &ParameterAnalysis::linear_upper>,
     {},
     6},
    {"bootstrap_interval",
     own_unit,
     "bootstrap interval",
     "the same by the bootstrap",
     ends<&ParameterAnalysis::bootstrap_lower, &ParameterAnalysis::bootstrap_upper>,
     {},
     6},
    {"profile",
     "",
     "",
     "`value`, `objective`: least objective with the parameter held at each value",
     nested<ParameterAnalysis>,
     {},
     6},
};

inline constexpr Result<OutlyingDevice> outlier_results[]{
    {"device", "", "device", "name of the device", get<&OutlyingDevice::device>},
    {"property", "", "property", "the property by which it stands apart", get<&OutlyingDevice::property>},
    {"unit", "", "unit", "unit of `value` and `median`", get<&OutlyingDevice::unit>},
    {"value", own_unit, "value", "value on this device", get<&OutlyingDevice::value>},
    {"median", own_unit, "median", "median over the devices", get<&OutlyingDevice::median>},
    {"score", "-", "score", "modified z-score", get<&OutlyingDevice::score>},
    {"percent", "%", "difference", "difference from the median", get<&OutlyingDevice::percent>},
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
    return headings(row.heading, row.unit, row.of(Object{}));
  else
    return headings(row.heading, row.unit, {});
}

}  // namespace isolaw::study
