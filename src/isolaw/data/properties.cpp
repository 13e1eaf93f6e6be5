#include "isolaw/data/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace isolaw::data {
namespace {

// A crossing of zero counts once displacement has been beyond this share of the half range on the other side: above
// the noise and tremor of a rig at rest, below the smallest stage of a test from 5 to 200 % strain (2.5 %).
constexpr double hysteresis_band = 0.02;
// Fewer samples in a cycle lose more than 1.6 % of its energy to the trapezoid, and 1.2 % of its peak.
constexpr double least_samples_per_cycle = 20.0;
constexpr std::size_t reported_cycle = 3;

struct Crossings {
  std::vector<double> at;  // fractional sample indices
  double band = 0.0;       // mm
};

// +1 or -1: where displacement first leaves the band about zero, or about its first value when that is outside.
double first_direction(std::span<double const> x, double band) {
  double const origin = std::abs(x.front()) <= band ? 0.0 : x.front();
  for (double const value : x)
    if (std::abs(value - origin) > band) return value > origin ? 1.0 : -1.0;
  return 0.0;
}

// A record that comes to rest inside the band ends its last cycle there: at the sample nearest to zero after the last
// one beyond the band (three exact cycles of a sine end at zero without crossing it).
std::size_t rest_index(std::span<double const> x, double band) {
  std::size_t first = x.size();
  while (first > 0 && std::abs(x[first - 1]) <= band) --first;
  std::size_t nearest = first;
  for (std::size_t i = first; i < x.size(); ++i)
    if (std::abs(x[i]) < std::abs(x[nearest])) nearest = i;
  return nearest;
}

Crossings find_crossings(std::span<double const> x) {
  Crossings crossings;
  if (x.size() < 3) return crossings;
  auto const [least, largest] = std::ranges::minmax(x);
  crossings.band = hysteresis_band * (largest - least) / 2.0;
  if (!(crossings.band > 0.0)) return crossings;
  double const direction = first_direction(x, crossings.band);
  if (std::abs(x.front()) <= crossings.band) crossings.at.push_back(0.0);
  bool armed = direction * x.front() < -crossings.band;
  for (std::size_t i = 1; i < x.size(); ++i) {
    double const before = direction * x[i - 1];
    double const after = direction * x[i];
    if (after < -crossings.band) armed = true;
    if (!armed || before >= 0.0 || after < 0.0) continue;
    double const part = before / (before - after);  // not finite where a damaged store's values are not
    crossings.at.push_back(static_cast<double>(i - 1) + (std::isfinite(part) ? part : 0.0));
    armed = false;
  }
  if (armed && std::abs(x.back()) <= crossings.band)
    crossings.at.push_back(static_cast<double>(rest_index(x, crossings.band)));
  return crossings;
}

double value_at(std::span<double const> values, double index) {
  auto const i = std::min(static_cast<std::size_t>(index), values.size() - 1);
  double const part = index - static_cast<double>(i);
  return part > 0.0 && i + 1 < values.size() ? values[i] + part * (values[i + 1] - values[i]) : values[i];
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  auto const half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2.0;
}

std::string refusal_of(Crossings const& crossings, Properties const& properties, std::span<double const> x) {
  if (x.empty()) return "no samples";
  auto const [least, largest] = std::ranges::minmax(x);
  if (properties.cycles.empty())
    return fmt::format(
        "less than one complete cycle: displacement runs from {:.4g} to {:.4g} mm and {} crossings of zero in the "
        "direction of the first motion were found, 2 are needed (one counts once displacement has been {:.3g} mm "
        "beyond zero on the other side)",
        least, largest, crossings.at.size(), crossings.band);
  if (*properties.samples_per_cycle < least_samples_per_cycle * (1.0 - 1e-9))
    return fmt::format("{:.1f} samples per cycle, fewer than the {:.0f} that stiffness and energy need",
                       *properties.samples_per_cycle, least_samples_per_cycle);
  return {};
}

}  // namespace

Cycle properties_on(Cycle const& cycle, std::span<double const> disp_mm, std::span<double const> force_kN) {
  assert(disp_mm.size() == force_kN.size());
  Cycle result{.number = cycle.number, .first = cycle.first, .last = cycle.last};
  double const start_x = value_at(disp_mm, cycle.first);
  double const start_F = value_at(force_kN, cycle.first);
  double x = start_x;
  double F = start_F;
  double energy = 0.0;
  double least = x, F_at_least = F;
  double largest = x, F_at_largest = F;
  auto const go_to = [&](double next_x, double next_F) {
    energy += (F + next_F) / 2.0 * (next_x - x);
    x = next_x;
    F = next_F;
    if (x < least) least = x, F_at_least = F;
    if (x > largest) largest = x, F_at_largest = F;
  };
  auto const end = std::min(static_cast<std::size_t>(std::ceil(cycle.last)), disp_mm.size());
  for (auto i = static_cast<std::size_t>(std::floor(cycle.first)) + 1; i < end; ++i) go_to(disp_mm[i], force_kN[i]);
  go_to(value_at(disp_mm, cycle.last), value_at(force_kN, cycle.last));
  go_to(start_x, start_F);  // closes the loop
  result.amplitude_mm = (largest - least) / 2.0;
  result.K_eff_kN_per_mm = (F_at_largest - F_at_least) / (largest - least);
  result.energy_kN_mm = energy;
  result.damping_percent =
      100.0 * energy / (2.0 * std::numbers::pi * result.K_eff_kN_per_mm * result.amplitude_mm * result.amplitude_mm);
  return result;
}

Properties cyclic_properties(std::span<double const> disp_mm, std::span<double const> force_kN) {
  assert(disp_mm.size() == force_kN.size());
  Properties properties;
  auto const crossings = find_crossings(disp_mm);
  std::vector<double> lengths;
  for (std::size_t i = 1; i < crossings.at.size(); ++i) {
    Cycle const cut{.number = static_cast<int>(i), .first = crossings.at[i - 1], .last = crossings.at[i]};
    properties.cycles.push_back(properties_on(cut, disp_mm, force_kN));
    lengths.push_back(cut.last - cut.first);
  }
  if (!lengths.empty()) properties.samples_per_cycle = median(lengths);
  properties.refusal = refusal_of(crossings, properties, disp_mm);
  if (properties.refusal.empty())
    properties.reported = properties.cycles[std::min(properties.cycles.size(), reported_cycle) - 1];
  return properties;
}

}  // namespace isolaw::data
