#include "isolaw/conditions/curves.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <vector>

namespace isolaw::conditions {
namespace {

struct Line {
  double start = 0.0, slope = 0.0, residual = 0.0;  // y = start + slope x; `residual` is the sum of squared errors
};
Line line_through(std::span<double const> x, std::span<double const> y) {
  double const n = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
  }
  Line line{.slope = xy / xx};
  line.start = mean_y - line.slope * mean_x;
  for (std::size_t i = 0; i < x.size(); ++i) line.residual += std::pow(y[i] - line.start - line.slope * x[i], 2.0);
  return line;
}

Level const* reference_of(Response const& response) {
  for (auto const& level : response.levels())
    if (level.reference) return &level;
  return nullptr;
}

}  // namespace

std::optional<double> exponent(Response const& response) {
  bool const over_frequency = response.effect() == Effect::rate;
  auto const* reference = reference_of(response);
  if ((response.effect() != Effect::temperature && !over_frequency) || reference == nullptr) return std::nullopt;
  double xx = 0.0, xy = 0.0;
  for (auto const& level : response.levels()) {
    if (level.reference || level.unpaired_factor) continue;
    double const x = over_frequency ? std::log(level.at / reference->at) : level.at - reference->at;
    xx += x * x, xy += x * level.mean();
  }
  return xx > 0.0 ? std::optional(xy / xx) : std::nullopt;
}

double LoadCurve::at(double load_kN) const {
  return unloaded * (1.0 - std::pow(load_kN / critical_kN, 2.0));
}

std::optional<LoadCurve> load_curve(Response const& load) {
  std::vector<double> squares, factors;
  for (auto const& level : load.levels()) {
    if (level.unpaired_factor) continue;
    squares.push_back(level.at * level.at);
    factors.push_back(std::exp(level.mean()));
  }
  if (squares.size() < 2) return std::nullopt;
  auto const line = line_through(squares, factors);
  if (!(line.slope < 0.0 && line.start > 0.0)) return std::nullopt;
  return LoadCurve{.unloaded = line.start, .critical_kN = std::sqrt(-line.start / line.slope)};
}

double Softening::at(double cycle) const {
  return last + (first - last) * std::pow(cycle, -p);
}

std::optional<Softening> softening(std::span<double const> values) {
  if (values.size() < fewest_cycles) return std::nullopt;
  std::vector<double> x(values.size());
  auto const line_at = [&](double p) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::pow(static_cast<double>(i + 1), -p);
    return line_through(x, values);
  };
  constexpr double least_p = 0.2, most_p = 3.0;
  constexpr int bits = std::numeric_limits<double>::digits / 2;  // rounding blurs a minimum beyond half of the digits
  auto const [p, residual] = boost::math::tools::brent_find_minima(
      [&](double power) { return line_at(power).residual; }, least_p, most_p, bits);
  auto const line = line_at(p);
  return Softening{.first = line.start + line.slope, .last = line.start, .p = p};
}

}  // namespace isolaw::conditions
