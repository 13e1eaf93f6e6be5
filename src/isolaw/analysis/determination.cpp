#include "isolaw/analysis/determination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "isolaw/analysis/sensitivity.hpp"
#include "isolaw/base/work_ahead.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::analysis {
namespace {

using num::Index;
using num::Matrix;
using num::Vector;
using Point = std::vector<double>;

struct GivenUp {};

Point without(Point point, std::size_t coordinate) {
  point.erase(point.begin() + static_cast<std::ptrdiff_t>(coordinate));
  return point;
}
Point with(Point point, std::size_t coordinate, double value) {
  point.insert(point.begin() + static_cast<std::ptrdiff_t>(coordinate), value);
  return point;
}

// Computes for each free parameter the profile of the objective (determination.hpp). If a profile comes to a point with
// a lower objective than the optimum, this point becomes the optimum, and all profiles are computed again from it.
class Examination {
 public:
  Examination(fit::LawOnRecord const& model, fit::SearchBox const& box, Point optimum, Interrupted const& interrupted)
      : model_(model),
        box_(box),
        problem_(model, box),
        interrupted_(interrupted),
        free_(free_parameters(box)),
        best_(std::move(optimum)) {
    if (!free_.empty()) best_value_ = value_at(best_, result_.evaluations);
  }

  Determination run() {
    if (free_.empty()) return closed();
    if (!std::isfinite(best_value_)) return nothing_determined();
    do {
      result_.parameters.clear();
      rise_ = least_seen();
      look_around();
    } while (!profile_all());
    return closed();
  }

 private:
  double least_seen() const { return std::max(visible_rise * best_value_, least_visible_rise); }

  Determination closed() {
    result_.optimum.resize(box_.parameters.size());
    box_.expand(best_, result_.optimum);
    std::vector<double> work;
    result_.objective = best_value_ = model_.objective(result_.optimum, work);
    result_.rise = free_.empty() ? least_seen() : rise_;
    return result_;
  }

  // The result if the law has no finite force at the optimum: every free parameter is undetermined, with its whole
  // interval as its range.
  Determination nothing_determined() {
    for (auto const* p : free_)
      result_.parameters.push_back({.parameter = index_of(*p),
                                    .verdict = Verdict::undetermined,
                                    .lower = p->lower,
                                    .upper = p->upper,
                                    .open_below = true,
                                    .open_above = true,
                                    .profile = {}});
    return closed();
  }

  std::size_t index_of(fit::SearchParameter const& p) const {
    return static_cast<std::size_t>(&p - box_.parameters.data());
  }

  // Estimates how much the force must change to raise the objective by `rise_`: the root mean square of the change,
  // divided by the standard deviation of the force. Assumes that the residuals have a two-sided exponential
  // distribution whose mean magnitude is the objective. The result is at least `rise_`.
  double visible_change() const { return std::max(std::sqrt(2.0 * best_value_ * rise_), rise_); }

  double value_at(Point const& point, int& evaluations) const {
    opt::Points one(point.size(), 1);
    std::ranges::copy(point, one[0].begin());
    double value = 0.0;
    problem_.evaluate(one, std::span(&value, 1));
    ++evaluations;
    return value;
  }
  double value_of(std::size_t k) const { return free_[k]->at(best_[k]); }
  bool at_bound(std::size_t k) const {
    return best_[k] <= fit::bound_tolerance || best_[k] >= 1.0 - fit::bound_tolerance;
  }

