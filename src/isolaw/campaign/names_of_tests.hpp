// Reads the conditions of tests from the names of their records, such as P1_T-20C_0.1Hz_2000kN_aged. A name can
// mislead, so these conditions are only proposed to the user.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isolaw::campaign {

struct ProposedTest {
  std::string device;  // the name up to the first condition in it; the whole name if it has none
  std::optional<double> temperature_C, load_kN;
  bool is_aged = false, is_virgin = false;
  bool lacks_load = false;         // the reference has a vertical load, but neither name nor record states this test's
  bool is_near_reference = false;  // its temperature agrees with that of the reference
};

// Returns a proposal for each name. The names together decide what a dash in front of a number means. A temperature is
// left out if it may have the other sign ("P1-20C" alone), if the name has two, or if it follows the word "aged",
// because it may be that of the oven.
std::vector<ProposedTest> propose_tests(std::span<std::string const> names);

}  // namespace isolaw::campaign
