#include "isolaw/analysis/intervals.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "isolaw/analysis/sensitivity.hpp"
#include "isolaw/base/work_ahead.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::analysis {
namespace {

using num::Index;
using num::Matrix;
using num::Vector;

double quantile(std::vector<double> sorted, double probability) {
  std::ranges::sort(sorted);
  double const at = probability * static_cast<double>(sorted.size() - 1);
  auto const below = static_cast<std::size_t>(at);
  auto const above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

// For each sample, the mean |residual| in the eighth of the record around it, but at least a tenth of the mean over the
// record. In a narrower window, the samples that the fit passes through exactly would make this mean too small.
Vector local_size(Vector const& residuals) {
  constexpr double rounding = 1e-12;
  Index const n = residuals.size(), half = std::max<Index>(1, n / 16);
  double const least = std::max(0.1 * residuals.cwiseAbs().mean(), rounding);
  Vector sizes(n);
  for (Index i = 0; i < n; ++i) {
    Index const first = std::max<Index>(0, i - half), last = std::min(n - 1, i + half);
    sizes[i] = std::max(residuals.segment(first, last - first + 1).cwiseAbs().mean(), least);
  }
  return sizes;
}

// Probability density at zero of residuals scaled to unit size, by a Gaussian kernel. The `fitted` smallest residuals
// are left out: a fit by least absolute residuals passes exactly through as many samples as it has parameters.
double density_at_zero(Vector const& residuals, Index fitted) {
  std::vector<double> sizes;
  for (double const r : residuals) sizes.push_back(std::abs(r));
  std::ranges::sort(sizes);
  sizes.erase(sizes.begin(), sizes.begin() + std::min(fitted, residuals.size() / 2));
  auto const count = static_cast<double>(sizes.size());
  double squares = 0.0;
  for (double const size : sizes) squares += size * size;
  // Half a normal distribution lies within 0.6745 standard deviations, so the median of the sizes gives an estimate of
  // the standard deviation. least_spread keeps the kernel's width above 0.
  constexpr double least_spread = 1e-3;
  double const spread = std::max(std::min(quantile(sizes, 0.5) / 0.6745, std::sqrt(squares / count)), least_spread);
  double const width = 1.06 * spread * std::pow(count, -0.2);
  double sum = 0.0;
  for (double const size : sizes) sum += std::exp(-0.5 * size * size / (width * width));
  return sum / (count * width * std::sqrt(2.0 * std::numbers::pi));
}

// Computes H (intervals.hpp). The density f of a sample's residual at zero is estimated from the residuals around the
// sample. Its own residual tells nothing if few samples decide on a parameter, since the fit then passes through these
// samples exactly.
Matrix curvature(Sensitivity const& response) {
  Vector const size = local_size(response.residuals);
  double const density = density_at_zero(response.residuals.cwiseQuotient(size), response.jacobian.cols());
  Vector const weights = 2.0 * density * response.weights.cwiseQuotient(size);
  return num::weighted_gram(response.jacobian, weights);
}

// The degrees of freedom that remain after a fit of p parameters, if neighbouring residuals are correlated.
struct Freedom {
  double share = 1.0;    // 1 - p / n; n is the number of independent samples that tell as much as the whole record
  double degrees = 0.0;  // n - p, the degrees of freedom of Student's t distribution
};
// The fit makes the residuals less correlated than the errors, about by the factor `share`. They therefore seem to be
// worth `seeming` = n / share independent samples instead of n. It follows that n is the larger root of n^2 - seeming n
// + p seeming = 0. The share is taken as at least a half, because the intervals are divided by it: they at most double.
Freedom freedom_left(std::size_t samples, std::size_t fitted, std::vector<double> const& correlation) {
  double total = -1.0;
  for (double const c : correlation) total += 2.0 * c;
  double const seeming = static_cast<double>(samples) / std::max(1.0, total), p = static_cast<double>(fitted);
  double const n = 0.5 * (seeming + std::sqrt(std::max(0.0, seeming * (seeming - 4.0 * p))));
  double const share = std::max(0.5, 1.0 - p / n);
  return {.share = share, .degrees = std::max(2.0, share * n)};
}

// Computes V, the variance of sum(weight * sign of the residual * derivatives). All pairs of samples at the same
// distance get the same correlation of their signs, estimated from the whole record. V cannot be computed from the
// actual signs: the fit makes the sum nearly zero, and if few samples decide on a parameter, V would be zero too.
Matrix variance_of_score(Sensitivity const& response, std::vector<double> const& correlation) {
  Matrix const rows = response.weights.asDiagonal() * response.jacobian;
  Matrix sum = num::transposed_product(rows, rows);
  Vector const size = sum.diagonal().cwiseSqrt().cwiseMax(1e-300);
  for (std::size_t k = 1; k < correlation.size(); ++k) {
    auto const lag = static_cast<Index>(k);
    Matrix const products =
        num::transposed_product(rows.topRows(rows.rows() - lag), rows.bottomRows(rows.rows() - lag));
    sum += correlation[k] * (products + products.transpose());
  }
  // SerialCorrelation reduces the correlations of large lags, so a direction may have a variance below zero. Such a
  // variance is set to zero.
  Matrix const scaled = size.cwiseInverse().asDiagonal() * sum * size.cwiseInverse().asDiagonal();
  auto const eigen = num::symmetric_eigen(scaled);
  Matrix const axes = size.asDiagonal() * eigen.vectors;
  return num::product_of_transposed(axes, eigen.values.cwiseMax(0.0), axes);
}

constexpr double variance_over_box = 1.0 / 12.0;  // variance of a uniform distribution over [0, 1]

// Covariance H^-1 V H^-1 in the unit box. The variance along an eigenvector of H is limited to that of a uniform
// distribution over the box, since no parameter can be less certain than that.
Matrix covariance_in_box(Matrix const& H, Matrix const& V) {
  auto const [values, axes] = num::symmetric_eigen(H);
  double const least = 1e-10 * std::max(values.cwiseAbs().maxCoeff(), 1e-300);
  Matrix half = Matrix::Zero(H.rows(), H.cols());
  Matrix undetermined = Matrix::Zero(H.rows(), H.cols());
  for (Index k = 0; k < values.size(); ++k) {
    auto const axis = axes.col(k);
    double const variance =
        values[k] > least ? axis.dot(num::apply(V, axis)) / (values[k] * values[k]) : variance_over_box;
    if (values[k] <= least || variance > variance_over_box)
      undetermined += variance_over_box * axis * axis.transpose();
    else
      half += axis * axis.transpose() / values[k];
  }
  return undetermined + num::product(num::product(half, V), half);
}

// Weights of one bootstrap replicate. Blocks of samples are drawn until together they have as many samples as the
// record.
std::vector<double> drawn(std::span<double const> weights, std::size_t samples, std::size_t block, num::Draws& draws) {
  std::vector<double> count(samples, 0.0);
  for (std::size_t filled = 0; filled < samples; filled += block) {
    auto const first = draws.below(samples);
    for (std::size_t i = 0; i < std::min(block, samples - filled); ++i) count[(first + i) % samples] += 1.0;
  }
  std::vector<double> redrawn(weights.begin(), weights.end());
  double sum = 0.0;
  for (std::size_t j = 0, next = 0; j < redrawn.size(); ++j)
    if (redrawn[j] > 0.0) sum += redrawn[j] *= count[next++];
  for (double& weight : redrawn) weight /= sum;
  return redrawn;
}

}  // namespace

SerialCorrelation serial_correlation(std::span<double const> series, double mean) {
  std::size_t const n = series.size();
  auto const covariance = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < n; ++i) sum += (series[i] - mean) * (series[i + lag] - mean);
    return sum / static_cast<double>(n);
  };
  SerialCorrelation result;
  double const size = static_cast<double>(n), variance = covariance(0);
  constexpr double rounding = 1e-20;
  if (n < 12 || !(variance > rounding * mean * mean)) return result;
  // Finds `last`, the largest lag with a significant correlation. The search stops after `in_a_row` insignificant lags.
  auto const in_a_row = static_cast<std::size_t>(std::max(5.0, std::sqrt(std::log10(size))));
  auto const most = static_cast<std::size_t>(std::ceil(std::sqrt(size))) + in_a_row;
  double const threshold = 2.0 * std::sqrt(std::log10(size) / size);
  std::size_t quiet = 0, last = 0;
  for (std::size_t lag = 1; lag < std::min(most, n) && quiet < in_a_row; ++lag) {
    bool const correlated = std::abs(covariance(lag) / variance) >= threshold;
    quiet = correlated ? 0 : quiet + 1;
    if (correlated) last = lag;
  }
  if (last == 0) return result;
  std::size_t const reach = std::min(2 * last, n - 1);
  double g = 0.0, total = variance;
  for (std::size_t k = 1; k <= reach; ++k) {
    double const place = static_cast<double>(k) / static_cast<double>(reach);
    double const c = (place <= 0.5 ? 1.0 : 2.0 * (1.0 - place)) * covariance(k);
    g += 2.0 * static_cast<double>(k) * c;
    total += 2.0 * c;
    result.correlation.push_back(c / variance);
  }
  double const d = 4.0 / 3.0 * total * total;
  if (d > 0.0) result.block = std::max(1.0, std::cbrt(2.0 * g * g / d * size));
  return result;
}

