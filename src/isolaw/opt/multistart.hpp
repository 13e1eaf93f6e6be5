// Minimises a sum of absolute residuals over the unit box by descents from many starts. In each round, descents begin
// at points scattered over the box (Latin hypercube) and then at disturbed copies of the best point (hops, as in basin
// hopping). A descent is a Levenberg-Marquardt iteration with bounds. It minimises sum w sqrt(r^2 + delta^2), which
// rounds off the corner of |r|. delta begins at the size of the residuals, where the sum resembles a sum of squares,
// and falls to a hundredth of that size. All points that the finite differences of a Jacobian need are computed in one
// batch, and every iteration tries several steps at once. A problem may offer an outline: a smaller problem with about
// a third of the residuals, whose minima lie in the same valleys. A descent then minimises the outline first and uses
// all residuals only for its last steps. A descent that ends at the best value is a hit. The larger the share of hits,
// the fewer descents the search makes (see MultistartOptions). In more than fourteen dimensions it makes up to 2.5
// times `starts` descents, half of them hops. Rejected: descending only from the starts of lowest value. For isolaw's
// laws these starts lie in the wrong valleys.
#pragma once

#include <functional>
#include <span>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

struct MultistartOptions {  // campaign::setting_table() holds the limits of each option
  int least_starts = 16;    // number of descents if three quarters of the scattered starts are hits
  // Number of descents if less than three quarters of the scattered starts are hits. A third of this number suffices
  // after a dozen hits if two fifths of the scattered starts are hits. Otherwise the number rises by a third if half of
  // the scattered starts end within ten hit tolerances of the best value.
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
// start of the first round has a finite value. A point on an outline with a third of the residuals counts as a third of
// an evaluation. The history ends with the value after polishing. `stream` determines the result, however many threads
// help (base/work_ahead.hpp). `interrupted`, if given, is called before each start; the search ends if it returns true.
// Throws Error if the problem has no dimensions.
MultistartResult minimise_multistart(DeviationProblem const& problem, num::Stream const& stream,
                                     MultistartOptions const& options = {},
                                     std::function<bool()> const& interrupted = {});

// Points scattered evenly over the unit box: along each coordinate, each of `count` equal intervals holds one point.
Points latin_hypercube(std::size_t dimension, std::size_t count, num::Draws& draws);

// Makes one descent from a point near a minimum, for a problem that differs little from one already solved. The result
// is never above the value at the start; it is not usable if that value is not finite. The first delta is `rounding`
// times the value at the start; a small delta keeps the descent in its valley. A `brief` descent ends with about four
// correct digits, which is enough where many results are summarised, as in a bootstrap. Throws Error if the problem has
// no dimensions.
BestPoint descend(DeviationProblem const& problem, std::span<double const> start, double rounding = 0.3,
                  bool brief = false);

}  // namespace isolaw::opt
