#include "isolaw/study/analysis_findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "isolaw/study/adequacy.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {
namespace {

using Names = std::vector<std::string>;

Names laws_on(Summary const& summary, bool LawResult::*front) {
  std::vector<LawResult const*> laws;
  for (auto const& law : summary.laws)
    if (law.*front) laws.push_back(&law);
  std::ranges::stable_sort(laws, {}, [](auto const* law) {
    return law->objective_converged.value_or(law->objective.mean.value_or(std::numeric_limits<double>::infinity()));
  });
  Names ids;
  for (auto const* law : laws) ids.push_back(law->id);
  return ids;
}

bool changes_beta(LawResult const& law) {
  if (!law.beta || !law.beta_converged) return false;
  constexpr double nothing = 1e-4;
  return std::abs(*law.beta_converged - *law.beta) > std::max(0.1 * std::max(*law.beta, *law.beta_converged), nothing);
}

void add_front(Summary const& summary, std::vector<Finding>& findings) {
  auto const runs = laws_on(summary, &LawResult::on_front);
  auto const converged = laws_on(summary, &LawResult::on_front_converged);
  if (converged.empty()) return;
  Names run_names;
  for (auto const& id : runs) run_names.emplace_back(laws::display_name(id));
  findings.push_back({.kind = FindingKind::converged_front,
                      .other_laws = converged,
                      .words = {{"same", runs == converged ? "yes" : "no"},
                                {"of_runs", runs == converged ? "" : enumerate(run_names)}}});
  for (auto const& law : summary.laws)
    if (changes_beta(law))
      findings.push_back({.kind = FindingKind::converged_beta,
                          .law = law.id,
                          .parameters = law.left_out_of_beta,
                          .numbers = {{"beta", *law.beta}, {"beta_converged", *law.beta_converged}},
                          .words = {{"reduced", law.reduced ? "yes" : ""}}});
}

void add_error_on_untested(Summary const& summary, std::vector<Finding>& findings) {
  LawResult const *best = nullptr, *least = nullptr;
  for (auto const& law : summary.laws) {
    if (!law.loo_objective) continue;
    if (least == nullptr || *law.loo_objective < *least->loo_objective) least = &law;
    if (!law.prediction_holds() || !is_adequate(law)) continue;
    if (best == nullptr || *law.loo_objective < *best->loo_objective) best = &law;
  }
  if (best == nullptr) return;
  Finding finding{.kind = FindingKind::converged_untested,
                  .law = best->id,
                  .devices = {best->loo_worst_device},
                  .numbers = {{"error", *best->loo_objective}, {"worst", *best->loo_worst}},
                  .words = {{"least", best == least ? "all" : "predicting"}}};
  if (best->objective_converged) finding.numbers.push_back({"fitted", *best->objective_converged});
  findings.push_back(std::move(finding));
}

void add_predictions(Summary const& summary, std::vector<Finding>& findings) {
  LawResult const* best = nullptr;
  Names unusable;
  for (auto const& law : summary.laws) {
    if (!law.predicted_objective) continue;
    if (law.prediction_unusable())
      unusable.push_back(law.id);
    else if (best == nullptr || *law.predicted_objective < *best->predicted_objective)
      best = &law;
  }
  if (best != nullptr)
    findings.push_back({.kind = FindingKind::converged_prediction,
                        .law = best->id,
                        .other_laws = unusable,
                        .numbers = {{"predicted", *best->predicted_objective}, {"fitted", *best->fitted_objective}},
                        .words = {{"grade", std::string(name(*best->prediction_grade))}}});
  else if (!unusable.empty())
    findings.push_back({.kind = FindingKind::converged_no_prediction, .other_laws = unusable});
}

void add_determined(Summary const& summary, std::vector<Finding>& findings) {
  for (auto const& law : summary.laws) {
    double examined = 0.0, determined = 0.0, weakly = 0.0;
    for (auto const& fit : law.counting())
      for (auto const& parameter : fit.parameters) {
        if (!parameter.analysis) continue;
        auto const verdict = parameter.analysis->identifiability;
        examined += 1.0;
        determined += verdict == analysis::Verdict::determined ? 1.0 : 0.0;
        weakly += verdict == analysis::Verdict::weakly_determined ? 1.0 : 0.0;
      }
    if (examined > 0.0)
      findings.push_back({.kind = FindingKind::converged_determined,
                          .law = law.id,
                          .numbers = {{"determined", determined / examined}, {"weakly", weakly / examined}}});
  }
}

}  // namespace

std::vector<Finding> converged_findings(Summary const& summary) {
  std::vector<Finding> findings;
  if (summary.missing_runs() > 0 || summary.missing_analyses() > 0) return findings;
  add_front(summary, findings);
  add_error_on_untested(summary, findings);
  add_predictions(summary, findings);
  add_determined(summary, findings);
  return findings;
}

}  // namespace isolaw::study
