// Estimates the population that a lot's devices come from, as a distribution of one law's parameters (centre, scatter
// and correlation), and draws devices from it.
// Model: the estimate of device d is theta_d = mu + b_d + e_d in transformed coordinates (see Transform), with b_d ~
// N(0, Sigma) the difference between devices and e_d ~ N(0, C_d) the error of its fit. The covariance S of the
// estimates (divisor devices - 1) has the expected value Sigma + C, where C is the mean of the C_d. We therefore use
// Sigma = S - C where this is positive: in the generalised eigenproblem S x = lambda C x, directions with lambda > 1
// keep lambda - 1 and the others get no variance (Amemiya 1985, What should be done when an estimated between-group
// covariance matrix is not nonnegative definite?; for equal C_d this Sigma makes S most likely). A direction thus has
// no variance if the devices differ no more in it than their own uncertainty explains: the tests do not determine it.
// Rejected: drawing parameters one by one. Their errors and true values are strongly correlated, so that independent
// draws give devices unlike any that was tested.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/num/random.hpp"

namespace isolaw::lot {

// The coordinate in which a parameter is taken to be normal: its value, or log|value| with the sign of all devices.
enum class Transform { identity, logarithm };
std::string_view name(Transform transform);
// logarithm if all values are finite, have the same sign and none is zero: a scatter is then a fraction, and no draw
// changes the sign. identity otherwise, also if there are no values.
Transform transform_for(std::span<double const> values);

using SquareMatrix = std::vector<std::vector<double>>;  // [row][column]

struct DeviceEstimate {        // the fit of one device, in the units of the parameters
  std::vector<double> values;  // [n] best fit
  // [n][n] covariance of its error; empty: no error. In log coordinates it becomes C_ij / (value_i value_j). It may be
  // singular, or huge in directions that the test does not determine. Only its symmetric part counts.
  SquareMatrix covariance;
};

// A direction without variance between devices. Each transformed coordinate counts in multiples of root(S_ii + C_ii),
// the standard deviation from scatter and uncertainty together.
struct Direction {
  std::vector<double> weights;  // [n], of length 1; the largest is positive
  double ratio = 0.0;           // lambda: variance of the estimates / variance of their errors, at most 1
};

// Vectors and matrices have an element per parameter, in the order given, transformed unless a comment says otherwise.
struct Population {
  std::vector<std::string> names;
  std::vector<Transform> transforms;
  std::vector<double> signs;  // 1 or -1; 1 for parameters that are not logarithmic
  std::size_t devices = 0;

  std::vector<double> mean;     // mu; empty without devices
  std::vector<double> medians;  // mu in the units of the parameters
  // With fewer than two devices this and all that follows, except the note, is empty.
  SquareMatrix estimates;               // S
  SquareMatrix uncertainty;             // C
  SquareMatrix covariance;              // Sigma
  std::size_t directions = 0;           // number of directions with variance, the rank of Sigma; at most devices - 1
  std::vector<Direction> undetermined;  // directions without variance, smallest ratio first
  std::vector<double> std;              // standard deviations by Sigma
  std::vector<double> relative_std;  // std itself for logarithmic parameters, std / |mean| for others; NaN if mean is 0
  SquareMatrix correlation;          // NaN off the diagonal if either parameter has no variance
  std::string note;                  // why there is no covariance or why its rank is too low; empty otherwise

  bool has_covariance() const { return !covariance.empty(); }
};

// names[n] and devices[d]; transform_for chooses the transforms from the devices' values. A single device gives a mean
// but no covariance, no device gives neither; `note` says so. Throws Error, with all complaints, for vectors and
// matrices of another size than names, values that are not finite or whose squares are not, and negative variances.
// `undetermined` are indices of parameters that no device's test determines. Such a parameter has no effect if its
// estimates scatter no more than its error would if all others were known. Its rows and columns of S are then set to
// zero first: otherwise chance correlations with parameters that do differ would give it a scatter in a lot of a dozen
// devices. If a law depends only on the product of Ke and A, both stay. Cost: n^3 + devices n^2.
Population estimate_population(std::vector<std::string> const& names, std::span<DeviceEstimate const> devices,
                               std::span<std::size_t const> undetermined = {});

struct Limits {  // physical limits of a parameter in its units; a value at a limit is inside
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

struct Sample {
  SquareMatrix values;          // [count][n], in the units of the parameters
  std::size_t rejected = 0;     // draws outside the limits
  std::size_t pulled_back = 0;  // devices whose `most_tries` draws were all outside
};
inline constexpr std::uint32_t most_tries = 100;
// Draws `count` devices from N(mu, Sigma), all parameters of a device together, as mu + Sigma^(1/2) z. The symmetric
// root does not jump where eigenvalues coincide. Device i depends only on the stream's places (i, try), not on the
// count. A draw outside `limits` (one per parameter, or none at all) is repeated. After `most_tries` the last one is
// pulled back towards the medians along a straight line in transformed coordinates, which keeps it in the directions in
// which devices differ. Many rejected or pulled back draws mean that the limits, not the tests, shape the sample.
// Throws Error for a population without covariance, for another number of limits, and for medians outside the limits.
Sample sample(Population const& population, std::size_t count, num::Stream const& stream,
              std::span<Limits const> limits = {});

}  // namespace isolaw::lot
