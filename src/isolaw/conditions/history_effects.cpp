#include "isolaw/conditions/history_effects.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "isolaw/num/statistics.hpp"

namespace isolaw::conditions {
namespace {

constexpr double kelvin = 273.15, gas_constant = 8.314462618e-3, year_days = 365.25;  // gas_constant in kJ/(mol K)

}  // namespace

double stands_for_years(Ageing const& test, double service_temperature_C, double activation_energy_kJ_per_mol) {
  double const inverse = 1.0 / (service_temperature_C + kelvin) - 1.0 / (test.at_C + kelvin);
  return test.days / year_days * std::exp(activation_energy_kJ_per_mol / gas_constant * inverse);
}

Level const* ageing_level_for(double years, std::span<Level const> levels, double service_temperature_C,
                              double activation_energy_kJ_per_mol) {
  Level const* chosen = nullptr;
  double life = 0.0;
  for (auto const& level : levels) {
    if (!level.ageing) continue;
    double const of_level = stands_for_years(*level.ageing, service_temperature_C, activation_energy_kJ_per_mol);
    bool const nearer = life < years ? of_level > life : of_level >= years && of_level < life;
    if (chosen == nullptr || nearer) chosen = &level, life = of_level;
  }
  return chosen;
}

Ageing ageing_for(double years, double oven_C, double service_temperature_C, double activation_energy_kJ_per_mol) {
  Ageing const day{.days = 1.0, .at_C = oven_C};
  return {.days = years / stands_for_years(day, service_temperature_C, activation_energy_kJ_per_mol), .at_C = oven_C};
}

Factor aged_factor(Factor const& of_test, double years, double test_stands_for_years) {
  auto factor = of_test;
  if (factor.status == Status::not_covered || years <= test_stands_for_years) return factor;
  constexpr double farthest = 2.0;
  if (years > farthest * test_stands_for_years) return Factor::not_covered(Lack::too_long);
  double const times = years / test_stands_for_years;
  factor.ln *= times, factor.std *= times, factor.drift *= times;
  if (factor.se) *factor.se *= times;
  factor.status = Status::extrapolated;
  return factor;
}

std::vector<Recovered> recovery(std::span<ReferenceTest const> first, std::span<ReferenceTest const> again) {
  std::map<double, std::vector<double>> shares;
  for (auto const& later : again) {
    auto const own = std::ranges::find(first, later.device, &ReferenceTest::device);
    if (own == first.end() || !later.rest_h) continue;
    double const settled = std::exp(own->ln_third), lost = std::exp(own->ln_first) - settled;
    if (lost > 0.0) shares[*later.rest_h].push_back((std::exp(later.ln_first) - settled) / lost);
  }
  std::vector<Recovered> tested;
  for (auto const& [rest_h, of_devices] : shares)
    tested.push_back({.rest_h = rest_h,
                      .share = std::clamp(num::moments(of_devices).mean, 0.0, 1.0),
                      .devices = static_cast<int>(of_devices.size())});
  return tested;
}

std::optional<double> recovery_after(std::span<Recovered const> tested, double rest_h) {
  auto const above = std::ranges::find_if(tested, [&](Recovered const& each) { return each.rest_h >= rest_h; });
  if (above == tested.end()) return std::nullopt;
  if (above->rest_h == rest_h) return above->share;
  if (above == tested.begin()) return std::nullopt;
  auto const& below = *std::prev(above);
  return std::lerp(below.share, above->share, std::log(rest_h / below.rest_h) / std::log(above->rest_h / below.rest_h));
}

Factor mean_factor(std::span<double const> ln_ratios, Lack if_none) {
  if (ln_ratios.empty()) return Factor::not_covered(if_none);
  auto const of = num::moments(ln_ratios);
  Factor factor{.ln = of.mean, .devices = static_cast<int>(of.count), .std = of.std};
  if (of.count > 1) {
    factor.se = of.std / std::sqrt(static_cast<double>(of.count));
    factor.df = static_cast<double>(of.count - 1);
  }
  return factor;
}

Factor scragging_factor(std::span<ReferenceTest const> first, std::optional<double> recovered) {
  std::vector<double> ratios;
  for (auto const& test : first) {
    double const settled = std::exp(test.ln_third);
    double const value =
        recovered ? std::log(settled + *recovered * (std::exp(test.ln_first) - settled)) : test.ln_first;
    ratios.push_back(value - test.ln_reference);
  }
  return mean_factor(ratios, Lack::no_new_device);
}

}  // namespace isolaw::conditions
