// The method's descriptive statistics. None leaves a value out: a value that is not finite makes the result not finite.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace isolaw::num {

struct Moments {
  std::size_t count = 0;
  double mean = 0.0;  // NaN when count is 0
  double std = 0.0;   // divides by n - 1; 0 when count is 1, NaN when it is 0
};
Moments moments(std::span<double const> values);
// Standard deviation that divides by n; the objective is relative to it. NaN when there are no values.
double population_std(std::span<double const> values);
// The middle value, or the mean of the two middle ones. NaN when there are no values or one of them is NaN.
double median(std::span<double const> values);
template <class Items, class Property>
double median_over(Items const& items, Property property) {
  std::vector<double> values;
  for (auto const& item : items) values.push_back(std::invoke(property, item));
  return median(values);
}

// The signed distance of each value from the median in standard deviations estimated from the median absolute deviation
// (MAD): (x - median) / max(1.4826 MAD, least_scale * |median|). Outliers move neither median nor MAD. Source: Iglewicz
// and Hoaglin 1993, as 0.6745 (x - median) / MAD; a value beyond outlying_score is an outlier. `least_scale` is the
// relative error of a value, so that nearly equal values are no outliers. All scores are 0 if the divisor is 0.
struct ModifiedScores {
  double median = 0.0;
  std::vector<double> scores;
};
ModifiedScores modified_scores(std::span<double const> values, double least_scale);
inline constexpr double outlying_score = 3.5;

}  // namespace isolaw::num
