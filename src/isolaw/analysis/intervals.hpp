// How uncertain fitted parameters are, two ways, for residuals that are not independent of their neighbours.
//
// Linearisation: the estimate by least absolute residuals is asymptotically normal with covariance H^-1 V H^-1 (Koenker
// and Bassett 1978), H the curvature of the expected objective, sum 2 f w J J^T with the density f of the residuals at
// zero, by a kernel and their local size, and V the variance of the score w sign(r) J, where neighbouring signs are
// correlated as their autocorrelation says (Weiss 1990). n / (n - p) makes up for the p parameters fitted, n the
// samples that would be as many independent ones. Valid where the law is as good as linear over the interval, and with
// ten independent samples or more for each parameter; with three, intervals of 95 % cover 80 to 92 %.
// Bootstrap: the blocks of the record are drawn with replacement and the law is fitted again, many times; a drawn block
// counts as often as it was drawn, while the history that the law runs through stays as it was (Kuensch 1989). Neither
// linear laws nor residuals of one kind are supposed; of residuals correlated over many samples there are few blocks,
// and with three dozen independent samples intervals of 95 % cover 89 %.
// Blocks are as long as the correlation of the residuals' signs asks for (Politis and White 2004, corrected by Patton
// et al. 2009), and never longer than an eighth of the samples.
//
// Both say how far another record of the same device could move the fit, taking the misfit of the law for noise. They
// are no statement about the truth of the law, nor a distribution of the parameters.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "isolaw/analysis/problems.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::analysis {

struct ParameterInterval {
  std::size_t parameter = 0;                      // index among the law's
  double linear_lower = 0.0, linear_upper = 0.0;  // inside the box, as all of these
  std::optional<double> bootstrap_lower = {}, bootstrap_upper = {};
};

struct Intervals {
  double level = 0.95;
  std::size_t samples = 0, block = 0;              // scored samples, and how many make a block
  int replicates = 0;                              // fits of the bootstrap
  std::vector<ParameterInterval> parameters = {};  // the free ones, in order
  // By linearisation, of the free parameters in the law's units, row by row. Directions the record does not determine
  // have the variance of a uniform distribution over the box.
  std::vector<double> covariance = {};
  int evaluations = 0;
};

struct IntervalOptions {
  double level = 0.95;
  int replicates = 100;  // 0: no bootstrap
};

// `optimum`: all of the law's parameters, at the least objective. A parameter at its bound is held there: its intervals
// are that one value. nullopt when interrupted.
std::optional<Intervals> intervals(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                   std::span<double const> optimum, num::Stream const& stream,
                                   IntervalOptions const& options = {}, Interrupted const& interrupted = {});

// What is known of a series from its autocovariance, by the circular form of the rule: the length of its blocks in
// samples, 1 or more, and the correlations of neighbours up to where they have died out, tapered. For series of a dozen
// values or more; shorter ones count as independent.
struct Serial {
  double block = 1.0;
  std::vector<double> correlation = {1.0};  // by lag
};
Serial serial(std::span<double const> series, double mean);

}  // namespace isolaw::analysis
