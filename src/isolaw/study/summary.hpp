// The campaign in numbers: the plain data that summary.json, the tables, the page and the terminal print.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/analysis/determination.hpp"
#include "isolaw/campaign/contents.hpp"
#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/properties/error_budget.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/properties/vertical.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/lot/population.hpp"
#include "isolaw/study/acceptance.hpp"
#include "isolaw/study/conditions.hpp"

namespace isolaw::study {

struct Statistic {
  std::optional<double> mean, std, best;  // empty without a usable run; std needs two runs
};

// How well the test of one device determines a parameter, from the objective around its minimum.
struct ParameterAnalysis {
  double optimum = 0.0;
  analysis::Verdict identifiability = analysis::Verdict::determined;
  // The range in which the objective, with all other parameters fitted again, rises by at most DeviceFit::rise.
  double open_lower = 0.0, open_upper = 0.0;
  bool open_below = false, open_above = false;  // the range ends at a bound of the search box
  double linear_lower = 0.0, linear_upper = 0.0;
  std::optional<double> bootstrap_lower, bootstrap_upper;
  std::vector<double> profile_value, profile_objective;
};

struct BlockScore {
  int block = 0;
  bool fitted = false;  // false: the law was not fitted to this block but predicts it
  double objective = 0.0;
};

// How the energy falls from first_cycle to last_cycle of `block`: measured_percent on the device, `percent` in a law.
struct EnergyFall {
  int block = 0, first_cycle = 0, last_cycle = 0;
  double measured_percent = 0.0, percent = 0.0;
};

struct ParameterFit {
  std::string name;
  std::string unit;
  bool free = true;  // false: fixed by default or by the user; then mean = best = the value, std = 0
  double lower = 0.0, upper = 0.0;
  Statistic value;
  std::optional<double> percent_of_lot;      // difference of this device's mean from the mean of all devices
  fit::AtBound at_bound = fit::AtBound::no;  // whether the best run ended at a bound of the box
  std::string tied_to;                       // the parameter whose value this one takes; "" for none
  std::string paper_name;                    // its name in the tables of Cucuzza et al. 2025, if different; else ""
  std::optional<ParameterAnalysis> analysis;
};

struct TestFit {  // compares a law, fitted to all tests of a device, with one of these tests
  std::string test;
  std::optional<double> objective, K_eff_error_percent, energy_error_percent, damping_error_percent;
};

struct DeviceFit {
  std::string device;
  bool counts = true;   // false: the record is a copy (DeviceResult::copy_of), so statistics over devices leave it out
  std::string refusal;  // why the law was not identified on this device; "" if it was
  int runs = 0, failed_runs = 0, missing_runs = 0;
  std::string failure;                                    // why the first failed run failed, or that no run finished
  std::uint64_t evaluations = 0, failed_evaluations = 0;  // parameter sets tried, and those without a finite force
  Statistic objective;
  std::optional<double> objective_by_time;  // the best run's objective by Eq. (27), if the campaign uses other weights
  // If the device has several tests, each of these errors is taken from the test in which its magnitude is largest.
  std::optional<double> K_eff_error_percent, energy_error_percent, damping_error_percent;
  std::vector<TestFit> tests;  // empty if the device has one test
  std::optional<double> integration_shift;
  int refinement = 1;  // integration steps per sample, in the best run
  // The share of the usable runs that end within found_within (0.1 %) of the least objective that the campaign found
  // for this law on this device, in a run or in the analysis. Empty with fewer than two usable runs.
  std::optional<double> success_share;
  double runs_apart = 0.0;        // relative difference between the objectives of the best and the worst usable run
  std::string success_reference;  // where the least objective of `success_share` comes from
  std::optional<double> optimum;  // least objective that the analyses found
  std::optional<double> rise;     // rise of the objective from its least value to open_lower and open_upper
  std::vector<std::string> trade_offs;  // sentences on parameters that compensate each other
  std::optional<double> interval_level;
  std::size_t interval_samples = 0, interval_block = 0;
  int interval_replicates = 0;
  std::optional<double> lot_objective;  // objective with the parameters that fit the lot best on average
  // Objective with LotLaw::worst_parameters, which make the largest objective of any device as small as possible.
  std::optional<double> worst_objective;
  std::optional<double> left_out_objective;  // objective with parameters fitted to all other devices
  // Objective on the large swings of the test with parameters fitted to its small swings. Several fits to the small
  // swings may be equally good; these are the largest and the least objective among them. Infinite if a force is not
  // finite; empty if the swings of the test cannot be divided into small and large ones.
  std::optional<double> larger_swings_objective, larger_swings_least;
  std::vector<double> larger_swings_force_kN;  // the force of a fit to the small swings, at the record's samples
  // Objectives on the device's tests if springs around a circle follow the law (fit/as_springs.hpp): with parameters
  // fitted to these springs, and with the parameters of the law alone.
  std::optional<double> springs_objective, springs_given_objective;
  std::vector<BlockScore> blocks;
  std::optional<EnergyFall> energy_fall;       // empty if the device does not lose energy steadily
  std::vector<ParameterFit> parameters;        // in the law's order
  std::vector<double> force_kN;                // force of the best run at the samples of the device's FitRecord
  std::vector<std::vector<double>> histories;  // for each run the best objective after each generation or descent
};

// "ok", "refused" (the law does not apply to the device) or "failed" (the law was tried, and no run was usable).
inline std::string_view fit_status(DeviceFit const& fit) {
  if (!fit.refusal.empty()) return "refused";
  return fit.objective.mean ? "ok" : "failed";
}

// Two parameter sets for all devices, in the law's order: with `parameters` the mean objective over the devices is
// least, and with `worst_parameters` the largest objective of any device is least.
struct LotLaw {
  std::vector<double> parameters, worst_parameters;
  double mean = 0.0, worst = 0.0;  // mean and largest objective with `parameters`
  std::string worst_device = {};
  double least_worst = 0.0, least_worst_bound = 0.0;  // largest objective with `worst_parameters`; a lower bound for it
  std::vector<std::pair<std::string, fit::AtBound>> at_bound = {};  // entries of `parameters` that lie at a bound
};

// How well a law predicts blocks that it was not fitted to. docs/decision.md has the limits.
enum class PredictionGrade { good, fair, poor, unusable };
constexpr std::string_view name(PredictionGrade grade) {
  constexpr std::string_view names[]{"good", "fair", "poor", "unusable"};
  return names[static_cast<std::size_t>(grade)];
}

// A law in steady cycles at a displacement beyond the tests. It has the lot's parameters or, if there are none, those
// of the first device that has a fit and was tested as far as the lot (at least 90 % of tested_mm).
struct BeyondTests {
  double tested_mm = 0.0;  // the largest displacement of the tests
  double asked_mm = 0.0;   // the displacement of the design, at least tested_mm; twice tested_mm if none is stated
  double K_kN_per_mm = 0.0, energy_kN_mm = 0.0;       // stiffness and energy of a cycle at asked_mm
  double stiffness_ratio = 0.0, damping_ratio = 0.0;  // value at asked_mm / value at tested_mm
};

struct LawResult {
  std::string id, title;
  Statistic objective;  // mean of the devices' means; std and best over all devices and runs
  std::optional<double> beta;
  std::string beta_note;  // why beta is empty
  bool on_front = false;
  // These members, up to `on_front_converged`, use each device's least known objective, not means over the runs.
  std::optional<double> success_share;
  std::string success_reference;
  std::optional<double> objective_converged, beta_converged;
  std::string beta_converged_note;            // why beta_converged is empty
  std::vector<std::string> left_out_of_beta;  // parameters that most tests leave undetermined or at a bound
  bool reduced = false;  // true: beta_converged is computed with the redundant parameter held fixed
  bool on_front_converged = false;
  std::optional<LotLaw> lot;
  std::optional<double> loo_objective, loo_worst;  // mean and largest left_out_objective of the devices
  std::string loo_worst_device;
  bool on_front_loo = false;  // on the front of objective_converged against loo_objective
  // The first two are means of the members of the same names in DeviceFit, over the devices that have them. The third
  // is the largest larger_swings_objective of any device.
  std::optional<double> larger_swings_objective, larger_swings_least, larger_swings_worst;
  std::optional<BeyondTests> beyond_tests;  // empty if no parameters are known with which to compute it
  // Faults of the law inside the tested displacements. Each names the device with whose parameters it occurs; a fault
  // that occurs with the lot's parameters names none.
  std::vector<Finding> faults_inside = {};
  std::optional<Finding> runs_away = {};  // FindingKind::law_runs_away: why the law is not recommended for a building
  std::optional<lot::Population> population;
  std::optional<double> fitted_objective, predicted_objective,
      worst_predicted;  // mean objective on the fitted and on the predicted blocks, and the largest on a predicted one
  std::optional<PredictionGrade> prediction_grade;  // empty if no blocks are predicted
  bool in_programs = false;  // an analysis program has this law and can take its parameter values
  std::string reduced_form;  // the option `--set` that fixes the redundant parameter in a fit; "" if there is none
  std::vector<std::string> notes;  // how isolaw reads the law where its source is ambiguous
  std::vector<DeviceFit> devices;

