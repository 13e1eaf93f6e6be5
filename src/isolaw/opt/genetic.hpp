// The genetic algorithm of Cucuzza et al. 2025 (section 4.1, Table 3): real-coded, with roulette wheel, double-point
// crossover and uniform mutation. The paper leaves some choices open. Here the roulette wheel favours small values,
// every pair crosses over, and parents and children together compete for survival; docs/method.md gives the reasons.
// The initial population is the first generation, so that 50 generations of 100 points take 5,000 evaluations.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

struct GeneticOptions {             // campaign::setting_table() holds the limits of each option
  int population = 100;             // an even number, at least 4
  int generations = 50;             // largest number of generations, including the initial population
  double mutation_rate = 0.01;      // probability for each gene
  int stagnation = 20;              // the search stops after this many generations without improvement
  double stagnation_tolerance = 0;  // a relative gain up to this value is no improvement
  double selection_pressure = 8;    // roulette weight exp(-pressure * value / worst finite value)
};

// Minimises a problem whose values are not negative (see roulette_weights() for negative ones). All points of a
// generation are evaluated in one call. A point without a finite value survives only if there are too few others.
// Random numbers depend only on (stream, generation, individual or pair), so that equal streams give equal results.
// `interrupted`, if given, is called before each generation; the search ends if it returns true.
// A generation is an improvement if its best value is below (1 - stagnation_tolerance) times the best value of the last
// improvement. If all points have the same value, the search therefore ends after 1 + stagnation generations.
// Outcomes: stagnated if the search stopped before the last generation; all_generations if it did not; no_finite_value
// if no point of the initial population has a finite value; interrupted, with a best point if at least one generation
// was computed. Throws Error if the problem has no dimensions.
SearchResult minimise_genetic(Problem const& problem, num::Stream const& stream, GeneticOptions const& options = {},
                              std::function<bool()> const& interrupted = {});

// Tells how a search with this history of best values ended. The result is `interrupted` if no stopping rule is met.
Outcome outcome_of(std::span<double const> history, GeneticOptions const& options);
// Roulette weights exp(-pressure v / worst finite v) of the values v. Values that are not finite get 0. If the worst
// value is 0, all finite values get 1. If some values are negative, the smallest is first subtracted from all.
std::vector<double> roulette_weights(std::span<double const> values, double pressure);

// Draws indices with probabilities proportional to the weights, with repetition. Weights are finite, >= 0, not all 0.
class RouletteWheel {
 public:
  explicit RouletteWheel(std::span<double const> weights);
  std::size_t spin(num::Draws& draws) const;

 private:
  std::vector<double> cumulative_;
};

// Two cuts with 0 <= first < second <= dimension. All pairs are equally likely, except that (0, dimension) never
// occurs, since it would swap whole parents.
struct Cuts {
  std::size_t first = 0, second = 0;
};
Cuts draw_cuts(std::size_t dimension, num::Draws& draws);
// Double-point crossover: exchanges the genes between two random cuts. Points of one gene stay unchanged.
void crossover(std::span<double> a, std::span<double> b, num::Draws& draws);
void mutate(std::span<double> point, double rate, num::Draws& draws);  // redraws each gene with probability `rate`
// Indices of the `count` smallest values, best first, among the parents followed by the children. Values that are not
// finite come last. Equal values keep their order. count <= parents + children.
std::vector<std::size_t> survivors(std::span<double const> parents, std::span<double const> children,
                                   std::size_t count);

}  // namespace isolaw::opt
