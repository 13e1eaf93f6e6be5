// A law as a campaign fitted it, taken from what its store holds.
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
  int refinement = 1;                          // steps per sample that the law was integrated in
  double dead_band_mm = 0.0;                   // FitRecord::dead_band_mm; of a lot the largest
  study::Ranges ranges = {};                   // of the records that it was fitted to
  std::optional<fit::AsSprings> springs = {};  // of the same, where the campaign fitted it as springs too
  std::string part = {};                       // of the tests that it was fitted to alone; empty: all
};

using campaign::whole_lot;

// The law of one device (its best run), or with `whole_lot` the one law for all. Throws Error that says what there is.
FittedLaw fitted_law(campaign::Contents const& contents, std::string_view law, std::string_view device);

}  // namespace isolaw
