// Checks away from the tested cycle: a law that stands in for the exported one, at smaller amplitudes and another rate;
// the law beyond the tests; the step that a program needs; and two springs in place of one bearing. Each check uses the
// second of two equal cycles from rest.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/programs/mapping.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {

// Returns the force in kN.
using ForceOf = std::function<std::vector<double>(History const&)>;

// Differences in percent. Empty if the law's own value is not above 0 or not finite.
struct OtherCycle {
  double amplitude_share = 1.0, rate_share = 1.0;  // as shares of the tested values
  std::optional<double> energy, peak;
  double largest() const;  // magnitude, in percent
};
// The cycles have a quarter, half, three quarters and all of the tested amplitude and, if the law is rate dependent,
// also half the rate. A force that is NaN gives an infinite difference.
std::vector<OtherCycle> other_cycles(Subject const& subject, ForceOf const& stand_in);
std::string text(std::vector<OtherCycle> const& cycles);

// A re-fit is marked if it errs by more than the first limit at one of these cycles, and far off beyond the second.
inline constexpr double marked_percent = 10.0, other_cycle_far_off_percent = 30.0;
bool marked(std::vector<OtherCycle> const& cycles);

// Reports a falling or steeply rising peak force, a stiffness below zero, a cycle that gives energy back, or no force.
inline constexpr double beyond_times[] = {1.25, 1.5};
std::vector<std::string> beyond_the_tests(Subject const& subject, UnitSystem const& units);

// The smallest of 20, 40, ..., 1280 steps a cycle whose energy agrees with the energy at 2560 steps, and its error in
// percent.
inline constexpr double step_energy_percent = 1.0;
struct StepsNeeded {
  int per_cycle = 0;
  double energy = 0.0;
};
std::optional<StepsNeeded> steps_needed(Subject const& subject, Form const& form);

// Two springs at right angles on a circle of the tested amplitude. `force`: their largest resultant over the peak force
// of one spring along its axis. `energy`: their work in a turn over pi/2 times the work of one spring in a cycle, which
// is the energy that a coupled bearing of constant strength dissipates.
struct TwoSprings {
  double force = 0.0, energy = 0.0;
};
std::optional<TwoSprings> two_springs(Subject const& subject);

}  // namespace isolaw::programs
