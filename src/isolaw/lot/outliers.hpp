// Finds devices that differ from their lot in a measured property, a parameter of a law or an error of its fit.
// Source of the score: Iglewicz and Hoaglin 1993. The rules' lot view uses the same score (num::modified_scores) for
// measured properties, but asks for at least five values, since a verdict depends on them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace isolaw::lot {

struct Outlier {
  std::size_t device = 0, property = 0;  // indices into `values`
  double value = 0.0;
  double median = 0.0;   // over the devices that have the property
  double score = 0.0;    // modified z-score, negative below the median
  double percent = 0.0;  // 100 (value - median) / |median|; infinite for a median of zero
};

// With fewer values the median absolute deviation is no measure of scatter.
inline constexpr std::size_t fewest_for_outliers = 4;
// The smallest standard deviation, as a share of |median|: the error of a property from one record.
inline constexpr double least_scatter = 0.005;
// values[property][device] is NaN if the device lacks the property; messages use names[property]. A device is an
// outlier if its modified z-score is beyond 3.5 among the devices that have the property, at least fewest_for_outliers.
// Largest score first, equal scores by property, then device. Throws Error if there are not as many names as
// properties, for rows of different lengths, and for infinite values.
std::vector<Outlier> find_outliers(std::span<std::string const> names, std::span<std::vector<double> const> values);

}  // namespace isolaw::lot
