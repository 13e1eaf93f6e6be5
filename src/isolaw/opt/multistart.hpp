// The smallest sum of absolute residuals over the unit box, sought by descents from many starts.
//
// Starts are scattered over the box (Latin hypercube); in between, the best point found is disturbed and descended from
// again (basin hopping). A descent is a Levenberg-Marquardt iteration with bounds on sum w sqrt(r^2 + delta^2), the
// absolute value rounded off at its corner; delta falls from the size of the residuals, where the sum behaves as a sum
// of squares, to a hundredth of it. The Jacobian comes from differences, all of it in one batch, and every iteration
// tries several steps at once. It goes by the problem's outline, where there is one, down to the outline's floor: a
// third of the residuals find the same valleys; the last iterations are by all of them. The search ends when enough
// descents have ended at the best value: soon where nearly all of the scattered ones do, later where there are other
// valleys, and after all its starts where few have, a third more where many ended close to it. In more than fourteen
// dimensions as many hops as scattered starts are made, and two and a half times as many descents.
//
// Points are not screened by their value before a descent: in the laws' boxes the low ones lie in the wrong valleys.
#pragma once

#include <functional>
#include <span>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

// What each may be says campaign::setting_table().
struct MultistartOptions {
  int least_starts = 16;  // descents, where three quarters of the scattered ones end at the best value
  // Elsewhere; a third of these where a dozen ended there, among them two fifths of the scattered; a third more where
  // half of the scattered ones ended within ten tolerances of it.
  int starts = 72;
  int hits = 3;                    // descents that must have ended at the best value
  double hit_tolerance = 5e-4;     // relative
  int most_evaluations = 200'000;  // no round begins after these
  int scattered = 12;              // starts of a round, over the box
  int hops = 4;                    // of a round, about the best point
};

struct MultistartResult : SearchResult {
  int starts = 0;  // descents
  int hits = 0;    // of them, those that ended within the tolerance of the best value
};

// Outcomes: confirmed; budget_spent; interrupted; no_finite_value where none of the first scattered points had a value.
// Evaluations by the outline count as its share of the residuals; the history ends with the value after the last
// refinement. Deterministic for a given stream, however many threads help (base/ahead.hpp). `interrupted`, when given,
// is asked before each start.
// Throws Error for a problem without dimensions.
MultistartResult minimise_multistart(DeviationProblem const& problem, num::Stream const& stream,
                                     MultistartOptions const& options = {},
                                     std::function<bool()> const& interrupted = {});

// One descent from a point near a minimum, to its last digits: after the problem has changed a little. Nothing usable
// when the start has no value, and never a value above its. `rounding` is the first delta, as a share of the value at
// the start: small keeps the descent in its valley. `brief`: to about a ten-thousandth of the value, for many descents
// of which none is reported by itself. Throws Error for a problem without dimensions.
Found descend(DeviationProblem const& problem, std::span<double const> start, double rounding = 0.3,
              bool brief = false);

}  // namespace isolaw::opt
