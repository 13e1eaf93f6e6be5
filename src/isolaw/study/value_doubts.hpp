// Says where an error of the measurement puts a certified value in doubt, and what the value is without the error.
#pragma once

#include <string>
#include <vector>

#include "isolaw/study/results.hpp"

namespace isolaw::study {

struct ValueDoubt {
  std::string quantity;    // "damping", as rule sets name it
  double value = 0.0;      // the value that is stated for the device
  double otherwise = 0.0;  // the value if `condition` holds
  std::string unit;
  std::string condition;  // such as "the force channel is early"

  // "damping 18.5 %, or 12.2 % if the force channel is early"
  std::string text() const;
};

// Doubts about damping, from the error budget: a late or early force channel, a jump of the force, friction of the rig.
// An effect below a fiftieth of the value raises no doubt.
std::vector<ValueDoubt> value_doubts(DeviceResult const& device);

inline constexpr Result<ValueDoubt> doubt_results[]{
    {"quantity", "", "", "the property whose value is in doubt, such as `\"damping\"`", get<&ValueDoubt::quantity>},
    {"value", own_unit, "", "the value that the report states for the device", get<&ValueDoubt::value>},
    {"otherwise", own_unit, "", "the value that the device would have if `condition` were true",
     get<&ValueDoubt::otherwise>},
    {"unit", "", "", "unit of `value` and `otherwise`", get<&ValueDoubt::unit>},
    {"condition", "", "", "the error that may have changed the value, such as `\"the force channel is early\"`",
     get<&ValueDoubt::condition>},
};

}  // namespace isolaw::study
