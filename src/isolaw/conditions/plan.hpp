// Which tests are missing until enough devices show every condition of the design.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/conditions/contrast.hpp"

namespace isolaw::conditions {

struct Candidate {  // a device that can be tested again
  std::string device;
  bool has_reference = false;       // it has a reference test with which a new test of it can be compared
  bool was_new = false;             // in its first reference test it had not been stretched before
  std::optional<Ageing> aged = {};  // so far; ageing cannot be undone
};

// One end of the design range of an effect.
struct DesignEnd {
  Effect effect = Effect::temperature;
  Condition condition = {};             // of a test that shows it: at reference in all but this effect
  int cycles = 3;                       // of this test, at least
  std::optional<double> rest_h = {};    // before this test, if the effect is what comes back in such a rest
  Status status = Status::not_covered;  // now, and the number of devices behind it
  int devices = 0;
  std::vector<std::string> shown_on = {}, tested = {};  // devices that show it, and those with any test of the effect
  // Devices that were tested there and have no reference test, but could have one that is comparable.
  std::vector<std::string> without_reference = {};
};

struct PlannedTest {
  std::string device;
  bool is_new = false;                  // the device is not one of the lot: one of the same type that was never tested
  bool is_reference = false;            // a reference test, without which the device's other tests cannot be compared
  Effect effect = Effect::temperature;  // that the test helps to show
  Condition condition = {};
  int cycles = 3;                                              // at least
  std::optional<double> rest_h = {};                           // before the test; empty: any
  Status before = Status::not_covered, after = Status::shown;  // of the end of the design, with the devices behind them
  int devices_before = 0, devices_after = 0;
};

// Every end shall be shown on so many devices. The tests of the devices that do not show it yet are listed until it is:
// first of devices with tests of this effect, then of others with a reference test, then of those that need a reference
// test too, then of new devices, which are called "new 1", "new 2". The candidates are in the order of the file. A
// device that was aged is taken only for a longer ageing in the same oven.
std::vector<PlannedTest> plan(std::span<DesignEnd const> ends, std::vector<Candidate> candidates, int devices,
                              Condition const& reference, int reference_cycles);

}  // namespace isolaw::conditions
