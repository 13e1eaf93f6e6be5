// Every result under one name: its key in JSON, its unit, its heading in tables, what it means. summary.json, the data
// of the page and the tables are written from these rows, in their order; docs/summary-json.md is checked against them.
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
struct Nested {};  // an object or array of its own, which the renderer writes

using Value = std::variant<std::monostate, bool, int, std::uint64_t, double, std::string_view,
                           std::vector<std::string> const*, Statistic, Ends, Nested>;  // monostate: undefined

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

// Through members, or functions of the object: get<&ParameterFit::value, &Statistic::mean>.
template <auto first, auto... rest, class Of>
Value get(Of const& of) {
  if constexpr (sizeof...(rest) > 0)
    return get<rest...>(std::invoke(first, of));
  else
    return value_of(std::invoke(first, of));
}
template <auto lower, auto upper, class Of>
Value ends(Of const& of) {
  return Ends{of.*lower, of.*upper};
}
// A word that is undefined where it is empty.
template <auto member, class Of>
Value word(Of const& of) {
  return (of.*member).empty() ? Value() : value_of(of.*member);
}
template <class Of>
Value nested(Of const&) {
  return Nested{};
}

// Of a parameter: stated beside it.
inline constexpr std::string_view own_unit = "its own";

// How the page's tables print a number.
struct Printed {
  std::optional<int> decimals, significant;
};
constexpr Printed decimals(int count) {
  return {.decimals = count, .significant = {}};
}
constexpr Printed significant(int count) {
  return {.decimals = {}, .significant = count};
}

