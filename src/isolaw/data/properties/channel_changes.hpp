// Finds faults of a channel that leave a plausible loop: a gain that changes within the test or between the two
// directions, a zero that jumps, and an oscillation of one frequency, such as mains hum. docs/properties.md has the
// limits and rates of error.
#pragma once

#include <optional>
#include <span>

#include "isolaw/data/properties/properties.hpp"

namespace isolaw::data {

// A rise of the force, and so of the stiffness, between two cycles of the same amplitude without a rest between them.
struct StiffnessRise {
  int from_cycle = 0, cycle = 0;
  double share = 0.0;            // the rise divided by the force before it
  std::optional<double> sample;  // sample index at which the gain of the force changed, if it changed at once
};
std::optional<StiffnessRise> stiffness_rise(CycleView const& view, Block const& block);

// A difference between the forces of the two directions, while displacement is symmetric.
struct Asymmetry {
  double ratio = 1.0;       // forces for positive displacement / forces for negative displacement
  bool is_of_gain = false;  // a factor explains the difference three times as well as an offset does
};
std::optional<Asymmetry> asymmetry(CycleView const& view, Block const& block);

// A jump of a channel's zero. nullopt without a jump, or if the block is too short to distinguish a jump from a drift:
// it needs four counted cycles without rests.
struct OffsetStep {
  double jump = 0.0, sample = 0.0;  // the jump in the channel's unit, and its sample index
};
enum class LoopChannel { displacement, force };
std::optional<OffsetStep> offset_step(CycleView const& view, Block const& block, LoopChannel channel);

// An oscillation of one frequency besides the motion. It is a line in the spectrum of `values` over the block, at ten
// times the test's frequency or more. This line must be over four times as high as every line that is less than nine
// times the test's frequency away; the height of a line of lower frequency is first multiplied by the square of the
// ratio of the frequencies. nullopt without time, or if sampling is not uniform.
struct Hum {
  double amplitude = 0.0, frequency_Hz = 0.0;
  double rate_Hz = 0.0;            // samples a second
  std::optional<double> mains_Hz;  // frequency of the mains hum that samples at rate_Hz show at frequency_Hz (aliasing)
};
std::optional<Hum> hum(std::span<double const> values, CycleView const& view, Block const& block);

}  // namespace isolaw::data
