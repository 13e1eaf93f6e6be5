#include "isolaw/opt/multistart.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/work_ahead.hpp"
#include "isolaw/num/linear.hpp"
#include "isolaw/num/row_kernels.hpp"

namespace isolaw::opt {
namespace {

// Constants of the search. We logged many descents and chose the rules that did best on the log (docs/performance.md,
// "The optimum"). Gains and distances between values are relative. Coordinates are in [0, 1].
namespace tuning {

// A descent has stages. It minimises the sum of sqrt(residual^2 + delta^2), in which delta rounds off |residual|. A
// stage lowers delta to `smoothing` times the mean residual. It ends when the iterations at this last delta gain too
// little, at the latest after `iterations` iterations.
struct Stage {
  double smoothing;
  int iterations;
  double least_gain = 0.0;   // the stage ends if it gains less over `patience` iterations at its last delta
  std::size_t patience = 4;  // several iterations, since one may gain little while a residual crosses zero
};
// Finds a valley, which is the surroundings of a minimum. Delta ends at half the mean residual, where the sum is still
// smooth and few iterations are needed.
constexpr Stage approach{.smoothing = 0.5, .iterations = 25};
// Finds the floor of the valley. Its least gain is below the hit tolerance of 5e-4, and need not be smaller, because
// the value at the end is only compared with the values of other descents.
constexpr Stage settle{.smoothing = 0.01, .iterations = 80, .least_gain = 3e-4};
// Replaces `settle` after a descent on the outline (a problem with fewer residuals). This stage uses all residuals. It
// starts at the minimum of the outline, which is close to the minimum of all residuals.
constexpr Stage finish{.smoothing = 0.01, .iterations = 80, .least_gain = 3e-4, .patience = 3};
// Replaces `finish` if descend() is asked to be brief. Ends with about four correct digits.
constexpr Stage finish_briefly{.smoothing = 0.01, .iterations = 80, .least_gain = 3e-4, .patience = 2};
constexpr double rounding_after_outline = 0.03;                // delta after the outline is at most this times the sum
constexpr Stage polish{.smoothing = 0.003, .iterations = 60};  // computes more digits of a value that may be reported

constexpr double gain_worth_staying = 3e-3;  // after an iteration with a smaller relative gain, delta falls
// When delta falls, it is multiplied by this factor. The fall is so small that a few iterations lead from the minimum
// for one delta to the minimum for the next.
constexpr double fall_of_delta = 0.3;
constexpr double noise_of_gain = 1e-6;  // smaller gains count as none: one-sided differences have errors of this size
// Step of one-sided differences. A slope is wrong by about 1e-6 because the residuals are curved, and by 1e-9 because
// of rounding. Both errors change a Newton step less than its damping does.
constexpr double difference_step = 1e-6;
// Each iteration tries bold and cautious steps (see slopes()). The curvature for bold steps is bold_share times the
// true curvature plus cautious_share times the cautious curvature, since the true one vanishes if no residual is near
// zero.
constexpr double bold_share = 0.9, cautious_share = 0.1;
// Trial steps in an iteration: as many as a law's kernel computes at once, since fewer would cost as much.
constexpr std::size_t tried = 8;
constexpr double damping_ratio = 20.0;  // trial steps use 1/20, 1, 20 and 400 times the present damping
constexpr double damping_rise = 1e4;    // factor on the damping if all trial steps failed; more than the factor 400
constexpr int rises = 4;                // attempts in an iteration: enough to raise usual_damping beyond most_damping
constexpr double usual_damping = 1e-2;
constexpr double most_damping = 1e8;                        // steps damped this much follow the gradient and are short
constexpr double least_carried = 1e-9, most_carried = 1e6;  // limits of the damping that the next iteration starts with
// This fraction of the largest curvature is added to all curvatures, because some coordinates have no curvature.
constexpr double least_curvature = 1e-9;

constexpr double one_valley = 0.75;  // if this share of the scattered starts are hits, a better valley is unlikely
// A search ends early after `many_hits` hits, if at least the share `agreeing` of the scattered starts are hits. This
// rule missed the best valley in 1 of 380 logged searches. Ending when 0.3 of all descents were hits missed it in 6 of
// them.
constexpr std::ptrdiff_t many_hits = 12;
constexpr double agreeing = 0.4;                // share of hits among the scattered starts
constexpr std::ptrdiff_t part_when_agreed = 3;  // a third of the starts suffices: 24 instead of 72
// If half of the scattered starts end within ten hit tolerances of the best value, but few hit it, the floor of the
// valley is ragged: it has many minima of nearly the same value. For law abe, 8 of 300 logged searches with 72 starts
// missed the best point, and 2 with 96 starts.
constexpr double close = 10.0;  // in hit tolerances
constexpr double ragged = 0.5;
constexpr std::ptrdiff_t more_when_ragged = 3;  // if the floor is ragged, a third of the starts is added
// Above this number of dimensions, hops (starts near the best point) found better valleys than scattered starts, at a
// quarter of the cost.
constexpr std::size_t many_dimensions = 14;
constexpr double more_in_many_dimensions = 2.5;  // factor on the starts, half of which are hops: 180 instead of 72
// A descent is given up if its value after approach() exceeds the best value by this factor, since settle() gains less.
constexpr double promising = 1.5;
constexpr double least_power_of_hop = -1.5, most_power_of_hop = -0.3;  // hops of 0.03 to 0.5, to leave a valley
constexpr double least_power_of_last_hop = -2.0, most_power_of_last_hop = -0.5;  // of 0.01 to 0.3, to stay in a valley

// The floor of the valley counts as smooth if at least half of the hits, and at least twice MultistartOptions::hits,
// are closer to the best value than this number of hit tolerances.
constexpr double smooth_floor_height = 0.2;
// If the values of the hits scatter, this many of the best descents are polished. Polishing only the best one left the
// result 0.1 % too high in 3 of 29 logged searches.
constexpr std::size_t polished = 6;
constexpr double near_enough = 2.0;  // in hit tolerances; descents that end farther from the best are in other valleys
// A descent is not polished if its value after approach() exceeds the best value by more than this factor.
constexpr double worth_polishing = 1.01;
// refine() stops after hops_in_vain hops in a row without gain, or after most_last_hops hops in all.
constexpr int hops_in_vain = 10, most_last_hops = 40;
constexpr double gain_of_last_hop = 0.1;     // in hit tolerances; smaller gains count as none
constexpr double absolute_tolerance = 1e-9;  // added to relative tolerances, for a best value of zero

}  // namespace tuning

using num::Index;
using num::Matrix;
using num::Vector;

struct Cost {
  std::size_t computed = 0, failed = 0;  // numbers of residuals: in all, and at points without a finite value
  Cost& operator+=(Cost const& other) {
    computed += other.computed;
    failed += other.failed;
    return *this;
  }
};
void write_cost(Cost const& cost, DeviationProblem const& problem, BestPoint& result) {
  std::size_t const per_point = problem.weights().size();
  auto const in_points = [&](std::size_t residuals) {
    return static_cast<int>((residuals + per_point - 1) / per_point);
  };
  result.evaluations = in_points(cost.computed);
  result.failed_evaluations = in_points(cost.failed);
}

class Counting {  // computes and counts residuals of the problem or of its outline, which has fewer residuals
 public:
  explicit Counting(DeviationProblem const& problem) : problem_(&problem), whole_(problem) {}

