#include "isolaw/data/signals/smoothing.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <numeric>

namespace isolaw::data {
namespace {

// The sums of the first 0, 1, 2, ... values. Also stores each sum's rounding error, so that differences stay exact
// after a million samples.
class PrefixSums {
 public:
  explicit PrefixSums(std::vector<double> const& values) : sum_(values.size() + 1), lost_(values.size() + 1) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      double const next = sum_[i] + values[i];
      double const part = next - sum_[i];
      lost_[i + 1] = lost_[i] + ((sum_[i] - (next - part)) + (values[i] - part));
      sum_[i + 1] = next;
    }
  }
  double between(std::size_t first, std::size_t end) const {
    return (sum_[end] - sum_[first]) + (lost_[end] - lost_[first]);
  }

 private:
  std::vector<double> sum_;
  std::vector<double> lost_;
};

}  // namespace

std::vector<double> moving_average(std::vector<double> const& values, int window) {
  assert(window >= 1 && window % 2 == 1);
  if (window <= 1 || values.size() < 3) return values;
  auto const half = static_cast<std::size_t>(window / 2);
  PrefixSums const sums(values);
  std::vector<double> averages(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    auto const reach = std::min({half, i, values.size() - 1 - i});
    averages[i] = sums.between(i - reach, i + reach + 1) / static_cast<double>(2 * reach + 1);
  }
  return averages;
}

std::vector<double> central_difference(std::vector<double> const& time_s, std::vector<double> const& values) {
  assert(time_s.size() == values.size());
  auto const size = values.size();
  if (size < 2) return std::vector<double>(size, 0.0);
  auto const interval = [&](std::size_t i) { return time_s[i + 1] - time_s[i]; };
  auto const slope = [&](std::size_t i) { return (values[i + 1] - values[i]) / interval(i); };
  if (size == 2) return {slope(0), slope(0)};
  auto const central = [&](std::size_t i) {
    double const before = interval(i - 1);
    double const after = interval(i);
    return (before * slope(i) + after * slope(i - 1)) / (before + after);
  };
  // The rate at each end follows from the next rate: the slope of a parabola's chord is the mean of its slopes at the
  // ends.
  std::vector<double> rate;
  rate.reserve(size);
  rate.push_back(2.0 * slope(0) - central(1));
  for (std::size_t i = 1; i + 1 < size; ++i) rate.push_back(central(i));
  rate.push_back(2.0 * slope(size - 2) - central(size - 2));
  return rate;
}

}  // namespace isolaw::data
