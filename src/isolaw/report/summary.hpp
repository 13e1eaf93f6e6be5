// The campaign in numbers: everything that summary.json, the tables, the page and the terminal print. Plain data;
// who prints it decides nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/data/error_budget.hpp"
#include "isolaw/data/properties.hpp"
#include "isolaw/data/record.hpp"
#include "isolaw/report/acceptance.hpp"

namespace isolaw::report {

struct Statistic {
  std::optional<double> mean, std, best;  // empty: no usable run (std is empty below two runs)
};

struct ParameterFit {
  std::string name;
  std::string unit;
  bool free = true;  // false: fixed by default or by the user; then mean = best = the value, std = 0
  double lower = 0.0, upper = 0.0;
  Statistic value;
  std::optional<double> percent_of_lot;  // difference of the mean from the mean over devices, percent
  std::string at_bound;                  // "", "lower" or "upper": of the best run
};

// One law on one device.
struct DeviceFit {
  std::string device;
  std::string refusal;  // why the law was not identified here ("" when it was)
  int runs = 0, failed_runs = 0, missing_runs = 0;
  std::string failure;                                    // reason of the first failed run
  std::uint64_t evaluations = 0, failed_evaluations = 0;  // parameter sets tried; of them, without a finite force
  Statistic objective;
  std::optional<double> K_eff_error_percent, energy_error_percent, damping_error_percent;
  std::optional<double> integration_shift;
  std::vector<ParameterFit> parameters;        // in the law's order
  std::vector<double> force_kN;                // computed by the best run at the samples of the device's FitRecord
  std::vector<std::vector<double>> histories;  // per run: best objective after each generation
};

// "ok", "refused" (the law does not apply to the device) or "failed" (it was tried, and no run was usable).
inline std::string_view fit_status(DeviceFit const& fit) {
  if (!fit.refusal.empty()) return "refused";
  return fit.objective.mean ? "ok" : "failed";
}

struct LawResult {
  std::string id, title;
  Statistic objective;  // mean and best over devices and runs
  std::optional<double> beta;
  std::string beta_note;  // why beta is empty
  bool on_front = false;
  std::vector<std::string> notes;  // how the law was read where the source is ambiguous
  std::vector<DeviceFit> devices;
};

struct DeviceResult {
  std::string name, file, sha256;
  std::string status;   // "ok" or "refused"
  std::string message;  // reason of a refusal
  std::string serial, lot, test_date;
  std::optional<double> temperature_C, rubber_thickness_mm, rubber_area_mm2;
  data::TestRecord raw;            // empty when refused
  data::FitRecord record;          // what the laws were fitted to
  data::Properties properties;     // from raw values
  std::vector<std::string> notes;  // numbers of the error budget that are worth knowing, beside the record's warnings
  std::vector<data::Effect> effects;  // all of the error budget, for machines
  DeviceAcceptance acceptance;
};

struct Setting {
  std::string key;
  std::string json;  // its value as JSON text
};

struct Summary {
  std::string version;
  std::string title;  // of the lot
  std::uint64_t seed = 0;
  std::vector<Setting> settings;
  std::vector<DeviceResult> devices;
  std::vector<LawResult> laws;  // in the order asked for; none for an inspection
  campaign::Acceptance asked;   // what `acceptance` was made from
  LotAcceptance acceptance;
  std::size_t runs = 0, expected_runs = 0;  // stored, and of a campaign that is complete

  std::size_t missing_runs() const { return expected_runs > runs ? expected_runs - runs : 0; }
};

// Some limit of a verified rule set is not kept, by a device or by the lot.
bool acceptance_failed(Summary const& summary);

// Fills in what rules and statistics say of the devices. Throws Error: the lot is smaller than the number of devices.
void add_acceptance(Summary& summary, rules::RuleSet const& rules, rules::Design const& design,
                    std::optional<int> lot_size);

}  // namespace isolaw::report