  // The fits that statistics over devices use: all except fits to copies of records.
  auto counting() const { return devices | std::views::filter(&DeviceFit::counts); }
  bool prediction_holds() const { return !prediction_grade || *prediction_grade <= PredictionGrade::fair; }
  bool prediction_unusable() const { return prediction_grade == PredictionGrade::unusable; }
};

struct DeviceResult {
  std::string name, file, sha256;
  std::string status;                 // "ok" or "refused"
  std::string message;                // reason of a refusal
  std::vector<Complaint> complaints;  // the problems of a refused record, which an inspection lists
  std::string copy_of;                // the device with the same record that counts instead of this one; else empty
  std::string serial, lot, test_date;
  std::optional<double> temperature_C, rubber_thickness_mm, rubber_area_mm2;
  data::TestRecord raw;    // empty if the device was refused
  data::FitRecord record;  // the record that the laws were fitted to
  // For each sample of `record`, whether it lies in a large swing. Laws that were fitted to the small swings are judged
  // on the large ones. Empty if the tests have no such swings.
  std::vector<bool> in_large_swings;
  data::Properties properties;                      // properties of the raw record
  std::optional<data::Properties> uncorrected;      // properties before the user's corrections; empty if there are none
  data::VerticalTest vertical_test;                 // holds the reason if the test gives no stiffness
  std::optional<data::VerticalStiffness> vertical;  // vertical stiffness from the raw compression test
  std::vector<Finding> notes;                       // remarks from the error budget, besides the record's warnings
  std::vector<data::Effect> effects;                // the whole error budget, for JSON
  DeviceAcceptance acceptance;

