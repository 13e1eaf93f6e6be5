// Compares a production lot with a rule set: spread, sample size, outliers, limits on the mean, factors and bounds.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/rules/assess.hpp"
#include "isolaw/rules/factors.hpp"

namespace isolaw::rules {

struct DeviceValues {
  std::string name;
  BlockValues block;  // the block that the rules are applied to
  // The name of another device with the same record; empty if there is none. A device with a copied record does not
  // count as tested. It enters neither means nor spreads, except those of K_v, which comes from another test.
  std::string copy_of = {};
  // Whether the device was tested at the lot's usual amplitude. Only such devices can be outliers, except in K_v.
  bool at_usual_amplitude = true;
};

struct Outlier {
  std::string device;
  double value = 0.0;
  double score = 0.0;  // modified z score
  std::string reason;  // "58 % above the median: modified z 12.1, above 3.5"
};

// Values whose modified z score (num/statistics.hpp) is above 3.5 in size. The standard deviation is taken as at least
// 0.5 % of |median|, which is the error of a property from one record. Empty for fewer than
// num::fewest_for_outliers values.
std::vector<Outlier> find_outliers(std::span<std::string const> names, std::span<double const> values);

// Which values lie within a bound. contract: those that the contract allows, as the rule set states them; device: the
// value of any single device of the lot; system: the mean over all devices of the isolation system.
enum class BoundScope { contract, device, system };
std::string_view name(BoundScope scope);  // "contract", "device", "system"

struct Bound {         // factors on the design value (or the lot's mean), and the resulting property
  std::string source;  // "contract band", "observed", "statistical, each device", "statistical, system", ...
  BoundScope scope = BoundScope::device;
  FactorPair spec;                  // lambda_spec; without a lower bound all minima and `lower` are NaN
  CombinedFactors combined;         // `spec` combined with the factors of environment and test; see combine()
  double lower = 0.0, upper = 0.0;  // combined factors times the design value or the mean
  std::string note;                 // explains the source
  bool is_tolerance = false;        // true for a tolerance limit, which holds 95 % of the devices with confidence 95 %
  std::string no_lower;             // why there is no lower bound
};

struct LotQuantity {
  Quantity quantity = Quantity::K_eff;
  std::string unit;
  std::size_t count = 0;  // devices with a value; without copies, except for K_v
  std::vector<std::string> devices_without_value;
  std::optional<double> mean, min, max;
  std::string min_device, max_device;
  std::optional<double> std, cov_percent;         // spread of the values; nullopt for fewer than two tested devices
  std::optional<double> nominal;                  // design value
  std::optional<double> mean_deviation_percent;   // deviation of the mean from the design value
  std::optional<double> worst_deviation_percent;  // deviation of the device farthest from the design value
  std::string worst_device;
  std::optional<double> fractile_5, fractile_95;        // mean +- 1.645 std
  std::optional<double> tolerance_factor;               // mean +- this many std holds 95 % of devices, confidence 95 %
  std::optional<double> tolerance_low, tolerance_high;  // mean +- tolerance_factor std
  std::string no_lower;                                 // why fractile_5 or tolerance_low is missing
  std::vector<Outlier> outliers;
  std::string outlier_note;      // why no outliers are named, or which devices were not searched for outliers
  std::string limit_individual;  // the rule set's limit on every single device
  std::optional<double> lower_percent, upper_percent;  // limit_individual as deviations from the design value
  std::vector<Assessment> mean_limits;                 // the rule set's limits on the lot's mean
  std::optional<TestFactors> test_factors;             // extremes of lambda_test over the devices
  std::string test_min_device, test_max_device;
  std::vector<Bound> bounds;
  // The members below say whether a verified set permits an analysis with mean properties. They only judge how devices
  // of the supply differ, because the records show neither ageing nor the environment.
  std::optional<double> largest_from_mean_percent;  // largest deviation of a tested device from the mean
  std::optional<bool> mean_analysis_permitted;
  std::string mean_analysis_open;  // why the permission is not decided although all deviations are small enough
};

struct LotView {
  std::size_t devices = 0;  // tested devices, without copies
  std::optional<int> lot_size;
  std::optional<int> required;  // devices to test by the set's sample rule, if the lot's size is known
  Assessment sample;            // compares `devices` with `required`
  std::string note;             // not empty if only one device of a lot was tested
  std::vector<LotQuantity> quantities;
};

// `lot_size` counts all devices installed or produced. Throws Error if it is smaller than the number of `devices`.
LotView lot_view(RuleSet const& rules, std::span<DeviceValues const> devices, Design const& design,
                 std::optional<int> lot_size = std::nullopt);

}  // namespace isolaw::rules
