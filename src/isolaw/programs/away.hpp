// Checks away from the tested cycle: a stand-in at smaller amplitudes and at another rate, the law beyond the tests,
// the step that a program needs, and two springs in place of one bearing. Each looks at the second of two equal cycles
// from rest.
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

// How far a stand-in's cycle energy and peak force are from the law's, in percent. Empty: the law's own value is not
// above 0 or not finite.
struct OtherCycle {
  double amplitude_share = 1.0, rate_share = 1.0;  // of what was tested
  std::optional<double> energy, peak;
  double largest() const;  // magnitude, in percent
};
// Compares at a quarter, half, three quarters and the whole of the tested amplitude, and where the law depends on the
// rate also at the whole amplitude and half the rate. A force that is no number gives infinity.
std::vector<OtherCycle> other_cycles(Subject const& subject, ForceOf const& stand_in);
std::string text(std::vector<OtherCycle> const& cycles);

// A re-fit that errs by more than the first limit at one of these cycles is marked, by more than the second far off.
inline constexpr double marked_percent = 10.0, other_cycle_far_off_percent = 30.0;
bool marked(std::vector<OtherCycle> const& cycles);

// One sentence for each thing that an analysis should not meet at 1.25 or 1.5 times the tested displacement: a peak
// force that falls or grows faster than the square, a stiffness below zero, a cycle that gives energy back, no force.
inline constexpr double beyond_times[] = {1.25, 1.5};
std::vector<std::string> beyond_the_tests(Subject const& subject, UnitSystem const& units);

// The smallest of 20, 40, ..., 1280 steps a cycle whose energy is within step_energy_percent of that of the same form
// in 2560 steps, and the error of that energy in percent. Empty: none of them is.
inline constexpr double step_energy_percent = 1.0;
struct StepsNeeded {
  int per_cycle = 0;
  double energy = 0.0;
};
std::optional<StepsNeeded> steps_needed(Subject const& subject, Form const& form);

// Two springs at right angles on a circle of the tested amplitude. `force`: their largest joint force over the peak
// force of one spring along its axis. `energy`: that of a turn over pi/2 times that of one spring's cycle, which is
// what a coupled bearing of constant strength dissipates.
struct TwoSprings {
  double force = 0.0, energy = 0.0;
};
std::optional<TwoSprings> two_springs(Subject const& subject);

}  // namespace isolaw::programs
