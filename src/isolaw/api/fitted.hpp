// A law as a campaign fitted it, from the contents of the campaign's store.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/fit/as_springs.hpp"
#include "isolaw/study/ranges.hpp"

namespace isolaw {

struct FittedLaw {
  std::vector<double> parameters;  // in the law's order and units
  laws::Integration integration = laws::Integration::converged;
  laws::TurningPoints turning_points = laws::TurningPoints::as_sampled;
  int refinement = 1;                          // integration steps per sample in the fit
  double dead_band_mm = 0.0;                   // FitRecord::dead_band_mm; for a lot the largest of its devices
  study::Ranges ranges = {};                   // displacements and velocities of the records that it was fitted to
  std::optional<fit::AsSprings> springs = {};  // the fit as springs to the same records, if there is one
  std::string part = {};                       // the part of the tests that it was fitted to; empty: all
};

using campaign::whole_lot;

// The law of a device, from its best run, or of the lot if `device` is `whole_lot`. Throws Error if there is none.
FittedLaw fitted_law(campaign::Contents const& contents, std::string_view law, std::string_view device);

}  // namespace isolaw