  bool has_outline() const { return whole_.outline() != nullptr; }
  void show_outline() { problem_ = whole_.outline(); }
  void show_whole() { problem_ = &whole_; }

  std::size_t dimension() const { return problem_->dimension(); }

  // For each point, the sum of weight * |residual| and the sum of weight * sqrt(residual^2 + delta^2). A sum that is
  // not a finite number is infinite.
  struct Sizes {
    std::vector<double> value, rounded;
  };
  Sizes sizes(Points const& points, double delta) {
    compute(points);
    Sizes result{.value = std::vector<double>(stride_), .rounded = std::vector<double>(stride_)};
    num::row_kernels().sizes(table(), points.size(), delta, result.value.data(), result.rounded.data());
    for (auto* sums : {&result.value, &result.rounded})
      for (double& sum : *sums) sum = std::isfinite(sum) ? sum : infinity;
    for (std::size_t i = 0; i < points.size(); ++i) count_failure(!std::isfinite(result.value[i]));
    return result;
  }
  void compute(Points const& points) {
    auto const weights = problem_->weights();
    stride_ = num::padded(points.size());
    rows_.resize(stride_ * weights.size());
    problem_->residual_rows(points, stride_, rows_);
    cost_.computed += points.size() * weights.size();
  }
  void count_failure(bool failed) { cost_.failed += failed ? problem_->weights().size() : 0; }
  Cost const& cost() const { return cost_; }
  num::RowTable table() const { return {rows_.data(), stride_, problem_->weights()}; }
  std::size_t columns() const { return stride_; }

