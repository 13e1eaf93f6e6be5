// The uncertainty of fitted parameters, computed in two ways, for residuals that depend on their neighbours.
// Linearisation: the estimate by least absolute residuals is asymptotically normal with covariance H^-1 V H^-1 (Koenker
// and Bassett 1978). H is the curvature of the expected objective, sum 2 f w J J^T, where f is the density of the
// residuals at zero, from a kernel and their local size. V is the variance of the score w sign(r) J, where the signs
// are correlated according to their autocorrelation (Weiss 1990). A factor n / (n - p) makes up for the p fitted
// parameters, n being the number of independent samples that the record is worth. Valid if the law is nearly linear
// over the interval and n is ten or more for each parameter; with three, intervals of 95 % cover 80 to 92 %. Bootstrap:
// blocks of the record are drawn with replacement and the law is fitted again, many times. A block's residuals count as
// often as it was drawn, while the law still runs through the whole history (Kuensch 1989). This assumes neither a
// linear law nor residuals of one kind. Long correlation leaves few blocks: with three dozen independent samples,
// intervals of 95 % cover 89 %. The length of the blocks follows from the correlation of the residuals' signs (Politis
// and White 2004, corrected by Patton et al. 2009) and is at most an eighth of the samples.
// Both estimate how far another record of the same device could move the fit if the law's misfit were noise. They do
// not show whether the law is true, and they are no distribution of the parameters.
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
  std::size_t parameter = 0;                      // index among the law's parameters
  double linear_lower = 0.0, linear_upper = 0.0;  // these and the next are inside the box, in the law's units
  std::optional<double> bootstrap_lower = {}, bootstrap_upper = {};
};

struct Intervals {
  double level = 0.95;
  std::size_t samples = 0, block = 0;              // scored samples, and the length of a block in samples
  int replicates = 0;                              // successful fits of the bootstrap
  std::vector<ParameterInterval> parameters = {};  // the free ones, in order
  // Covariance by linearisation of the free parameters in the law's units, row by row. Directions that the record does
  // not determine have the variance of a uniform distribution over the box.
  std::vector<double> covariance = {};
  int evaluations = 0;
};

struct IntervalOptions {
  double level = 0.95;
  int replicates = 100;  // 0: no bootstrap
};

// `optimum` holds all of the law's parameters, at the least objective. A parameter at its bound is kept at the bound,
// and its intervals are that single value. nullopt if interrupted.
std::optional<Intervals> intervals(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                   std::span<double const> optimum, num::Stream const& stream,
                                   IntervalOptions const& options = {}, Interrupted const& interrupted = {});

// The serial correlation of a series: the length of its circular blocks in samples, at least 1, and the tapered
// autocorrelation up to the lag where it has died out. Less than a dozen values count as independent.
struct Serial {
  double block = 1.0;
  std::vector<double> correlation = {1.0};  // by lag
};
Serial serial(std::span<double const> series, double mean);

}  // namespace isolaw::analysis
