// The genetic algorithm of Cucuzza et al. 2025 (section 4.1, Table 3): real-coded, roulette wheel, double-point
// crossover, uniform mutation. Where the paper is silent the choices are those of docs/method.md: a wheel defined for
// minimisation, crossover always, survivors chosen among parents and children together, and the initial population
// counted as the first generation, so that 50 generations of 100 are 5,000 evaluations.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

// What each may be says campaign::setting_table().
struct GeneticOptions {
  int population = 100;             // even, at least 4
  int generations = 50;             // at most this many; the initial population is generation 1
  double mutation_rate = 0.01;      // probability per gene
  int stagnation = 20;              // generations without improvement before stopping
  double stagnation_tolerance = 0;  // relative improvement that counts as none
  double selection_pressure = 8;    // roulette weight exp(-pressure * value / worst finite value)
};

// Outcomes: all_generations, also when the last generation is the one that stagnates; stagnated; no_finite_value where
// the whole initial population failed and left nothing to breed from; interrupted, with a best point if a generation
// was finished. Evaluations: population x generations done.
// Deterministic for a given stream: random numbers depend on (stream, generation, individual or pair) alone.
// Values that are not finite mark failed points; they survive only where nothing better exists. Best over values >= 0;
// see roulette_weights for others.
// `interrupted`, when given, is asked once per generation, before it. A generation counts as without improvement when
// the best value is not below (1 - tolerance) times the best at the last improvement (for positive values); a flat
// problem thus stops after 1 + stagnation generations.
// Throws Error for a problem without dimensions.
SearchResult minimise_genetic(Problem const& problem, num::Stream const& stream, GeneticOptions const& options = {},
                              std::function<bool()> const& interrupted = {});

// How a search whose best values after each generation are `history` ended under these options; interrupted: not yet.
Outcome outcome_of(std::span<double const> history, GeneticOptions const& options);

// The operators, each usable and tested alone -------------------------------------------------------------------

// Roulette weights of `values`: exp(-pressure v / worst finite v); 0 for values that are not finite. When the worst is
// 0 all finite weights are 1. Values below zero have no such ratio: all are then counted from the smallest.
std::vector<double> roulette_weights(std::span<double const> values, double pressure);

// Draws indices with probabilities proportional to weights, with replacement, so a point may be paired with itself.
// Weights: finite, not negative, at least one positive.
class RouletteWheel {
 public:
  explicit RouletteWheel(std::span<double const> weights);
  std::size_t spin(num::Draws& draws) const;

 private:
  std::vector<double> cumulative_;
};

// Two cut points 0 <= first < second <= dimension, every admissible pair equally likely. The pair (0, dimension),
// which would only exchange the parents' names, is not admissible. dimension >= 2.
struct Cuts {
  std::size_t first = 0, second = 0;
};
Cuts draw_cuts(std::size_t dimension, num::Draws& draws);

// Double-point crossover: exchanges the genes between two drawn cut points. A single gene offers no cut: unchanged.
void crossover(std::span<double> a, std::span<double> b, num::Draws& draws);

// Replaces each gene, with probability `rate`, by a new one uniform in [0, 1).
void mutate(std::span<double> point, double rate, num::Draws& draws);

// The `count` smallest of parents and children together, best first: indices into parents followed by children.
// Values that are not finite come last; equal values keep parents before children, then the order given.
// count <= parents + children.
std::vector<std::size_t> survivors(std::span<double const> parents, std::span<double const> children,
                                   std::size_t count);

}  // namespace isolaw::opt
