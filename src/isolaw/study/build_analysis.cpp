#include "isolaw/study/build_analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/campaign/analyse.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/lot/outliers.hpp"
#include "isolaw/lot/robustness.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/opt/pareto.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/lot_conditions.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {
namespace {

constexpr double no_value = std::numeric_limits<double>::infinity();

double least_objective(campaign::Contents const& contents, campaign::Search const& search) {
  double least = no_value;
  if (auto const* best = contents.best_run(search.device, search.law)) least = best->objective;
  if (auto const* a = contents.analysis_of(search.device, search.law))
    least = std::min(least, a->determination.objective);
  return least;
}

void add_success(DeviceFit& fit, campaign::Contents const& contents, campaign::Search const& search) {
  double const least = least_objective(contents, search);
  int usable = 0, found = 0;
  for (auto const& run : contents.runs) {
    if (run.device != search.device || run.law != search.law || !run.usable()) continue;
    ++usable;
    found += run.objective <= least * (1.0 + found_within) + 1e-9 ? 1 : 0;
  }
  // A single run cannot agree with another one, so there is no share.
  if (usable < 2) return;
  fit.success_share = static_cast<double>(found) / usable;
  fit.success_reference = "best of this campaign";
}

void add_blocks(DeviceFit& fit, data::FitRecord const& record) {
  if (record.block.empty() || fit.force_kN.empty()) return;
  std::map<int, std::vector<double>> members;
  std::map<int, bool> fitted;
  for (std::size_t i = 0; i < record.size(); ++i) {
    int const block = static_cast<int>(record.block[i]);
    if (block == 0) continue;
    auto& mask = members.try_emplace(block, record.size(), 0.0).first->second;
    mask[i] = 1.0;
    fitted[block] = fitted[block] || record.is_scored(i);
  }
  for (auto& [block, mask] : members) {
    // If the law was fitted to some cycles of a block only, the block's objective is computed from these cycles alone.
    if (fitted[block])
      for (std::size_t i = 0; i < mask.size(); ++i) mask[i] *= record.is_scored(i) ? 1.0 : 0.0;
    double const objective = fit::objective_on(record, fit.force_kN, std::move(mask));
    if (!std::isnan(objective)) fit.blocks.push_back({block, fitted[block], objective});
  }
}

// The best values of the free parameters on the analysed devices, as [parameter][device]. If the law has a redundant
// parameter (LawEntry::redundant) and it was free, LawEntry::reduce() has fixed it and changed the others to give the
// same forces. `left_out` names parameters that most tests leave undetermined or at a bound.
struct Examined {
  std::vector<std::string> names, left_out;
  std::vector<std::vector<double>> values;
  bool reduced = false;
};

Examined examined(std::vector<DeviceFit const*> const& fits, laws::LawEntry const& entry) {
  Examined result;
  auto const& parameters = fits.front()->parameters;
  auto const is_redundant = [&](auto const& p) { return !entry.redundant.empty() && p.name == entry.redundant; };
  result.reduced = std::ranges::any_of(parameters, [&](auto const& p) { return p.free && is_redundant(p); });
  std::vector<std::vector<double>> all;
  for (auto const* fit : fits) {
    auto& values = all.emplace_back();
    for (auto const& p : fit->parameters) values.push_back(p.analysis ? p.analysis->optimum : *p.value.best);
    if (result.reduced) entry.reduce(values);
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    auto const& p = parameters[i];
    if (!p.free || (result.reduced && is_redundant(p))) continue;
    bool const in_reduction =
        result.reduced && std::ranges::find(entry.redundant_with, p.name) != entry.redundant_with.end();
    auto const blind = std::ranges::count_if(fits, [&](DeviceFit const* fit) {
      auto const& a = fit->parameters[i].analysis;
      return a && (a->identifiability == analysis::Verdict::at_bound ||
                   (a->identifiability == analysis::Verdict::undetermined && !in_reduction));
    });
    if (2 * blind > std::ssize(fits)) {
      result.left_out.push_back(p.name);
      continue;
    }
    result.names.push_back(p.name);
    auto& values = result.values.emplace_back();
    for (auto const& on_device : all) values.push_back(on_device[i]);
  }
  return result;
}

void add_converged_beta(LawResult& law, laws::LawEntry const& entry) {
  std::vector<DeviceFit const*> fits;
  double sum = 0.0;
  for (auto const& fit : law.counting()) {
    if (!fit.optimum) continue;
    fits.push_back(&fit);
    sum += *fit.optimum;
  }
  if (fits.empty()) {
    law.beta_converged_note = "no device was examined";
    return;
  }
  auto const found = examined(fits, entry);
  law.reduced = found.reduced;
  law.left_out_of_beta = found.left_out;
  law.objective_converged = sum / static_cast<double>(fits.size());
  if (found.names.empty() && !found.left_out.empty()) {
    law.beta_converged_note = "the tests determine no parameter inside its box";
    return;
  }
  auto const robustness = lot::robustness_index(found.names, found.values);
  law.beta_converged = robustness.beta;
  law.beta_converged_note = robustness.note;
}

std::vector<fit::SearchParameter> parameters_of_search(campaign::Contents const& contents, std::string_view law) {
  for (auto const& search : contents.searches)
    if (search.law == law && search.refusal.empty()) return search.box.parameters;
  return {};
}

// The covariance of the estimates of one device's free parameters by linearisation, as [parameter][parameter]. If a
// parameter is at its bound and the test does not determine it, its variance is a quarter of the squared width of its
// box: no distribution inside the box has a larger one. To keep every variance above zero, (1e-6 s)^2 is added, where s
// is the estimate's magnitude or a thousandth of the box's width, whichever is larger.
lot::SquareMatrix uncertainty(DeviceFit const& fit, campaign::DeviceAnalysis const& analysis) {
  constexpr double rounding = 1e-6;
  auto const& intervals = analysis.intervals;
  auto const n = intervals.parameters.size();
  lot::SquareMatrix covariance(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) covariance[i][j] = intervals.covariance[i * n + j];
    auto const& p = fit.parameters[intervals.parameters[i].parameter];
    double const width = p.upper - p.lower;
    if (covariance[i][i] == 0.0 && p.analysis->identifiability == analysis::Verdict::undetermined)
      covariance[i][i] = width * width / 4.0;
    covariance[i][i] += std::pow(rounding * std::max(std::abs(p.analysis->optimum), 1e-3 * width), 2);
  }
  return covariance;
}

