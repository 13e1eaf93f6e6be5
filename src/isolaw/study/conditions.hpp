// How the properties of a lot's devices change with temperature, frequency, vertical load, ageing and history: the
// results of `isolaw conditions`, from the records that a lot file with a table [conditions] names.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/observed_tests.hpp"
#include "isolaw/conditions/combine.hpp"
#include "isolaw/conditions/history_effects.hpp"
#include "isolaw/conditions/observe.hpp"
#include "isolaw/study/conditions_at_reference.hpp"
#include "isolaw/study/conditions_dependence.hpp"
#include "isolaw/study/conditions_plan.hpp"

namespace isolaw::study {

// How a block of a test is used.
enum class TestRole {
  reference,      // the block agrees with the reference in all conditions
  effect,         // the block differs in one condition, and shows the effect of this condition
  combined,       // the block differs in two conditions or more, so it shows no single effect
  other_strain,   // the block has another strain than the reference
  cycle_missing,  // the block has no cycle with the number of the reference cycle
  other_history,  // no reference test of the device has a cycle with the history of this block's cycle
  unpaired,       // the device has no reference test; the effect is taken from devices that have one
  other_device,   // the device has another compound or size than [conditions] names
  scaled,         // the specimen is scaled; the effect is taken from devices of full size
};
std::string_view name(TestRole role);

struct ConditionsCycle {
  int number = 0;
  std::optional<conditions::History> history = {};
  // Empty if the cycle has no such value.
  std::optional<double> K_eff_kN_per_mm = {}, damping_percent = {}, energy_kN_mm = {}, Q_d_kN = {}, K_d_kN_per_mm = {};
};

struct ConditionsTest {                           // one block of one test
  std::string device, test, file, sha256, place;  // place: its table in the lot file, such as "lot.toml:38"
  campaign::StatedDevice of_device = {};
  std::string temperature_of;  // where the temperature was measured, as stated; empty if it is not stated
  bool is_scaled = false, is_acceptance = false;
  int order = 0, block = 0;
  double amplitude_mm = 0.0;
  conditions::Condition
      condition;  // frequency, strain and, if there is a channel, load as measured; the rest as stated
  std::optional<double> rest_h = {};
  std::optional<conditions::History> history = {};  // history of the reference cycle; empty if there is no such cycle
  TestRole role = TestRole::reference;
  std::optional<conditions::Effect> effect = {};  // the effect that the block shows, if it shows one
  // Values in the reference cycle.
  std::optional<double> K_eff_kN_per_mm = {}, damping_percent = {}, energy_kN_mm = {}, Q_d_kN = {}, K_d_kN_per_mm = {};
  std::optional<double> heating_K = {};  // upper bound of the temperature rise in the reference cycle
  // warming_h: how long the rubber takes to reach the temperature of the test. Set only if this temperature was
  // measured in a chamber and is not the reference temperature. conditioned_h: how long the device was kept at this
  // temperature, as stated.
  std::optional<double> warming_h = {}, conditioned_h = {};
  std::vector<ConditionsCycle> cycles = {};
  std::vector<double> loop_mm = {}, loop_kN = {};  // the loop of one cycle (ObservedBlock), for drawing
};

struct RefusedTest {  // a test that is not used, or a block of a test
  std::string device, test, place, reason;
};

struct DoubtedTest {  // a test with a doubt about its record
  std::string device, test, place;
  Finding doubt;
};

// A device whose last test has an order above the number of its tests: the lot file lacks some.
struct DeviceLackingTests {
  std::string device;
  int tests = 0, last_order = 0;
};

struct LevelRow {  // one tested level of an effect, such as a temperature of -20 C
  rules::Quantity quantity;
  conditions::Effect effect;
  std::string level;  // as the user would write it: "-20 C", "14 days at 70 C", "cycle 1"
  conditions::Factor factor;
  std::vector<conditions::DeviceRatio> ratios = {};
  std::optional<conditions::Ageing> ageing = {};
};

struct EndRow {  // one end of a range of the design's temperatures, frequencies or loads
  rules::Quantity quantity;
  conditions::Effect effect;
  double at = 0.0;
  conditions::Factor factor;
};

struct EffectResponse {
  rules::Quantity quantity;
  conditions::Response response;
};

struct CurveRow {  // a smooth curve fitted to test results (conditions/curves.hpp), and its parameter
  rules::Quantity quantity;
  conditions::Effect effect;
  std::string parameter;  // "exponent", "critical load" or "p"
  double value = 0.0;
  std::string unit;
  std::string device = {};                   // the tested device, if the curve is over the cycles of one test
  std::vector<double> at = {}, lambda = {};  // points of the curve: condition or cycle, and factor
};

struct AssumedFrom {  // where an assumed factor comes from
  std::string rules, clause;
  bool verified = false;
};

struct DesignRow {  // the largest and the smallest factor of an effect in the design range
  rules::Quantity quantity;
  conditions::Effect effect;
  conditions::Factor max, min;
  std::optional<AssumedFrom> assumed = {};
};

struct BoundRow {  // the bounds of a property from all effects together
  rules::Quantity quantity;
  conditions::Combined max, min;
  // The value that the factors multiply, in the quantity's unit: the geometric mean of the reference tests over the
  // devices. `devices` is the number of these devices.
  double value_at_reference = 0.0;
  int devices = 0;
};

struct CombinationMethod {  // how the factors of all effects make a bound
  conditions::Form form = conditions::Form::product;
  double adjust = 1.0, margin = 1.0;  // see rules::CombinationRule
  std::string rules = {};             // the rule set that states the form; empty: isolaw's own rule
  std::string clause = {};
  bool verified = false;
};

// Whether a verified rule set lets a building be analysed with mean properties only, although the properties change
// over the design conditions.
struct MeanProperties {
  rules::MeanAnalysisRule rule;
  std::optional<bool> permitted = {};                 // empty: the answer depends on factors that no test shows
  rules::Quantity quantity = rules::Quantity::K_eff;  // K_eff or energy, whichever changes more
  double farthest_percent = 0.0;                      // largest change of `quantity` from its value at reference
};

// The word that reports print for how sure a factor is: its status, in capitals if it is assumed or not covered, or
// "reference" for the factor 1 of the reference itself.
std::string_view status_word(conditions::Factor const& factor);

struct RecoveryRow {
  double rest_h = 0.0, share = 0.0;
  int devices = 0;
};

struct ConditionsDevice {  // a device of the lot, in the order of the lot file
  std::string name;
  double largest_percent = 0.0;  // largest strain in any of its tests; infinite if that of a test is not known
  std::optional<conditions::Ageing> aged = {};  // ageing in its last test
  bool is_scaled = false, is_compared = true;   // is_compared: it has the compound and size that [conditions] names
};

struct ConditionsResult {
  std::string title;
  campaign::StatedConditions stated;
  // The reference conditions. If the lot file does not state one of them, it is the value in which all tests agree.
  conditions::Condition reference;
  conditions::Tolerance tolerance;
  std::vector<ConditionsDevice> devices;
  std::vector<ConditionsTest> tests;
  std::vector<RefusedTest> refused;
  std::vector<DoubtedTest> doubted;
  std::vector<DeviceLackingTests> devices_lacking_tests;
  std::vector<LevelRow> levels;
  std::vector<EffectResponse> responses;  // one for each measured quantity and each of the four conditions of a test
  std::vector<EndRow> ends;
  std::vector<DesignRow> design;
  std::string rules;  // id of the rule set; empty if there is none
  CombinationMethod combination;
  std::vector<BoundRow> bounds;
  std::vector<RecoveryRow> recovery;
  std::vector<CurveRow> curves;
  std::optional<int> installed;  // number of devices in the production lot
  // Tested effects for which no device has a second reference test, and those with too few levels to tell whether the
  // response between two levels is a straight line.
  std::vector<conditions::Effect> drift_not_checked, straightness_not_checked;
  // The ageing test that represents the design's years in service, and the years for which it stands.
  std::optional<conditions::Ageing> ageing_test = {};
  std::optional<double> ageing_stands_for_years;
  std::vector<DependenceRow> dependence;
  std::optional<MeanProperties> mean_properties = {};  // empty without a rule about it in a verified rule set
  std::vector<AtReferenceRow> at_reference;
  ConditionsPlan plan;
};

// A test that cannot be used is listed in `refused`. Throws Error if no test agrees with the reference, or if the tests
// differ in a condition that the reference does not state.
ConditionsResult build_conditions(campaign::ObservedTests const& observed, std::string title,
                                  campaign::Acceptance const& acceptance);

}  // namespace isolaw::study
