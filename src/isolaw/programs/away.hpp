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

// Force in kN.
using ForceOf = std::function<std::vector<double>(History const&)>;

// Differences in percent. Empty: the law's own value is not above 0 or not finite.
struct OtherCycle {
  double amplitude_share = 1.0, rate_share = 1.0;  // as shares of the tested values
  std::optional<double> energy, peak;
  double largest() const;  // magnitude, in percent
};
// At a quarter, half, three quarters and all of the tested amplitude, and if the law is rate dependent also at half the
// rate. A force that is no number gives infinity.
std::vector<OtherCycle> other_cycles(Subject const& subject, ForceOf const& stand_in);
std::string text(std::vector<OtherCycle> const& cycles);

// A re-fit that errs by more than the first limit at one of these cycles is marked, by more than the second far off.
inline constexpr double marked_percent = 10.0, other_cycle_far_off_percent = 30.0;
bool marked(std::vector<OtherCycle> const& cycles);

// A falling or steeply rising peak force, a stiffness below zero, a cycle that gives energy back, or no force.
inline constexpr double beyond_times[] = {1.25, 1.5};
std::vector<std::string> beyond_the_tests(Subject const& subject, UnitSystem const& units);

// The smallest of 20, 40, ..., 1280 steps a cycle whose energy agrees with that of 2560 steps, and its error in
// percent.
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
