// Tests whether the laws of a campaign give plausible forces in the cycles of a building, within the tested
// displacements and up to those that the design asks for. A law whose forces are not plausible is not recommended.
// docs/decision.md has the limits.
#pragma once

#include "isolaw/campaign/contents.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Sets `beyond_tests`, `runs_away` and `faults_inside` of every law that was identified. A law runs away if it exceeds
// a limit with the lot's parameters. It also runs away if its fits to devices exceed a limit: with fewer than 20
// devices, one such fit is enough; with 20 or more, it takes more than 5 % of the fits.
void add_range_tests(Summary& summary, campaign::Contents const& contents);

inline constexpr double period_of_building_s = 2.0;
// The limits of (value at the displacement that the design asks for) / (value at the largest tested displacement).
inline constexpr double least_stiffness_ratio = 0.45, most_stiffness_ratio = 3.0;
inline constexpr double least_damping_ratio = 0.15, most_damping_ratio = 3.0;
inline constexpr double most_damping = 0.70;  // largest damping at the tested amplitude; a rectangular loop has 0.64
// The damping at the tested amplitude may be at most most_times_measured times the measured one plus
// damping_above_measured.
inline constexpr double most_times_measured = 1.5, damping_above_measured = 0.02;
inline constexpr double most_overshoot = 1.5;  // largest force / force at the peaks
inline constexpr double most_jump = 0.10;      // change of force between two of 4,000 samples / force at the peaks
// The damping at the building's speed may be at most this many times the damping at a tested speed, or the reverse.
inline constexpr double most_change_with_speed = 1.5;

}  // namespace isolaw::study
