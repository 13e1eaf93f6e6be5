// The value that a test made under other conditions would have had under reference conditions.
#pragma once

#include <optional>
#include <span>

#include "isolaw/conditions/combine.hpp"

namespace isolaw::conditions {

struct AtReference {
  std::optional<double> ln = {};          // natural logarithm of the value at reference; empty: see `obstacle`
  std::optional<double> half_width = {};  // half of this device's 95 % interval, in ln; empty if a factor has none
  std::optional<Effect> obstacle = {};    // the first effect whose factor is neither shown nor interpolated
};
// Divides a measured value by the factors of all conditions in which the test differs from the reference. A factor may
// be used only if devices were tested at its condition or on both sides of it. Any other factor is an obstacle.
AtReference at_reference(double ln_measured, std::span<Part const> factors);

}  // namespace isolaw::conditions
