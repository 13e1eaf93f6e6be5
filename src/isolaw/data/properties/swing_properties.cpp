#include "isolaw/data/properties/swing_properties.hpp"

#include <algorithm>
#include <numbers>

namespace isolaw::data {
namespace {

constexpr double share_of_largest = 0.8;

// The area between the force of a swing and its chord. It is positive if the device loses energy: the force then lies
// above the chord on the way up, and below it on the way down.
double area_above_chord(Swing const& swing, std::span<double const> x, std::span<double const> F) {
  double area = 0.0;
  for (auto i = swing.first; i < swing.last; ++i) area += 0.5 * (F[i] + F[i + 1]) * (x[i + 1] - x[i]);
  return area - 0.5 * (F[swing.first] + F[swing.last]) * (x[swing.last] - x[swing.first]);
}

}  // namespace

SwingProperties properties_on(std::span<Swing const> swings, std::span<double const> x, std::span<double const> F) {
  SwingProperties sums;
  double largest = 0.0, half_ranges = 0.0, squares = 0.0;
  auto const mean_of_pair = [&](std::size_t k) {
    return 0.5 * (swings[k].half_range_mm + swings[k + 1].half_range_mm);
  };
  auto const is_pair = [&](std::size_t k) { return swings[k].last == swings[k + 1].first; };
  for (std::size_t k = 0; k + 1 < swings.size(); ++k)
    if (is_pair(k)) largest = std::max(largest, mean_of_pair(k));
  for (std::size_t k = 0; k + 1 < swings.size(); ++k) {
    if (!is_pair(k) || mean_of_pair(k) < share_of_largest * largest) continue;
    ++sums.pairs;
    for (auto const& swing : {swings[k], swings[k + 1]}) {
      double const change = F[swing.last] - F[swing.first];
      sums.force_kN += x[swing.last] > x[swing.first] ? change : -change;
      sums.energy_kN_mm += area_above_chord(swing, x, F);
      half_ranges += swing.half_range_mm;
      squares += swing.half_range_mm * swing.half_range_mm;
    }
  }
  if (sums.pairs == 0) return sums;
  sums.amplitude_mm = half_ranges / static_cast<double>(2 * sums.pairs);
  sums.K_kN_per_mm = sums.force_kN / (2.0 * half_ranges);
  sums.damping_percent = 100.0 * sums.energy_kN_mm / (std::numbers::pi * sums.K_kN_per_mm * squares);
  return sums;
}

std::optional<SwingProperties> swing_properties(std::span<double const> disp_mm, std::span<double const> force_kN,
                                                std::span<double const> time_s) {
  auto const found = properties_on(swings(disp_mm, time_s), disp_mm, force_kN);
  return found.pairs > 0 && found.K_kN_per_mm > 0.0 ? std::optional(found) : std::nullopt;
}

std::optional<SwingProperties> swing_properties(TestRecord const& record) {
  std::optional<SwingProperties> largest;
  for (auto const& range : test_ranges(record.starts, record.size())) {
    auto const found =
        swing_properties(range.slice(record.disp_mm), range.slice(record.force_kN), range.slice(record.time_s));
    if (found && (!largest || found->amplitude_mm > largest->amplitude_mm)) largest = found;
  }
  return largest;
}

}  // namespace isolaw::data
