#include "isolaw/conditions/observe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isolaw::conditions {

std::optional<double> CycleValues::ln(rules::Quantity quantity) const {
  auto const& all = rules::measured_quantities();
  double const value = values[static_cast<std::size_t>(std::ranges::find(all, quantity) - all.begin())];
  return value > 0.0 ? std::optional(std::log(value)) : std::nullopt;
}

CycleValues const* Block::find(int cycle) const {
  auto const found = std::ranges::find(cycles, cycle, &CycleValues::number);
  return found == cycles.end() ? nullptr : &*found;
}

std::string_view name(History history) {
  switch (history) {
    case History::virgin:
      return "virgin";
    case History::first_after_rest:
      return "first after rest";
    case History::scragged:
      return "scragged";
    case History::disturbed:
      return "disturbed";
  }
  return "";
}

History history(double strain_percent, double largest_before_percent, int number, std::optional<double> rest_h,
                Tolerance const& tolerance) {
  constexpr double hardly = 0.25;  // share of the strain up to which an earlier block leaves a device as new
  constexpr double long_rest_h = 1.0;
  constexpr int settled = 3;
  double const near = tolerance.strain_percent / 100.0, share = largest_before_percent / strain_percent;
  bool const repeats = std::abs(share - 1.0) <= near;
  if (share > 1.0 + near || (share > hardly && share < 1.0 - near && number < settled)) return History::disturbed;
  if (number >= settled || (repeats && rest_h && *rest_h < long_rest_h)) return History::scragged;
  return repeats ? History::first_after_rest : History::virgin;
}

std::vector<double> largest_before(std::span<Block const> blocks) {
  std::vector<double> before;
  double largest = 0.0;
  for (auto const& block : blocks) {
    before.push_back(largest);
    largest = std::max(largest, block.condition.strain_percent.value_or(0.0));
  }
  return before;
}

double heating_K(double energy_kN_mm, double capacity_MJ_per_m3K, double rubber_area_mm2, double rubber_thickness_mm) {
  constexpr double per_mm3 = 1e-3;  // 1 MJ/(m3 K) in J/(mm3 K)
  return energy_kN_mm / (capacity_MJ_per_m3K * per_mm3 * rubber_area_mm2 * rubber_thickness_mm);
}

double warming_h(double rubber_thickness_mm) {
  constexpr double diffusivity_mm2_per_s = 0.09, seconds_per_h = 3600.0;
  return 3.0 * rubber_thickness_mm * rubber_thickness_mm /
         (std::numbers::pi * std::numbers::pi * diffusivity_mm2_per_s * seconds_per_h);
}

}  // namespace isolaw::conditions
