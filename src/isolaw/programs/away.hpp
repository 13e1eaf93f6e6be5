// Away from the cycle that was tested: a stand-in at smaller amplitudes and at another rate, the law beyond the tests,
// the step that a program needs, and two springs in place of one bearing. All on cycles from rest, the second of two at
// the same amplitude.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/programs/mapping.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {

// Force [kN] at the points of a history.
using ForceOf = std::function<std::vector<double>(History const&)>;

// A stand-in against the law, in percent of the law's: energy of the cycle and peak force. Empty: the law has none.
struct OtherCycle {
  double amplitude_share = 1.0, rate_share = 1.0;  // of what was tested
  std::optional<double> energy, peak;
  double largest() const;  // magnitude, in percent
};
// At a quarter, half, three quarters and the whole amplitude, and at the whole at half the rate where the law depends
// on it. A force that is no number gives infinity.
std::vector<OtherCycle> other_cycles(Subject const& subject, ForceOf const& stand_in);
std::string text(std::vector<OtherCycle> const& cycles);

// A re-fit that errs by more at one of them is marked, and one that errs by more than the second is far off.
inline constexpr double marked_percent = 10.0, other_cycle_far_off_percent = 30.0;
bool marked(std::vector<OtherCycle> const& cycles);

// What the law does at 1.25 and 1.5 times the tested displacement that an analysis should not meet: a peak force that
// falls, a stiffness below zero, a force that grows faster than the square, no force. A sentence each.
inline constexpr double beyond_times[] = {1.25, 1.5};
std::vector<std::string> beyond_the_tests(Subject const& subject, UnitSystem const& units);

// The fewest steps a cycle at which a form's energy is within so many percent of its own in steps of a 2,560th, of 20,
// 40, ..., 1280; and that energy's error. Empty: none of them.
inline constexpr double step_energy_percent = 1.0;
struct StepsNeeded {
  int per_cycle = 0;
  double energy = 0.0;
};
std::optional<StepsNeeded> steps_needed(Subject const& subject, Form const& form);

// Two springs at right angles on a circle of the tested amplitude: the largest force of both together over that of one
// along its axis, and the energy of a turn over pi/2 of one's cycle, which is what a coupled bearing of constant
// strength dissipates.
struct TwoSprings {
  double force = 0.0, energy = 0.0;
};
std::optional<TwoSprings> two_springs(Subject const& subject);

}  // namespace isolaw::programs