  bool counts() const { return copy_of.empty(); }
};

struct OutlyingDevice {
  std::string device, property, unit;
  std::string law;  // the law whose error `property` is; empty if `property` was measured on the device
  double value = 0.0, median = 0.0, score = 0.0, percent = 0.0;
};

struct Setting {
  std::string key;
  std::string json;  // the value as JSON text
};

struct Summary {
  std::string version;                  // the version of isolaw that made the summary
  std::vector<campaign::Maker> makers;  // the builds of isolaw that computed the campaign
  std::string title;                    // the title of the lot
  std::uint64_t seed = 0;
  std::vector<Setting> settings;
  std::vector<DeviceResult> devices;
  std::vector<LawResult> laws;  // in the order asked for; none for an inspection
  campaign::Acceptance asked;   // the options that `acceptance` was computed with
  LotAcceptance acceptance;
  std::optional<Finding> conditions_differ;    // the conditions in which the devices' tests differ, if any
  std::optional<Finding> without_corrections;  // the verdict without the corrections that the user asked for, if any
  std::optional<Finding> not_compared;         // devices whose measured values were not compared to find outliers
  std::vector<OutlyingDevice> outliers;
  std::optional<ConditionsResult> conditions;  // empty if the lot file has no table [conditions]
  std::string no_conditions;                   // why the tests of this table cannot be compared; else empty
  std::size_t analyses = 0, expected_analyses = 0;
  std::size_t runs = 0, expected_runs = 0;  // stored runs, and runs of the complete campaign
  std::optional<campaign::Part> part;       // the part that the store holds; nullopt: the whole campaign
  std::size_t expected_here = 0;            // runs of this part, or of the whole campaign

  std::size_t missing_runs() const { return expected_runs > runs ? expected_runs - runs : 0; }
  UnitSystem const& units() const { return find_unit_system(asked.report_units); }  // units of reports
  std::size_t missing_analyses() const { return expected_analyses > analyses ? expected_analyses - analyses : 0; }
};

// True if a test under other conditions was refused, or if the tests could not be compared at all.
bool conditions_refused(Summary const& summary);
// True if a device or the lot does not keep a limit of a verified rule set: the rule set of the acceptance, or that of
// the table [conditions] in the lot file.
bool acceptance_failed(Summary const& summary);
// Assesses the devices and the lot. Throws Error if the lot is smaller than the number of devices.
void add_acceptance(Summary& summary, rules::RuleSet const& rules, rules::Design const& design,
                    std::optional<int> lot_size);

}  // namespace isolaw::study
