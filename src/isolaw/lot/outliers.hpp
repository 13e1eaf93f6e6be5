// Finds devices that differ from the other devices of their lot in a property: a measured value, a law's parameter or
// the error of a fit. Source: the modified z-score of Iglewicz and Hoaglin 1993 (num::modified_scores). Rule sets use
// this score for measured properties too, but ask for at least five values, since the score of fewer says little.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace isolaw::lot {

struct Outlier {
  std::size_t device = 0, property = 0;  // `value` is values[property][device] of find_outliers()
  double value = 0.0;
  double median = 0.0;   // median of this property over all devices that have it
  double score = 0.0;    // modified z-score; negative if the value is below the median
  double percent = 0.0;  // 100 (value - median) / |median|; infinite if the median is zero
};

// The smallest standard deviation that the score uses, as a share of |median|: one record does not determine a property
// more exactly than that.
inline constexpr double least_scatter = 0.005;
// values[property][device] is NaN if the device does not have the property. A device is an outlier if the size of its
// modified z-score exceeds 3.5 and at least num::fewest_for_outliers devices have the property. The largest scores come
// first, equal scores in the order of properties and devices. Messages use names[property]. Throws Error if there are
// not as many names as properties, if rows differ in length, and for infinite values.
std::vector<Outlier> find_outliers(std::span<std::string const> names, std::span<std::vector<double> const> values);

}  // namespace isolaw::lot