  // Finds parameters without a visible effect on the force. For all other parameters, finds the singular values of the
  // force's derivatives with respect to relative changes of these parameters, and the trade-offs among them.
  void look_around() {
    auto const response = sensitivity(problem_, best_);
    result_.evaluations += static_cast<int>(2 * free_.size() + 1);
    weighted_ = response.weights.cwiseSqrt().asDiagonal() * response.jacobian;
    result_.singular_values.clear();
    result_.trade_offs.clear();
    std::vector<std::size_t> acting;
    Matrix relative(weighted_.rows(), weighted_.cols());
    for (std::size_t k = 0; k < free_.size(); ++k) {
      if (at_bound(k)) continue;
      double const value = value_of(k), size = std::copysign(natural_size(*free_[k], value), value);
      auto const column = static_cast<Index>(acting.size());
      relative.col(column) = weighted_.col(static_cast<Index>(k)) * size / slope(*free_[k], best_[k]);
      double const force_change = relative.col(column).norm();
      if (is_seen(force_change))
        acting.push_back(k);
      else
        add_trade_off({k}, {1.0}, force_change);
    }
    if (acting.empty()) return;
    relative.conservativeResize(Eigen::NoChange, static_cast<Index>(acting.size()));
    Vector const alone = relative.colwise().norm();
    auto const [values, directions] = num::singular_values(relative);
    for (Index i = 0; i < values.size(); ++i) {
      result_.singular_values.push_back(values[i]);
      add_direction(directions.col(i), values[i], acting, alone);
    }
  }

  // Returns whether a change of the parameters by 50 % (weakly_determined_within) changes the force visibly.
  // `force_change` is the change of the force for a change of 100 %; the force is taken as linear.
  bool is_seen(double force_change) const { return weakly_determined_within * force_change >= visible_change(); }

  // Adds a direction of parameter changes to the trade-offs if a move along it does not change the force visibly, and
  // if at least two parameters act on the force at all. alone[i] is the force change if only parameter i changes, by
  // 100 %. The trade-off names every parameter whose change, or whose effect on the force, is at least a tenth of the
  // largest. It also names the parameter with the strongest effect besides the one that changes most, so that it always
  // names at least two.
  void add_direction(Vector const& direction, double singular_value, std::vector<std::size_t> const& acting,
                     Vector const& alone) {
    constexpr double takes_part = 0.1;
    Index largest = 0;
    double const most = direction.cwiseAbs().maxCoeff(&largest), force_change = singular_value / most;
    if (is_seen(force_change) || acting.size() < 2) return;
    Vector const change = direction / direction[largest];
    Vector const moved = change.cwiseAbs().cwiseProduct(alone);
    double second = 0.0;
    for (Index i = 0; i < moved.size(); ++i)
      if (i != largest) second = std::max(second, moved[i]);
    std::vector<std::size_t> taking_part;
    std::vector<double> changes;
    for (Index i = 0; i < change.size(); ++i) {
      if (std::abs(change[i]) < takes_part && moved[i] < std::min(takes_part * moved.maxCoeff(), second)) continue;
      taking_part.push_back(acting[static_cast<std::size_t>(i)]);
      changes.push_back(change[i]);
    }
    add_trade_off(taking_part, std::move(changes), force_change);
  }

  void add_trade_off(std::vector<std::size_t> const& coordinates, std::vector<double> change, double force_change) {
    TradeOff found{.parameters = {}, .change = std::move(change), .force_change = force_change, .sentence = {}};
    std::vector<std::string> names;
    for (auto const k : coordinates) {
      found.parameters.push_back(index_of(*free_[k]));
      names.push_back(free_[k]->name);
    }
    found.sentence = trade_off_sentence(names, found.change);
    result_.trade_offs.push_back(std::move(found));
  }

  // Estimates how far coordinate k can move before the force changes visibly, and how the other coordinates follow.
  std::pair<double, Vector> first_order(std::size_t k) const {
    auto const column = static_cast<Index>(k);
    Matrix others(weighted_.rows(), weighted_.cols() - 1);
    others << weighted_.leftCols(column), weighted_.rightCols(weighted_.cols() - 1 - column);
    Vector follow = Vector::Zero(others.cols());
    Vector remains = weighted_.col(column);
    if (others.cols() > 0) {
      follow = -num::least_squares(others, weighted_.col(column));
      remains += num::apply(others, follow);
    }
    double const norm = remains.norm();
    double const most = 0.1;
    return {norm > 0.0 ? std::min(visible_change() / norm, most) : most, follow};
  }

