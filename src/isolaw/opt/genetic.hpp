// The genetic algorithm of the paper (section 4.1, Table 3), with the choices of docs/method.md where it is silent.
#pragma once

#include <functional>
#include <vector>

#include "isolaw/num/random.hpp"
#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

struct GeneticOptions {
  int population = 100;             // even, at least 4
  int generations = 50;             // the initial population is generation 1
  double mutation_rate = 0.01;      // probability per gene
  int stagnation = 20;              // generations without improvement before stopping
  double stagnation_tolerance = 0;  // relative improvement that counts as none
  double selection_pressure = 8;    // roulette weight exp(-pressure * value / worst finite value)

  void validate() const;  // throws Error
};

enum class GeneticOutcome { all_generations, stagnated, interrupted, no_finite_value };

struct GeneticResult {
  GeneticOutcome outcome = GeneticOutcome::no_finite_value;
  std::vector<double> best;     // in the unit box; empty when no point was finite
  double best_value = 0.0;
  int evaluations = 0;
  std::vector<double> history;  // best value after each generation

  bool usable() const { return !best.empty(); }
};

// Deterministic for a given stream: random numbers depend on (stream, generation, individual) alone.
// `interrupted`, when given, is asked once per generation.
GeneticResult minimise_genetic(Problem const& problem, num::Stream const& stream, GeneticOptions const& options = {},
                               std::function<bool()> const& interrupted = {});

// The operators, each usable and tested alone -------------------------------------------------------------------

// Roulette weights of `values`: exp(-pressure v / worst finite v); 0 for values that are not finite.
std::vector<double> roulette_weights(std::span<double const> values, double pressure);

}  // namespace isolaw::opt
