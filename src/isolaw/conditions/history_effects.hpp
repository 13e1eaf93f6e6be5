// Effects of the history of a device: ageing in an oven and in service, the loss of stiffness in the first cycles, and
// the recovery of this loss at rest.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/conditions/contrast.hpp"

namespace isolaw::conditions {

// How many years at the service temperature an ageing test stands for, by the law of Arrhenius.
double stands_for_years(Ageing const& test, double service_temperature_C, double activation_energy_kJ_per_mol);
// The level of ageing to use for a life of `years`: among the levels that stand for at least this life, the one with
// the shortest life; if there are none, the level with the longest life. nullptr if no level is aged.
Level const* ageing_level_for(double years, std::span<Level const> levels, double service_temperature_C,
                              double activation_energy_kJ_per_mol);
// The ageing in an oven at `oven_C` that stands for `years` of service.
Ageing ageing_for(double years, double oven_C, double service_temperature_C, double activation_energy_kJ_per_mol);
// The factor of ageing after `years`. Up to the life for which the test stands, it is the factor of the test. Up to
// twice this life, ln of the factor rises in proportion to the life and is extrapolated. Beyond, it is not covered.
Factor aged_factor(Factor const& of_test, double years, double test_stands_for_years);

// A reference test of one device: ln of a property in its first and in its third cycle, and ln of the mean over the
// reference cycles.
struct ReferenceTest {
  std::string device;
  double ln_first = 0.0, ln_third = 0.0, ln_reference = 0.0;
  std::optional<double> rest_h = {};  // time at rest before the test; empty for the first test of the device
};

struct Recovered {  // the share of the loss in the first cycles that comes back after a rest
  double rest_h = 0.0, share = 0.0;
  int devices = 0;
};
// For each tested rest the share R = (P_1,again - P_3)/(P_1 - P_3), a mean over the devices, limited to 0 to 1. P_1 and
// P_3 are the values in the first and third cycle of a new device (`first`), P_1,again the value in the first cycle of
// its later test (`again`), which follows a rest.
std::vector<Recovered> recovery(std::span<ReferenceTest const> first, std::span<ReferenceTest const> again);
// The share after a rest of `rest_h`: between two tested rests, a straight line over the logarithm of the rest. nullopt
// for a shorter or longer rest than those tested.
std::optional<double> recovery_after(std::span<Recovered const> tested, double rest_h);

// The value of a property in the first cycle of a new device, divided by its value in the reference cycle. If the share
// `recovered` of the loss is given, the ratio is that of a device which was stretched before and then rested.
Factor scragging_factor(std::span<ReferenceTest const> first, std::optional<double> recovered = {});

// Makes a factor that tests show from the mean of ln ratios over devices. Without ratios the factor is not covered, for
// the reason `if_none`.
Factor mean_factor(std::span<double const> ln_ratios, Lack if_none);

}  // namespace isolaw::conditions