// Fixes the redundant parameter as LawEntry::reduce() does, and converts the others' covariance by first derivatives.
lot::DeviceEstimate reduced(laws::LawEntry const& entry, std::vector<double> const& values,
                            std::vector<std::size_t> const& free, lot::SquareMatrix const& covariance,
                            std::vector<std::size_t> const& kept) {
  auto const form = [&](std::vector<double> parameters) {
    entry.reduce(parameters);
    return parameters;
  };
  auto const here = form(values);
  std::vector<std::vector<double>> slopes;  // d kept parameter / d free parameter, as [free][kept]
  for (auto const k : free) {
    constexpr double step = 1e-6;
    double const size = values[k] != 0.0 ? step * std::abs(values[k]) : step;
    auto moved = values;
    moved[k] += size;
    auto const there = form(moved);
    auto& row = slopes.emplace_back();
    for (auto const i : kept) row.push_back((there[i] - here[i]) / size);
  }
  lot::DeviceEstimate estimate;
  for (auto const i : kept) estimate.values.push_back(here[i]);
  estimate.covariance.assign(kept.size(), std::vector<double>(kept.size(), 0.0));
  for (std::size_t a = 0; a < free.size(); ++a)
    for (std::size_t b = 0; b < free.size(); ++b)
      for (std::size_t i = 0; i < kept.size(); ++i)
        for (std::size_t j = 0; j < kept.size(); ++j)
          estimate.covariance[i][j] += slopes[a][i] * covariance[a][b] * slopes[b][j];
  return estimate;
}

std::vector<std::size_t> undetermined_everywhere(LawResult const& law, std::vector<std::string> const& names) {
  std::vector<std::size_t> found;
  for (std::size_t n = 0; n < names.size(); ++n)
    if (std::ranges::all_of(law.counting(), [&](DeviceFit const& fit) {
          auto const p = std::ranges::find(fit.parameters, names[n], &ParameterFit::name);
          bool const examined = p != fit.parameters.end() && p->analysis;
          return !examined || p->analysis->identifiability == analysis::Verdict::undetermined;
        }))
      found.push_back(n);
  return found;
}

