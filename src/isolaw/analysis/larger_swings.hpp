// Fits a law to the small swings of a device's tests and judges it on the large ones. A swing is the motion from one
// turning point to the next; data/cycles/swing_sizes.hpp decides which swings are small and which are large.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "isolaw/analysis/problems.hpp"
#include "isolaw/data/cycles/swing_sizes.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::analysis {

// Two models of a law on each test. The objective in `small` counts only the small swings: the law is fitted to them.
// The objective in `large` counts only the large swings: the law is judged on them. In both, the law runs through the
// whole history before these swings. A test has no model for a size if it has too few swings of this size, or if the
// force is constant in them.
struct SwingModels {
  std::vector<fit::LawOnRecord> small, large;
};
SwingModels swing_models(laws::LawEntry const& law, std::span<data::FitRecord const> tests,
                         data::SwingSizes const& sizes, laws::Integration integration,
                         laws::TurningPoints turning_points, int refinement);

double mean_objective(std::span<fit::LawOnRecord const> models, std::span<double const> parameters);

// Several descents may end with fits that are equally good on the small swings but differ on the large ones. The result
// is the one with the largest error on the large swings.
struct LargerSwings {
  std::vector<double> parameters;  // all parameters of the law
  double fitted = 0.0;             // mean objective of the tests on their small swings
  // Mean objective of the tests on their large swings: the largest and the least among the equally good fits.
  double predicted = 0.0;
  double least_predicted = 0.0;
  int evaluations = 0;  // how often the law was computed for one test
};
// Two fits of the small swings are equally good if their objectives differ by at most this share of the least one.
inline constexpr double equally_good_fit = 0.02;
// Makes eight descents from scattered starts, and none from a fit to the whole tests, since such a fit already knows
// the large swings. nullopt if interrupted or if no start has finite forces. An objective is infinite if a force is not
// finite.
std::optional<LargerSwings> predict_larger_swings(SwingModels const& models, fit::SearchBox const& box,
                                                  num::Stream const& stream, Interrupted const& interrupted = {});

}  // namespace isolaw::analysis
