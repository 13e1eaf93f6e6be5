// Compares a production lot with a rule set: spread, sample size, outliers, limits on the mean, factors with bounds.
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
  BlockValues block;  // the block that counts, the same for every device
  // The other device of the lot whose record this device's record copies. This one counts in means, but not as tested.
  std::string copy_of = {};
};

struct Outlier {
  std::string device;
  double value = 0.0;
  double score = 0.0;  // modified z
  std::string reason;  // "K_eff 1.9 kN/mm is 58 % above the median 1.2: modified z 12.1, above 3.5"
};

// Values with a modified z score |x - median| / max(1.4826 MAD, 0.5 % of |median|) above 3.5 (Iglewicz, Hoaglin 1993);
// outliers do not move the median and the median absolute deviation. The floor of 0.5 %, the error of a property from
// one record, keeps nearly identical devices from being outliers of one another. Empty for fewer than five values.
std::vector<Outlier> find_outliers(std::string_view quantity, std::string_view unit_text,
                                   std::span<std::string const> names, std::span<double const> values);
inline constexpr std::size_t fewest_for_outliers = 5;

// Bounds hold for any device as the contract says, for one device, or for the mean of all devices of the system.
enum class Spread { contract, device, system };
std::string_view name(Spread spread);  // "contract", "device", "system"

struct Bound {         // factors on the design value (the lot's mean if there is none), and the property they give
  std::string source;  // "contract band", "observed", "statistical, each device", "statistical, system", ...
  Spread spread = Spread::device;
  FactorPair spec;           // lambda_spec of this source; min, combined.min and `lower` are NaN without a lower bound
  CombinedFactors combined;  // with the defaults of the set if it has a [[factor]] of the property
  double lower = 0.0, upper = 0.0;  // base value x combined, in the quantity's unit
  std::string note;                 // explains the source
  std::string no_lower;             // why there is no lower bound
};

struct LotQuantity {
  Quantity quantity = Quantity::K_eff;
  std::string unit;
  std::size_t count = 0;             // devices with a value
  std::size_t tested = 0;            // count without copies; the sample rule and statistical bounds use it
  std::vector<std::string> without;  // devices without a value
  std::optional<double> mean, min, max;
  std::string min_device, max_device;
  std::optional<double> std, cov_percent;         // the sample's; for two tested devices or more
  std::optional<double> nominal;                  // design value
  std::optional<double> mean_deviation_percent;   // between the mean and the design value
  std::optional<double> worst_deviation_percent;  // of the device that is farthest from the design value
  std::string worst_device;
  std::optional<double> fractile_5, fractile_95;        // mean +- 1.645 std
  std::optional<double> tolerance_factor;               // two-sided, exact: 95 % of devices with confidence 95 %
  std::optional<double> tolerance_low, tolerance_high;  // mean +- factor x std
  std::string no_lower;                                 // why fractile_5 or tolerance_low is missing
  std::vector<Outlier> outliers;
  std::string outlier_note;                            // says that there are too few devices to name outliers
  std::string limit_individual;                        // the rule set's limit on every single device
  std::optional<double> lower_percent, upper_percent;  // that limit as deviations from nominal
  std::vector<Assessment> mean_limits;                 // the rule set's limits on the lot's mean
  std::optional<TestFactors> test_factors;             // extremes of lambda_test over the devices
  std::string test_min_device, test_max_device;
  std::vector<Bound> bounds;
  // Largest deviation of a device from the lot's mean, and whether a verified set permits an analysis with mean
  // properties as far as the variability within the supply is concerned; the records do not show the other effects.
  std::optional<double> largest_from_mean_percent;  // for two tested devices or more
  std::optional<bool> mean_analysis_permitted;
  std::string mean_analysis_open;  // why this stays open although the deviations are small enough
};

struct LotView {
  std::size_t devices = 0;  // tested, without copies
  std::optional<int> lot_size;
  std::optional<int> required;  // devices that the set's sample rule requires, if the lot's size is known
  Assessment sample;            // tested devices against required ones
  std::string note;             // says that one device is no lot
  std::vector<LotQuantity> quantities;
};

// `lot_size`: devices installed or produced, tested ones included. Throws Error if it is smaller than `devices`.
LotView lot_view(RuleSet const& rules, std::span<DeviceValues const> devices, Design const& design,
                 std::optional<int> lot_size = std::nullopt);

}  // namespace isolaw::rules
