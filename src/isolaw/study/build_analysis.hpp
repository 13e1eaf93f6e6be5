// The part of a summary that rests on the analyses: what the tests determine, the lot's law, prediction.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// A run this close to the least objective of its campaign, relative, has found it.
inline constexpr double found_within = 1e-3;
// A prediction is as good as the mean objective on the blocks predicted, up to these; above the last it is unusable.
inline constexpr double good_prediction = 0.1, fair_prediction = 0.3, poor_prediction = 0.6;
// And it collapses, unusable too, where a block is missed by more than its force's standard deviation, as a constant
// force would, or by a visible part of it that is this many times what the law misses the blocks it was fitted to.
inline constexpr double collapsed_objective = 1.0, collapsed_ratio = 10.0, collapsed_least = 0.2;
// docs/decision.md says why these.
PredictionGrade graded(double fitted_objective, double predicted_objective, double worst_predicted);
// How such a prediction collapses: it misses a block as a constant force would, or far more than those it was fitted to.
enum class Collapse { no, constant, far };
std::string_view name(Collapse collapse);  // "no", "constant", "far"
Collapse collapse(double fitted_objective, double predicted_objective, double worst_predicted);

// `made` is what build_summary has made of the search so far; needs its best run's forces.
void add_analysis(DeviceFit& made, campaign::Contents const& contents, campaign::Search const& search);

// After every device's fit of the law is there.
void add_lot_analysis(LawResult& law, campaign::Contents const& contents);

// Which laws no other law beats in both; one without a value of either is never among them.
using Coordinate = std::optional<double> (*)(LawResult const&);
std::vector<bool> front_of(std::vector<LawResult> const& laws, Coordinate robust, Coordinate accurate);
void mark_front(std::vector<LawResult>& laws, Coordinate robust, Coordinate accurate, bool LawResult::*on_front);

// After every law: the fronts without noise, and devices that stand apart.
void add_converged_views(Summary& summary);

}  // namespace isolaw::study
