// Doubts about the ground motions of a study and about its analyses.
#pragma once

#include <string>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

// Hardly any earthquake was recorded with a larger horizontal acceleration of the ground.
inline constexpr double largest_ground_g = 2.0;
// If the mean acceleration exceeds the first share of the peak acceleration, or the final velocity the second share of
// the largest velocity, the baseline of the record was not corrected.
inline constexpr double largest_mean_share = 0.02, largest_final_share = 0.5;
// The energy error of an analysis is the input energy minus all energy that is stored or dissipated, divided by the
// input energy or by the work on the bearings, whichever is larger. An analysis is doubted if the size of this error
// exceeds a limit. The first limit is for the implicit analyses of the nominal building. The second limit is for all
// runs of a study (of the nominal building, the bounds and the draws), which may be integrated explicitly.
inline constexpr double largest_energy_error = 1e-3, largest_energy_error_of_runs = 2e-3;
// An analysis is also doubted if the draws' integrator differs from the implicit one by more than the first of these
// limits, or if the base rotates by more than the second, since displacements are computed as for small rotations.
inline constexpr double largest_difference_percent = 1.0, largest_rotation_rad = 0.1;

// If the period of the building on its bearings is outside these limits, a mass may have the wrong unit or bearings may
// be missing.
inline constexpr double least_period_s = 0.3, most_period_s = 15.0;

// Findings about a ground motion: how it was changed when it was read, and the kinds ground_too_strong, ground_off_zero
// and ground_keeps_moving.
std::vector<Finding> motion_doubts(Motion const& motion);
// Doubts about the inputs of a study: those about its motions, and period_implausible for each law.
std::vector<Finding> study_doubts(Study const& study);
// Doubts about the implicit analysis of the nominal building with a law: displacement_beyond_tests if the run goes
// beyond `largest_test_mm` (0: not known), energy_error_large, rotation_large.
std::vector<Finding> run_doubts(Response const& run, std::string const& law, std::string const& motion,
                                double largest_test_mm);

}  // namespace isolaw::building
