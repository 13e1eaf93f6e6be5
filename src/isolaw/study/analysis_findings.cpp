#include "isolaw/study/analysis_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "isolaw/base/number_text.hpp"
#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/build_analysis.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;

std::string error_percent(double fraction) {
  return fmt::format("{:.1f} %", 100.0 * fraction);
}

Names on(Summary const& summary, bool LawResult::*front) {
  std::vector<LawResult const*> laws;
  for (auto const& law : summary.laws)
    if (law.*front) laws.push_back(&law);
  std::ranges::stable_sort(laws, {}, [](auto const* law) {
    return law->objective_converged.value_or(law->objective.mean.value_or(std::numeric_limits<double>::infinity()));
  });
  Names names;
  for (auto const* law : laws) names.push_back(called(*law));
  return names;
}

// How a law's beta changes without the optimiser's noise; "" where it does not by more than a tenth.
std::string changed_beta(LawResult const& law) {
  if (!law.beta || !law.beta_converged) return {};
  constexpr double nothing = 1e-4;
  double const change = *law.beta_converged - *law.beta;
  if (std::abs(change) <= std::max(0.1 * std::max(*law.beta, *law.beta_converged), nothing)) return {};
  Names reasons;
  if (law.reduced) reasons.emplace_back("in its reduced form");
  if (!law.left_out_of_beta.empty()) reasons.push_back("without " + enumerate(law.left_out_of_beta, 4));
  auto const why = reasons.empty() ? std::string() : fmt::format(" ({})", fmt::join(reasons, ", "));
  return fmt::format("{} {} instead of {}{}", called(law), percent(*law.beta_converged), percent(*law.beta), why);
}

// Why it changes: of all laws at once.
std::string reasons_of_change(Summary const& summary) {
  bool missed = false, left_out = false, reduced = false;
  for (auto const& law : summary.laws) {
    if (changed_beta(law).empty()) continue;
    missed = missed || (law.success_share && *law.success_share < 0.99);
    left_out = left_out || !law.left_out_of_beta.empty();
    reduced = reduced || law.reduced;
  }
  Names reasons;
  if (missed) reasons.emplace_back("the runs' means are not where the least objectives are");
  if (left_out) reasons.emplace_back("what most tests do not determine or the box decides is left out");
  if (reduced) reasons.emplace_back("a redundant parameter scatters for nothing");
  return enumerate(reasons);
}

void say_what_changed(Summary const& summary, Names& sentences) {
  auto const runs = on(summary, &LawResult::on_front), converged = on(summary, &LawResult::on_front_converged);
  if (converged.empty()) return;
  if (runs == converged)
    sentences.push_back(fmt::format("Without the optimiser's noise the front is the same: {}.", enumerate(converged)));
  else
    sentences.push_back(
        runs.empty() ? fmt::format("Without the optimiser's noise the front is {}.", enumerate(converged))
                     : fmt::format("Without the optimiser's noise the front is {}, of the mean of the runs it is {}.",
                                   enumerate(converged), enumerate(runs)));
  Names changes;
  for (auto const& law : summary.laws)
    if (auto text = changed_beta(law); !text.empty()) changes.push_back(std::move(text));
  if (changes.empty()) return;
  auto const reasons = reasons_of_change(summary);
  sentences.push_back(
      fmt::format("Beta changes{}: {}.", reasons.empty() ? "" : ", since " + reasons, fmt::join(changes, ", ")));
}

void say_what_an_engineer_meets(Summary const& summary, Names& sentences) {
  LawResult const *best = nullptr, *least = nullptr;
  for (auto const& law : summary.laws) {
    if (!law.loo_objective) continue;
    if (least == nullptr || *law.loo_objective < *least->loo_objective) least = &law;
    if (!law.prediction_holds() || !inadequacy(law).empty()) continue;
    if (best == nullptr || *law.loo_objective < *best->loo_objective) best = &law;
  }
  if (best == nullptr) return;
  auto text = fmt::format(
      "Taken for a device that was not tested, the lot's one law is {} wrong on average with {}, the least of {}, and {} at worst ({})",
      error_percent(*best->loo_objective), called(*best),
      best == least ? "all" : "those that describe the devices and predict", error_percent(*best->loo_worst),
      best->loo_worst_device);
  if (best->objective_converged)
    text += fmt::format("; fitted to each device itself it would be {}", error_percent(*best->objective_converged));
  sentences.push_back(text + ".");
}

void say_what_is_predicted(Summary const& summary, Names& sentences) {
  LawResult const* best = nullptr;
  Names unusable;
  for (auto const& law : summary.laws) {
    if (!law.predicted_objective) continue;
    if (law.prediction_unusable()) {
      unusable.push_back(called(law));
      continue;
    }
    if (best == nullptr || *law.predicted_objective < *best->predicted_objective) best = &law;
  }
  if (best == nullptr) {
    if (!unusable.empty())
      sentences.push_back(fmt::format("No law fitted to some blocks predicts the others: {}.", enumerate(unusable)));
    return;
  }
  auto text = fmt::format(
      "Of the laws fitted to some blocks, {} predicts the others best: {} (OF {} against {} where it was fitted)",
      called(*best), name(*best->prediction_grade), number_text(*best->predicted_objective, 3),
      number_text(*best->fitted_objective, 3));
  if (!unusable.empty()) text += fmt::format("; the prediction of {} is unusable", enumerate(unusable));
  sentences.push_back(text + ".");
}

