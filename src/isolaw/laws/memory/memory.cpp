// Fills in the Memory of a path. Source: the sections on power-masing and gallardo in docs/laws.md.
#include <algorithm>
#include <vector>

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/memory/followed.hpp"
#include "isolaw/laws/memory/open_branches.hpp"
#include "isolaw/laws/memory/remembered.hpp"
#include "isolaw/laws/memory/softening.hpp"
#include "isolaw/laws/memory/wear.hpp"

namespace isolaw::laws {

std::vector<double> followed(std::span<double const> x, double dead_band) {
  std::vector<double> motion;
  motion.reserve(x.size());
  Followed<double> follower;
  for (double const to : x) motion.push_back(follower.move(to, dead_band));
  return motion;
}

void remember(Path& path) {
  Remembered<double, OpenBranches, Wear<double>, Sides<double>, Softening<double>> all;
  path.memory.clear();
  path.memory.reserve(path.steps.size());
  path.deepest = 0;
  for (auto const& step : path.steps) {
    bool const first = path.memory.empty();
    all.move(first ? 0.0 : step.x0, step.x1, 0.0);
    path.memory.push_back({.turns = all.turns,
                           .turn_index = all.turn_index,
                           .first_dropped = all.first_dropped,
                           .branch_index = all.branch_index,
                           .branch_x = all.branch_x,
                           .direction = all.direction,
                           .peak0 = all.peak0,
                           .peak = all.peak,
                           .length_below_peak = all.length_below_peak,
                           .side_peak = all.side_peak,
                           .virgin_share = all.virgin_share,
                           .log2_worn = all.log2_worn,
                           .one_sided_growth = all.one_sided_growth,
                           .log2_softening = all.log2_softening,
                           .log2_way_back = all.log2_way_back,
                           .side = all.side,
                           .softens = all.softens,
                           .returns = all.returns,
                           .peak_grows = all.peak_grows,
                           .side_peak_grows = all.side_peak_grows});
    path.deepest = std::max(path.deepest, all.depth);
  }
}

}  // namespace isolaw::laws
