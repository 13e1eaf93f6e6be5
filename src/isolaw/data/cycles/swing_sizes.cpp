#include "isolaw/data/cycles/swing_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isolaw::data {
namespace {

constexpr double least_share = 0.05;
constexpr std::size_t fewest_large = 2, fewest_small = 4;

std::span<double const> time_of(FitRecord const& record) {
  return record.has_time() ? std::span<double const>(record.time_s) : std::span<double const>();
}

double larger_turn(FitRecord const& record, Swing const& swing) {
  return std::max(std::abs(record.disp_mm[swing.first]), std::abs(record.disp_mm[swing.last]));
}

}  // namespace

std::vector<Swing> scored_swings(FitRecord const& record) {
  auto found = swings(record.disp_mm, time_of(record));
  std::erase_if(found, [&](Swing const& swing) {
    for (auto i = swing.first; i <= swing.last; ++i)
      if (!record.is_scored(i)) return true;
    return false;
  });
  return found;
}

SwingSizes swing_sizes(std::span<FitRecord const> tests, Weighting weighting) {
  std::vector<std::vector<Swing>> swings_of;
  double largest = 0.0;
  for (auto const& record : tests)
    for (auto const& swing : swings_of.emplace_back(scored_swings(record)))
      largest = std::max(largest, larger_turn(record, swing));
  SwingSizes sizes;
  std::size_t small = 0, large = 0;
  double small_share = 0.0, large_share = 0.0;
  for (std::size_t t = 0; t < tests.size(); ++t) {
    auto const& record = tests[t];
    auto const is_small = [&](Swing const& swing) { return larger_turn(record, swing) <= small_swing * largest; };
    auto const first_large = std::stable_partition(swings_of[t].begin(), swings_of[t].end(), is_small);
    auto const count_small = static_cast<std::size_t>(first_large - swings_of[t].begin());
    std::span<Swing const> const swings = swings_of[t];
    auto const weights_of = [&](std::span<Swing const> some) {
      return weights_within(some, record.disp_mm, time_of(record),
                            record.weights.empty() ? Weighting::time : weighting);
    };
    SwingSizes::Test test{.small = weights_of(swings.first(count_small)),
                          .large = weights_of(swings.subspan(count_small))};
    auto const total = [](std::vector<double> const& w) { return std::accumulate(w.begin(), w.end(), 0.0); };
    double const both = total(test.small) + total(test.large);
    double const share = both > 0.0 ? total(test.large) / both : 0.0;
    if (!(share >= least_share)) test.large.clear();
    if (!(both > 0.0 && 1.0 - share >= least_share)) test.small.clear();
    small += count_small;
    large += swings.size() - count_small;
    large_share += share / static_cast<double>(tests.size());
    if (both > 0.0) small_share += (1.0 - share) / static_cast<double>(tests.size());
    sizes.tests.push_back(std::move(test));
  }
  sizes.shows_larger_swings =
      large >= fewest_large && small >= fewest_small && large_share >= least_share && small_share >= least_share;
  return sizes;
}

}  // namespace isolaw::data
