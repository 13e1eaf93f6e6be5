#include "isolaw/opt/genetic.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "isolaw/base/error.hpp"

namespace isolaw::opt {
namespace {

double rank_key(double value) {  // all values that are not finite rank behind all numbers
  return std::isfinite(value) ? value : infinity;
}

struct Population {
  Points points;
  std::vector<double> values;
};

num::Draws draws_at(num::Stream const& stream, int generation, std::size_t index) {
  return {stream, static_cast<std::uint32_t>(generation), static_cast<std::uint32_t>(index)};
}

Points initial_points(std::size_t dimension, std::size_t size, num::Stream const& stream) {
  Points points(dimension, size);
  for (std::size_t i = 0; i < size; ++i) {
    auto draws = draws_at(stream, 1, i);
    for (double& gene : points[i]) gene = draws.uniform();
  }
  return points;
}

Points breed(Population const& parents, num::Stream const& stream, int generation, GeneticOptions const& options) {
  RouletteWheel const wheel(roulette_weights(parents.values, options.selection_pressure));
  Points children(parents.points.dimension, parents.points.size());
  for (std::size_t pair = 0; pair < children.size() / 2; ++pair) {
    auto draws = draws_at(stream, generation, pair);
    auto const first = children[2 * pair], second = children[2 * pair + 1];
    std::ranges::copy(parents.points[wheel.spin(draws)], first.begin());
    std::ranges::copy(parents.points[wheel.spin(draws)], second.begin());
    crossover(first, second, draws);
    mutate(first, options.mutation_rate, draws);
    mutate(second, options.mutation_rate, draws);
  }
  return children;
}

Population select(Population const& parents, Population const& children, std::size_t size) {
  Population next{Points(children.points.dimension, size), std::vector<double>(size)};
  auto const kept = survivors(parents.values, children.values, size);
  for (std::size_t i = 0; i < size; ++i) {
    bool const is_parent = kept[i] < parents.values.size();
    auto const& from = is_parent ? parents : children;
    auto const index = is_parent ? kept[i] : kept[i] - parents.values.size();
    std::ranges::copy(from.points[index], next.points[i].begin());
    next.values[i] = from.values[index];
  }
  return next;
}

// Tells when the search stagnates. Each generation is compared with the last improvement, not with the generation
// before it, so that slow steady progress does not count as stagnation.
class Progress {
 public:
  explicit Progress(GeneticOptions const& options) : options_(options) {}

  bool stagnates(double best) {
    bool const first = generation_++ == 0;
    if (first || best < at_improvement_ - options_.stagnation_tolerance * std::abs(at_improvement_)) {
      at_improvement_ = best;
      without_ = 0;
      return false;
    }
    return ++without_ == options_.stagnation && generation_ < options_.generations;
  }

