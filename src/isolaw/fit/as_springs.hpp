// Fits a law in the form of springs around the circle, as it is used in two directions (laws/springs.hpp). With the
// law's own parameters springs keep its stiffness and strength along one direction but not its knee.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::fit {

struct AsSprings {
  std::vector<double> parameters;  // the springs', in the law's order and units
  // Eq. (27), or its mean over the records: for the law, springs with its parameters, and springs with `parameters`.
  double law = 0.0, given = 0.0, fitted = 0.0;
};

// Descends once from the law's `parameters` inside their box, on the record that they were fitted to. The motion is in
// the first spring's direction; integration is converged, reversals are at samples, with `refinement` steps a sample.
// Returns `parameters` themselves if the descent does not improve on them or springs with them have no finite force.
AsSprings fitted_as_springs(laws::LawEntry const& law, data::FitRecord const& record, SearchBox const& box,
                            std::vector<double> parameters, int refinement = 1);
AsSprings fitted_as_springs(laws::LawEntry const& law, std::span<data::FitRecord const* const> records,
                            SearchBox const& box, std::vector<double> parameters, int refinement = 1);

}  // namespace isolaw::fit
