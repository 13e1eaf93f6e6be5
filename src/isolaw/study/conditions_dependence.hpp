// Judges the devices of a lot by a rule set's limits on how far properties may change with conditions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "isolaw/conditions/dependence.hpp"
#include "isolaw/rules/measured.hpp"

namespace isolaw::study {

struct ConditionsResult;

struct DependenceRow {
  rules::DependenceLimit limit;
  // True if the limit is on the difference between the values at the least and the largest load of the design, in
  // percent of the value at reference (rules::LoadVariation). The ratio of a device is then 1 plus this difference.
  bool is_load_variation = false;
  std::vector<conditions::DeviceDependence> devices = {};

  // The verdict on all devices: fail if one fails; else "not assessed" if one is not assessed; else information if the
  // set is not verified; else pass.
  rules::Verdict verdict() const;
  // Among the devices that were assessed, the one whose ratio is farthest from 1; nullptr if none was assessed.
  conditions::DeviceDependence const* worst() const;
};

// `result` must already hold its responses, its design and its tests.
std::vector<DependenceRow> judge_dependence(ConditionsResult const& result, rules::RuleSet const& rules,
                                            rules::Design const& design);

// True if a limit of a verified rule set is not kept. The commands `conditions`, `inspect` and `calibrate` set their
// exit code by this result.
bool dependence_failed(ConditionsResult const& result);

}  // namespace isolaw::study
