// Reads the conditions of tests from the names of their records, such as P1_T-20C_0.1Hz_2000kN_aged. A name can
// mislead, so these conditions are only proposed to the user.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace isolaw::campaign {

struct ProposedTest {
  std::string device;  // the name up to the first condition; the whole name if it states none
  std::optional<double> temperature_C, load_kN;
  bool is_aged = false, is_virgin = false;
  bool lacks_load = false;         // the reference condition has a load, but neither name nor record states one
  bool is_near_reference = false;  // its temperature agrees with the reference temperature
};

// Returns a proposal for each name. All names together decide what a dash in front of a number means. A temperature is
// left out if its sign is not clear ("P1-20C" alone), if the name has two temperatures, or if the word "aged" comes
// before it, because it may then be the temperature of the oven.
std::vector<ProposedTest> propose_tests(std::span<std::string const> names);

}  // namespace isolaw::campaign
