// Population recovery: 50 synthetic devices of a law are drawn from a known population at five levels of variability,
// tested (one record each, with noise) and fitted one by one. The population estimated from the fits must equal the
// known one within the sampling error.
//
// The devices are drawn here with a Cholesky factor, not by the library's sampler. Tolerances are 3.5 standard errors,
// from the normal theory of sample covariances (Anderson 2003, An Introduction to Multivariate Statistical Analysis,
// section 3.4). With m = devices - 1 and independent vectors x, y of covariances A and B: var(cov(x, x)_ij) = (A_ii
// A_jj + A_ij^2) / m, var(cov(x, y)_ij) = A_ii B_jj / m.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "isolaw/base/hash.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/lot/population.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::lot {
namespace {

using Eigen::Index;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
using Values = std::vector<double>;

constexpr std::size_t devices = 50;
constexpr double freedom = devices - 1.0;
constexpr double standard_errors = 3.5;
// The correlation between the logarithms of the first two free parameters. The other parameters are independent.
constexpr double correlation = 0.6;

// A law and the medians of its free parameters. Its other parameters are fixed at zero.
struct Lot {
  std::string law;
  std::vector<std::string> names;
  Values medians;
};

std::vector<Lot> const lots{
    {"bilinear", {"K1", "xy", "K2"}, {4.0, 12.0, 0.8}},               // kN/mm, mm, kN/mm
    {"jankowski", {"a1", "a9", "a2", "a11"}, {6e5, 3e4, 8e6, 0.08}},  // N/m, N, N/m^3, m/s
};

// Returns a record of two cycles at each of three amplitudes, at 0.5 Hz. test() replaces its force.
data::FitRecord motion() {
  data::FitRecord record;
  constexpr double omega = std::numbers::pi;
  for (int i = 0; i <= 480; ++i) {
    double const t = 0.025 * i, amplitude_mm = 50.0 * (1 + std::min(i / 160, 2));
    record.time_s.push_back(t);
    record.disp_mm.push_back(amplitude_mm * std::sin(omega * t));
    record.vel_mm_s.push_back(amplitude_mm * omega * std::cos(omega * t));
    record.force_kN.push_back(record.disp_mm.back());
  }
  return record;
}

// Tests and fits devices of a law. Its free parameters are searched on logarithmic scales, from a quarter of their
// medians to four times their medians, so wide that the box cuts off no drawn device.
class Laboratory {
 public:
  explicit Laboratory(Lot const& lot) : lot_(lot), law_(laws::find_law(lot.law)), record_(motion()) {
    for (auto const& parameter : law_.parameters)
      box_.parameters.push_back({.name = std::string(parameter.name), .unit = {}, .free = false});
    for (std::size_t i = 0; i < lot.names.size(); ++i) {
      place_.push_back(law_.index_of(lot.names[i]));
      auto& parameter = box_.parameters[place_.back()];
      parameter.free = true;
      parameter.lower = 0.25 * lot.medians[i];
      parameter.upper = 4.0 * lot.medians[i];
      parameter.scale = laws::Scale::logarithmic;
    }
  }

  // Makes a device's record. `noise` is the standard deviation of the noise over the standard deviation of the force.
  data::FitRecord test(Values const& device, double noise, num::Draws& draws) const {
    auto record = record_;
    record.force_kN = fit::LawOnRecord(law_, record_, laws::Integration::converged).force_kN(all(device));
    double const spread = noise * num::population_std(record.force_kN);
    for (double& force : record.force_kN) force += spread * draws.normal();
    return record;
  }

  DeviceEstimate fitted(data::FitRecord const& record) const {
    fit::LawOnRecord const model(law_, record, laws::Integration::converged);
    Values start;
    for (auto const& parameter : box_.parameters)
      if (parameter.free) start.push_back(0.5);  // start at the medians
    auto const found = opt::descend(fit::IdentificationProblem(model, box_), start, 1.0);
    Values values(box_.parameters.size());
    box_.expand(found.best, values);
    Values best;
    for (auto const place : place_) best.push_back(values[place]);
    return {best, covariance(model, best)};
  }

 private:
  Values all(Values const& free) const {
    Values values(box_.parameters.size(), 0.0);
    for (std::size_t i = 0; i < free.size(); ++i) values[place_[i]] = free[i];
    return values;
  }

