// Minimises a sum of absolute residuals over the unit box by descents from many starts.
// A round descends from points scattered over the box (Latin hypercube), then from disturbed copies of the best point
// (hops, as in basin hopping). A descent is a Levenberg-Marquardt iteration with bounds. It minimises
// sum w sqrt(r^2 + delta^2), which rounds off the corner of the absolute value; delta falls from the size of the
// residuals, where the sum behaves like a sum of squares, to a hundredth of that size. The Jacobian comes from finite
// differences in one batch, and every iteration tries several steps at once. If the problem has an outline (about a
// third of the residuals, with the same valleys), a descent first minimises it; only the last steps use all residuals.
// The search ends when enough descents have ended at the best value: early if nearly all scattered ones did, later if
// there are other valleys, after all starts if few descents ended at that value, and after a third more if many ended
// close to it. In more than fourteen dimensions a round makes as many hops as scattered starts, and a search makes two
// and a half times as many descents.
// Rejected: descending only from starts of low value. In the laws' boxes such starts lie in the wrong valleys.
#pragma once

#include <functional>
#include <span>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

// campaign::setting_table() holds the limits of each option. A hit is a descent that ended at the best value.
struct MultistartOptions {
  int least_starts = 16;  // descents that suffice if three quarters of the scattered ones are hits
  // Descents in all other cases. A third of these suffice if there are a dozen hits and two fifths of the scattered
  // descents are hits; a third more are made if half of the scattered ones ended within ten tolerances of the best.
  int starts = 72;
  int hits = 3;                    // the search goes on until there are this many
  double hit_tolerance = 5e-4;     // relative distance from the best value
  int most_evaluations = 200'000;  // after these no round begins
  int scattered = 12;              // scattered starts in a round
  int hops = 4;                    // hops in a round
};

struct MultistartResult : SearchResult {
  int starts = 0;  // descents made
  int hits = 0;    // how many of them ended within the tolerance of the best value
};

// Outcomes: confirmed by enough hits; budget_spent after most_evaluations; interrupted; no_finite_value if no scattered
// point of the first round had a value. An evaluation of the outline counts as its share of the residuals. The history
// ends with the value after the final refinement. Deterministic for a given stream, however many threads help
// (base/ahead.hpp). `interrupted`, if given, is called before each start. Throws Error if there are no dimensions.
MultistartResult minimise_multistart(DeviationProblem const& problem, num::Stream const& stream,
                                     MultistartOptions const& options = {},
                                     std::function<bool()> const& interrupted = {});

// One descent to the last digits from a point near a minimum, for a problem that has changed a little. The result is
// never above the value at the start, and not usable if the start has no value. `rounding` is the first delta, as a
// share of the value at the start; a small one keeps the descent in its valley. `brief` stops when about four digits
// are right, for many descents of which none is reported by itself. Throws Error for a problem without dimensions.
Found descend(DeviationProblem const& problem, std::span<double const> start, double rounding = 0.3,
              bool brief = false);

}  // namespace isolaw::opt
