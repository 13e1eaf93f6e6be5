// Gives parameters with which tests can export any law.
#pragma once

#include "isolaw/fit/box.hpp"
#include "unit/programs_fixture.hpp"

namespace isolaw::programs_test {

// Returns parameters inside the box in which a fit to a record of 150 mm would search. `share`, from 0 to 1, chooses
// the point.
inline std::vector<double> inside_box(laws::LawEntry const& law, double share) {
  data::FitRecord record;
  auto const history = cycles({50.0, 150.0}, 200);
  auto const force = law_force(laws::find_law("bilinear"), bilinear_parameters, history);
  record.time_s = history.time_s;
  record.disp_mm = history.disp_mm;
  record.vel_mm_s = history.vel_mm_s;
  record.force_kN = force;
  auto const box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(record, law.info), {});
  std::vector<double> point(box.free_count()), values(law.parameters.size());
  for (std::size_t i = 0; i < point.size(); ++i)
    point[i] = std::fmod(share + 0.31 * static_cast<double>(i), 1.0) * 0.6 + 0.2;
  box.expand(point, values);
  return values;
}

}  // namespace isolaw::programs_test
