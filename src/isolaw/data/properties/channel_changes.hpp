// Finds faults of a channel that leave a plausible loop: a gain that changes within the test or between the two
// directions, a zero that jumps, and an oscillation of one frequency, such as mains hum. docs/properties.md has the
// limits and rates of error.
#pragma once

#include <optional>
#include <span>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// The force, and with it the stiffness, rises between two cycles of one amplitude that no rest separates.
struct StiffnessRise {
  int from_cycle = 0, cycle = 0;
  double share = 0.0;        // rise over the force before
  std::optional<double> at;  // sample index at which the gain of the force changed, if it changed at once
};
std::optional<StiffnessRise> stiffness_rise(CycleView const& view, Block const& block);

// The forces of the two directions differ by a factor, and displacement does not.
struct Asymmetry {
  double ratio = 1.0;       // forces for positive displacement over those for negative displacement
  bool is_of_gain = false;  // the factor explains the difference three times as well as an offset does
};
std::optional<Asymmetry> asymmetry(CycleView const& view, Block const& block);

// A jump of a channel's zero at a sample index. nullopt without a jump, or if the block is too short to tell it from a
// drift: it needs four counted cycles without rests.
struct OffsetStep {
  double by = 0.0, at = 0.0;
};
enum class Along { displacement, force };
std::optional<OffsetStep> offset_step(CycleView const& view, Block const& block, Along channel);

// An oscillation of one frequency besides the motion: a line in the spectrum of `values` over the block. It must be
// four times as large as all lines within nine times the test's frequency of it, and lie above ten times the test's
// frequency. nullopt without time, or if sampling is not uniform.
struct Hum {
  double amplitude = 0.0, frequency_Hz = 0.0;
  double rate_Hz = 0.0;            // samples a second
  std::optional<double> mains_Hz;  // frequency of the mains hum that samples at rate_Hz show at frequency_Hz (aliasing)
};
std::optional<Hum> hum(std::span<double const> values, CycleView const& view, Block const& block);

}  // namespace isolaw::data
