// Fills in the Memory of a path: turning points by Masing's rules, and for each side its peak, travel, softening and
// travel back. Source: docs/laws.md, power-masing and gallardo.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {
namespace {

// The travel N of a side is relative to its peak m and is forgotten as the peak grows: dN = |dx|/m - 60 N dm/m. During
// a first motion from 0, N is therefore 1/60.
constexpr int forgetting = 60;
constexpr double catching_up = 0.5;  // share by which the followed motion is faster than x after a turn
// Shares of the travel outwards and back that add to the softening G.
constexpr double softening_outwards = 0.5, softening_back = 4.0;

double travel_as_the_peak_grows(double travel, double from, double to) {
  constexpr double virgin = 1.0 / forgetting;
  return virgin + (travel - virgin) * std::pow(from / to, forgetting);
}

struct Side {
  double peak = 0.0, travel = 0.0;
  double softening = 0.0, way_back = 0.0;
  double reported_softening = 0.0, reported_way_back = 0.0;

  void move(double x0, double x1) {  // x0 and x1 are on this side or 0
    double const from = std::abs(x0), to = std::abs(x1);
    if (to > from)
      outwards(from, to);
    else if (to < from)
      back(from, to);
    if (peak > 0.0) travel += std::abs(std::min(to, peak) - std::min(from, peak)) / peak;
    if (to <= peak) return;
    travel = travel_as_the_peak_grows(travel, peak, to);
    peak = to;
  }

 private:
  // A run is a motion in one direction on this side. It is summed from its start, in however many steps.
  struct Run {
    bool goes_out = true;
    double at = 0.0, peak = 0.0, softening = 0.0, way_back = 0.0;
  };

  void begin(bool goes_out, double at) {
    if (goes_out != run_.goes_out)
      run_ = {.goes_out = goes_out, .at = at, .peak = peak, .softening = softening, .way_back = way_back};
  }
  void outwards(double from, double to) {
    begin(true, from);
    double const inside = std::min(to, run_.peak) - run_.at, beyond = std::max(0.0, to - run_.peak);
    softening = std::min(run_.softening + softening_outwards * inside, run_.peak) + softening_outwards * beyond;
  }
  void back(double from, double to) {
    begin(false, from);
    way_back = run_.way_back + (run_.at - to);
    softening = std::min(run_.softening + softening_back * (run_.at - to), run_.peak);
  }

  Run run_;
};

double log2_of(double length) {
  return std::log2(std::max(length, num::smallest_power_base));
}

class Walk {
 public:
  Memory to(double x0, double x1) {
    Memory now;
    double const direction = x1 > x0 ? 1.0 : x1 < x0 ? -1.0 : direction_;
    if (direction != direction_ && direction_ != 0.0) {
      now.kept = turned_.size();
      turned_.push_back(x0);
    }
    direction_ = direction;
    if (x1 != x0) close(x1);
    if (!turned_.empty()) {
      now.branch = turned_.size() - 1;
      now.branch_x = turned_.back();
    }
    now.side = x1 < 0.0 ? 1 : 0;
    auto& side = sides_[now.side];
    double const side_peak = side.peak;
    if (x0 * x1 < 0.0) {
      sides_[1 - now.side].move(x0, 0.0);
      side.move(0.0, x1);
    } else if (x0 < 0.0 || x1 < 0.0) {
      sides_[1].move(x0, x1);
    } else {
      sides_[0].move(x0, x1);
    }
    now.direction = direction;
    now.peak0 = peak_;
    now.peak = peak_ = std::max(peak_, std::abs(x1));
    now.inside = std::abs(x1 - x0) - (now.peak - now.peak0);
    if (now.peak0 > 0.0) travel_ += now.inside / now.peak0;
    if (now.peak > now.peak0) {
      travel_ = travel_as_the_peak_grows(travel_, now.peak0, now.peak);
      pushed_ += x1 < 0.0 ? now.peak0 - now.peak : now.peak - now.peak0;
    }
    now.log2_worn = std::log2(1.0 + travel_);
    now.pushed = pushed_;
    now.side_peak = side.peak;
    now.travel = side.travel;
    now.virgin = 1.0 / std::cbrt(1.0 + side.travel);
    now.softening = side.softening;
    now.way_back = side.way_back;
    now.log2_softening = log2_of(side.softening);
    now.log2_way_back = log2_of(side.way_back);
    now.softens = std::exchange(side.reported_softening, side.softening) != side.softening;
    now.returns = std::exchange(side.reported_way_back, side.way_back) != side.way_back;
    now.peak_grows = now.peak > now.peak0;
    now.side_peak_grows = side.peak > side_peak;
    return now;
  }

 private:
  // A branch that reaches the start of the branch before it closes together with that branch. The last branch closes
  // where it meets the skeleton, at the mirror image of its start.
  void close(double x) {
    auto const passes = [&](double target) { return direction_ * (x - target) >= 0.0; };
    while (turned_.size() >= 2 && passes(turned_[turned_.size() - 2])) turned_.resize(turned_.size() - 2);
    if (turned_.size() == 1 && passes(-turned_.front())) turned_.clear();
  }

  std::vector<double> turned_;
  Side sides_[2];
  double direction_ = 0.0, peak_ = 0.0, travel_ = 0.0, pushed_ = 0.0;
};

}  // namespace

std::vector<double> followed(std::span<double const> x, double dead_band) {
  std::vector<double> motion;
  motion.reserve(x.size());
  double behind = 0.0, lead = 0.0;  // a point that x pulls along, and how far ahead of it the followed motion is
  for (double const to : x) {
    double const before = std::exchange(behind, std::clamp(behind, to - dead_band, to + dead_band));
    double const moved = std::abs(behind - before);
    lead += std::clamp((behind > before ? dead_band : -dead_band) - lead, -catching_up * moved, catching_up * moved);
    motion.push_back(behind + lead);
  }
  return motion;
}

void remember(Path& path) {
  Walk walk;
  path.memory.clear();
  path.memory.reserve(path.steps.size());
  path.deepest = 0;
  for (auto const& step : path.steps) {
    bool const first = path.memory.empty();
    path.memory.push_back(walk.to(first ? 0.0 : step.x0, step.x1));
    if (auto const kept = path.memory.back().kept; kept != Memory::none)
      path.deepest = std::max(path.deepest, kept + 1);
  }
}

}  // namespace isolaw::laws
