#include "isolaw/num/tolerance_factor.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace isolaw::num {
namespace {

double normal_share(double from, double to) {
  return 0.5 * (std::erf(to / std::numbers::sqrt2) - std::erf(from / std::numbers::sqrt2));
}

template <class Function>
double root(Function&& function, double lower, double upper) {
  std::uintmax_t iterations = 200;
  auto const [from, to] = boost::math::tools::toms748_solve(function, lower, upper,
                                                            boost::math::tools::eps_tolerance<double>(48), iterations);
  return 0.5 * (from + to);
}

// Half the width of the interval around `centre` that contains the share `coverage` of a standard normal distribution.
double half_width(double centre, double coverage) {
  return root([&](double r) { return normal_share(centre - r, centre + r) - coverage; }, 0.0, std::abs(centre) + 40.0);
}

// Probability that k times the sample's standard deviation is at least `half`, for a standard normal population.
double spread_is_enough(double freedom, double half, double k) {
  double const ratio = half / k;
  return boost::math::gamma_q(0.5 * freedom, 0.5 * freedom * ratio * ratio);
}

}  // namespace

double tolerance_factor(std::size_t count, double coverage, double confidence) {
  if (count < 2) return std::numeric_limits<double>::quiet_NaN();
  auto const n = static_cast<double>(count);
  // The integral over the sample's mean ends at nine of its standard deviations. The rest is below the rounding error.
  double const end = 9.0 / std::sqrt(n);
  auto const reached = [&](double k) {
    auto const integrand = [&](double mean) {
      return std::exp(-0.5 * n * mean * mean) * spread_is_enough(n - 1.0, half_width(mean, coverage), k);
    };
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
    return 2.0 * std::sqrt(0.5 * n / std::numbers::pi) * Quadrature::integrate(integrand, 0.0, end, 4, 1e-11);
  };
  double upper = 2.0;
  while (reached(upper) < confidence) upper *= 2.0;
  return root([&](double k) { return reached(k) - confidence; }, 1e-3, upper);
}

}  // namespace isolaw::num
