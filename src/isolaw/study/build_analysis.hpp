// Adds to a summary what the analyses found: which parameters the tests determine, the law of the lot, prediction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// A run that ends within this relative distance of the campaign's least objective has found it.
inline constexpr double found_within = 1e-3;
// The largest mean objective on the predicted blocks for each grade. Beyond poor_prediction it is unusable.
inline constexpr double good_prediction = 0.1, fair_prediction = 0.3, poor_prediction = 0.6;
// A prediction that collapses is unusable too: the objective on some block exceeds collapsed_objective, which a
// constant force also gives, or the mean objective is at least collapsed_least and more than collapsed_ratio times the
// mean on the fitted blocks. docs/decision.md gives the reasons.
inline constexpr double collapsed_objective = 1.0, collapsed_ratio = 10.0, collapsed_least = 0.2;
PredictionGrade graded(double fitted_objective, double predicted_objective, double worst_predicted);
// constant: it misses a block as a constant force would; far: it misses predicted blocks far more than fitted ones.
enum class Collapse { no, constant, far };
std::string_view name(Collapse collapse);  // "no", "constant", "far"
Collapse collapse(double fitted_objective, double predicted_objective, double worst_predicted);
// Adds the analysis of a search to the fit that build_summary() has filled in; needs the forces of its best run.
void add_analysis(DeviceFit& fit, campaign::Contents const& contents, campaign::Search const& search);
// To be called when every device's fit of the law is filled in.
void add_lot_analysis(LawResult& law, campaign::Contents const& contents);
// True for each law that no other law beats in both coordinates. A law that lacks one of them is never on the front.
using Coordinate = std::optional<double> (*)(LawResult const&);
std::vector<bool> front_of(std::vector<LawResult> const& laws, Coordinate robust, Coordinate accurate);
void mark_front(std::vector<LawResult>& laws, Coordinate robust, Coordinate accurate, bool LawResult::*on_front);
// To be called after all laws are filled in. Adds the fronts without the optimiser's noise, and the outliers.
void add_converged_views(Summary& summary);

}  // namespace isolaw::study
