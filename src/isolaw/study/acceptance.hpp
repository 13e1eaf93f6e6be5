// The tests of a lot against a rule set: which block of each record counts, what the set says of every device and of
// the lot. Without a set the statistics of the third cycles are given, and no verdict.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/data/properties.hpp"
#include "isolaw/rules/assess.hpp"
#include "isolaw/rules/lot_view.hpp"

namespace isolaw::study {

// What a device is assessed by.
struct AssessedTest {
  std::string device;
  data::Properties const* properties = nullptr;
  std::optional<double> rubber_thickness_mm, rubber_area_mm2;
  rules::VerticalValue vertical = {};
  std::string copy_of = {};  // the device that this record is assessed for, where that is another
};

struct DeviceAcceptance {
  std::optional<int> block;  // the block that counts; empty where the record has no cyclic properties
  std::string choice;        // why this block
  std::string copy_of;       // the device that this record is assessed for; empty where that is this one
  std::vector<rules::Assessment> assessments;
};

struct LotAcceptance {
  rules::RuleSet rules;  // id is empty when none was asked for
  rules::Design design;
  rules::LotView lot;

  bool has_rules() const { return !rules.id.empty(); }
};

bool any_failed(std::vector<rules::Assessment> const& assessments);
// Some limit of a verified set is not kept by the lot.
bool lot_failed(LotAcceptance const& acceptance);

// The third cycle of that block that counts, or its last where there are fewer; nullptr where there is none.
data::Cycle const* counting_cycle(data::Properties const& properties, std::optional<int> block);

// Over the counted cycles; none without a load channel.
std::optional<double> mean_load_kN(data::Block const& block);

// `devices` receives one entry for each test. Throws Error: the lot is smaller than the number of devices.
LotAcceptance assess_lot(rules::RuleSet const& rules, rules::Design const& design, std::optional<int> lot_size,
                         std::vector<AssessedTest> const& tests, std::vector<DeviceAcceptance>& devices);

// The design values that were given, in the order of reports.
struct DesignValue {
  std::string name;
  double value = 0.0;
  std::string unit;
};
std::vector<DesignValue> design_values(rules::Design const& design);

// Whether the analysis may use mean properties, as far as the scatter of the lot goes: every quantity's answer in one.
struct MeanAnalysis {
  std::optional<bool> permitted;  // empty: no verified set says
  std::string sentence;
};
MeanAnalysis mean_analysis(rules::LotView const& lot);

}  // namespace isolaw::study