void add_population(LawResult& law, laws::LawEntry const& entry, campaign::Contents const& contents) {
  std::vector<std::string> names;
  std::vector<lot::DeviceEstimate> estimates;
  for (auto const& fit : law.counting()) {
    if (!fit.optimum) continue;
    auto const device = std::ranges::find(contents.devices, fit.device, &campaign::Device::name);
    auto const* a = contents.analysis_of(static_cast<std::size_t>(device - contents.devices.begin()), law.id);
    std::vector<std::size_t> free, kept;
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
      if (!fit.parameters[i].free) continue;
      free.push_back(i);
      if (!law.reduced || fit.parameters[i].name != entry.redundant) kept.push_back(i);
    }
    auto const& values = a->determination.optimum;
    auto covariance = uncertainty(fit, *a);
    lot::DeviceEstimate estimate;
    if (law.reduced) {
      estimate = reduced(entry, values, free, covariance, kept);
    } else {
      for (auto const i : free) estimate.values.push_back(values[i]);
      estimate.covariance = std::move(covariance);
    }
    if (names.empty())
      for (auto const i : kept) names.push_back(fit.parameters[i].name);
    estimates.push_back(std::move(estimate));
  }
  if (estimates.empty() || names.empty()) return;
  try {
    law.population = lot::estimate_population(names, estimates, undetermined_everywhere(law, names));
  } catch (Error const& error) {
    lot::Population empty;
    empty.note = error.what();
    law.population = std::move(empty);
  }
}

void add_prediction(LawResult& law) {
  double fitted = 0.0, predicted = 0.0, worst = 0.0;
  std::size_t devices = 0;
  for (auto const& fit : law.counting()) {
    double sums[2] = {0.0, 0.0};
    int counts[2] = {0, 0};
    for (auto const& score : fit.blocks) {
      sums[score.fitted ? 0 : 1] += score.objective;
      ++counts[score.fitted ? 0 : 1];
      if (!score.fitted) worst = std::max(worst, score.objective);
    }
    if (counts[0] == 0 || counts[1] == 0) continue;
    fitted += sums[0] / counts[0];
    predicted += sums[1] / counts[1];
    ++devices;
  }
  if (devices == 0) return;
  law.fitted_objective = fitted / static_cast<double>(devices);
  law.predicted_objective = predicted / static_cast<double>(devices);
  law.worst_predicted = worst;
  law.prediction_grade = graded(*law.fitted_objective, *law.predicted_objective, worst);
}

// Sets the share of the usable runs, over all devices, that found the least objective known for their device.
void add_success_on_lot(LawResult& law) {
  double usable = 0.0, found = 0.0;
  for (auto const& fit : law.devices) {
    if (!fit.success_share) continue;
    double const runs = fit.runs - fit.failed_runs;
    usable += runs;
    found += runs * *fit.success_share;
    law.success_reference = fit.success_reference;
  }
  if (usable > 0.0) law.success_share = found / usable;
}

void add_reduced_form(LawResult& law, laws::LawEntry const& entry, campaign::Contents const& contents) {
  if (entry.redundant.empty()) return;
  for (auto const& p : parameters_of_search(contents, law.id))
    if (p.free && p.name == entry.redundant)
      law.reduced_form = fmt::format("--set {}.{}={}", law.id, entry.redundant, entry.redundant_value);
}

DeviceFit& fit_on(LawResult& law, campaign::Device const& device) {
  return *std::ranges::find(law.devices, device.name, &DeviceFit::device);
}

void add_lot_law(LawResult& law, campaign::Contents const& contents) {
  auto const lot = std::ranges::find(contents.lot_analyses, law.id, &campaign::LotAnalysis::law);
  if (lot == contents.lot_analyses.end() || lot->mean.parameters.empty()) return;
  LotLaw lot_law{.parameters = lot->mean.parameters,
                 .worst_parameters = lot->worst.law.parameters,
                 .mean = lot->mean.mean,
                 .worst = lot->mean.worst,
                 .least_worst = lot->worst.law.worst,
                 .least_worst_bound = lot->worst.bound};
  for (std::size_t i = 0; i < lot->devices.size(); ++i) {
    auto& fit = fit_on(law, contents.devices[lot->devices[i]]);
    fit.lot_objective = lot->mean.objectives[i];
    fit.worst_objective = lot->worst.law.objectives[i];
    if (lot->mean.objectives[i] == lot->mean.worst) lot_law.worst_device = fit.device;
  }
  auto const box = campaign::box_of_lot(contents, law.id);
  for (std::size_t n = 0; n < lot_law.parameters.size(); ++n)
    if (auto const bound = fit::at_bound(box.parameters[n], lot_law.parameters[n]); bound != fit::AtBound::no)
      lot_law.at_bound.emplace_back(box.parameters[n].name, bound);
  law.lot = std::move(lot_law);
}

