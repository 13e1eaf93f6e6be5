// Assesses the tests of a lot against a rule set: it chooses the block of each record to assess, and tests whether
// every device and the lot keep the limits. Without a rule set it gives statistics of the third cycles and no verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/rules/assess.hpp"
#include "isolaw/rules/lot_view.hpp"

namespace isolaw::study {

struct AssessedTest {
  std::string device;
  data::Properties const* properties = nullptr;
  std::optional<double> rubber_thickness_mm = {}, rubber_area_mm2 = {};
  rules::VerticalValue vertical = {};
  std::string copy_of = {};  // the device with the same record that is assessed instead of this one; else empty
};

struct DeviceAcceptance {
  std::optional<int> block;   // the block that is assessed; empty if the record has no cyclic properties
  std::string choice;         // why this block was chosen
  std::string copy_of;        // the device with the same record that is assessed instead; else empty
  std::string withheld = {};  // why the device cannot pass: its test lost force, or the block is faulty; else empty
  bool as_corrected = false;  // the device passes, but would not without the corrections that the user asked for
  std::vector<rules::Assessment> assessments;
};

struct LotAcceptance {
  rules::RuleSet rules;  // its id is empty if no rule set was asked for
  rules::Design design;
  rules::LotView lot;
  bool conditions_forbid_mean = false;  // MeanProperties::permitted is false

  bool has_rules() const { return !rules.id.empty(); }
};

bool any_failed(std::vector<rules::Assessment> const& assessments);
// True if the sample size or a mean over the lot does not keep a limit of a verified rule set.
bool lot_failed(LotAcceptance const& acceptance);
// The third counted cycle of the block, or the last if there are fewer; nullptr without a counted cycle.
data::Cycle const* counting_cycle(data::Properties const& properties, std::optional<int> block);
std::optional<double> mean_load_kN(data::Block const& block);
// Fills `devices` with one entry for each test. Throws Error if `lot_size` is below the number of devices.
LotAcceptance assess_lot(rules::RuleSet const& rules, rules::Design const& design, std::optional<int> lot_size,
                         std::vector<AssessedTest> const& tests, std::vector<DeviceAcceptance>& devices,
                         campaign::Alike const& alike = {});

struct DesignValue {
  std::string name;
  double value = 0.0;
  std::string unit;
};
std::vector<DesignValue> design_values(rules::Design const& design);

// Whether a structure may be analysed with the lot's mean properties. Every quantity whose scatter the rule set limits
// must scatter little enough, and the design conditions must allow it too. K_v is not considered.
struct MeanAnalysis {
  std::optional<bool> permitted;  // empty: no verified rule set has a limit, or a quantity cannot be judged
  std::string sentence;
};
MeanAnalysis mean_analysis(LotAcceptance const& acceptance);

}  // namespace isolaw::study
