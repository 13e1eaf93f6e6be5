// Doubts about the ground motions of a study and about its analyses.
#pragma once

#include <string>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

// Hardly any earthquake was recorded with a larger horizontal acceleration of the ground.
inline constexpr double largest_ground_g = 2.0;
// A mean acceleration beyond this share of the peak, or a final velocity beyond this share of the largest one, shows
// that a baseline was not corrected.
inline constexpr double largest_mean_share = 0.02, largest_final_share = 0.5;
// Limits beyond which an analysis is doubted, in this order: the error of the energy balance in the implicit analysis
// of the nominal building, and in any run; the difference of the draws' integrator from the implicit one in percent;
// and the rotation of the base, since displacements are computed as for small rotations.
inline constexpr double largest_energy_error = 1e-3, largest_energy_error_of_runs = 2e-3;
inline constexpr double largest_difference_percent = 1.0, largest_rotation_rad = 0.1;

// If the period of the building on its bearings is outside these limits, a mass may have the wrong unit or bearings may
// be missing.
inline constexpr double least_period_s = 0.3, most_period_s = 15.0;

// How a ground motion was changed when it was read, and doubts about it: ground_too_strong, ground_off_zero,
// ground_keeps_moving.
std::vector<Finding> motion_doubts(Motion const& motion);
// Doubts about the inputs of a study: those about its motions, and period_implausible for each law.
std::vector<Finding> study_doubts(Study const& study);
// Doubts about the implicit analysis of the nominal building with a law: displacement_beyond_tests if `tested_mm` is
// above 0 and the run goes beyond it, energy_error_large, rotation_large.
std::vector<Finding> run_doubts(Response const& run, std::string const& law, std::string const& motion,
                                double tested_mm);

}  // namespace isolaw::building
