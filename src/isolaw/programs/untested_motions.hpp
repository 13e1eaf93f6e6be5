// Checks an exported law on motions that differ from the tested cycle: a substitute at smaller amplitudes and another
// rate, the law at larger amplitudes, the exported commands in larger steps, and two springs in place of a bearing on a
// circle in plan. Each check drives two equal cycles from rest and uses the second.
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

// Differences of a substitute from the exported law in the energy and the peak force of one cycle, in percent of the
// law's value. A difference is empty if the law's value is not finite and above 0.
struct OtherCycle {
  double amplitude_share = 1.0, rate_share = 1.0;  // amplitude and rate as shares of the tested ones
  std::optional<double> energy, peak;
  double largest() const;  // the larger of |energy| and |peak|
};
// Compares the cycles of `stand_in` with the law's at a quarter, half, three quarters and all of the tested amplitude.
// A rate-dependent law is also compared at all of the amplitude and half the tested rate. A force of `stand_in` that is
// not finite gives an infinite difference.
std::vector<OtherCycle> other_cycles(Subject const& subject, ForceOf const& stand_in);
std::string text(std::vector<OtherCycle> const& cycles);

// A substitute that differs by more than the first percentage gets a warning. Beyond the second it is refused.
inline constexpr double warning_percent = 10.0, other_cycle_far_off_percent = 30.0;
bool needs_warning(std::vector<OtherCycle> const& cycles);

// Returns a sentence for each fault of the law at 1.25 and 1.5 times the tested amplitude: no finite force, a peak
// force that falls or rises steeply, a negative stiffness, or a cycle that returns energy.
inline constexpr double beyond_times[] = {1.25, 1.5};
std::vector<std::string> beyond_the_tests(Subject const& subject, UnitSystem const& units);

// The number of steps per cycle that the commands of `form` need: the smallest of 20, 40, ..., 1280 with which the
// energy of a cycle differs from that with 2560 steps by at most step_energy_percent. `energy` is this difference in
// percent.
inline constexpr double step_energy_percent = 1.0;
struct StepsNeeded {
  int per_cycle = 0;
  double energy = 0.0;
};
std::optional<StepsNeeded> steps_needed(Subject const& subject, Form const& form);

// Compares two springs at right angles, which move around a circle of the tested amplitude, with a single spring that
// moves along its axis at this amplitude. `force` is the largest resultant of the two springs, divided by the peak
// force of the single one. `energy` is the work of the two springs in one turn, divided by pi/2 times the work of the
// single one in a cycle. For a coupled bearing of constant strength, `energy` would be 1.
struct TwoSprings {
  double force = 0.0, energy = 0.0;
};
std::optional<TwoSprings> two_springs(Subject const& subject);

}  // namespace isolaw::programs