void say_what_is_determined(Summary const& summary, Names& sentences) {
  Names parts;
  for (auto const& law : summary.laws) {
    int free = 0, determined = 0, weakly = 0;
    for (auto const& fit : law.devices)
      for (auto const& p : fit.parameters) {
        if (!p.analysis) continue;
        ++free;
        determined += p.analysis->identifiability == "determined" ? 1 : 0;
        weakly += p.analysis->identifiability == "weakly determined" ? 1 : 0;
      }
    auto const share = [&](int count) { return percent(static_cast<double>(count) / static_cast<double>(free)); };
    if (free > 0) parts.push_back(fmt::format("{} {} (and {} weakly)", called(law), share(determined), share(weakly)));
  }
  if (!parts.empty())
    sentences.push_back(fmt::format("Share of the parameters that the tests determine: {}.", fmt::join(parts, ", ")));
}

void warn_of_prediction(Summary const& summary, LawResult const& law, std::vector<Warning>& warnings) {
  if (law.prediction_holds()) return;
  auto text = fmt::format(
      "{}: its prediction is {}: OF {} on blocks it was not fitted to ({} at worst), against {} on those it was fitted to",
      called(law), name(*law.prediction_grade), number_text(*law.predicted_objective, 3),
      number_text(*law.worst_predicted, 3), number_text(*law.fitted_objective, 3));
  if (law.prediction_unusable()) {
    auto const why = collapse(*law.fitted_objective, *law.predicted_objective, *law.worst_predicted);
    if (!why.empty()) text += "; it collapses: " + why;
    text += "; it is no law for other amplitudes or frequencies than those it was fitted to";
    if (auto const mm = largest_displacement(summary, law)) text += fmt::format(", up to {} mm", number_text(*mm, 3));
  }
  warnings.push_back({"prediction", std::move(text)});
}

void warn_of_success(Summary const& summary, std::vector<Warning>& warnings) {
  std::vector<std::pair<std::string, Names>> missed;  // by what is said of them
  for (auto const& law : summary.laws) {
    if (!law.success_share || *law.success_share >= 0.5) continue;
    auto const text =
        fmt::format("{} of the runs ended within 0.1 % of the least objective ({})",
                    *law.success_share == 0.0 ? "none" : percent(*law.success_share), law.success_reference);
    beside(missed, text).push_back(called(law));
  }
  for (auto const& [text, laws] : missed)
    warnings.push_back({"search", fmt::format("{}: {}", enumerate(laws, 20), text)});
}

void warn_of_undetermined(LawResult const& law, std::vector<Warning>& warnings) {
  std::vector<std::pair<std::string, int>> blind;
  int devices = 0;
  for (auto const& fit : law.devices) {
    devices += fit.optimum ? 1 : 0;
    for (auto const& p : fit.parameters)
      if (p.analysis && p.analysis->identifiability == "undetermined") ++beside(blind, p.name);
  }
  if (blind.empty()) return;
  Names parts;
  for (auto const& [name, count] : blind)
    parts.push_back(count == devices ? name : fmt::format("{} ({} of {} devices)", name, count, devices));
  auto text = fmt::format("{}: the tests do not determine {}", called(law), enumerate(parts, 6));
  if (!law.reduced_form.empty())
    text += fmt::format("; {} searches a form of the same loops without the redundant one", law.reduced_form);
  warnings.push_back({"undetermined", std::move(text)});
}

void warn_of_outliers(Summary const& summary, std::vector<Warning>& warnings) {
  std::vector<std::pair<std::string, Names>> devices;
  for (auto const& outlier : summary.outliers) {
    auto const unit = outlier.unit.empty() ? std::string() : " " + outlier.unit;
    beside(devices, outlier.device)
        .push_back(fmt::format("{} {}{} ({:+.0f} % from the median)", outlier.property, number_text(outlier.value),
                               unit, outlier.percent));
  }
  for (auto const& [device, properties] : devices)
    warnings.push_back({"outlier", fmt::format("{} stands apart from its lot: {}", device, enumerate(properties, 4))});
}

}  // namespace

std::vector<std::string> converged_sentences(Summary const& summary) {
  Names sentences;
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0) return sentences;
  say_what_changed(summary, sentences);
  say_what_an_engineer_meets(summary, sentences);
  say_what_is_predicted(summary, sentences);
  say_what_is_determined(summary, sentences);
  return sentences;
}

void warn_of_analysis(Summary const& summary, std::vector<Warning>& warnings) {
  for (auto const& law : summary.laws) warn_of_prediction(summary, law, warnings);
  warn_of_success(summary, warnings);
  for (auto const& law : summary.laws) warn_of_undetermined(law, warnings);
  bool several_blocks = false, predicted = false;
  for (auto const& device : summary.devices)
    several_blocks = several_blocks || (device.status == "ok" && device.properties.blocks.size() > 1);
  for (auto const& law : summary.laws) predicted = predicted || law.predicted_objective.has_value();
  if (several_blocks && !predicted && !summary.laws.empty())
    warnings.push_back(
        {"not predicted",
         "the records hold several blocks; whether a law fitted to one holds for the others is not asked: --fit-blocks with the numbers of some predicts the rest"});
  warn_of_outliers(summary, warnings);
}

}  // namespace isolaw::study
