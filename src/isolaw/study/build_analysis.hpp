// Adds the results of the analyses to a summary: which parameters the tests determine, the lot's law, and prediction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// A run has found the campaign's least objective if it ends within this relative distance of it.
inline constexpr double found_within = 1e-3;
// Largest mean objective of each grade on the blocks left out of the fit; above the last, a prediction is unusable.
inline constexpr double good_prediction = 0.1, fair_prediction = 0.3, poor_prediction = 0.6;
// A prediction that collapses is unusable too. It collapses if the objective on some predicted block exceeds
// collapsed_objective, so that the law does worse than a constant force. It also collapses if the mean objective on the
// predicted blocks is at least collapsed_least and more than collapsed_ratio times the mean on the fitted blocks.
// docs/decision.md gives the reasons.
inline constexpr double collapsed_objective = 1.0, collapsed_ratio = 10.0, collapsed_least = 0.2;
PredictionGrade graded(double fitted_objective, double predicted_objective, double worst_predicted);
// `constant`: on some predicted block the law does worse than a constant force. `much_worse`: it does much worse on
// predicted blocks than on fitted ones.
enum class Collapse { no, constant, much_worse };
std::string_view name(Collapse collapse);  // "no", "constant", "far"
Collapse collapse(double fitted_objective, double predicted_objective, double worst_predicted);
// Adds the analysis of a search (a law on a device) to its fit. The fit must already have the force of its best run.
void add_analysis(DeviceFit& fit, campaign::Contents const& contents, campaign::Search const& search);
// Must be called after the fits of this law on all devices are filled in.
void add_lot_analysis(LawResult& law, campaign::Contents const& contents);
// front_of() returns true for each law that no other law beats; mark_front() stores this in the member `on_front`.
// Smaller is better in both coordinates. A law that lacks one of them is never on the front.
using Coordinate = std::optional<double> (*)(LawResult const&);
std::vector<bool> front_of(std::vector<LawResult> const& laws, Coordinate robust, Coordinate accurate);
void mark_front(std::vector<LawResult>& laws, Coordinate robust, Coordinate accurate, bool LawResult::*on_front);
// Marks the laws on two fronts: objective_converged against beta_converged, and objective_converged against
// loo_objective. Then adds the outlying devices. Does nothing while runs or analyses are missing. Must be called after
// all laws are filled in.
void add_converged_views(Summary& summary);

}  // namespace isolaw::study
