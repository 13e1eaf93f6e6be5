#include "isolaw/lot/robustness.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "isolaw/base/words.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::lot {
namespace {

// A mean counts as 0 if it is at most this fraction of the largest |value|. Rounding errors in sums of 10 to 1000
// values are smaller.
constexpr double near_zero = 1e-9;

bool all_finite(std::span<double const> values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

// The mean by which differences are divided; nullopt if it is nearly 0, or if a value is not finite.
std::optional<double> reference_mean(std::span<double const> values) {
  if (values.empty() || !all_finite(values)) return std::nullopt;
  double largest = 0.0;
  for (double const value : values) largest = std::max(largest, std::abs(value));
  double const mean = num::moments(values).mean;
  if (!std::isfinite(mean) || std::abs(mean) <= near_zero * largest) return std::nullopt;
  return mean;
}

}  // namespace

std::vector<double> percent_differences(std::span<double const> device_means) {
  std::vector<double> differences;
  if (auto const mean = reference_mean(device_means))
    for (double const value : device_means) differences.push_back(100.0 * (value - *mean) / *mean);
  return differences;
}

std::optional<double> largest_relative_difference(std::span<double const> device_means) {
  auto const mean = reference_mean(device_means);
  if (!mean || device_means.size() < 2) return std::nullopt;
  double largest = 0.0;
  for (double const value : device_means) largest = std::max(largest, std::abs(value - *mean));
  return largest / std::abs(*mean);
}

Robustness robustness_index(std::vector<std::string> const& names,
                            std::vector<std::vector<double>> const& device_means) {
  assert(names.size() == device_means.size());
  if (names.empty()) return {.beta = {}, .note = "no free parameter"};
  auto const devices = device_means.front().size();
  assert(std::ranges::all_of(device_means, [&](auto const& means) { return means.size() == devices; }));
  if (devices == 0) return {.beta = {}, .note = "no device"};
  if (devices == 1) return {.beta = {}, .note = "one device: no spread between devices"};

  double sum = 0.0;
  std::vector<std::string> not_finite, mean_near_zero;
  for (std::size_t n = 0; n < names.size(); ++n) {
    if (auto const delta = largest_relative_difference(device_means[n]))
      sum += *delta;
    else
      (all_finite(device_means[n]) ? mean_near_zero : not_finite).push_back(names[n]);
  }
  std::string note;
  if (!not_finite.empty()) note = "a device's mean is not finite: " + joined(not_finite);
  if (!mean_near_zero.empty())
    note += (note.empty() ? "" : "; ") + ("mean over devices near zero: " + joined(mean_near_zero));
  if (!note.empty()) return {.beta = {}, .note = note};
  return {.beta = sum / static_cast<double>(names.size()), .note = {}};
}

}  // namespace isolaw::lot