void add_larger_swings(LawResult& law) {
  double sum = 0.0, least = 0.0, count = 0.0;
  for (auto const& fit : law.counting()) {
    if (!fit.larger_swings_objective) continue;
    sum += *fit.larger_swings_objective;
    least += *fit.larger_swings_least;
    ++count;
    law.larger_swings_worst = std::max(law.larger_swings_worst.value_or(0.0), *fit.larger_swings_objective);
  }
  if (count == 0.0) return;
  law.larger_swings_objective = sum / count;
  law.larger_swings_least = least / count;
}

// Sets the law's error on each device with parameters fitted to all other devices.
void add_left_out(LawResult& law, campaign::Contents const& contents) {
  double sum = 0.0;
  std::size_t count = 0;
  for (auto const& left_out : contents.left_out) {
    double const objective = left_out.left_out.objective;
    if (left_out.law != law.id || !std::isfinite(objective)) continue;
    auto& fit = fit_on(law, contents.devices[left_out.device]);
    fit.left_out_objective = objective;
    if (!fit.counts) continue;
    sum += objective;
    ++count;
    if (objective > law.loo_worst.value_or(0.0)) {
      law.loo_worst = objective;
      law.loo_worst_device = fit.device;
    }
  }
  if (count > 0) law.loo_objective = sum / static_cast<double>(count);
}

constexpr double least_misfit_percent = 10.0;  // a misfit is an outlier only if it exceeds the median by this much

void add_outliers(Summary& summary) {
  std::vector<std::string> names, units, laws;
  std::vector<std::vector<double>> values;  // [property][device]; NaN for a device without the property
  auto const add = [&](std::string name, std::string unit, std::string law, auto const& value_on) {
    names.push_back(std::move(name));
    units.push_back(std::move(unit));
    laws.push_back(std::move(law));
    auto& row = values.emplace_back();
    for (auto const& device : summary.devices)
      row.push_back(device.counts() ? value_on(device).value_or(std::nan("")) : std::nan(""));
  };
  std::vector<double> amplitudes;
  for (auto const& device : summary.devices)
    if (auto const& cycle = device.properties.reported; cycle && device.counts())
      amplitudes.push_back(cycle->amplitude_mm);
  auto const usual = usual_amplitude(amplitudes, summary.acceptance.rules, summary.asked.alike);
  Finding left_out{.kind = FindingKind::not_compared,
                   .numbers = {{"usual_mm", usual.mm}, {"allowed", usual.allowed_percent}}};
  for (auto const& device : summary.devices)
    if (auto const& cycle = device.properties.reported; cycle && device.counts() && !usual.has(cycle->amplitude_mm))
      left_out.devices.push_back(device.name);
  if (!left_out.devices.empty() && amplitudes.size() >= num::fewest_for_outliers)
    summary.not_compared = std::move(left_out);
  auto const reported = [usual](double data::Cycle::*member) {
    return [usual, member](DeviceResult const& device) {
      auto const& cycle = device.properties.reported;
      return cycle && usual.has(cycle->amplitude_mm) ? std::optional((*cycle).*member) : std::nullopt;
    };
  };
  add("effective stiffness", "kN/mm", "", reported(&data::Cycle::K_eff_kN_per_mm));
  add("dissipated energy", "kN mm", "", reported(&data::Cycle::energy_kN_mm));
  add("equivalent damping", "%", "", reported(&data::Cycle::damping_percent));
  for (auto const& law : summary.laws) {
    auto const misfit = [&](std::optional<double> DeviceFit::*member) {
      return [&law, member](DeviceResult const& device) {
        auto const* fit = fit_of(law, device.name);
        return fit != nullptr ? fit->*member : std::nullopt;
      };
    };
    add(fmt::format("misfit of {}", display_name(law)), "", law.id, misfit(&DeviceFit::optimum));
    add(fmt::format("misfit of {} as fitted to the other devices", display_name(law)), "", law.id,
        misfit(&DeviceFit::left_out_objective));
  }
  for (auto const& found : lot::find_outliers(names, values)) {
    auto const& unit = units[found.property];
    // Only the misfits of laws have no unit. A misfit that is smaller than usual, or hardly larger, is not reported.
    if (unit.empty() && found.percent < least_misfit_percent) continue;
    summary.outliers.push_back({.device = summary.devices[found.device].name,
                                .property = names[found.property],
                                .unit = unit,
                                .law = laws[found.property],
                                .value = found.value,
                                .median = found.median,
                                .score = found.score,
                                .percent = found.percent});
  }
  // A device's own properties come before the misfits of laws.
  std::stable_partition(summary.outliers.begin(), summary.outliers.end(),
                        [](auto const& outlier) { return outlier.law.empty(); });
}

}  // namespace

std::string_view name(Collapse collapse) {
  constexpr std::string_view names[]{"no", "constant", "far"};
  return names[static_cast<std::size_t>(collapse)];
}

