// Estimates the population that the devices of a lot come from, as a distribution of one law's parameters (centre,
// scatter and correlation), and draws devices from it.
// Model: in transformed coordinates (see Transform) the estimate of device d is theta_d = mu + b_d + e_d. The device
// differs from the centre by b_d ~ N(0, Sigma); the error of its fit is e_d ~ N(0, C_d). The covariance S of the
// estimates, with divisor devices - 1, has the expected value Sigma + C, where C is the mean of the C_d. Sigma is
// therefore estimated as S - C, as far as this is positive. The generalised eigenproblem S x = lambda C x gives the
// directions x. A direction with lambda > 1 gets the variance lambda - 1 times that of C, the others get none
// (Amemiya 1985, What should be done when an estimated between-group covariance matrix is not nonnegative definite?).
// For equal C_d this is the Sigma of maximum likelihood. In a direction without variance, the uncertainty of the fits
// explains all differences between devices.
// Parameters are not drawn one by one: their errors and true values are strongly correlated, and independent draws
// would give devices unlike any tested device.
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

// The coordinate in which a parameter is normally distributed: its value, or log|value| if the values of all devices
// have one sign.
enum class Transform { identity, logarithm };
std::string_view name(Transform transform);
// Returns logarithm if all values are finite, not zero and of one sign: the scatter is then relative, and no draw has
// the other sign. Returns identity otherwise, and if there are no values.
Transform transform_for(std::span<double const> values);

using SquareMatrix = std::vector<std::vector<double>>;  // [row][column]

// The fit of a law with n free parameters to one device, in the units of the parameters.
struct DeviceEstimate {
  std::vector<double> values;  // the n parameters of the best fit
  // n x n covariance of the fit's error; empty means no error. It may be singular, and huge in directions that the
  // test does not determine. Only its symmetric part is used. If parameters i and j are both transformed to logarithms,
  // C_ij becomes C_ij / (value_i value_j).
  SquareMatrix covariance;
};

// A direction in which devices show no variance. Its coordinates are the transformed ones, each divided by
// root(S_ii + C_ii), the standard deviation from scatter and uncertainty together.
struct Direction {
  // One component for each parameter: a vector of unit length, with the sign that makes its largest component positive.
  std::vector<double> weights;
  double ratio = 0.0;  // lambda: variance of the estimates / variance of their errors, in this direction; at most 1
};

// Vectors and matrices have one element per parameter, in the given order, transformed unless a comment says otherwise.
struct Population {
  std::vector<std::string> names;
  std::vector<Transform> transforms;
  std::vector<double> signs;  // 1 or -1: the sign of a parameter whose Transform is a logarithm; 1 for the others
  std::size_t devices = 0;

  std::vector<double> mean;     // mu, the mean of the devices' estimates; empty if there are no devices
  std::vector<double> medians;  // mu transformed back to the units of the parameters
  // From here on, all members except `note` are empty if there are fewer than two devices.
  SquareMatrix estimates;               // S, the covariance of the estimates
  SquareMatrix uncertainty;             // C, the mean covariance of the fits' errors
  SquareMatrix covariance;              // Sigma, the covariance between devices
  std::size_t directions = 0;           // rank of Sigma: number of directions with variance; at most devices - 1
  std::vector<Direction> undetermined;  // directions without variance, smallest ratio first
  std::vector<double> std;              // standard deviation of each parameter between devices, from Sigma
  std::vector<double> relative_std;  // std of a logarithm is relative already; otherwise std / |mean|, NaN for mean 0
  SquareMatrix correlation;          // between parameters, from Sigma; NaN if one of the two has no variance
  std::string note;                  // why covariance is missing or of low rank; empty otherwise

  bool has_covariance() const { return !covariance.empty(); }
};

// Estimates the population from names[n] and devices[d]; transform_for() chooses the transforms. From one device there
// is a mean but no covariance, from no device neither, and `note` says so. Throws one Error with all complaints: sizes
// that do not fit the number of names, values or squares of values that are not finite, and negative variances.
// `undetermined` holds indices of parameters that no device's test determines. The variance of such a parameter's
// estimates is compared with the variance that its error would have if all other parameters were known. If the
// estimates vary no more than that error, the row and column of S become zero, so that the parameter has no scatter.
// Otherwise chance correlations with other parameters would give it a scatter in a lot of a dozen devices. If a law
// depends only on the product of two parameters, both keep their scatter, since each has a small error once the other
// is known. Cost: n^3 + devices n^2.
Population estimate_population(std::vector<std::string> const& names, std::span<DeviceEstimate const> devices,
                               std::span<std::size_t const> undetermined = {});

// Physical limits of a parameter, in its unit. A value equal to a limit is allowed.
struct Limits {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

struct Sample {
  SquareMatrix values;       // [device drawn][parameter], in the units of the parameters
  std::size_t rejected = 0;  // number of draws that were thrown away because a parameter was outside its limits
  // Number of devices that were moved into the limits, because `most_tries` draws in a row had been outside.
  std::size_t pulled_back = 0;
};
inline constexpr std::uint32_t most_tries = 100;
// Draws `count` devices from N(mu, Sigma) as mu + Sigma^(1/2) z, with all parameters of a device together. The root is
// the symmetric one, which does not jump where eigenvalues coincide. The random numbers of device i depend on i and on
// the number of the try only, so they do not depend on `count`. A draw outside `limits` (one pair per parameter, or
// none) is repeated. After `most_tries` the last draw is moved towards the medians on a straight line in transformed
// coordinates, because this keeps to the directions in which devices differ. If many draws are repeated or moved, the
// limits shape the sample more than the tests do. Throws Error for a population without covariance, if the number of
// limits is wrong, and if a median is outside its limits.
Sample sample(Population const& population, std::size_t count, num::Stream const& stream,
              std::span<Limits const> limits = {});

}  // namespace isolaw::lot
