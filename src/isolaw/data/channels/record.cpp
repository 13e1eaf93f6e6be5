#include "isolaw/data/channels/record.hpp"

#include <algorithm>
#include <cmath>

namespace isolaw::data {

double FitRecord::largest_scored(std::vector<double> const& values) const {
  double largest = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_scored(i)) largest = std::max(largest, std::abs(values[i]));
  return largest;
}

}  // namespace isolaw::data