 private:
  DeviationProblem const* problem_;
  DeviationProblem const& whole_;
  std::vector<double> rows_;
  std::size_t stride_ = 0;
  Cost cost_;
};

struct Located {
  std::vector<double> x;
  double value = infinity;  // sum of weight * |residual|
};

// One descent. approach() finds a valley, and settle() finds the valley's floor. If the problem has an outline (a
// problem with fewer residuals), approach() uses only the outline, and settle() uses the outline first and then all
// residuals. polish() computes more digits.
class Descent {
 public:
  Descent(DeviationProblem const& problem, std::span<double const> start, double rounding = 1.0)
      : problem_(problem), n_(problem.dimension()) {
    move_to(start);
    delta_ = rounding * here_.value;
  }

  bool usable() const { return std::isfinite(here_.value); }
  double value() const { return best_.value; }
  Located const& best() const { return best_; }
  Cost const& cost() const { return problem_.cost(); }

  void approach() { problem_.has_outline() ? by_outline(tuning::approach) : go(tuning::approach); }
  void settle(tuning::Stage const& finish = tuning::finish) { floor_of_outline() ? go(finish) : go(tuning::settle); }
  void polish() { go(tuning::polish); }

  bool floor_of_outline() {
    if (!problem_.has_outline()) return false;
    by_outline(tuning::settle);
    delta_ = std::min(delta_, tuning::rounding_after_outline * here_.value);
    return true;
  }

 private:
  void by_outline(tuning::Stage const& stage) {
    Located const start = std::exchange(best_, {});
    problem_.show_outline();
    move_to(start.x);
    if (usable()) go(stage);
    problem_.show_whole();
    auto const found = std::exchange(best_, start);
    move_to(found.x.empty() ? start.x : found.x);
    if (!usable()) here_ = start;
  }

  void go(tuning::Stage const& stage) {
    using namespace tuning;
    std::vector<double> values;  // the sum after each iteration at the stage's last delta
    for (int i = 0; i < stage.iterations; ++i) {
      auto const [before, after] = iterate();
      bool const moved = after < before;
      if (moved && after <= before * (1.0 - gain_worth_staying)) continue;
      if (delta_ > stage.smoothing * here_.value) {
        delta_ = std::max(fall_of_delta * std::min(delta_, here_.value), 0.999 * stage.smoothing * here_.value);
        damping_ = std::min(damping_, usual_damping);
        continue;
      }
      values.push_back(after);
      if (!moved || after > before * (1.0 - noise_of_gain)) return;
      if (values.size() > stage.patience &&
          after > values[values.size() - 1 - stage.patience] * (1.0 - stage.least_gain))
        return;
    }
  }

  void move_to(std::span<double const> x) {
    Points one(n_, 1);
    std::ranges::copy(x, one[0].begin());
    take(one[0], problem_.sizes(one, 0.0).value[0]);
  }

