#include "isolaw/building/coverage.hpp"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <cstdint>
#include "isolaw/wording/table.hpp"

namespace isolaw::building {

Coverage coverage_of(Quantity const& quantity, std::vector<double> const& draws, Distribution const& d,
                     std::vector<double> const& grid) {
  auto const [least, most] = std::minmax(d.lower, d.upper);
  Coverage coverage{.quantity = quantity.key, .factor_low = {}, .factor_high = {}};
  // The nominal response may lie outside the range of the two bounds by this fraction, because responses that should be
  // equal differ by rounding.
  constexpr double rounding = 1e-9;
  bool const known = std::isfinite(d.lower) && std::isfinite(d.upper);
  if (known && (d.nominal < least - rounding * std::abs(least) || d.nominal > most + rounding * std::abs(most))) {
    coverage.monotony = Finding{.kind = FindingKind::bounds_not_monotonic,
                                .numbers = {{"lower", d.lower}, {"nominal", d.nominal}, {"upper", d.upper}},
                                .words = {{"quantity", std::string(quantity.title)},
                                          {"unit", quantity.unit == "-" ? "" : std::string(quantity.unit)},
                                          {"side", d.nominal < least ? "above" : "below"}}};
    coverage.not_monotonic = wording::remark(*coverage.monotony);
  }
  std::size_t inside = 0, below = 0;
  for (double const v : draws) {
    inside += v >= least && v <= most;
    below += v < least;
  }
  auto const n = static_cast<double>(draws.size());
  if (draws.empty()) return coverage;
  coverage.share_inside = static_cast<double>(inside) / n;
  coverage.share_below = static_cast<double>(below) / n;
  coverage.share_above = static_cast<double>(draws.size() - inside - below) / n;
  auto const interval = binomial_interval(inside, draws.size());
  coverage.interval_low = interval[0], coverage.interval_high = interval[1];
  double low = grid[grid_half], high = low;
  for (std::uint32_t a = 0; a <= grid_half; ++a) {
    for (double const v : {grid[grid_half - a], grid[grid_half + a]}) low = std::min(low, v), high = std::max(high, v);
    auto const within = std::ranges::count_if(draws, [&](double v) { return v >= low && v <= high; });
    if (static_cast<double>(within) < wanted_share * n) continue;
    coverage.factor_low = grid_factor(grid_half - a);
    coverage.factor_high = grid_factor(grid_half + a);
    break;
  }
  return coverage;
}

Finding covering_factors(Coverage const& coverage) {
  Finding finding{.kind = FindingKind::covering_factors,
                  .numbers = {{"wanted", wanted_share},
                              {"grid_low", grid_factor(0)},
                              {"grid_high", grid_factor(2 * grid_half)},
                              {"grid_step", grid_step}}};
  constexpr double rounding = 1e-9;
  bool const near = coverage.factor_low && *coverage.factor_low > 1.0 - grid_step - rounding;
  finding.words = {{"factors", !coverage.factor_low ? "none" : near ? "near" : "found"}};
  if (coverage.factor_low) finding.numbers.push_back({"factor_low", *coverage.factor_low});
  if (coverage.factor_high) finding.numbers.push_back({"factor_high", *coverage.factor_high});
  return finding;
}

namespace {

using Binomial = boost::math::binomial_distribution<>;

// The lower end of the confidence interval of the share found / trials. `found` need not be a whole number.
double lower_end(double found, double trials, double level) {
  return found > 0.0 ? Binomial::find_lower_bound_on_p(trials, found, 0.5 * (1.0 - level)) : 0.0;
}

}  // namespace

std::array<double, 2> binomial_interval(std::size_t found, std::size_t trials, double level) {
  if (trials == 0) return {0.0, 1.0};
  auto const n = static_cast<double>(trials), k = static_cast<double>(found);
  return {lower_end(k, n, level), found == trials ? 1.0 : Binomial::find_upper_bound_on_p(n, k, 0.5 * (1.0 - level))};
}

std::optional<std::size_t> draws_that_tell(std::size_t found, std::size_t trials) {
  constexpr std::size_t most = 100'000;
  auto const tells = [&](std::size_t draws) {
    auto const n = static_cast<double>(draws), share = static_cast<double>(found) / static_cast<double>(trials);
    return lower_end(share * n, n, 0.95) >= wanted_share;
  };
  if (trials == 0 || !tells(most)) return {};
  std::size_t low = 1, high = most;
  while (low < high) {
    auto const middle = low + (high - low) / 2;
    tells(middle) ? high = middle : low = middle + 1;
  }
  return high;
}

}  // namespace isolaw::building
