// Which tests are missing until enough devices show every condition of the design.
#pragma once

#include <string_view>
#include <vector>

#include "isolaw/conditions/plan.hpp"

namespace isolaw::study {

struct ConditionsResult;

inline constexpr int usual_planned_devices = 2, most_planned_devices = 100;

enum class NoPlan {  // why no test can be named for an effect
  no_condition,      // the design does not state it
  no_reference,      // the reference does not state this condition
  no_energy,         // the design states years, and no activation energy is stated
  no_oven,           // the design states years, and no ageing test shows the temperature of the oven
  no_such_test,      // no test of this program shows the effect
};

std::string_view name(NoPlan why);

struct Unplanned {
  conditions::Effect effect;
  NoPlan why;
};

struct ConditionsPlan {
  int devices = usual_planned_devices;  // that shall show every end of the design
  std::vector<conditions::PlannedTest> tests = {};
  std::vector<Unplanned> unplanned = {};

  int turn_assumed_into_shown() const;  // the number of these tests
};

// The plan for so many devices. An end is shown if a test of K_eff agrees with it.
ConditionsPlan plan_tests(ConditionsResult const& result, int devices);

}  // namespace isolaw::study