  struct Side {
    // For each point of the profile, from the optimum outwards: the parameter's coordinate in the unit box, and the
    // objective there.
    std::vector<std::pair<double, double>> points;
    double end = 0.0;   // coordinate where the objective is rise_ above its least value, or else the edge of the box
    bool open = false;  // true if the objective does not rise by rise_ before the edge of the box
  };
  // The profile of a parameter below and above the optimum. If it meets an objective lower than the optimum's, it stops
  // there and keeps the point in `lower_at` and the objective in `lower`.
  struct Sides {
    Side below = {}, above = {};
    int evaluations = 0;
    Point lower_at = {};
    double lower = 0.0;

    bool found_lower() const { return !lower_at.empty(); }
  };

  // Returns false if a profile found a lower objective. The profiles of later parameters are then discarded.
  bool profile_all() {
    std::vector<Sides> sides(free_.size());
    WorkAhead profiles(sides.size(), [&](std::size_t k) { sides[k] = profiled(k); });
    for (std::size_t k = 0; k < sides.size(); ++k) {
      if (interrupted_ && interrupted_()) throw GivenUp();
      profiles.need(k);
      result_.evaluations += sides[k].evaluations;
      if (sides[k].found_lower()) {
        best_ = sides[k].lower_at;
        best_value_ = sides[k].lower;
        return false;
      }
      result_.parameters.push_back(judged(k, sides[k].below, sides[k].above));
    }
    return true;
  }

  Sides profiled(std::size_t k) const {
    auto const [reach, follow] = first_order(k);
    Sides sides;
    sides.below = profile_side(k, -1.0, reach, follow, sides);
    if (!sides.found_lower()) sides.above = profile_side(k, 1.0, reach, follow, sides);
    return sides;
  }

  Side profile_side(std::size_t k, double sign, double reach, Vector const& follow, Sides& sides) const {
    // The profile goes on until the objective has risen by this many times rise_, so that figures show more than the
    // range in which it rises by less than rise_.
    constexpr double rises_shown = 4.0;
    double const room = sign > 0.0 ? 1.0 - best_[k] : best_[k];
    Side side;
    double distance = 0.0, step = 0.5 * reach;
    Point others = without(best_, k);
    for (std::size_t i = 0; i < others.size(); ++i)
      if (std::isfinite(follow[static_cast<Index>(i)]))
        others[i] = std::clamp(others[i] + sign * step * follow[static_cast<Index>(i)], 0.0, 1.0);
    constexpr int most_points = 12;
    for (int i = 0; i < most_points && distance < room; ++i) {
      double const next = std::min(distance + step, room);
      double const u = std::clamp(best_[k] + sign * next, 0.0, 1.0);
      auto const [point, value] = refitted(k, u, others, sides.evaluations);
      if (value < best_value_ * (1.0 - 1e-4) - 1e-9) {
        sides.lower_at = with(point, k, u);
        sides.lower = value;
        auto const polished = opt::descend(problem_, sides.lower_at);
        sides.evaluations += polished.evaluations;
        if (polished.usable()) sides.lower_at = polished.best;
        sides.lower = std::min(value, polished.best_value);
        return side;
      }
      if (side.points.empty() && value > best_value_ + rises_shown * rise_ && step > 1e-7 && i < 6) {
        step *= 0.2;
        others = without(best_, k);
        continue;
      }
      side.points.emplace_back(u, value);
      if (value > best_value_ + rises_shown * rise_) break;
      if (!point.empty()) others = point;
      distance = next;
      step = side.points.size() < 4 ? step : 1.7 * step;
    }
    find_end(side, k, sign);
    return side;
  }

  // Holds coordinate k at u and fits the others again, starting from `others`. Returns the others and the objective.
  std::pair<Point, double> refitted(std::size_t k, double u, Point const& others, int& evaluations) const {
    HeldCoordinateProblem const held(problem_, k, u);
    if (others.empty()) return {Point(), value_at({u}, evaluations)};
    auto found = opt::descend(held, others, 0.2, true);
    evaluations += found.evaluations;
    return {std::move(found.best), found.best_value};
  }

