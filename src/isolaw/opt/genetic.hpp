// The genetic algorithm of Cucuzza et al. 2025 (section 4.1, Table 3): real-coded, roulette wheel, double-point
// crossover, uniform mutation. The paper leaves some choices open; docs/method.md explains ours: the wheel is defined
// for minimisation, every pair crosses over, survivors are chosen among parents and children together, and the initial
// population counts as the first generation, so that 50 generations of 100 take 5,000 evaluations.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

struct GeneticOptions {             // campaign::setting_table() holds the limits of each option
  int population = 100;             // even, at least 4
  int generations = 50;             // at most; the initial population is generation 1
  double mutation_rate = 0.01;      // probability per gene
  int stagnation = 20;              // the search stops after this many generations without improvement
  double stagnation_tolerance = 0;  // a relative gain up to this is no improvement
  double selection_pressure = 8;    // roulette weight exp(-pressure * value / worst finite value)
};

// Minimises a problem whose values are not negative (roulette_weights says what happens to negative ones). The outcome
// is all_generations (also if the last generation stagnates), stagnated, no_finite_value (if no point of the initial
// population has a finite value) or interrupted (with a best point if at least one generation was done). It evaluates
// the population once in each generation. Random numbers depend only on (stream, generation, individual or pair), so
// the result is deterministic for a stream. A value that is not finite marks a failed point, which survives only if
// nothing better exists. `interrupted`, if given, is called before each generation. A generation brings no improvement
// if its best value is not below (1 - tolerance) times the best at the last improvement (for positive values), so a
// flat problem stops after 1 + stagnation generations. Throws Error if the problem has no dimensions.
SearchResult minimise_genetic(Problem const& problem, num::Stream const& stream, GeneticOptions const& options = {},
                              std::function<bool()> const& interrupted = {});

// How a search ended, by its best value after each generation (`history`); interrupted if it would have gone on.
Outcome outcome_of(std::span<double const> history, GeneticOptions const& options);
// Roulette weights exp(-pressure v / worst finite v) of the values v; 0 for values that are not finite, and 1 for all
// others if the worst is 0. If there are values below zero, all are measured from the smallest.
std::vector<double> roulette_weights(std::span<double const> values, double pressure);

// Draws indices by weight, with replacement (a point may be paired with itself). Weights are finite, >= 0, not all 0.
class RouletteWheel {
 public:
  explicit RouletteWheel(std::span<double const> weights);
  std::size_t spin(num::Draws& draws) const;

 private:
  std::vector<double> cumulative_;
};

// Equally likely cuts 0 <= first < second <= dimension (at least 2), without (0, dimension), which swaps whole parents.
struct Cuts {
  std::size_t first = 0, second = 0;
};
Cuts draw_cuts(std::size_t dimension, num::Draws& draws);
// Double-point crossover: exchanges the genes between two drawn cut points. Points of a single gene stay as they are.
void crossover(std::span<double> a, std::span<double> b, num::Draws& draws);
void mutate(std::span<double> point, double rate, num::Draws& draws);  // redraws each gene with probability `rate`
// The `count` smallest values, best first, as indices into the parents followed by the children. Failed points come
// last; equal values keep their order, parents first. count <= parents + children.
std::vector<std::size_t> survivors(std::span<double const> parents, std::span<double const> children,
                                   std::size_t count);

}  // namespace isolaw::opt
