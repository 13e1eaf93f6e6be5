// Doubts about a certified value that the measurement itself causes: the value, and what it would be otherwise.
#pragma once

#include <string>
#include <vector>

#include "isolaw/study/results.hpp"

namespace isolaw::study {

struct ValueDoubt {
  std::string quantity;    // "damping", as rule sets name it
  double value = 0.0;      // as it is stated of the device
  double otherwise = 0.0;  // as it would be
  std::string unit;
  std::string condition;  // if: "the force channel is early"

  // "damping 18.5 %, or 12.2 % if the force channel is early"
  std::string text() const;
};

// From the effects of the error budget on damping: a late or early channel, the rig's friction. What moves a value by
// less than a fiftieth is no doubt of it.
std::vector<ValueDoubt> value_doubts(DeviceResult const& device);

inline constexpr Result<ValueDoubt> doubt_results[]{
    {"quantity", "", "", "whose value is in doubt: `\"damping\"`", get<&ValueDoubt::quantity>},
    {"value", own_unit, "", "as it is stated of the device", get<&ValueDoubt::value>},
    {"otherwise", own_unit, "", "what it would be", get<&ValueDoubt::otherwise>},
    {"unit", "", "", "of both", get<&ValueDoubt::unit>},
    {"condition", "", "", "if this is so", get<&ValueDoubt::condition>},
};

}  // namespace isolaw::study
