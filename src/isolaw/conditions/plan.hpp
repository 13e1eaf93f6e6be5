// Plans the tests that are missing until enough devices show every condition of the design.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/conditions/contrast.hpp"

namespace isolaw::conditions {

struct Candidate {  // a device that can be tested again
  std::string device;
  bool has_reference = false;       // the device has a reference test with which its new tests can be compared
  bool was_new = false;             // the device had not been stretched before its first reference test
  std::optional<Ageing> aged = {};  // the device's ageing so far, which cannot be undone
};

// One end of the design range of an effect.
struct DesignEnd {
  Effect effect = Effect::temperature;
  Condition condition = {};  // of a test that shows this end; it differs from the reference only in this effect
  int cycles = 3;            // least number of cycles of such a test
  std::optional<double> rest_h = {};    // rest before such a test, if the effect is the recovery at rest
  Status status = Status::not_covered;  // present status, which rests on `devices` devices
  int devices = 0;
  std::vector<std::string> shown_on = {}, tested = {};  // devices that show this end; those with any test of the effect
  // Devices that were tested at this end and have no reference test, but could still get one that is comparable.
  std::vector<std::string> without_reference = {};
};

struct PlannedTest {
  std::string device;
  bool is_new = false;                  // the device is not from the lot, but a new one of the same type
  bool is_reference = false;            // a reference test, without which the device's other tests cannot be compared
  Effect effect = Effect::temperature;  // the effect that the test helps to show
  Condition condition = {};
  int cycles = 3;                     // least number of cycles
  std::optional<double> rest_h = {};  // rest before the test; empty: any
  // Status of the end of the design before and after the planned test, and the numbers of devices that it rests on.
  Status before = Status::not_covered, after = Status::shown;
  int devices_before = 0, devices_after = 0;
};

// Lists tests until every end of the design is shown on `devices` devices. For each end it takes devices that do not
// show it yet: first those with a reference test, then those that need one too, in both groups first those with tests
// of this effect. Last come new devices, which are called "new 1", "new 2". The candidates are in the order of the lot
// file. An aged device is taken only for a longer ageing in the same oven.
std::vector<PlannedTest> plan(std::span<DesignEnd const> ends, std::vector<Candidate> candidates, int devices,
                              Condition const& reference, int reference_cycles);

}  // namespace isolaw::conditions
