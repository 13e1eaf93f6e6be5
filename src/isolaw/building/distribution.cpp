#include "isolaw/building/distribution.hpp"

#include <algorithm>
#include <cmath>
#include "isolaw/num/statistics.hpp"

namespace isolaw::building {
namespace {

// The fractile of `count` values by linear interpolation: share 0 gives the smallest value and share 1 the largest.
// `sorted` holds only the finite values. The other values count as larger than these, so the result is NaN if the
// fractile falls on one of the others.
double fractile(std::vector<double> const& sorted, std::size_t count, double share) {
  if (count == 0) return std::nan("");
  double const place = share * static_cast<double>(count - 1);
  auto const i = static_cast<std::size_t>(place);
  double const part = place - static_cast<double>(i);
  auto const last = part > 0.0 ? i + 1 : i;
  if (last >= sorted.size()) return std::nan("");
  return sorted[i] + part * (sorted[last] - sorted[i]);
}
// Splits the variance of ln(response) over motions and draws into two parts. The motions' part is the variance over the
// motions of the draws' mean. The lot's part is the mean over the motions of the draws' variance.
void split_variance(Distribution& d, std::vector<std::vector<double>> const& draws_by_motion) {
  std::vector<double> means;
  double within = 0.0;
  d.motion_std_ln = d.lot_std_ln = d.lot_share = std::nan("");
  for (auto const& draws : draws_by_motion) {
    std::vector<double> logs;
    for (double const v : draws)
      if (v > 0.0) logs.push_back(std::log(v));
    auto const finite = finite_of(draws).size();
    if (logs.empty() || static_cast<double>(finite) < least_finite_share * static_cast<double>(draws.size())) return;
    auto const moments = num::moments(logs);
    means.push_back(moments.mean);
    within += moments.count > 1 ? moments.std * moments.std : 0.0;
  }
  within /= static_cast<double>(means.size());
  double const between = means.size() > 1 ? std::pow(num::moments(means).std, 2) : 0.0;
  d.motion_std_ln = std::sqrt(between);
  d.lot_std_ln = std::sqrt(within);
  d.lot_share = between + within > 0.0 ? within / (between + within) : 0.0;
}

}  // namespace

std::array<double, 4> fractiles(std::vector<double> values) {
  auto const count = values.size();
  values = finite_of(std::move(values));
  std::ranges::sort(values);
  std::array<double, 4> at_shares{};
  for (std::size_t i = 0; i < at_shares.size(); ++i) at_shares[i] = fractile(values, count, shares[i]);
  return at_shares;
}

CasePlaces::CasePlaces(Settings const& settings) : cases(cases_of(settings)) {
  auto const first = [&](CaseKind kind) {
    return static_cast<std::size_t>(std::ranges::find(cases, kind, &Case::kind) - cases.begin());
  };
  first_draw = first(CaseKind::draw);
  draws = static_cast<std::size_t>(settings.draws);
  first_uncertain = first(CaseKind::uncertain);
  first_factor = first(CaseKind::factor);
}

Responses responses_of(std::vector<std::vector<std::vector<double>>> const& kept, std::size_t quantity) {
  Responses responses;
  for (auto const& motion : kept) {
    auto& row = responses.by_motion.emplace_back(motion[quantity]);
    responses.mean.resize(row.size());
    for (std::size_t c = 0; c < row.size(); ++c) responses.mean[c] += row[c] / static_cast<double>(kept.size());
  }
  return responses;
}

std::vector<double> part_of(std::vector<double> const& values, std::size_t first, std::size_t count) {
  auto const begin = values.begin() + static_cast<std::ptrdiff_t>(first);
  return {begin, begin + static_cast<std::ptrdiff_t>(count)};
}

std::vector<double> finite_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return values;
}

Distribution distribution_of(Responses const& responses, CasePlaces const& places, Settings const& settings) {
  auto const draws = part_of(responses.mean, places.first_draw, places.draws);
  Distribution d{.nominal = responses.mean[0],
                 .lower = responses.mean[1],
                 .upper = responses.mean[2],
                 .fractiles = fractiles(draws),
                 .uncertain_std_ln = {},
                 .by_motion = {},
                 .nominal_by_motion = {},
                 .histogram = histogram(finite_of(draws))};
  std::vector<std::vector<double>> draws_by_motion;
  for (auto const& row : responses.by_motion) {
    d.by_motion.push_back(fractiles(draws_by_motion.emplace_back(part_of(row, places.first_draw, places.draws))));
    d.nominal_by_motion.push_back(row[0]);
  }
  split_variance(d, draws_by_motion);
  if (settings.populations > 1) {
    auto const each = static_cast<std::size_t>(settings.draws_of_each);
    std::vector<double> medians;
    for (std::size_t p = 0; p < static_cast<std::size_t>(settings.populations); ++p)
      medians.push_back(fractiles(part_of(responses.mean, places.first_uncertain + p * each, each))[1]);
    d.uncertain_std_ln = spread_ln(medians);
  }
  return d;
}

double spread_ln(std::vector<double> const& values) {
  std::vector<double> logs;
  for (double const v : values) logs.push_back(v > 0.0 ? std::log(v) : std::nan(""));
  if (logs.size() < 2 || finite_of(logs).size() < logs.size()) return std::nan("");
  return num::moments(logs).std;
}

// Rice's rule gives the number of bins: 2 n^(1/3) for n values.
Histogram histogram(std::vector<double> const& values) {
  Histogram histogram;
  if (values.empty()) return histogram;
  auto const [least, most] = std::ranges::minmax(values);
  bool const spread = most - least > 1e-9 * std::abs(most);
  auto const bins =
      spread ? static_cast<std::size_t>(std::ceil(2.0 * std::cbrt(static_cast<double>(values.size())))) : 1;
  histogram.width = spread ? (most - least) / static_cast<double>(bins) : 1e-3 * std::abs(most);
  histogram.from = spread ? least : least - 0.5 * histogram.width;
  histogram.counts.assign(bins, 0);
  for (double const v : values)
    ++histogram.counts[spread ? std::min(bins - 1, static_cast<std::size_t>((v - least) / histogram.width)) : 0];
  return histogram;
}

}  // namespace isolaw::building
