// Fits a law in its form for motions in two directions: equal springs around a circle that each follow the law (see
// laws/plane/springs.hpp). Springs with the law's own parameters have the law's stiffness and strength along a line,
// but the knee of their loop has another shape.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::fit {

struct SpringsFit {
  std::vector<double> parameters;  // the law's parameters in every spring, in the law's order and units
  // Objectives as in LawOnRecord, averaged over the records: `law` is that of the law itself, `given` that of springs
  // with the law's own parameters, and `fitted` that of springs with `parameters`.
  double law = 0.0, given = 0.0, fitted = 0.0;
};

// Fits springs to the record inside the box, by one descent that starts from `parameters`, the law's own fit to this
// record. The motion is along the first spring. Uses converged integration with `refinement` steps per sample. Returns
// `parameters` unchanged if the descent finds nothing better or if such springs have no finite force.
SpringsFit fitted_as_springs(laws::LawEntry const& law, data::FitRecord const& record, SearchBox const& box,
                             std::vector<double> parameters, int refinement = 1);
SpringsFit fitted_as_springs(laws::LawEntry const& law, std::span<data::FitRecord const* const> records,
                             SearchBox const& box, std::vector<double> parameters, int refinement = 1);

}  // namespace isolaw::fit
