// Descriptive statistics. A NaN makes means, standard deviations and medians NaN; only modified_scores() leaves it out.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace isolaw::num {

struct Moments {
  std::size_t count = 0;
  double mean = 0.0;  // NaN when count is 0
  double std = 0.0;   // standard deviation with divisor count - 1; 0 when count is 1, NaN when count is 0
};
Moments moments(std::span<double const> values);
// Standard deviation with divisor n, as in the objective of a fit. NaN when there are no values.
double population_std(std::span<double const> values);
// The middle value, or the mean of the two middle ones. NaN when there are no values or one of them is NaN.
double median(std::span<double const> values);
// Quantile 0.975 of Student's t, which bounds a two-sided interval of 95 %. `freedom` need not be whole.
double student_97_5(double freedom);
template <class Items, class Property>
double median_over(Items const& items, Property property) {
  std::vector<double> values;
  for (auto const& item : items) values.push_back(std::invoke(property, item));
  return median(values);
}

// Modified z-scores: (x - median) / max(1.4826 MAD, least_scale * |median|), where 1.4826 MAD (median absolute
// deviation) estimates the standard deviation. A few outliers hardly move the median and the MAD. Source: Iglewicz and
// Hoaglin 1993, who call a value an outlier if its score is beyond +-outlying_score. `least_scale` is the relative
// error of a value: it keeps nearly equal values from being outliers. If the divisor is 0, all scores are 0. The score
// of a NaN is NaN, and a NaN has no influence on other scores.
struct ModifiedScores {
  double median = 0.0;
  std::vector<double> scores;
};
ModifiedScores modified_scores(std::span<double const> values, double least_scale);
inline constexpr double outlying_score = 3.5;
// The smallest number of values among which outliers are sought: the median absolute deviation of fewer values says
// little about how much they scatter.
inline constexpr std::size_t fewest_for_outliers = 4;

}  // namespace isolaw::num
