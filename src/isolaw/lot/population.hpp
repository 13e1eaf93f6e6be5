// The population that a lot's devices were drawn from, as the parameters of one law: centre, scatter and correlation.
//
// Model: the estimate of device d is theta_d = mu + b_d + e_d in transformed coordinates (see Transform), with
// b_d ~ N(0, Sigma) the difference between devices and e_d ~ N(0, C_d) the error of its fit. The covariance S of the
// estimates (divisor devices - 1) has the mean Sigma + C, C the mean of the C_d. Sigma is S - C where that is positive:
// in the generalised eigenproblem S x = lambda C x the directions with lambda > 1 keep lambda - 1, the others get none
// (Amemiya 1985, What should be done when an estimated between-group covariance matrix is not nonnegative definite?;
// for equal C_d the Sigma under which S is most likely). So a direction in which the devices do not differ by more
// than their own uncertainty explains has no variance: these tests do not determine it.
//
// Parameters are never drawn one by one: their errors and their true values are strongly correlated, and independent
// marginals make devices that no test has seen.
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

// The coordinate in which a parameter is taken to be normal: its value, or log|value|, the sign being that of the
// devices.
enum class Transform { identity, logarithm };
std::string_view name(Transform transform);

// logarithm where all devices have the same sign and none is zero: a scatter is then a fraction, and no draw changes
// the sign. identity elsewhere, also for no value and where one is not finite.
Transform transform_for(std::span<double const> values);

using SquareMatrix = std::vector<std::vector<double>>;  // [row][column]

// What the fit of one device gave, in the units of the parameters.
struct DeviceEstimate {
  std::vector<double> values;  // [n] best fit
  // [n][n] covariance of its error, taken to log coordinates by C_ij / (value_i value_j); empty: no error. May be
  // singular, or huge along what the test does not determine. Only its symmetric part counts.
  SquareMatrix covariance;
};

// A direction of the transformed coordinates without variance between devices, each coordinate in multiples of the
// standard deviation that scatter and uncertainty give it together, root(S_ii + C_ii).
struct Direction {
  std::vector<double> weights;  // [n], of length 1; the largest is positive
  double ratio = 0.0;           // lambda: variance of the estimates over that of their errors, at most 1
};

// Vectors and matrices over the parameters, in the order given; "transformed" where not said otherwise.
struct Population {
  std::vector<std::string> names;
  std::vector<Transform> transforms;
  std::vector<double> signs;  // of logarithmic parameters; 1 for the others
  std::size_t devices = 0;

  std::vector<double> mean;     // mu; empty without devices
  std::vector<double> medians;  // mu in units of the parameters

  // Empty with fewer than two devices, as all that follows.
  SquareMatrix estimates;               // S
  SquareMatrix uncertainty;             // C
  SquareMatrix covariance;              // Sigma
  std::size_t directions = 0;           // with variance, the rank of Sigma; at most devices - 1
  std::vector<Direction> undetermined;  // those left out, smallest ratio first
  std::vector<double> std;              // of Sigma; in units of the parameter for Transform::identity
  std::vector<double> relative_std;  // of logarithmic parameters std itself, of others std / |mean|; NaN: mean is zero
  SquareMatrix correlation;          // NaN off the diagonal where a parameter has no variance
  std::string note;                  // why there is no covariance, or what its rank does not cover; empty otherwise

  bool has_covariance() const { return !covariance.empty(); }
};

// names[n] and devices[d]; transforms from transform_for on the devices' values. One device has a mean and no
// covariance, none has neither; `note` says so. Throws Error, with all complaints, for vectors and matrices of another
// size than names, values that are not finite or whose squares are not, and negative variances of an estimate.
// `undetermined`: parameters that no device's test determines. One whose estimates scatter no more than its error would
// if all others were known does not act and is taken out of S first: in a lot of a dozen devices its chance
// correlations with those that do differ would give it a scatter back. Ke and A of a law that knows only their product
// stay. Cost: n^3 + devices n^2.
Population estimate_population(std::vector<std::string> const& names, std::span<DeviceEstimate const> devices,
                               std::span<std::size_t const> undetermined = {});

// Physical limits of a parameter, in its units; a value at a limit is inside.
struct Limits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

struct Sample {
  SquareMatrix values;          // [count][n], in units of the parameters
  std::size_t rejected = 0;     // draws outside the limits, drawn again
  std::size_t pulled_back = 0;  // draws without one inside in `most_tries`
};
inline constexpr std::uint32_t most_tries = 100;

// `count` devices of the population N(mu, Sigma), all parameters of one drawn together: mu + Sigma^(1/2) z by the
// symmetric root, which does not jump where eigenvalues coincide. Number i comes from the stream's place (i, try)
// alone, whatever the count. What leaves `limits` (one per parameter, or none at all) is drawn again; after
// `most_tries` the last draw is pulled back towards the medians, along the straight line in transformed coordinates, so
// that it keeps to the directions in which devices differ. Both are counted: many of them mean that the limits, not the
// tests, shape the sample.
// Throws Error for a population without covariance, for limits of another number, and for medians outside the limits.
Sample sample(Population const& population, std::size_t count, num::Stream const& stream,
              std::span<Limits const> limits = {});

}  // namespace isolaw::lot