  void take(std::span<double const> x, double value) {
    here_.x.assign(x.begin(), x.end());
    here_.value = value;
    if (here_.value < best_.value) best_ = here_;
  }

  // Gradient and two curvatures of the sum of sqrt(residual^2 + delta^2), by one-sided differences. They are zero for a
  // coordinate if the residuals at the neighbouring point are not finite. The cautious curvature belongs to a parabola
  // that touches the sum from above; steps with it are too short. The bold curvature is nearly the sum's true
  // curvature, to which only residuals near zero contribute; steps with it are too long.
  struct Slopes {
    Vector gradient;
    Matrix cautious, bold;
    double value = 0.0;
  };
  Slopes slopes() {
    constexpr double step = tuning::difference_step;
    Points points(n_, n_ + 1);
    for (std::size_t i = 0; i <= n_; ++i) std::ranges::copy(here_.x, points[i].begin());
    for (std::size_t k = 0; k < n_; ++k) points[k + 1][k] += here_.x[k] > 0.5 ? -step : step;
    problem_.compute(points);
    std::size_t const columns = problem_.columns();
    std::vector<double> gradient(columns), cautious(columns * columns), bold(columns * columns);
    auto const n = static_cast<Index>(n_);
    Slopes result{.gradient = Vector::Zero(n), .cautious = Matrix::Zero(n, n), .bold = Matrix::Zero(n, n)};
    num::row_kernels().normal(problem_.table(), n_ + 1, delta_, tuning::cautious_share, tuning::bold_share,
                              {gradient.data(), cautious.data(), bold.data(), &result.value});
    auto const failed = [&](std::size_t column) { return !std::isfinite(cautious[column * columns + column]); };
    auto const per_step = [&](std::size_t k) { return 1.0 / (points[k + 1][k] - here_.x[k]); };
    for (std::size_t a = 0; a < n_; ++a) {
      problem_.count_failure(failed(a + 1));
      if (failed(a + 1)) continue;
      auto const row = static_cast<Index>(a);
      result.gradient[row] = gradient[a + 1] * per_step(a);
      for (std::size_t b = 0; b <= a; ++b) {
        if (failed(b + 1)) continue;
        auto const column = static_cast<Index>(b);
        auto const at = (a + 1) * columns + b + 1;
        double const scale = per_step(a) * per_step(b);
        result.cautious(row, column) = result.cautious(column, row) = cautious[at] * scale;
        result.bold(row, column) = result.bold(column, row) = bold[at] * scale;
      }
    }
    return result;
  }

  // Does one iteration. Returns the sum of sqrt(r^2 + delta^2) before and after; both are equal if no step lowered it.
  std::pair<double, double> iterate() {
    using namespace tuning;
    auto const here = slopes();
    auto const stretch = [](std::size_t i) { return std::pow(damping_ratio, static_cast<double>(i / 2) - 1.0); };
    for (int attempt = 0; attempt < rises && damping_ <= most_damping; ++attempt) {
      Points points(n_, tried);
      for (std::size_t i = 0; i < tried; ++i)
        propose(i % 2 == 0 ? here.cautious : here.bold, here.gradient, damping_ * stretch(i), points[i]);
      auto const [values, rounded] = problem_.sizes(points, delta_);
      auto const least = std::min_element(rounded.begin(), rounded.begin() + tried);
      auto const best = static_cast<std::size_t>(least - rounded.begin());
      if (*least < here.value) {
        damping_ = std::clamp(damping_ * stretch(best) / std::sqrt(damping_ratio), least_carried, most_carried);
        take(points[best], values[best]);
        return {here.value, *least};
      }
      damping_ *= damping_rise;
    }
    damping_ = usual_damping;
    return {here.value, here.value};
  }

