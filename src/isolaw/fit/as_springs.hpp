// A law fitted as it is wrapped: springs around the circle keep its stiffness and strength along one direction, not its
// knee (laws/springs.hpp), so that the parameters of the law itself are not theirs.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/record.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::fit {

struct AsSprings {
  std::vector<double> parameters;
  // Eq. (27) on the record, or its mean over the records: of the law by itself, of springs of the same parameters, and
  // of springs with their own.
  double law = 0.0, given = 0.0, fitted = 0.0;
};

// One descent from `parameters` within their box, on the record that they were fitted to. Springs are along one
// direction, in the first one's; converged integration, turning at samples, `refinement` steps a sample. Where springs
// have no finite force with these parameters, these come back.
AsSprings fitted_as_springs(laws::LawEntry const& law, data::FitRecord const& record, SearchBox const& box,
                            std::vector<double> parameters, int refinement = 1);
// One set of parameters for the records of several devices.
AsSprings fitted_as_springs(laws::LawEntry const& law, std::span<data::FitRecord const* const> records,
                            SearchBox const& box, std::vector<double> parameters, int refinement = 1);

}  // namespace isolaw::fit
