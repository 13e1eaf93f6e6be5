#include "isolaw/lot/population.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/num/linear.hpp"

namespace isolaw::lot {
namespace {

using num::Index;
using num::Matrix;
using num::Vector;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
// An eigenvalue of a covariance matrix counts as 0 if it is below this fraction of the largest one: it may be only a
// rounding error.
constexpr double rounding = 1e-13;
// Devices count as different in a direction if the variance of the estimates exceeds that of their errors by this share
// of the sum of the two variances.
constexpr double least_remainder = 1e-10;

std::size_t as_size(Index i) {
  return static_cast<std::size_t>(i);
}

std::vector<double> plain(Vector const& v) {
  return {v.begin(), v.end()};
}

SquareMatrix plain(Matrix const& m) {
  SquareMatrix rows;
  for (Index i = 0; i < m.rows(); ++i) rows.push_back(plain(Vector(m.row(i))));
  return rows;
}

Matrix matrix(SquareMatrix const& rows) {
  auto const n = static_cast<Index>(rows.size());
  Matrix m(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) m(i, j) = rows[as_size(i)][as_size(j)];
  return m;
}

Vector vector(std::vector<double> const& values) {
  return Eigen::Map<Vector const>(values.data(), static_cast<Index>(values.size()));
}

void check_covariance(std::vector<std::string> const& names, SquareMatrix const& covariance, std::string const& where,
                      std::vector<Complaint>& complaints) {
  auto const n = names.size();
  bool const square =
      covariance.size() == n && std::ranges::all_of(covariance, [&](auto const& row) { return row.size() == n; });
  if (!square) {
    complaints.push_back({where, "a covariance of another size", fmt::format("{0} by {0}, or none", n), {}});
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::ranges::all_of(covariance[i], [](double value) { return std::isfinite(value); }))
      complaints.push_back({where, "a covariance of " + names[i] + " that is not finite", "finite numbers", {}});
    else if (covariance[i][i] < 0.0)
      complaints.push_back({where, fmt::format("a variance of {} of {}", names[i], covariance[i][i]), "0 or more", {}});
  }
}

void check(std::vector<std::string> const& names, std::span<DeviceEstimate const> devices) {
  std::vector<Complaint> complaints;
  for (std::size_t d = 0; d < devices.size(); ++d) {
    auto const where = fmt::format("population, device {}", d + 1);
    auto const& values = devices[d].values;
    if (values.size() != names.size()) {
      complaints.push_back({where, fmt::format("{} values", values.size()), fmt::format("{}", names.size()), {}});
      continue;
    }
    for (std::size_t n = 0; n < names.size(); ++n)
      if (!std::isfinite(values[n]))
        complaints.push_back({where, fmt::format("{} = {}", names[n], values[n]), "a finite value",
                              "leaving out a device whose fit failed"});
    if (!devices[d].covariance.empty()) check_covariance(names, devices[d].covariance, where, complaints);
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
}

// One device in transformed coordinates.
struct Located {
  Vector at;     // theta_d, the estimate of its parameters
  Matrix error;  // C_d, the covariance of the error of its fit
};

Located transformed(Population const& population, DeviceEstimate const& device) {
  auto const n = static_cast<Index>(device.values.size());
  Located result{vector(device.values), Matrix::Zero(n, n)};
  if (!device.covariance.empty()) {
    Matrix const given = matrix(device.covariance);
    result.error = 0.5 * given + 0.5 * given.transpose();
  }
  for (Index i = 0; i < n; ++i) {
    if (population.transforms[as_size(i)] == Transform::identity) continue;
    double const value = result.at[i];
    result.error.row(i) /= value;
    result.error.col(i) /= value;
    result.at[i] = std::log(std::abs(value));
  }
  return result;
}

std::vector<double> physical(Population const& population, Vector const& at) {
  auto values = plain(at);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (population.transforms[i] == Transform::logarithm) values[i] = population.signs[i] * std::exp(values[i]);
  return values;
}

// Replaces each element that is not above 0 by 1, so that the result can be a divisor.
Vector or_one(Vector v) {
  for (double& x : v) x = x > 0.0 ? x : 1.0;
  return v;
}

// Multiplies row i and column i of a matrix by factors[i].
Matrix scaled(Matrix const& m, Vector const& factors) {
  return factors.asDiagonal() * m * factors.asDiagonal();
}

std::vector<double> unit_direction(Vector v) {
  v.normalize();
  Index largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  return plain(Vector(v[largest] < 0.0 ? -v : v));
}

// Computes the covariance Sigma between devices from the covariance S of the estimates and the covariance C of their
// errors (see S x = lambda C x in population.hpp). It solves S x = m T x with T = S + C and m = lambda / (1 + lambda)
// instead, because m is between 0 and 1 even if C and S are singular or zero. (lambda - 1) C becomes (2 m - 1) T.
// Division by the diagonal of T makes units irrelevant. Directions in which T is zero are left out: they have no
// scatter.
Matrix between_devices(Matrix const& S, Matrix const& C, Population& population) {
  Vector const scale = or_one((S + C).diagonal().cwiseMax(0.0).cwiseSqrt());
  Vector const shrink = scale.cwiseInverse();
  Matrix const s = scaled(S, shrink);
  auto const total = num::symmetric_eigen(s + scaled(C, shrink));
  double const largest = total.values.maxCoeff();
  std::vector<Index> range;
  for (Index i = 0; i < total.values.size(); ++i)
    if (total.values[i] > rounding * largest) range.push_back(i);

  auto const n = S.rows();
  Matrix sigma = Matrix::Zero(n, n);
  if (range.empty()) return sigma;
  Matrix const axes = total.vectors(Eigen::all, range);
  Vector const size = total.values(range).cwiseSqrt();
  Matrix const whiten = axes * size.cwiseInverse().asDiagonal(), colour = axes * size.asDiagonal();
  auto const shares = num::symmetric_eigen(num::product(num::transposed_product(whiten, s), whiten));
  for (Index i = 0; i < shares.values.size(); ++i) {
    double const m = shares.values[i], remainder = 2.0 * m - 1.0;
    Vector const direction = num::apply(colour, shares.vectors.col(i));
    if (remainder > least_remainder) {
      ++population.directions;
      sigma += remainder * direction * direction.transpose();
    } else {
      population.undetermined.push_back({unit_direction(direction), std::max(0.0, m) / (1.0 - m)});
    }
  }
  return scaled(sigma, scale);
}

// Variance of each parameter's error if all other parameters were known: 1 / (C^-1)_ii. It may be near zero if C is
// singular.
Vector conditional_variances(Matrix const& C) {
  Vector const scale = or_one(C.diagonal().cwiseMax(0.0).cwiseSqrt());
  auto const parts = num::symmetric_eigen(scaled(C, scale.cwiseInverse()));
  Vector const inverse = parts.values.cwiseMax(rounding).cwiseInverse();
  return num::apply(Matrix(parts.vectors.cwiseAbs2()), inverse).cwiseInverse().cwiseProduct(scale.cwiseAbs2());
}

// Sets the row and column of a parameter in S, the covariance of the estimates, to zero if the tests do not determine
// the parameter and its estimates scatter no more than their errors, whose covariance is C. Nothing then shows that
// devices differ in this parameter.
void zero_undetermined(Matrix& S, Matrix const& C, std::span<std::size_t const> undetermined) {
  Vector const error = conditional_variances(C);
  for (auto const parameter : undetermined) {
    auto const i = static_cast<Index>(parameter);
    if (S(i, i) > error[i]) continue;
    S.row(i).setZero();
    S.col(i).setZero();
  }
}

Matrix correlation_of(Matrix const& sigma) {
  Vector const spread = sigma.diagonal().cwiseSqrt();
  Matrix correlation = Matrix::Identity(sigma.rows(), sigma.cols());
  for (Index i = 0; i < correlation.rows(); ++i)
    for (Index j = 0; j < correlation.cols(); ++j) {
      double const product = spread[i] * spread[j];
      if (i != j) correlation(i, j) = product > 0.0 ? std::clamp(sigma(i, j) / product, -1.0, 1.0) : nan;
    }
  return correlation;
}

std::string note_on_rank(Population const& population) {
  auto const n = population.names.size();
  if (population.directions == n) return {};
  auto text = fmt::format(
      "the devices differ by more than the uncertainty of their fits in only {} of {} independent combinations of the parameters",
      population.directions, n);
  if (population.devices <= n)
    text += fmt::format("; from {} devices no more than {} can be seen", population.devices, population.devices - 1);
  return text;
}

void describe(Matrix const& sigma, Population& population) {
  population.covariance = plain(sigma);
  population.correlation = plain(correlation_of(sigma));
  population.std = plain(Vector(sigma.diagonal().cwiseSqrt()));
  for (std::size_t i = 0; i < population.names.size(); ++i) {
    bool const logarithm = population.transforms[i] == Transform::logarithm;
    double const mean = std::abs(population.mean[i]);
    population.relative_std.push_back(logarithm ? population.std[i] : mean > 0.0 ? population.std[i] / mean : nan);
  }
  population.note = note_on_rank(population);
}

// The symmetric square root of the covariance between devices. It is computed from the correlations, since these do not
// depend on the units of the parameters.
Matrix symmetric_root(Population const& population) {
  Matrix const sigma = matrix(population.covariance);
  Vector const spread = sigma.diagonal().cwiseMax(0.0).cwiseSqrt(), scale = or_one(spread);
  auto const parts = num::symmetric_eigen(scaled(sigma, scale.cwiseInverse()));
  return num::product_of_transposed(scale.asDiagonal() * parts.vectors, parts.values.cwiseMax(0.0).cwiseSqrt(),
                                    parts.vectors);
}

bool inside(std::vector<double> const& values, std::span<Limits const> limits) {
  for (std::size_t i = 0; i < limits.size(); ++i)
    if (!(values[i] >= limits[i].lower && values[i] <= limits[i].upper)) return false;
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

void check_sampling(Population const& population, std::span<Limits const> limits) {
  if (!population.has_covariance())
    throw Error({"sample of a population", "no covariance: " + population.note, "two devices or more", {}});
  if (!limits.empty() && limits.size() != population.names.size())
    throw Error({"sample of a population",
                 fmt::format("limits of {} parameters", limits.size()),
                 fmt::format("of {}, or none", population.names.size()),
                 {}});
  std::vector<Complaint> complaints;
  for (std::size_t i = 0; i < limits.size(); ++i)
    if (!(population.medians[i] >= limits[i].lower && population.medians[i] <= limits[i].upper))
      complaints.push_back({"sample of a population",
                            fmt::format("{}, median {}", population.names[i], population.medians[i]),
                            fmt::format("{} to {}", limits[i].lower, limits[i].upper),
                            {}});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

}  // namespace

std::string_view name(Transform transform) {
  return transform == Transform::logarithm ? "logarithm" : "identity";
}

Transform transform_for(std::span<double const> values) {
  if (values.empty()) return Transform::identity;
  bool const one_sign = std::ranges::all_of(values, [&](double value) {
    return std::isfinite(value) && value != 0.0 && std::signbit(value) == std::signbit(values[0]);
  });
  return one_sign ? Transform::logarithm : Transform::identity;
}

Population estimate_population(std::vector<std::string> const& names, std::span<DeviceEstimate const> devices,
                               std::span<std::size_t const> undetermined) {
  check(names, devices);
  Population population;
  population.names = names;
  population.devices = devices.size();
  for (std::size_t n = 0; n < names.size(); ++n) {
    std::vector<double> values;
    for (auto const& device : devices) values.push_back(device.values[n]);
    population.transforms.push_back(transform_for(values));
    bool const negative = population.transforms.back() == Transform::logarithm && values[0] < 0.0;
    population.signs.push_back(negative ? -1.0 : 1.0);
  }
  population.note = names.empty()         ? "no free parameter"
                    : devices.empty()     ? "no device"
                    : devices.size() == 1 ? "one device: no scatter between devices"
                                          : "";
  if (names.empty() || devices.empty()) return population;

  std::vector<Located> located;
  for (auto const& device : devices) located.push_back(transformed(population, device));
  auto const n = static_cast<Index>(names.size());
  auto const count = static_cast<double>(devices.size());
  Vector const first = transformed(population, devices.front()).at;
  // Starts from the first device and adds differences from it, so that equal devices have exactly zero scatter.
  Vector mean = first;
  for (auto const& device : located) mean += (device.at - first) / count;
  population.mean = plain(mean);
  population.medians = physical(population, mean);
  if (devices.size() == 1) return population;

  Matrix S = Matrix::Zero(n, n), C = Matrix::Zero(n, n);
  for (auto const& device : located) {
    S += (device.at - mean) * (device.at - mean).transpose() / (count - 1.0);
    C += device.error / count;
  }
  if (!S.allFinite() || !C.allFinite())
    throw Error({"population", "values or errors whose squares are no numbers any more",
                 "errors below 1e150 times the value", "fixing a parameter that the test does not determine"});
  population.estimates = plain(S);
  population.uncertainty = plain(C);
  zero_undetermined(S, C, undetermined);
  Matrix sigma = between_devices(S, C, population);
  // Sets variances that are only rounding errors to zero. Otherwise correlations would be computed from them.
  for (Index i = 0; i < n; ++i)
    if (sigma(i, i) <= 1e-12 * (S(i, i) + C(i, i))) {
      sigma.row(i).setZero();
      sigma.col(i).setZero();
    }
  describe(sigma, population);
  return population;
}

Sample sample(Population const& population, std::size_t count, num::Stream const& stream,
              std::span<Limits const> limits) {
  check_sampling(population, limits);
  Vector const mean = vector(population.mean);
  Matrix const root = symmetric_root(population);
  Sample result;
  for (std::size_t i = 0; i < count; ++i) {
    Vector z(mean.size());
    std::vector<double> values;
    bool found = false;
    for (std::uint32_t attempt = 0; attempt < most_tries && !found; ++attempt) {
      num::Draws draws(stream, static_cast<std::uint32_t>(i), attempt);
      for (double& x : z) x = draws.normal();
      values = physical(population, mean + num::apply(root, z));
      found = inside(values, limits);
      result.rejected += found ? 0 : 1;
    }
    if (!found) ++result.pulled_back;
    while (!found) {
      z *= 0.5;
      // If a median lies on its limit, even a tiny z may leave the limits. The medians themselves are then taken.
      values = z.norm() > 1e-12 ? physical(population, mean + num::apply(root, z)) : population.medians;
      found = inside(values, limits) || z.norm() <= 1e-12;
    }
    result.values.push_back(std::move(values));
  }
  return result;
}

}  // namespace isolaw::lot
