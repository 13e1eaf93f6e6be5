// Plans the tests that are missing until enough devices show every condition of the design.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/conditions/plan.hpp"

namespace isolaw::study {

struct ConditionsResult;

inline constexpr int usual_planned_devices = 2, most_planned_devices = 100;

enum class NoPlan {  // why no test can be planned for an effect
  no_condition,      // the design does not state the condition of the effect
  no_reference,      // the reference does not state this condition
  no_energy,         // the design states years in service, but no activation energy is stated
  no_oven,           // the design states years in service, but there is no ageing test whose oven could be planned
  no_such_test,      // isolaw knows no test that shows the effect
};

std::string_view name(NoPlan why);

struct Unplanned {
  conditions::Effect effect;
  NoPlan why;
};

struct ConditionsPlan {
  int devices = usual_planned_devices;  // number of devices that shall show every end of the design
  std::vector<conditions::PlannedTest> tests = {};
  std::vector<Unplanned> unplanned = {};

  int turn_assumed_into_shown() const;  // number of planned tests that show an end whose factor is now assumed
};

// Plans tests until every end of the design is shown on `devices` devices. An end counts as shown by tests that give
// K_eff there.
ConditionsPlan plan_tests(ConditionsResult const& result, int devices);

}  // namespace isolaw::study