std::optional<Intervals> intervals(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                   std::span<double const> optimum, num::Stream const& stream,
                                   IntervalOptions const& options, Interrupted const& interrupted) {
  auto inner = box;  // the search box, but with every parameter that lies at a bound fixed at this bound
  for (std::size_t i = 0; i < box.parameters.size(); ++i) {
    auto& p = inner.parameters[i];
    if (fit::at_bound(p, optimum[i]) == fit::AtBound::no) continue;
    p.free = false;
    p.value = optimum[i];
  }
  auto start = inner.contract(optimum);
  std::size_t const n = start.size();

  Intervals result{.level = options.level};
  fit::IdentificationProblem const problem(model, inner);
  Matrix covariance = Matrix::Zero(static_cast<Index>(n), static_cast<Index>(n));
  for (double const weight : model.residual_weights()) result.samples += weight > 0.0 ? 1 : 0;
  result.block = 1;
  std::vector<std::vector<double>> refits(n);
  double const tail = 0.5 * (1.0 - options.level);
  double const normal_reach = std::numbers::sqrt2 * boost::math::erf_inv(options.level);
  double reach = normal_reach;  // half the length of an interval by linearisation / standard deviation of the estimate
  double widening = 1.0;        // factor by which the intervals of the bootstrap are made longer
  auto const response = n > 0 ? sensitivity(problem, start) : Sensitivity();
  if (n > 0) result.evaluations += static_cast<int>(2 * n + 1);
  if (!response.residuals.allFinite()) {
    start.assign(n, 0.5);  // the law has no finite force at the optimum, so each interval becomes the whole box
    covariance.diagonal().setConstant(variance_over_box);
  } else if (n > 0) {
    Vector const signs = response.residuals.array().sign();
    auto const neighbours = serial_correlation({signs.data(), result.samples}, 0.0);
    result.block = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(neighbours.block)), 1,
                                           std::max<std::size_t>(1, result.samples / 8));
    auto const left = freedom_left(result.samples, n, neighbours.correlation);
    // The fit makes the residuals smaller, which raises H, and less correlated, which lowers V. A single factor on H,
    // left.share, makes up for both, since H enters the covariance twice.
    covariance =
        covariance_in_box(curvature(response) * left.share, variance_of_score(response, neighbours.correlation));
    reach = boost::math::quantile(boost::math::students_t(left.degrees), 1.0 - tail);
    widening = reach / normal_reach / left.share;
    auto const count = static_cast<std::size_t>(std::max(0, options.replicates));
    std::vector<opt::BestPoint> fits(count);
    WorkAhead replicates(count, [&](std::size_t i) {
      num::Draws draws(stream, static_cast<std::uint32_t>(i), 0);
      ReweightedProblem const resampled(problem, drawn(model.residual_weights(), result.samples, result.block, draws));
      fits[i] = opt::descend(resampled, start, 0.3, true);
    });
    for (std::size_t i = 0; i < count; ++i) {
      if (interrupted && interrupted()) return std::nullopt;
      replicates.need(i);
      result.evaluations += fits[i].evaluations;
      if (!fits[i].usable()) continue;
      ++result.replicates;
      for (std::size_t k = 0; k < n; ++k) refits[k].push_back(fits[i].best[k]);
    }
  }

  std::size_t const free_count = box.free_count();
  result.covariance.assign(free_count * free_count, 0.0);
  // For each parameter that is free in `inner`: its index among the free parameters of `box`, and the derivative of its
  // value with respect to its coordinate in the unit box, which turns the covariance of coordinates into that of
  // values.
  std::vector<std::pair<std::size_t, double>> inside;
  std::size_t row = 0;
  for (std::size_t i = 0; i < box.parameters.size(); ++i) {
    auto const& p = box.parameters[i];
    if (!p.free) continue;
    ParameterInterval found{.parameter = i, .linear_lower = optimum[i], .linear_upper = optimum[i]};
    if (!inner.parameters[i].free) {
      if (options.replicates > 0) found.bootstrap_lower = found.bootstrap_upper = optimum[i];
    } else {
      auto const k = inside.size();  // index among the free parameters of `inner`
      double const half = reach * std::sqrt(covariance(static_cast<Index>(k), static_cast<Index>(k)));
      found.linear_lower = p.at(start[k] - half);
      found.linear_upper = p.at(start[k] + half);
      if (refits[k].size() > 1) {
        auto const widened = [&](double quantile_) { return p.at(start[k] + widening * (quantile_ - start[k])); };
        found.bootstrap_lower = widened(quantile(refits[k], tail));
        found.bootstrap_upper = widened(quantile(refits[k], 1.0 - tail));
      }
      inside.emplace_back(row, slope(p, start[k]));
    }
    result.parameters.push_back(found);
    ++row;
  }
  for (std::size_t a = 0; a < inside.size(); ++a)
    for (std::size_t b = 0; b < inside.size(); ++b)
      result.covariance[inside[a].first * free_count + inside[b].first] =
          covariance(static_cast<Index>(a), static_cast<Index>(b)) * inside[a].second * inside[b].second;
  return result;
}

}  // namespace isolaw::analysis