  // Returns the asymptotic covariance of a fit by least absolute deviations with weights w (Koenker and Bassett 1978,
  // for independent errors of one density f). It is H^-1 V H^-1 with H = 2 f(0) sum w J J^T and V = sum w^2 J J^T,
  // where J are the derivatives of a residual.
  SquareMatrix covariance(fit::LawOnRecord const& model, Values const& best) const {
    constexpr double step = 1e-5;
    std::vector<Values> candidates{all(best)};
    for (std::size_t i = 0; i < best.size(); ++i)
      for (double const side : {1.0, -1.0}) {
        auto moved = best;
        moved[i] *= 1.0 + side * step;
        candidates.push_back(all(moved));
      }
    auto const samples = static_cast<Index>(model.samples());
    Matrix residuals(samples, static_cast<Index>(candidates.size()));
    model.residuals(candidates.size(),
                    [&](std::size_t i, std::span<double> to) { std::ranges::copy(candidates[i], to.begin()); },
                    {residuals.data(), static_cast<std::size_t>(residuals.size())});
    auto const n = static_cast<Index>(best.size());
    Matrix J(samples, n);
    for (Index i = 0; i < n; ++i)
      J.col(i) =
          (residuals.col(1 + 2 * i) - residuals.col(2 + 2 * i)) / (2.0 * step * best[static_cast<std::size_t>(i)]);
    Vector const w = Eigen::Map<Vector const>(model.residual_weights().data(), samples);
    Matrix const H = 2.0 * density_at_zero(residuals.col(0)) * J.transpose() * w.asDiagonal() * J;
    Matrix const V = J.transpose() * w.cwiseAbs2().asDiagonal() * J;
    Matrix const inverse = H.inverse(), C = inverse * V * inverse;
    SquareMatrix rows;
    for (Index i = 0; i < n; ++i) rows.emplace_back(C.row(i).begin(), C.row(i).end());
    return rows;
  }

  // Estimates the density of the residuals at zero, by a normal kernel with the width for a normal density (Silverman
  // 1986, Eq. 3.28).
  static double density_at_zero(Vector const& residuals) {
    auto const count = static_cast<double>(residuals.size());
    double const width = 1.06 * std::sqrt(residuals.squaredNorm() / count) * std::pow(count, -0.2);
    double const sum = (-0.5 * (residuals / width).array().square()).exp().sum();
    return sum / (count * width * std::sqrt(2.0 * std::numbers::pi));
  }

