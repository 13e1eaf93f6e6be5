#include "isolaw/analysis/intervals.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "isolaw/analysis/sensitivity.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::analysis {
namespace {

using Eigen::Index;

// The quantile of the standard normal distribution with probability (1 + level) / 2 below it.
double normal_quantile(double level) {
  double low = 0.0, high = 10.0;
  for (int i = 0; i < 60; ++i) {
    double const middle = 0.5 * (low + high);
    (std::erf(middle / std::numbers::sqrt2) < level ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double quantile(std::vector<double> sorted, double probability) {
  std::ranges::sort(sorted);
  double const at = probability * static_cast<double>(sorted.size() - 1);
  auto const below = static_cast<std::size_t>(at);
  auto const above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], at - static_cast<double>(below));
}

// Weighted sum of outer products of the Jacobian's rows, each counted by a Gaussian kernel of its residual.
Eigen::MatrixXd curvature(Sensitivity const& seen) {
  auto const& r = seen.residuals;
  double const n = static_cast<double>(r.size());
  std::vector<double> sizes(static_cast<std::size_t>(r.size()));
  for (Index i = 0; i < r.size(); ++i) sizes[static_cast<std::size_t>(i)] = std::abs(r[i]);
  // Half of a normal distribution lies within 0.6745 standard deviations.
  double const spread = std::min(quantile(sizes, 0.5) / 0.6745, std::sqrt(r.squaredNorm() / n));
  double const width = 1.06 * spread * std::pow(n, -0.2);
  if (!(width > 0.0)) return Eigen::MatrixXd::Zero(seen.jacobian.cols(), seen.jacobian.cols());
  Eigen::ArrayXd const kernel =
      (-0.5 * (r.array() / width).square()).exp() / (width * std::sqrt(2.0 * std::numbers::pi));
  Eigen::VectorXd const counted = 2.0 * seen.weights.array() * kernel;
  return seen.jacobian.transpose() * counted.asDiagonal() * seen.jacobian;
}

Eigen::MatrixXd scores(Sensitivity const& seen) {
  Eigen::VectorXd const signs = seen.weights.array() * seen.residuals.array().sign();
  return signs.asDiagonal() * seen.jacobian;
}

// The variance of the sum of the rows: over all blocks of neighbours, the last followed by the first.
Eigen::MatrixXd variance_of_sum(Eigen::MatrixXd const& rows, std::size_t block) {
  Index const n = rows.rows(), length = static_cast<Index>(block);
  Eigen::MatrixXd const centred = rows.rowwise() - rows.colwise().mean();
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(rows.cols());
  for (Index i = 0; i < length; ++i) sum += centred.row(i);
  Eigen::MatrixXd total = Eigen::MatrixXd::Zero(rows.cols(), rows.cols());
  for (Index i = 0; i < n; ++i) {
    total += sum.transpose() * sum;
    sum += centred.row((i + length) % n) - centred.row(i);
  }
  return total / static_cast<double>(length);
}

// H^-1 V H^-1 in coordinates of the unit box. A direction in which a standard deviation would exceed that of a uniform
// distribution over the box is as uncertain as that.
Eigen::MatrixXd covariance_in_box(Eigen::MatrixXd const& H, Eigen::MatrixXd const& V) {
  constexpr double uniform = 1.0 / 12.0;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> const eigen(H);
  auto const& values = eigen.eigenvalues();
  auto const& axes = eigen.eigenvectors();
  double const least = 1e-10 * std::max(values.cwiseAbs().maxCoeff(), 1e-300);
  Eigen::MatrixXd half = Eigen::MatrixXd::Zero(H.rows(), H.cols());
  Eigen::MatrixXd made = Eigen::MatrixXd::Zero(H.rows(), H.cols());
  for (Index k = 0; k < values.size(); ++k) {
    auto const axis = axes.col(k);
    double const variance = values[k] > least ? axis.dot(V * axis) / (values[k] * values[k]) : uniform;
    if (values[k] <= least || variance > uniform)
      made += uniform * axis * axis.transpose();
    else
      half += axis * axis.transpose() / values[k];
  }
  return made + half * V * half;
}

std::size_t block_of(Eigen::MatrixXd const& score, std::size_t samples) {
  double longest = 1.0;
  std::vector<double> series(samples);
  for (Index k = 0; k < score.cols(); ++k) {
    for (std::size_t i = 0; i < samples; ++i) series[i] = score(static_cast<Index>(i), k);
    longest = std::max(longest, block_length(series));
  }
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(longest)), 1, std::max<std::size_t>(1, samples / 8));
}

// Weights of a replicate: blocks of scored samples, drawn until they are as many as the samples.
std::vector<double> drawn(std::span<double const> weights, std::size_t samples, std::size_t block, num::Draws& draws) {
  std::vector<double> count(samples, 0.0);
  for (std::size_t filled = 0; filled < samples; filled += block) {
    auto const first = draws.below(samples);
    for (std::size_t i = 0; i < std::min(block, samples - filled); ++i) count[(first + i) % samples] += 1.0;
  }
  std::vector<double> made(weights.begin(), weights.end());
  double sum = 0.0;
  for (std::size_t j = 0, next = 0; j < made.size(); ++j)
    if (made[j] > 0.0) sum += made[j] *= count[next++];
  for (double& weight : made) weight /= sum;
  return made;
}

}  // namespace

