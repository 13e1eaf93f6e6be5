// Devices that do not belong to their lot, each with the property that sets it apart: measured properties, a law's
// parameters, errors of its fit.
//
// The rules' lot view names outliers among measured properties by the same score (num::modified_scores) in a text of
// its own; it asks for five values, since a verdict hangs on them.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace isolaw::lot {

struct Outlier {
  std::size_t device = 0, property = 0;  // index into the values
  double value = 0.0;
  double median = 0.0;   // over the devices that have the property
  double score = 0.0;    // modified z, negative below the median
  double percent = 0.0;  // difference from the median, 100 (value - median) / |median|; infinite for a median of zero
};

// Below this many values the median absolute deviation is no measure of scatter.
inline constexpr std::size_t fewest_for_outliers = 4;
// The least standard deviation, as a share of |median|: the error of a property from one record.
inline constexpr double least_scatter = 0.005;

// values[property][device], NaN where a device lacks the property; names[property] for messages alone. An outlier has a
// modified z-score beyond 3.5 (Iglewicz and Hoaglin 1993) among the devices that have the property, at least
// fewest_for_outliers of them. Largest score first; equal scores in the order of properties, then devices.
// Throws Error for properties without a name, rows of different lengths and infinite values.
std::vector<Outlier> find_outliers(std::span<std::string const> names, std::span<std::vector<double> const> values);

}  // namespace isolaw::lot