Collapse collapse(double fitted_objective, double predicted_objective, double worst_predicted) {
  if (!(worst_predicted <= collapsed_objective)) return Collapse::constant;
  bool const near = predicted_objective < collapsed_least || predicted_objective <= collapsed_ratio * fitted_objective;
  return near ? Collapse::no : Collapse::much_worse;
}

PredictionGrade graded(double fitted_objective, double predicted_objective, double worst_predicted) {
  bool const collapses = collapse(fitted_objective, predicted_objective, worst_predicted) != Collapse::no;
  if (collapses || !(predicted_objective <= poor_prediction)) return PredictionGrade::unusable;
  if (predicted_objective > fair_prediction) return PredictionGrade::poor;
  return predicted_objective > good_prediction ? PredictionGrade::fair : PredictionGrade::good;
}

void add_analysis(DeviceFit& fit, campaign::Contents const& contents, campaign::Search const& search) {
  add_success(fit, contents, search);
  add_blocks(fit, contents.devices[search.device].record);
  auto const* found = contents.analysis_of(search.device, search.law);
  if (found == nullptr) return;
  auto const& determination = found->determination;
  auto const& intervals = found->intervals;
  fit.optimum = determination.objective;
  fit.rise = determination.rise;
  if (found->springs) {
    fit.springs_objective = found->springs->fitted;
    fit.springs_given_objective = found->springs->given;
  }
  if (auto const& larger = found->larger_swings) {
    auto const or_infinite = [](double value) {
      return std::isfinite(value) ? value : std::numeric_limits<double>::infinity();
    };
    fit.larger_swings_objective = or_infinite(larger->predicted);
    fit.larger_swings_least = or_infinite(larger->least_predicted);
  }
  for (auto const& trade_off : determination.trade_offs) fit.trade_offs.push_back(trade_off.sentence);
  fit.interval_level = intervals.level;
  fit.interval_samples = intervals.samples;
  fit.interval_block = intervals.block;
  fit.interval_replicates = intervals.replicates;
  for (std::size_t i = 0; i < determination.parameters.size(); ++i) {
    auto const& p = determination.parameters[i];
    auto const& interval = intervals.parameters[i];
    fit.parameters[p.parameter].analysis = ParameterAnalysis{.optimum = determination.optimum[p.parameter],
                                                             .identifiability = p.verdict,
                                                             .open_lower = p.lower,
                                                             .open_upper = p.upper,
                                                             .open_below = p.open_below,
                                                             .open_above = p.open_above,
                                                             .linear_lower = interval.linear_lower,
                                                             .linear_upper = interval.linear_upper,
                                                             .bootstrap_lower = interval.bootstrap_lower,
                                                             .bootstrap_upper = interval.bootstrap_upper,
                                                             .profile_value = p.profile.value,
                                                             .profile_objective = p.profile.objective};
  }
}

std::vector<bool> front_of(std::vector<LawResult> const& laws, Coordinate robust, Coordinate accurate) {
  std::vector<double> x, y;
  for (auto const& law : laws) {
    x.push_back(robust(law).value_or(no_value));
    y.push_back(accurate(law).value_or(no_value));
  }
  return opt::non_dominated(x, y);
}

void mark_front(std::vector<LawResult>& laws, Coordinate robust, Coordinate accurate, bool LawResult::*on_front) {
  auto const front = front_of(laws, robust, accurate);
  for (std::size_t i = 0; i < laws.size(); ++i) laws[i].*on_front = front[i];
}

void add_lot_analysis(LawResult& law, campaign::Contents const& contents) {
  auto const& entry = laws::find_law(law.id);
  add_success_on_lot(law);
  add_prediction(law);
  if (!contents.settings.analysis) {
    law.beta_converged_note = "no analysis was asked for";
    return;
  }
  add_reduced_form(law, entry, contents);
  add_converged_beta(law, entry);
  add_population(law, entry, contents);
  add_lot_law(law, contents);
  add_left_out(law, contents);
  add_larger_swings(law);
}

void add_converged_views(Summary& summary) {
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0)
    return;  // laws with results on different devices cannot be compared
  auto const accurate = [](LawResult const& law) { return law.objective_converged; };
  mark_front(
      summary.laws, [](auto const& law) { return law.beta_converged; }, accurate, &LawResult::on_front_converged);
  mark_front(
      summary.laws, [](auto const& law) { return law.loo_objective; }, accurate, &LawResult::on_front_loo);
  add_outliers(summary);
}

}  // namespace isolaw::study
