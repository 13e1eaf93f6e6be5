// Adds made-up results of the analyses to the made-up lot of study_fixture.hpp. The lot then has every kind of verdict,
// a law whose prediction is unusable, populations that lack the scatter and the correlations of the last parameter, and
// an outlying device.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "unit/study_fixture.hpp"

namespace isolaw::study::fixture {

inline ParameterAnalysis analysed(ParameterFit const& parameter, double objective, double rise, std::size_t place) {
  using analysis::Verdict;
  constexpr std::array verdicts{Verdict::determined, Verdict::weakly_determined, Verdict::undetermined,
                                Verdict::at_bound};
  ParameterAnalysis parameter_analysis;
  parameter_analysis.identifiability = verdicts[place % 4];
  parameter_analysis.optimum = *parameter.value.best;
  double const width =
      std::abs(parameter_analysis.optimum) * (parameter_analysis.identifiability == Verdict::determined ? 0.02 : 0.3);
  parameter_analysis.open_lower = parameter_analysis.optimum - width;
  parameter_analysis.open_upper = parameter_analysis.optimum + width;
  parameter_analysis.open_above = parameter_analysis.identifiability == Verdict::at_bound;
  parameter_analysis.linear_lower = parameter_analysis.optimum - 0.7 * width;
  parameter_analysis.linear_upper = parameter_analysis.optimum + 0.7 * width;
  if (place % 2 == 0) {
    parameter_analysis.bootstrap_lower = parameter_analysis.optimum - 0.8 * width;
    parameter_analysis.bootstrap_upper = parameter_analysis.optimum + 0.9 * width;
  }
  for (int i = -4; i <= 4; ++i) {
    parameter_analysis.profile_value.push_back(parameter_analysis.optimum + i * width / 3.0);
    parameter_analysis.profile_objective.push_back(objective + rise * i * i / 9.0);
  }
  return parameter_analysis;
}

inline void analyse(DeviceFit& fit, std::size_t device) {
  fit.optimum = 0.98 * *fit.objective.best;
  fit.rise = 0.01 * *fit.optimum;
  fit.success_share = 0.75;
  fit.success_reference = "best of this campaign";
  fit.trade_offs = {"A and B trade off on " + fit.device + ": A +10 % is undone by B -10 %"};
  fit.interval_level = 0.95;
  fit.interval_samples = 601;
  fit.interval_block = 42;
  fit.interval_replicates = 100;
  fit.lot_objective = 1.6 * *fit.optimum;
  fit.worst_objective = 1.7 * *fit.optimum;
  fit.left_out_objective = 1.9 * *fit.optimum;
  fit.blocks = {{1, true, *fit.optimum}, {2, false, 3.0 * *fit.optimum}};
  for (std::size_t n = 0; n < fit.parameters.size(); ++n)
    fit.parameters[n].analysis = analysed(fit.parameters[n], *fit.optimum, *fit.rise, n + device);
}

inline lot::Population population(LawResult const& law) {
  lot::Population estimate;
  estimate.devices = law.devices.size();
  estimate.note = "the devices differ in one direction";
  for (auto const& parameter : law.devices.front().parameters) {
    estimate.names.push_back(parameter.name);
    estimate.medians.push_back(*parameter.value.mean);
    estimate.relative_std.push_back(0.1);
  }
  auto const n = estimate.names.size();
  estimate.correlation.assign(n, std::vector<double>(n, 0.0));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) estimate.correlation[i][j] = i == j ? 1.0 : (i + j) % 2 == 0 ? 0.83 : -0.61;
  estimate.relative_std.back() = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i + 1 < n; ++i)
    estimate.correlation[i][n - 1] = estimate.correlation[n - 1][i] = std::numeric_limits<double>::quiet_NaN();
  return estimate;
}

inline void analyse(LawResult& law) {
  double const scale = *law.objective.best;
  law.success_share = 0.75;
  law.success_reference = "best of this campaign";
  law.objective_converged = 0.98 * scale;
  for (std::size_t d = 0; d < law.devices.size(); ++d) analyse(law.devices[d], d);
  law.fitted_objective = law.objective_converged;
  law.predicted_objective = law.worst_predicted = 3.0 * scale;
  auto const& last = law.devices.back();
  if (law.devices.size() < 2) {
    law.beta_converged_note = law.beta_note;
    return;
  }
  law.beta_converged = 0.9 * *law.beta;
  law.loo_objective = 1.9 * scale;
  law.loo_worst = 2.3 * scale;
  law.loo_worst_device = last.device;
  LotLaw lot;
  for (auto const& parameter : last.parameters) {
    lot.parameters.push_back(*parameter.value.mean);
    lot.worst_parameters.push_back(1.05 * *parameter.value.mean);
  }
  lot.mean = 1.6 * scale;
  lot.worst = 2.0 * scale;
  lot.worst_device = last.device;
  lot.least_worst = 1.8 * scale;
  lot.least_worst_bound = 1.75 * scale;
  law.lot = lot;
  law.population = population(law);
}

// Puts all laws with a `beta_converged`, except the second law, on the front of `objective_converged` against
// `beta_converged`, and the first law alone on the front of errors on devices that were left out of the fit. The
// prediction of the second law is unusable, and that of the other laws is fair.
inline Summary analysed(Summary summary) {
  for (std::size_t j = 0; j < summary.laws.size(); ++j) {
    auto& law = summary.laws[j];
    analyse(law);
    law.on_front_converged = law.beta_converged && j != 1;
    law.on_front_loo = law.loo_objective && j == 0;
    law.prediction_grade = j == 1 ? PredictionGrade::unusable : PredictionGrade::fair;
  }
  if (summary.laws.size() > 1) summary.laws[1].left_out_of_beta = {"f0+"};
  if (summary.devices.size() > 2)
    summary.outliers.push_back({.device = summary.devices[1].name,
                                .property = "effective stiffness",
                                .unit = "kN/mm",
                                .law = {},
                                .value = 0.81,
                                .median = 0.62,
                                .score = 5.2,
                                .percent = 30.6});
  return summary;
}

}  // namespace isolaw::study::fixture