  // Computes a damped Newton step inside the box. A coordinate on an edge of the box stays there if the sum decreases
  // in the direction out of the box.
  void propose(Matrix const& H, Vector const& g, double damping, std::span<double> point) const {
    std::ranges::copy(here_.x, point.begin());
    std::vector<Index> free;
    for (std::size_t k = 0; k < n_; ++k) {
      double const slope = g[static_cast<Index>(k)];
      bool const stuck = (here_.x[k] <= 0.0 && slope >= 0.0) || (here_.x[k] >= 1.0 && slope <= 0.0);
      if (!stuck) free.push_back(static_cast<Index>(k));
    }
    double const floor = tuning::least_curvature * H.diagonal().maxCoeff() + 1e-300;
    Vector moved = Vector::Zero(g.size());
    // If the step of a coordinate would leave the box, the coordinate goes to the edge, and the steps of the others are
    // computed again.
    for (int pass = 0; pass < 3 && !free.empty(); ++pass) {
      Vector held = moved;
      held(free).setZero();
      Vector const b = -(g + num::apply(H, held))(free);
      Matrix A = H(free, free);
      A.diagonal() += damping * A.diagonal() + Vector::Constant(A.rows(), floor);
      Vector const step = num::solve_symmetric(A, b);
      std::vector<Index> inside;
      for (Index i = 0; i < step.size(); ++i) {
        auto const k = static_cast<std::size_t>(free[static_cast<std::size_t>(i)]);
        double const to = here_.x[k] + (std::isfinite(step[i]) ? step[i] : 0.0);
        point[k] = std::clamp(to, 0.0, 1.0);
        moved[static_cast<Index>(k)] = point[k] - here_.x[k];
        if (to == point[k]) inside.push_back(static_cast<Index>(k));
      }
      if (inside.size() == free.size()) break;
      free = std::move(inside);
    }
  }

  Counting problem_;
  std::size_t n_;
  Located here_, best_;
  double delta_ = 0.0;
  double damping_ = tuning::usual_damping;
};

// Adds normally distributed steps to about half of the coordinates. The standard deviation of the steps is 10 to a
// random power between least_power and most_power.
std::vector<double> disturbed(std::vector<double> x, double least_power, double most_power, num::Draws& draws) {
  double const size = std::pow(10.0, least_power + (most_power - least_power) * draws.uniform());
  for (double& coordinate : x)
    if (draws.uniform() < 0.5) coordinate = std::clamp(coordinate + size * draws.normal(), 0.0, 1.0);
  return x;
}
std::vector<double> with_two_drawn_anew(std::vector<double> x, num::Draws& draws) {
  for (int i = 0; i < 2; ++i) x[draws.below(x.size())] = draws.uniform();
  return x;
}

struct FinishedDescent {
  Located approached, settled;
  Cost to_approach, to_settle;
  bool usable = false;
};

class Search {
 public:
  Search(DeviationProblem const& problem, num::Stream const& stream, MultistartOptions const& options)
      : problem_(problem), options_(options), stream_(stream) {}

  MultistartResult run(std::function<bool()> const& interrupted) {
    for (std::uint32_t round = 0; !is_confirmed(); ++round) {
      if (result_.evaluations >= options_.most_evaluations) return ended(Outcome::budget_spent);
      num::Draws draws(stream_, round, 0);
      auto const points = latin_hypercube(problem_.dimension(), static_cast<std::size_t>(options_.scattered), draws);
      std::vector<FinishedDescent> results(points.size());
      WorkAhead descents(points.size(), [&](std::size_t i) { results[i] = descent_from(points[i]); });
      for (std::size_t i = 0; i < points.size() && !is_confirmed(); ++i) {
        if (interrupted && interrupted()) return ended(Outcome::interrupted);
        descents.need(i);
        scattered_.push_back(count_in(results[i]));
      }
      if (!result_.usable()) return ended(Outcome::no_finite_value);
      int const hops = has_many_dimensions() ? options_.scattered : options_.hops;
      for (int hop = 1; hop <= hops && !is_confirmed(); ++hop) {
        if (interrupted && interrupted()) return ended(Outcome::interrupted);
        num::Draws hop_draws(stream_, round, static_cast<std::uint32_t>(hop));
        count_in(descent_from(
            hop % 2 != 0 ? with_two_drawn_anew(result_.best, hop_draws)
                         : disturbed(result_.best, tuning::least_power_of_hop, tuning::most_power_of_hop, hop_draws)));
      }
    }
    refine(interrupted);
    return ended(interrupted && interrupted() ? Outcome::interrupted : Outcome::confirmed);
  }

