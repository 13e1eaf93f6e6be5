// Descriptive statistics as the method uses them. A value that is not finite makes the result not finite; nothing is
// left out silently.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace isolaw::num {

struct Moments {
  std::size_t count = 0;
  double mean = 0.0;  // NaN when count is 0
  double std = 0.0;   // sample form (n - 1); 0 when count is 1, NaN when 0
};

// Two-pass, so that a small spread about a large mean keeps its digits.
Moments moments(std::span<double const> values);

// Divides by n; used by the objective's normalisation. NaN when there are no values.
double population_std(std::span<double const> values);

// The middle value, the mean of the two middle ones for an even count. NaN when there are no values, or one is NaN.
double median(std::span<double const> values);
template <class Items, class Property>
double median_over(Items const& items, Property property) {
  std::vector<double> values;
  for (auto const& item : items) values.push_back(std::invoke(property, item));
  return median(values);
}

// Distance of each value from the median in standard deviations estimated from the median absolute deviation, signed:
// (x - median) / max(1.4826 MAD, least_scale * |median|) (Iglewicz and Hoaglin 1993, where it is 0.6745 (x - median) /
// MAD; an outlier is one beyond outlying_score). Neither is moved by the outliers themselves. `least_scale`, the
// relative error of a value, keeps nearly equal values from naming one another. All 0 where there is no scale.
struct ModifiedScores {
  double median = 0.0;
  std::vector<double> scores;
};
ModifiedScores modified_scores(std::span<double const> values, double least_scale);
inline constexpr double outlying_score = 3.5;

}  // namespace isolaw::num