 private:
  GeneticOptions const& options_;
  double at_improvement_ = infinity;
  int generation_ = 0, without_ = 0;
};

}  // namespace

Outcome outcome_of(std::span<double const> history, GeneticOptions const& options) {
  Progress progress(options);
  for (std::size_t i = 0; i < history.size(); ++i) {
    bool const last = i + 1 == history.size();
    if (rank_key(history[i]) == infinity) return last ? Outcome::no_finite_value : Outcome::interrupted;
    if (progress.stagnates(history[i])) return last ? Outcome::stagnated : Outcome::interrupted;
  }
  return std::cmp_equal(history.size(), options.generations) ? Outcome::all_generations : Outcome::interrupted;
}

SearchResult minimise_genetic(Problem const& problem, num::Stream const& stream, GeneticOptions const& options,
                              std::function<bool()> const& interrupted) {
  assert(options.population >= 4 && options.population % 2 == 0);
  auto const dimension = problem.dimension();
  if (dimension == 0)
    throw Error({"genetic algorithm", "a problem with no free parameter", "at least one",
                 "freeing a parameter, or evaluating the single point directly"});

  auto const size = static_cast<std::size_t>(options.population);
  SearchResult result;
  auto const ended = [&](Outcome outcome) {
    result.outcome = outcome;
    return result;
  };
  Population parents;  // empty in generation 1, so that its children all survive
  Progress progress(options);
  for (int generation = 1; generation <= options.generations; ++generation) {
    if (interrupted && interrupted()) return ended(Outcome::interrupted);
    Population children{
        generation == 1 ? initial_points(dimension, size, stream) : breed(parents, stream, generation, options),
        std::vector<double>(size, infinity)};
    problem.evaluate(children.points, children.values);
    result.evaluations += options.population;
    result.failed_evaluations +=
        static_cast<int>(std::ranges::count_if(children.values, [](double value) { return !std::isfinite(value); }));

    parents = select(parents, children, size);
    double const best = rank_key(parents.values.front());
    result.history.push_back(best);
    if (best == infinity) return ended(Outcome::no_finite_value);
    if (best < result.best_value) {
      auto const point = parents.points[0];
      result.best.assign(point.begin(), point.end());
      result.best_value = best;
    }
    if (progress.stagnates(best)) return ended(Outcome::stagnated);
  }
  return ended(Outcome::all_generations);
}

std::vector<double> roulette_weights(std::span<double const> values, double pressure) {
  double best = infinity, worst = -infinity;
  for (double const value : values) {
    if (!std::isfinite(value)) continue;
    best = std::min(best, value);
    worst = std::max(worst, value);
  }
  // Halves of the values are subtracted, so that the difference of two huge values of opposite sign stays finite.
  double const origin = std::min(0.0, 0.5 * best);
  double const range = 0.5 * worst - origin;
  std::vector<double> weights(values.size(), 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    weights[i] = range > 0.0 ? std::exp(-pressure * ((0.5 * values[i] - origin) / range)) : 1.0;
  }
  return weights;
}

RouletteWheel::RouletteWheel(std::span<double const> weights) : cumulative_(weights.size()) {
  std::partial_sum(weights.begin(), weights.end(), cumulative_.begin());
  assert(!cumulative_.empty() && cumulative_.back() > 0.0 && std::isfinite(cumulative_.back()));
}

std::size_t RouletteWheel::spin(num::Draws& draws) const {
  double const total = cumulative_.back();
  double const target = draws.uniform() * total;
  // Finds the first cumulative sum above the target, which never belongs to an index of weight zero. If rounding makes
  // the target equal to the total, the last index of positive weight is taken.
  auto const found =
      target < total ? std::ranges::upper_bound(cumulative_, target) : std::ranges::lower_bound(cumulative_, total);
  return static_cast<std::size_t>(found - cumulative_.begin());
}

Cuts draw_cuts(std::size_t dimension, num::Draws& draws) {
  assert(dimension >= 2);
  for (;;) {  // succeeds in 4 of 9 tries in the worst case, dimension 2
    auto const i = draws.below(dimension + 1), j = draws.below(dimension + 1);
    Cuts const cuts{std::min(i, j), std::max(i, j)};
    if (cuts.first != cuts.second && cuts.second - cuts.first != dimension) return cuts;
  }
}

void crossover(std::span<double> a, std::span<double> b, num::Draws& draws) {
  assert(a.size() == b.size());
  if (a.size() < 2) return;
  auto const [first, second] = draw_cuts(a.size(), draws);
  std::ranges::swap_ranges(a.subspan(first, second - first), b.subspan(first, second - first));
}

void mutate(std::span<double> point, double rate, num::Draws& draws) {
  for (double& gene : point)
    if (draws.uniform() < rate) gene = draws.uniform();
}

std::vector<std::size_t> survivors(std::span<double const> parents, std::span<double const> children,
                                   std::size_t count) {
  assert(count <= parents.size() + children.size());
  std::vector<double> keys;
  keys.reserve(parents.size() + children.size());
  for (auto const values : {parents, children})
    for (double const value : values) keys.push_back(rank_key(value));
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return keys[i]; });
  order.resize(count);
  return order;
}

}  // namespace isolaw::opt