 private:
  double within(double tolerance) const { return result_.best_value * (1.0 + tolerance) + tuning::absolute_tolerance; }
  static std::ptrdiff_t count(std::vector<double> const& values, double most) {
    return std::ranges::count_if(values, [&](double value) { return value <= most; });
  }

  bool is_confirmed() const {
    double const near = within(options_.hit_tolerance);
    auto const hits = count(ends_, near);
    return hits >= options_.hits && std::ssize(ends_) >= starts_for(hits, near);
  }

  // Number of descents to make. It is larger if few of the scattered starts are hits, since the search has then more
  // likely missed a better value. Hops do not count in this share, because they tend to return to the valley that they
  // came from.
  std::ptrdiff_t starts_for(std::ptrdiff_t hits, double near) const {
    std::ptrdiff_t const least = options_.least_starts, starts = options_.starts;
    auto const scattered_hits = count(scattered_, near);
    auto const share = static_cast<double>(scattered_hits) / static_cast<double>(scattered_.size());
    if (share >= tuning::one_valley) return least;
    if (has_many_dimensions())
      return static_cast<std::ptrdiff_t>(tuning::more_in_many_dimensions * static_cast<double>(starts));
    bool const agreed = hits >= tuning::many_hits && share >= tuning::agreeing;
    if (agreed) return std::max(least, starts / tuning::part_when_agreed);
    auto const crowd = count(scattered_, within(tuning::close * options_.hit_tolerance));
    bool const ragged = static_cast<double>(crowd) >= tuning::ragged * static_cast<double>(scattered_.size());
    return ragged ? starts + starts / tuning::more_when_ragged : starts;
  }

  bool has_many_dimensions() const { return problem_.dimension() > tuning::many_dimensions; }

  void keep(Located const& end) {
    if (end.value >= result_.best_value) return;
    result_.best_value = end.value;
    result_.best = end.x;
    best_so_far_ = end.value;
  }
  void add(Cost const& cost) {
    cost_ += cost;
    write_cost(cost_, problem_, result_);
  }

  // Runs one descent from `start`. Worker threads call this early, in any order; count_in() later adds the descents to
  // the result in the order of their starts. The descent is settled, that is, refined to its end, only if its value is
  // less than `promising` times the best value known now. When count_in() makes the same comparison, the best value may
  // be lower but never higher, so every descent that count_in() takes as settled was settled here.
  FinishedDescent descent_from(std::span<double const> start) const {
    FinishedDescent result;
    Descent descent(problem_, start);
    result.usable = descent.usable();
    if (result.usable) descent.approach();
    result.approached = descent.best();
    result.to_approach = descent.cost();
    if (result.usable && descent.value() < tuning::promising * best_so_far_) descent.settle();
    result.settled = descent.best();
    result.to_settle = descent.cost();
    return result;
  }

  double count_in(FinishedDescent const& descent) {
    bool const settled = descent.approached.value < tuning::promising * result_.best_value;
    auto const& end = settled ? descent.settled : descent.approached;
    add(settled ? descent.to_settle : descent.to_approach);
    if (descent.usable) keep(end);
    ends_.push_back(end.value);
    end_points_.push_back(end.x);
    result_.history.push_back(result_.best_value);
    return end.value;
  }

