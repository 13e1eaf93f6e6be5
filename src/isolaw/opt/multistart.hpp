// Minimises a sum of absolute residuals over the unit box by descents from many starts.
// In each round, descents begin at points scattered over the box (Latin hypercube) and then at disturbed copies of the
// best point (hops, as in basin hopping). A descent is a Levenberg-Marquardt iteration with bounds. It minimises sum w
// sqrt(r^2 + delta^2), which rounds off the corner of |r|. delta begins at the size of the residuals, where the sum
// resembles a sum of squares, and falls to a hundredth of that size. Finite differences give the Jacobian in one batch,
// and every iteration tries several steps at once. A problem may offer an outline: about a third of the residuals, with
// the same valleys. A descent then minimises the outline first and uses all residuals only for its last steps.
// The search ends when enough descents have ended at the best value. It ends early if nearly all scattered starts did.
// If there are other valleys it takes longer, and if few descents ended there it makes all starts. It makes a third
// more if many ended close to the best value. In more than fourteen dimensions it makes two and a half times as many,
// half hops.
// Rejected: descending only from starts of low value. For the laws in their boxes these lie in the wrong valleys.
#pragma once

#include <functional>
#include <span>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

// campaign::setting_table() holds the limits of each option. A descent that ends at the best value is called a hit.
struct MultistartOptions {
  int least_starts = 16;  // number of descents if three quarters of the scattered starts are hits
  // Number of descents in other cases. A third of it suffices after a dozen hits if two fifths of the scattered starts
  // are hits. A third more are made if half of the scattered starts end within ten hit tolerances of the best value.
  int starts = 72;
  int hits = 3;                    // the search continues until it has this many hits
  double hit_tolerance = 5e-4;     // relative distance of a hit from the best value
  int most_evaluations = 200'000;  // after this number no new round begins
  int scattered = 12;              // scattered starts in a round
  int hops = 4;                    // hops in a round
};

struct MultistartResult : SearchResult {
  int starts = 0;  // number of descents
  int hits = 0;    // number of descents that ended within the tolerance of the best value
};

// Outcomes: confirmed by enough hits; budget_spent after most_evaluations; interrupted; no_finite_value if no scattered
// start of the first round has a value. Residuals of an outline count as a part of an evaluation. The history ends with
// the value after polishing. A stream determines the result, however many threads help (base/work_ahead.hpp). `interrupted`,
// if given, is called before each start. Throws Error if the problem has no dimensions.
MultistartResult minimise_multistart(DeviationProblem const& problem, num::Stream const& stream,
                                     MultistartOptions const& options = {},
                                     std::function<bool()> const& interrupted = {});

// One descent to the last digits from a point near a minimum, for problems that differ little from one already solved.
// The result is never above the value at the start; it is not usable if that value is not finite. `rounding` * value is
// the first delta; a small delta keeps the descent in its valley. `brief` ends with about four right digits, for sets
// of many descents none of which is reported alone. Throws Error if the problem has no dimensions.
Found descend(DeviationProblem const& problem, std::span<double const> start, double rounding = 0.3,
              bool brief = false);

}  // namespace isolaw::opt
