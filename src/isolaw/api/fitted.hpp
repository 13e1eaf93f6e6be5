// Finds a law as it was fitted in a campaign.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/fit/as_springs.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/study/ranges.hpp"

namespace isolaw {

struct FittedLaw {
  std::vector<double> parameters;  // in the law's order and units
  laws::Integration integration = laws::Integration::converged;
  laws::TurningPoints turning_points = laws::TurningPoints::as_sampled;
  int refinement = 1;                           // integration steps per sample that the fit used
  double dead_band_mm = 0.0;                    // FitRecord::dead_band_mm of the device; for a lot, the largest one
  study::Ranges ranges = {};                    // displacements and velocities in the records of the fit
  std::optional<fit::SpringsFit> springs = {};  // the law fitted as springs around a circle to the same records
  std::string part = {};                        // the part of the tests that the law was fitted to; empty for all
};

using campaign::whole_lot;

// Returns the law as the best run fitted it to a device, or as it was fitted to the lot if `device` is `whole_lot`.
// Throws Error if there is no such fit.
FittedLaw fitted_law(campaign::Contents const& contents, std::string_view law, std::string_view device);
// Returns sentences about displacements and velocities of a motion beyond those of the fit or of the tests.
std::vector<std::string> beyond_what_is_known(laws::LawEntry const& law, FittedLaw const& as_fitted,
                                              data::FitRecord const& motion);
// As beyond_what_is_known(), with a sentence about a motion that does not start at zero.
std::vector<std::string> cautions(laws::LawEntry const& law, FittedLaw const& as_fitted, data::FitRecord const& motion);

}  // namespace isolaw
