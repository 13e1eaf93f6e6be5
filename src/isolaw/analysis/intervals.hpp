// Computes the uncertainty of fitted parameters in two ways, for residuals that are correlated with their neighbours.
// Linearisation: the estimate by least absolute residuals is asymptotically normal with covariance H^-1 V H^-1 (Koenker
// and Bassett 1978). r is the residual of a sample, w its weight, and J its derivatives with respect to the parameters.
// H = sum 2 f w J J^T is the curvature of the expected objective. f is the probability density of the residuals at
// zero, estimated with a Gaussian kernel and the residuals' local size. V is the variance of sum w sign(r) J; the
// correlation of the signs is estimated from the residuals (Weiss 1990). A fit of p parameters leaves residuals that
// are smaller and less correlated than the errors. For each of these two effects the covariance is divided by 1 - p /
// n, where n is the number of independent samples that carry as much information as the record. Student's t
// distribution with n - p degrees of freedom takes the place of the normal one. The linearisation is valid if the law
// is nearly linear over the interval.
// Bootstrap: blocks of the record are drawn with replacement, and the law is fitted again, many times. The residuals of
// a block count as often as the block was drawn; the law still runs through the whole history (Kuensch 1989). This
// assumes neither a linear law nor equal residuals everywhere. The length of the blocks follows from the correlation of
// the signs (Politis and White 2004, corrected by Patton et al. 2009) and is at most an eighth of the samples. The
// intervals are widened about the optimum, because the fit made the residuals too small (Hesterberg 2015).
// docs/analysis.md says how often intervals of 95 % contained the true value. Both ways tell how far another record of
// the same device could move the fit if the misfit were noise. They do not tell whether the law is right, nor how the
// parameters are distributed over devices.
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
  double linear_lower = 0.0, linear_upper = 0.0;  // interval by linearisation, inside the box, in the law's units
  std::optional<double> bootstrap_lower = {}, bootstrap_upper = {};
};

struct Intervals {
  double level = 0.95;
  // Number of samples with a weight above 0, and number of successive samples that the bootstrap draws together.
  std::size_t samples = 0, block = 0;
  int replicates = 0;                              // number of refits in the bootstrap that succeeded
  std::vector<ParameterInterval> parameters = {};  // one for each free parameter, in the law's order
  // Covariance of the free parameters by linearisation, in the law's units, row by row. In directions that the record
  // does not determine, it is that of a uniform distribution over the box.
  std::vector<double> covariance = {};
  int evaluations = 0;
};

struct IntervalOptions {
  double level = 0.95;
  int replicates = 100;  // number of refits in the bootstrap; 0: no bootstrap
};

// `optimum` holds all of the law's parameters, at the least objective. A parameter at a bound is fixed there, and its
// interval is this single value. Returns nullopt if interrupted.
std::optional<Intervals> intervals(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                   std::span<double const> optimum, num::Stream const& stream,
                                   IntervalOptions const& options = {}, Interrupted const& interrupted = {});

// Serial correlation of a series: the block length in samples for the bootstrap (at least 1), and the estimated
// autocorrelation. From the last significant lag on, the autocorrelation is multiplied by a factor that falls linearly
// to zero at twice that lag. A series is taken as independent if it has fewer than twelve values, hardly any variance,
// or no significant lag.
struct SerialCorrelation {
  double block = 1.0;
  std::vector<double> correlation = {1.0};  // autocorrelation for lags 0, 1, 2, ...
};
SerialCorrelation serial_correlation(std::span<double const> series, double mean);

}  // namespace isolaw::analysis
