// Checks an export away from the tested cycle: a substitute law at smaller amplitudes and another rate; the law beyond
// the tests; the time step that a program needs; two springs instead of one bearing. Every check uses the second of two
// equal cycles from rest.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/programs/mapping.hpp"
#include "isolaw/programs/subject.hpp"

namespace isolaw::programs {

// Computes the force in kN at all points of a history.
using ForceOf = std::function<std::vector<double>(History const&)>;

// Differences in percent. Empty if the law's own value is not above 0 or not finite.
struct OtherCycle {
  double amplitude_share = 1.0, rate_share = 1.0;  // as shares of the tested amplitude and rate
  std::optional<double> energy, peak;
  double largest() const;  // the larger of |energy| and |peak|
};
// Compares cycles of a quarter, half, three quarters and all of the tested amplitude; for a rate-dependent law also one
// at half the rate. A force that is NaN gives an infinite difference.
std::vector<OtherCycle> other_cycles(Subject const& subject, ForceOf const& stand_in);
std::string text(std::vector<OtherCycle> const& cycles);

// Limits for the largest difference of a substitute: beyond the first it is marked, beyond the second it is far off.
inline constexpr double marked_percent = 10.0, other_cycle_far_off_percent = 30.0;
bool marked(std::vector<OtherCycle> const& cycles);

// Reports a peak force that falls or rises steeply, a negative stiffness, a cycle that returns energy, or no force.
inline constexpr double beyond_times[] = {1.25, 1.5};
std::vector<std::string> beyond_the_tests(Subject const& subject, UnitSystem const& units);

// The smallest of 20, 40, ..., 1280 steps per cycle whose energy agrees with that of 2560 steps within
// step_energy_percent, and its error in percent.
inline constexpr double step_energy_percent = 1.0;
struct StepsNeeded {
  int per_cycle = 0;
  double energy = 0.0;
};
std::optional<StepsNeeded> steps_needed(Subject const& subject, Form const& form);

// Two springs at right angles, moved around a circle of the tested amplitude. `force` is their largest resultant / the
// peak force of one spring along its axis. `energy` is their work in a turn / (pi/2 * the work of one spring in a
// cycle), where the divisor is the work of a coupled bearing of constant strength.
struct TwoSprings {
  double force = 0.0, energy = 0.0;
};
std::optional<TwoSprings> two_springs(Subject const& subject);

}  // namespace isolaw::programs
