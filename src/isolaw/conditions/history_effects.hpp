// Effects of what a device went through: ageing in an oven and in service, the loss of stiffness in the first cycles
// and its recovery at rest.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/conditions/contrast.hpp"

namespace isolaw::conditions {

// The time in years at the service temperature for which an ageing test stands, by the law of Arrhenius.
double stands_for_years(Ageing const& test, double service_temperature_C, double activation_energy_kJ_per_mol);
// The level of ageing that stands for the shortest life of at least so many years, else the one for the longest life.
// nullptr if no level is aged.
Level const* ageing_level_for(double years, std::span<Level const> levels, double service_temperature_C,
                              double activation_energy_kJ_per_mol);
// The ageing in an oven of this temperature that stands for so many years.
Ageing ageing_for(double years, double oven_C, double service_temperature_C, double activation_energy_kJ_per_mol);
// The factor of ageing after so many years: that of the test for a shorter life than the test stands for, in proportion
// (extrapolated) up to twice this life, and not covered beyond.
Factor aged_factor(Factor const& of_test, double years, double test_stands_for_years);

// A reference test of one device: ln of a property in its first, its third and its last cycle, and in the reference
// cycle.
struct ReferenceTest {
  std::string device;
  double ln_first = 0.0, ln_third = 0.0, ln_reference = 0.0;
  std::optional<double> rest_h = {};  // before it; empty for the first test of the device
};

struct Recovered {  // the share of the loss in the first cycles that comes back after a rest
  double rest_h = 0.0, share = 0.0;
  int devices = 0;
};
// R = (P_1,again - P_s)/(P_1 - P_s) for each rest, a mean over the devices, from 0 to 1. `first` are the tests of new
// devices, and `again` their later tests, in which cycle 1 is the first one after a rest.
std::vector<Recovered> recovery(std::span<ReferenceTest const> first, std::span<ReferenceTest const> again);
// On a straight line in the logarithm of the rest between two tested rests. Empty outside them.
std::optional<double> recovery_after(std::span<Recovered const> tested, double rest_h);

// The ratio of the first cycle to the reference cycle. With `recovered`, the share of the loss that has come back, it
// is that of a device which was stretched before and then rested.
Factor scragging_factor(std::span<ReferenceTest const> first, std::optional<double> recovered = {});

// A mean over devices of ln ratios, as a factor that a test shows. Without ratios it is not covered, because of
// `if_none`.
Factor mean_factor(std::span<double const> ln_ratios, Lack if_none);

}  // namespace isolaw::conditions