template <class Of>
struct Result {
  // unit: "-" of a number without one, "" of what is none; heading: "" of what no table holds, the page's among them.
  std::string_view key, unit, heading, meaning;
  Value (*of)(Of const&) = nullptr;
  Printed printed{};
  int digits = 9;  // significant ones in the page's data, where numbers are drawn rather than computed with
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

inline constexpr Result<LawResult> law_results[]{
    {"id", "", "law", "short name, as on the command line", get<&LawResult::id>},
    {"objective", "-", "OF",
     "`mean`: of the device means; `std`, `best`: standard deviation and smallest value over devices and runs",
     get<&LawResult::objective>},
    {"beta", "-", "beta",
     "robustness index, Eq. (31) of Cucuzza et al. 2025: mean over the calibrated parameters of the largest relative difference of a device from the lot's mean; smaller is more robust",
     get<&LawResult::beta>},
    {"on_front", "", "on front",
     "no other law is at least as good in both `objective.mean` and `beta` and better in one",
     get<&LawResult::on_front>},
    {"devices", "", "", "the fits, one object per device the law was tried on", nested<LawResult>},
    {"beta_note", "", "note", "why `beta` is null; empty otherwise", get<&LawResult::beta_note>},
    {"name", "", "", "as people call the law: `\"Abe (constant yield)\"`",
     [](LawResult const& law) { return value_of(laws::called(law.id)); }},
    {"title", "", "", "of the law", get<&LawResult::title>},
    {"notes", "", "", "how its source was read where it is incomplete", get<&LawResult::notes>},
    {"success_share", "-", "success share",
     "usable runs that ended within 0.1 % of the least objective of the campaign (of its runs and their analysis), 0 to 1",
     get<&LawResult::success_share>},
    {"success_reference", "", "success refers to",
     "whose objective that is: best of this campaign; empty where `success_share` is null",
     get<&LawResult::success_reference>},
    {"objective_converged", "-", "mean least OF", "mean over devices of the least objectives (`optimum`)",
     get<&LawResult::objective_converged>},
    {"beta_converged", "-", "beta, converged",
     "`beta` from the least objectives, without what the tests do not determine", get<&LawResult::beta_converged>},
    {"beta_converged_note", "", "note", "why `beta_converged` is null; empty otherwise",
     get<&LawResult::beta_converged_note>},
    {"left_out_of_beta", "", "left out of beta", "parameters that most devices leave undetermined or whose box decides",
     get<&LawResult::left_out_of_beta>},
    {"reduced", "", "", "`beta_converged` is of the form without the redundant parameter", get<&LawResult::reduced>},
    {"on_front_converged", "", "on front, converged", "front of `objective_converged` against `beta_converged`",
     get<&LawResult::on_front_converged>},
    {"loo_objective", "-", "OF, device left out",
     "objective on a device by the law of all others: mean over the devices", get<&LawResult::loo_objective>},
    {"loo_worst", "-", "OF, worst device left out", "the largest of these", get<&LawResult::loo_worst>},
    {"loo_worst_device", "", "worst device left out", "where it is", get<&LawResult::loo_worst_device>},
    {"on_front_loo", "", "on front, left out", "front of `objective_converged` against `loo_objective`",
     get<&LawResult::on_front_loo>},
    {"lot", "", "", "one parameter vector for all devices", nested<LawResult>},
    {"population", "", "", "that the devices were drawn from", nested<LawResult>},
    {"fitted_objective", "-", "OF, blocks fitted", "mean over the blocks the law was fitted to and the devices",
     get<&LawResult::fitted_objective>},
    {"predicted_objective", "-", "OF, blocks predicted", "mean over the blocks it was not fitted to and the devices",
     get<&LawResult::predicted_objective>},
    {"worst_predicted", "-", "", "the largest of these", get<&LawResult::worst_predicted>},
    {"prediction_collapses", "", "", "`prediction_grade` is unusable", get<&LawResult::prediction_unusable>},
    {"prediction_grade", "", "prediction",
     "`good`, `fair`, `poor` or `unusable`, by `predicted_objective` and the worst block: [decision](decision.md)",
     get<&LawResult::prediction_grade>},
    {"reduced_form", "", "",
     "the `--set` that searches the form without the redundant parameter; empty where there is none",
     get<&LawResult::reduced_form>},
};

inline constexpr Result<LotLaw> lot_law_results[]{
    {"parameters", "", "", "by name", nested<LotLaw>},
    {"mean_objective", "-", "OF, law of the lot", "mean over the devices: the least there is", get<&LotLaw::mean>},
    {"worst_objective", "-", "OF, law of the lot, worst device", "the largest", get<&LotLaw::worst>},
    {"worst_device", "", "worst device", "where it is", get<&LotLaw::worst_device>},
    {"least_worst_parameters", "", "", "of the law that is least bad for the worst device", nested<LotLaw>},
    {"least_worst_objective", "-", "least OF of the worst device", "with it, on the worst device",
     get<&LotLaw::least_worst>},
    {"least_worst_bound", "-", "least possible where descents are global", "below which no law can go",
     get<&LotLaw::least_worst_bound>},
};

inline constexpr Result<DeviceFit> fit_results[]{
    {"name", "", "device", "of the device", get<&DeviceFit::device>},
    {"objective", "-", "OF", "over the usable runs", get<&DeviceFit::objective>},
    {"K_eff_error_percent", "%", "K_eff error",
     "effective stiffness of the best fit less that of the record it was fitted to, relative to the latter, on the reported cycle; where laws are judged by a part of the record (`fit-blocks`, `fit-cycles`), on the third counted cycle within that part, or its last, of the block of largest amplitude",
     get<&DeviceFit::K_eff_error_percent>},
    {"energy_error_percent", "%", "energy error", "the same for the dissipated energy",
     get<&DeviceFit::energy_error_percent>},
    {"damping_error_percent", "%", "damping error", "the same for the equivalent viscous damping",
     get<&DeviceFit::damping_error_percent>},
    {"integration_shift", "-", "integration shift of OF",
     "estimate of how far a finer integration step would still move the best objective",
     get<&DeviceFit::integration_shift>},
    {"parameters", "", "", "by name, in the law's order; empty when there is no fit", nested<DeviceFit>},
    {"status", "", "status",
     "refused: the law does not apply to the record; failed: it was tried, and no run was usable", get<fit_status>},
    {"message", "", "message",
     "why it was refused, the reason of the first failed run, or that no run has finished yet; empty otherwise",
     get<fit_message>},
    {"runs", "", "runs", "independent searches that have finished", get<&DeviceFit::runs>},
    {"failed_runs", "", "failed runs", "those without a usable result", get<&DeviceFit::failed_runs>},
    {"evaluations", "", "evaluations",
     "parameter sets tried in all runs; one tried on a share of the samples counts as that share",
     get<&DeviceFit::evaluations>},
    {"failed_evaluations", "", "failed evaluations",
     "those that gave no finite force (the law has none there, or it overflowed) and were passed over",
     get<&DeviceFit::failed_evaluations>},
    {"refinement", "", "", "integration steps per sample of the best run", get<&DeviceFit::refinement>},
    {"success_share", "-", "success share", "as of the law", get<&DeviceFit::success_share>},
    {"success_reference", "", "", "as of the law", get<&DeviceFit::success_reference>},
    {"optimum", "-", "least OF", "least objective", get<&DeviceFit::optimum>},
    {"rise", "-", "", "of the objective, by which open ranges are judged", get<&DeviceFit::rise>},
    {"trade_offs", "", "", "parameters that can change together without the loop showing it",
     get<&DeviceFit::trade_offs>},
    {"intervals", "", "", "`level`, `samples`, `block` (length in samples), `replicates`", nested<DeviceFit>},
    {"lot_objective", "-", "the lot, least mean", "on this device by the lot's law of least mean",
     get<&DeviceFit::lot_objective>},
    {"worst_objective", "-", "the lot, least worst", "on this device by the lot's law that is least bad for the worst",
     get<&DeviceFit::worst_objective>},
    {"left_out_objective", "-", "all other devices", "on this device by the law of all others",
     get<&DeviceFit::left_out_objective>},
    {"springs_objective", "-", "as springs",
     "as springs around the circle, fitted as such (`bidirectional`), along the test; buildings take them",
     get<&DeviceFit::springs_objective>},
    {"springs_given_objective", "-", "as springs, given", "the same with the parameters of the law",
     get<&DeviceFit::springs_given_objective>},
    {"blocks", "", "", "`block`, `fitted` (false: predicted), `objective`; only where blocks are predicted",
     nested<DeviceFit>},
    {"measured_energy_fall_percent", "%", "energy lost, measured",
     "of the energy of a cycle, from the third counted to the last of the block that loses most, where it falls steadily by a tenth or more through eight cycles or more",
     get<measured_energy_fall>},
    {"energy_fall_percent", "%", "energy lost, law", "the same of the law's energy", get<energy_fall_of_law>},
};

// What `blocks` of a fit holds.
inline constexpr Result<BlockScore> score_results[]{
    {"block", "", "block", "by its number", get<&BlockScore::block>},
    {"fitted", "", "fitted", "false: predicted", get<&BlockScore::fitted>},
    {"objective", "-", "OF", "on this block", get<&BlockScore::objective>},
};

// What `intervals` of a fit holds.
inline constexpr Result<DeviceFit> interval_results[]{
    {"level", "-", "", "confidence", get<&DeviceFit::interval_level>},
    {"samples", "", "", "that were judged", get<&DeviceFit::interval_samples>},
    {"block", "", "", "length in samples", get<&DeviceFit::interval_block>},
    {"replicates", "", "", "of the bootstrap", get<&DeviceFit::interval_replicates>},
};

inline constexpr Result<ParameterFit> parameter_results[]{
    {"unit", "", "unit", "of `mean`, `std`, `best`, `lower`, `upper`: the unit system of the law's source",
     get<&ParameterFit::unit>},
    {"mean", own_unit, "mean", "over the usable runs", get<&ParameterFit::value, &Statistic::mean>},
    {"std", own_unit, "std", "over the usable runs, sample form; 0 for a fixed parameter",
     get<&ParameterFit::value, &Statistic::std>},
    {"best", own_unit, "best", "of the run with the smallest objective", get<&ParameterFit::value, &Statistic::best>},
    {"at_bound", "", "at bound",
     "`best` lies within 0.1 % of the search box's width of that bound: the box, not the record, decided the value",
     [](ParameterFit const& fit) { return fit.at_bound == fit::AtBound::no ? Value() : value_of(fit.at_bound); }},
    {"free", "", "calibrated", "false: fixed by default or by the user, not calibrated", get<&ParameterFit::free>},
    {"lower", own_unit, "lower bound", "of the search box; the value of a fixed parameter, or as the law declares it",
     get<&ParameterFit::lower>},
    {"upper", own_unit, "upper bound", "the same", get<&ParameterFit::upper>},
    {"percent_of_lot", "%", "difference from lot",
     "difference of `mean` from the mean of the device means, relative to the magnitude `beta` uses",
     get<&ParameterFit::percent_of_lot>},
    {"tied_to", "", "", "the parameter whose value it takes", word<&ParameterFit::tied_to>},
    {"paper_name", "", "in the paper", "its name in Tables 4 and A.5 of Cucuzza et al. 2025",
     word<&ParameterFit::paper_name>},
};

// Beside those of a parameter that an analysis has examined.
inline constexpr Result<ParameterAnalysis> analysis_results[]{
    {"identifiability", "", "identifiability", "the keys below stand only beside it",
     get<&ParameterAnalysis::identifiability>},
    {"optimum", own_unit, "optimum", "at the least objective", get<&ParameterAnalysis::optimum>},
    {"open_range",
     own_unit,
     "open range",
     "where the objective, all others fitted again, stays within `rise`",
     ends<&ParameterAnalysis::open_lower, &ParameterAnalysis::open_upper>,
     {},
     6},
    {"open_below", "", "range ends at the box below", "that range ends at the box",
     get<&ParameterAnalysis::open_below>},
    {"open_above", "", "range ends at the box above", "the same above", get<&ParameterAnalysis::open_above>},
    {"linear_interval",
     own_unit,
     "linear interval",
     "of `intervals.level`; at its bound: that one value",
     ends<&ParameterAnalysis::linear_lower, &ParameterAnalysis::linear_upper>,
     {},
     6},
    {"bootstrap_interval",
     own_unit,
     "bootstrap interval",
     "the same",
     ends<&ParameterAnalysis::bootstrap_lower, &ParameterAnalysis::bootstrap_upper>,
     {},
     6},
    {"profile",
     "",
     "",
     "`value`, `objective`: least objective with the parameter held",
     nested<ParameterAnalysis>,
     {},
     6},
};

inline constexpr Result<OutlyingDevice> outlier_results[]{
    {"device", "", "device", "its name", get<&OutlyingDevice::device>},
    {"property", "", "property", "by which it stands apart", get<&OutlyingDevice::property>},
    {"unit", "", "unit", "of `value` and `median`", get<&OutlyingDevice::unit>},
    {"value", own_unit, "value", "of the device", get<&OutlyingDevice::value>},
    {"median", own_unit, "median", "over the devices", get<&OutlyingDevice::median>},
    {"score", "-", "score", "modified z", get<&OutlyingDevice::score>},
    {"percent", "%", "difference", "difference from the median", get<&OutlyingDevice::percent>},
};

// The rows of some keys, in their order; "key: heading" gives one another heading. A key that is not there does not
// compile.
template <class Of, std::size_t all, std::size_t count>
consteval std::array<Result<Of>, count> columns(Result<Of> const (&rows)[all], std::string_view const (&keys)[count]) {
  std::array<Result<Of>, count> chosen;
  for (std::size_t i = 0; i < count; ++i) {
    auto const colon = keys[i].find(": ");
    std::size_t row = 0;
    while (rows[row].key != keys[i].substr(0, colon)) ++row;
    chosen[i] = rows[row];
    if (colon != std::string_view::npos) chosen[i].heading = keys[i].substr(colon + 2);
  }
  return chosen;
}

// What stands above a row in a table: one for each cell that its value takes.
struct Heading {
  std::string title, unit;   // unit: empty of what has none of its own
  std::string text() const;  // with the unit
};
std::vector<Heading> headings(std::string_view heading, std::string_view unit, Value const& of_kind);
template <class Of>
std::vector<Heading> headings(Result<Of> const& row) {
  if constexpr (std::default_initializable<Of>)
    return headings(row.heading, row.unit, row.of(Of{}));
  else
    return headings(row.heading, row.unit, {});
}

}  // namespace isolaw::study