  // Finds the coordinate where the objective has risen by rise_. Interpolates the square root of the rise, because the
  // rise grows about with the square of the distance from the optimum.
  void find_end(Side& side, std::size_t k, double sign) const {
    double before_u = best_[k], before = 0.0;
    for (auto const& [u, value] : side.points) {
      double const root = std::isfinite(value) ? std::sqrt(std::max(0.0, value - best_value_) / rise_) : 2.0;
      if (root >= 1.0) {
        side.end = before_u + (u - before_u) * (1.0 - before) / (root - before);
        return;
      }
      before_u = u;
      before = root;
    }
    side.open = true;
    side.end = sign > 0.0 ? 1.0 : 0.0;
  }

  ParameterDetermination judged(std::size_t k, Side const& below, Side const& above) const {
    auto const& p = *free_[k];
    ParameterDetermination result;
    result.parameter = index_of(p);
    result.lower = p.at(below.end);
    result.upper = p.at(above.end);
    result.open_below = below.open;
    result.open_above = above.open;
    auto const add = [&](double u, double objective) {
      if (!std::isfinite(objective)) return;
      result.profile.value.push_back(p.at(u));
      result.profile.objective.push_back(objective);
    };
    for (std::size_t i = below.points.size(); i-- > 0;) add(below.points[i].first, below.points[i].second);
    add(best_[k], best_value_);
    for (auto const& [u, objective] : above.points) add(u, objective);

    double const value = value_of(k);
    double const half = std::max(value - result.lower, result.upper - value) / natural_size(p, value);
    if (half > weakly_determined_within || (below.open && above.open))
      result.verdict = Verdict::undetermined;
    else if (at_bound(k))
      result.verdict = Verdict::at_bound;
    else
      result.verdict =
          half > determined_within || below.open || above.open ? Verdict::weakly_determined : Verdict::determined;
    return result;
  }

  fit::LawOnRecord const& model_;
  fit::SearchBox const& box_;
  fit::IdentificationProblem problem_;
  Interrupted const& interrupted_;
  std::vector<fit::SearchParameter const*> free_;
  Point best_;
  double best_value_ = 0.0;
  double rise_ = 0.0;
  // The derivatives of each sample's residual (row) with respect to the free parameters' coordinates in the unit box
  // (columns), times the square root of the sample's weight.
  Matrix weighted_;
  Determination result_;
};

std::string listed(std::vector<std::string> const& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace

std::string_view name(Verdict verdict) {
  constexpr std::string_view names[]{"determined", "weakly determined", "undetermined", "at its bound"};
  return names[static_cast<std::size_t>(verdict)];
}

std::string trade_off_sentence(std::vector<std::string> const& names, std::span<double const> change) {
  if (names.size() == 1) return fmt::format("{} does not act on this record", names[0]);
  if (names.size() == 2) {
    constexpr double equal = 0.1;
    double const sum = std::abs(change[0] + change[1]), difference = std::abs(change[0] - change[1]);
    if (sum < equal) return fmt::format("{} trade off: only their product shapes the loop", listed(names));
    if (difference < equal) return fmt::format("{} trade off: only their ratio shapes the loop", listed(names));
  }
  auto const largest = static_cast<std::size_t>(
      std::ranges::max_element(change, {}, [](double c) { return std::abs(c); }) - change.begin());
  std::vector<std::string> others;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (i != largest) others.push_back(fmt::format("{} {:+.2g} %", names[i], 10.0 * change[i] / change[largest]));
  return fmt::format("{} trade off: {} +10 % is undone by {}", listed(names), names[largest], listed(others));
}

std::optional<Determination> determine(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                       std::span<double const> optimum, Interrupted const& interrupted) {
  try {
    return Examination(model, box, box.contract(optimum), interrupted).run();
  } catch (GivenUp const&) {
    return std::nullopt;
  }
}

}  // namespace isolaw::analysis