  // Polishes the best descent. If the values of the hits scatter, the valley's floor is ragged. The next best descents
  // are then polished too, and small hops follow until several in a row gain nothing.
  void refine(std::function<bool()> const& interrupted) {
    auto const polish = [&](std::vector<double> const& start) {
      Descent descent(problem_, start);
      if (descent.usable()) {
        descent.approach();
        if (descent.value() < tuning::worth_polishing * result_.best_value) descent.polish();
        keep(descent.best());
      }
      add(descent.cost());
    };
    auto const hits = count(ends_, within(options_.hit_tolerance));
    auto const agreeing = count(ends_, within(tuning::smooth_floor_height * options_.hit_tolerance));
    bool const floor_is_smooth = agreeing >= 2 * options_.hits && 2 * agreeing >= hits;
    double const near = within(tuning::near_enough * options_.hit_tolerance);
    std::vector<std::size_t> order(ends_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return ends_[i]; });
    order.resize(std::min<std::size_t>(order.size(), floor_is_smooth ? 1 : tuning::polished));
    for (std::size_t const i : order)
      if (ends_[i] <= near) polish(end_points_[i]);
    int without_gain = 0;
    for (std::uint32_t hop = 0; !floor_is_smooth && without_gain < tuning::hops_in_vain && hop < tuning::most_last_hops;
         ++hop) {
      if (interrupted && interrupted()) break;
      num::Draws hop_draws(stream_, std::numeric_limits<std::uint32_t>::max(), hop);
      double const before = result_.best_value;
      polish(disturbed(result_.best, tuning::least_power_of_last_hop, tuning::most_power_of_last_hop, hop_draws));
      bool const gained = result_.best_value < before * (1.0 - tuning::gain_of_last_hop * options_.hit_tolerance);
      without_gain = gained ? 0 : without_gain + 1;
    }
    result_.history.push_back(result_.best_value);
  }

  MultistartResult ended(Outcome outcome) {
    result_.outcome = outcome;
    result_.starts = static_cast<int>(ends_.size());
    result_.hits = static_cast<int>(count(ends_, within(options_.hit_tolerance)));
    return result_;
  }

  DeviationProblem const& problem_;
  MultistartOptions const& options_;
  num::Stream stream_;
  MultistartResult result_;
  Cost cost_;
  std::atomic<double> best_so_far_ = infinity;   // copy of result_.best_value for threads that work ahead
  std::vector<double> ends_, scattered_;         // final values of all descents, and of the scattered starts
  std::vector<std::vector<double>> end_points_;  // final points of all descents
};

void require_dimension(DeviationProblem const& problem) {
  if (problem.dimension() == 0)
    throw Error({"multistart", "a problem with no free parameter", "at least one",
                 "freeing a parameter, or evaluating the single point directly"});
}

}  // namespace

Points latin_hypercube(std::size_t dimension, std::size_t count, num::Draws& draws) {
  Points points(dimension, count);
  std::vector<std::size_t> slice(count);
  for (std::size_t k = 0; k < dimension; ++k) {
    std::iota(slice.begin(), slice.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i) std::swap(slice[i - 1], slice[draws.below(i)]);
    for (std::size_t i = 0; i < count; ++i)
      points[i][k] = (static_cast<double>(slice[i]) + draws.uniform()) / static_cast<double>(count);
  }
  return points;
}

MultistartResult minimise_multistart(DeviationProblem const& problem, num::Stream const& stream,
                                     MultistartOptions const& options, std::function<bool()> const& interrupted) {
  require_dimension(problem);
  return Search(problem, stream, options).run(interrupted);
}

BestPoint descend(DeviationProblem const& problem, std::span<double const> start, double rounding, bool brief) {
  require_dimension(problem);
  BestPoint result;
  Descent descent(problem, start, rounding);
  if (descent.usable() && brief) descent.settle(tuning::finish_briefly);
  if (descent.usable() && !brief) {
    descent.floor_of_outline();
    descent.polish();
  }
  write_cost(descent.cost(), problem, result);
  if (!descent.usable()) return result;
  result.best = descent.best().x;
  result.best_value = descent.value();
  return result;
}

}  // namespace isolaw::opt
