// Proposes for `isolaw init` which records are tests of one device under several conditions.
#pragma once

#include <string>
#include <vector>

#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/conditions/condition.hpp"

namespace isolaw::app {

struct RecognisedTest {             // a record as `isolaw init` has read it
  conditions::Condition condition;  // frequency and load as measured, temperature as its file states it
  double amplitude_mm = 0.0;
  int cycles = 0;  // number of counted cycles
};

// Adds to `remarks` the devices and conditions that the names of the records suggest, and reference conditions under
// which one of the tests was made. Adds nothing if no name suggests a condition, or if no two records belong to the
// same device. `tests` has an entry for each device of `lot`.
void propose_conditions(campaign::Lot const& lot, std::vector<RecognisedTest> tests, campaign::LotFileRemarks& remarks);

}  // namespace isolaw::app