double block_length(std::span<double const> series) {
  std::size_t const n = series.size();
  if (n < 12) return 1.0;
  double mean = 0.0;
  for (double const value : series) mean += value / static_cast<double>(n);
  auto const covariance = [&](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = 0; i + lag < n; ++i) sum += (series[i] - mean) * (series[i + lag] - mean);
    return sum / static_cast<double>(n);
  };
  double const size = static_cast<double>(n), variance = covariance(0);
  if (!(variance > 0.0)) return 1.0;
  // The lag from which on the correlation is no more than that of independent values, for a few lags in a row.
  auto const in_a_row = static_cast<std::size_t>(std::max(5.0, std::sqrt(std::log10(size))));
  auto const most = static_cast<std::size_t>(std::ceil(std::sqrt(size))) + in_a_row;
  double const threshold = 2.0 * std::sqrt(std::log10(size) / size);
  std::size_t quiet = 0, lag = 1, last = 0;
  for (; lag < std::min(most, n) && quiet < in_a_row; ++lag) {
    bool const correlated = std::abs(covariance(lag) / variance) >= threshold;
    quiet = correlated ? 0 : quiet + 1;
    if (correlated) last = lag;
  }
  std::size_t const reach = std::min(2 * std::max<std::size_t>(last, 1), n - 1);
  double g = 0.0, total = variance;
  for (std::size_t k = 1; k <= reach; ++k) {
    double const place = static_cast<double>(k) / static_cast<double>(reach);
    double const window = place <= 0.5 ? 1.0 : 2.0 * (1.0 - place);
    double const c = covariance(k);
    g += 2.0 * window * static_cast<double>(k) * c;
    total += 2.0 * window * c;
  }
  double const d = 4.0 / 3.0 * total * total;
  if (last == 0 || !(d > 0.0)) return 1.0;
  return std::max(1.0, std::cbrt(2.0 * g * g / d * size));
}

std::optional<Intervals> intervals(fit::LawOnRecord const& model, fit::SearchBox const& box,
                                   std::span<double const> optimum, num::Stream const& stream,
                                   IntervalOptions const& options, Interrupted const& interrupted) {
  // Parameters at a bound are held: a box in which they are not free.
  auto inner = box;
  std::vector<bool> held(box.parameters.size(), false);
  for (std::size_t i = 0; i < box.parameters.size(); ++i) {
    auto& p = inner.parameters[i];
    if (fit::at_bound(p, optimum[i]) == fit::AtBound::no) continue;
    held[i] = true;
    p.free = false;
    p.value = optimum[i];
  }
  auto const start = inner.contract(optimum);
  std::size_t const n = start.size();

  Intervals made{.level = options.level};
  auto const place = [&](std::size_t i) {  // of a parameter among those of `inner`
    return static_cast<std::size_t>(std::ranges::count_if(
        std::span(inner.parameters).first(i), [](auto const& p) { return p.free; }));
  };
  fit::IdentificationProblem const problem(model, inner);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(static_cast<Index>(n), static_cast<Index>(n));
  for (double const weight : model.residual_weights()) made.samples += weight > 0.0 ? 1 : 0;
  made.block = 1;
  std::vector<std::vector<double>> refits(n);
  if (n > 0) {
    auto const seen = sensitivity(problem, start);
    made.evaluations += static_cast<int>(2 * n + 1);
    auto const score = scores(seen);
    made.block = block_of(score, made.samples);
    covariance = covariance_in_box(curvature(seen), variance_of_sum(score, made.block));
    for (int replicate = 0; replicate < options.replicates; ++replicate) {
      if (interrupted && interrupted()) return std::nullopt;
      num::Draws draws(stream, static_cast<std::uint32_t>(replicate), 0);
      Reweighted const resampled(problem, drawn(model.residual_weights(), made.samples, made.block, draws));
      auto const again = opt::descend(resampled, start, 0.3);
      made.evaluations += again.evaluations;
      if (!again.usable()) continue;
      ++made.replicates;
      for (std::size_t k = 0; k < n; ++k) refits[k].push_back(again.best[k]);
    }
  }

  double const z = normal_quantile(options.level), tail = 0.5 * (1.0 - options.level);
  std::size_t const free_count = box.free_count();
  made.covariance.assign(free_count * free_count, 0.0);
  std::vector<std::pair<std::size_t, double>> inside;  // place among the free ones of `box`, d value / d coordinate
  std::size_t row = 0;
  for (std::size_t i = 0; i < box.parameters.size(); ++i) {
    auto const& p = box.parameters[i];
    if (!p.free) continue;
    ParameterInterval found{.parameter = i, .linear_lower = optimum[i], .linear_upper = optimum[i]};
    if (held[i]) {
      found.bootstrap_lower = found.bootstrap_upper = optimum[i];
      if (options.replicates == 0) found.bootstrap_lower = found.bootstrap_upper = std::nullopt;
    } else {
      auto const k = place(i);
      double const reach = z * std::sqrt(covariance(static_cast<Index>(k), static_cast<Index>(k)));
      found.linear_lower = p.at(start[k] - reach);
      found.linear_upper = p.at(start[k] + reach);
      if (refits[k].size() > 1) {
        found.bootstrap_lower = p.at(quantile(refits[k], tail));
        found.bootstrap_upper = p.at(quantile(refits[k], 1.0 - tail));
      }
      inside.emplace_back(row, slope(p, start[k]));
    }
    made.parameters.push_back(found);
    ++row;
  }
  for (std::size_t a = 0; a < inside.size(); ++a)
    for (std::size_t b = 0; b < inside.size(); ++b)
      made.covariance[inside[a].first * free_count + inside[b].first] =
          covariance(static_cast<Index>(a), static_cast<Index>(b)) * inside[a].second * inside[b].second;
  return made;
}

}  // namespace isolaw::analysis