  Lot const& lot_;
  laws::LawEntry const& law_;
  data::FitRecord record_;
  fit::SearchBox box_;
  std::vector<std::size_t> place_;  // index of each free parameter among the law's parameters
};

Matrix matrix(SquareMatrix const& rows) {
  auto const n = static_cast<Index>(rows.size());
  Matrix square(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) square(i, j) = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return square;
}

// Mean and covariance of the parameters' logarithms: of the population (true), of the 50 devices that were drawn, and
// as estimated from the tests.
struct Recovered {
  Vector true_mean, drawn_mean, mean;
  Matrix true_covariance, drawn_covariance;
  // S is the covariance of the estimates, C is the mean covariance of the errors of the fits, and `covariance` is the
  // covariance of the population as estimated from the tests.
  Matrix covariance, S, C;
  Population population;
};

Recovered recover(Lot const& lot, double level, double noise) {
  Laboratory const laboratory(lot);
  auto const stream = num::Stream(stable_hash(lot.law)).split(static_cast<std::uint64_t>(std::lround(1000.0 * level)));
  auto const n = static_cast<Index>(lot.names.size());
  Matrix root = level * Matrix::Identity(n, n);
  root(1, 0) = level * correlation;
  root(1, 1) = level * std::sqrt(1.0 - correlation * correlation);
  Vector const centre = Eigen::Map<Vector const>(lot.medians.data(), n).array().log();
  Matrix drawn(n, devices);
  std::vector<DeviceEstimate> estimates;
  for (std::uint32_t d = 0; d < devices; ++d) {
    num::Draws draws(stream, 0, d);
    Vector z = Vector::Zero(n);
    for (double& x : z) x = draws.normal();
    drawn.col(d) = centre + root * z;
    Values values;
    for (double const x : drawn.col(d)) values.push_back(std::exp(x));
    estimates.push_back(laboratory.fitted(laboratory.test(values, noise, draws)));
  }
  Recovered moments;
  moments.population = estimate_population(lot.names, estimates);
  moments.true_mean = centre;
  moments.drawn_mean = drawn.rowwise().mean();
  moments.mean = Eigen::Map<Vector const>(moments.population.mean.data(), n);
  moments.true_covariance = root * root.transpose();
  Matrix const centred = drawn.colwise() - moments.drawn_mean;
  moments.drawn_covariance = centred * centred.transpose() / freedom;
  moments.covariance = matrix(moments.population.covariance);
  moments.S = matrix(moments.population.estimates);
  moments.C = matrix(moments.population.uncertainty);
  return moments;
}

// Every entry must lie within 3.5 standard errors of its expected value. `variance` holds the squares of the standard
// errors.
void expect_within(Matrix const& found, Matrix const& expected, Matrix const& variance, char const* what) {
  for (Index i = 0; i < found.rows(); ++i)
    for (Index j = 0; j < found.cols(); ++j)
      EXPECT_NEAR(found(i, j), expected(i, j), standard_errors * std::sqrt(variance(i, j)))
          << what << ' ' << i << ' ' << j;
}

// These functions return the variances of the entries of cov(x, x), and of cov(x, y) + cov(y, x) for independent x and
// y with covariances A and B.
Matrix variance_of_covariance(Matrix const& A) {
  return (A.diagonal() * A.diagonal().transpose() + A.cwiseAbs2()) / freedom;
}
Matrix variance_of_cross_terms(Matrix const& A, Matrix const& B) {
  return (A.diagonal() * B.diagonal().transpose() + B.diagonal() * A.diagonal().transpose() + 2.0 * A.cwiseProduct(B)) /
         freedom;
}

class PopulationRecovery : public testing::TestWithParam<std::size_t> {};

// The devices scatter by 2.5 to 15 %. The errors of the fits are 0.1 to 0.8 %, small beside that scatter, so the mean
// and the covariance estimated from the fits must equal those of the population within the sampling error.
TEST_P(PopulationRecovery, GivesMeanAndCovarianceBack) {
  auto const& lot = lots[GetParam()];
  for (double const level : {0.025, 0.05, 0.10, 0.15}) {
    SCOPED_TRACE(fmt::format("{}, {} %", lot.law, 100.0 * level));
    auto const found = recover(lot, level, 0.01);
    for (auto const transform : found.population.transforms) EXPECT_EQ(transform, Transform::logarithm);
    EXPECT_EQ(found.population.directions, lot.names.size());
    EXPECT_TRUE(found.population.undetermined.empty());

    // The estimates scatter about the population for two reasons: only 50 devices were drawn, and each fit has an
    // error.
    Matrix const T = found.true_covariance + found.C;
    expect_within(found.mean, found.true_mean, T.diagonal() / devices, "mean");
    expect_within(found.covariance, found.true_covariance, variance_of_covariance(T), "covariance");
    // The correlation is far from 0, so its error is skewed. After Fisher's transform it is nearly normal.
    EXPECT_NEAR(std::atanh(found.population.correlation[0][1]), std::atanh(correlation),
                standard_errors / std::sqrt(freedom - 2.0));

    // The estimates differ from the devices that were drawn only by the errors of the fits.
    expect_within(found.mean, found.drawn_mean, found.C.diagonal() / devices, "mean of the devices");
    expect_within(found.covariance, found.drawn_covariance,
                  variance_of_cross_terms(found.drawn_covariance, found.C) + variance_of_covariance(found.C),
                  "covariance of the devices");
  }
}

// If all devices are equal, their estimates differ only by the errors of the fits. Let S be the covariance of the
// estimates, C that of the errors, n the number of parameters and m = devices - 1. Then m trace(C^-1 S) is chi-squared
// with n m degrees of freedom. C itself is about a tenth too large, because the kernel estimates the density of the
// residuals at zero, f(0), too low by half the square of its relative width, and C varies as 1/f(0)^2. For any t, the
// largest eigenvalue of C^-1 S exceeds (1 + root(n / m) + t / root(m))^2 with probability exp(-t^2 / 2) at most
// (Davidson and Szarek 2001, Theorem II.13). isolaw takes the part of an eigenvalue above 1 for scatter between
// devices, so this limits the scatter that it may find.
TEST_P(PopulationRecovery, OfEqualDevicesFindsNoMoreThanTheErrorsOfTheFits) {
  auto const& lot = lots[GetParam()];
  auto const found = recover(lot, 0.0, 0.01);
  auto const n = static_cast<double>(lot.names.size());
  double const ratio = found.C.ldlt().solve(found.S).trace() / n;
  EXPECT_NEAR(ratio, 1.0, standard_errors * std::sqrt(2.0 / (n * freedom)) + 0.10);
  double const largest = std::pow(1.0 + std::sqrt(n / freedom) + standard_errors / std::sqrt(freedom), 2);
  for (Index i = 0; i < found.C.rows(); ++i) {
    EXPECT_LE(found.covariance(i, i), (largest - 1.0) * found.C(i, i));
    // The limit is far below 0.025, the smallest variability in the other tests.
    EXPECT_LT(std::sqrt(found.covariance(i, i)), 0.01);
  }
  EXPECT_LT(found.population.directions, lot.names.size());
  expect_within(found.mean, found.true_mean, found.C.diagonal() / devices, "mean");
}

// With ten times the noise the errors of the fits are as large as the scatter between devices or larger. The covariance
// of the estimates is then the sum of two covariances, that of the population and that of the errors.
TEST_P(PopulationRecovery, AccountsForErrorsAsLargeAsTheScatter) {
  auto const& lot = lots[GetParam()];
  auto const found = recover(lot, 0.025, 0.10);
  ASSERT_GT(found.C.diagonal().maxCoeff(), found.true_covariance.diagonal().maxCoeff());
  Matrix const T = found.true_covariance + found.C;
  expect_within(found.S, T, variance_of_covariance(T), "covariance of the estimates");
  expect_within(found.covariance, found.true_covariance, variance_of_covariance(T), "covariance");
  expect_within(found.mean, found.true_mean, T.diagonal() / devices, "mean");
}

INSTANTIATE_TEST_SUITE_P(Of, PopulationRecovery, testing::Range(std::size_t{0}, lots.size()),
                         [](auto const& law) { return lots[law.param].law; });

}  // namespace
}  // namespace isolaw::lot
