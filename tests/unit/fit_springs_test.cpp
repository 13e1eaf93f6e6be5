// For motions in two directions, a law acts as springs in directions all around the circle. If these springs have the
// law's own parameters, the knee of the loop, where the device yields, becomes rounder. Parameters that are fitted to
// the springs must bring the loop back near the record.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "isolaw/fit/as_springs.hpp"
#include "isolaw/fit/in_plane.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::fit {
namespace {

data::FitRecord cycles() {
  data::FitRecord record;
  for (int i = 0; i <= 400; ++i) {
    double const t = 0.01 * i, size = i < 200 ? 50.0 : 120.0;
    record.time_s.push_back(t);
    record.disp_mm.push_back(size * std::sin(std::numbers::pi * t));
    record.vel_mm_s.push_back(size * std::numbers::pi * std::cos(std::numbers::pi * t));
  }
  return record;
}

TEST(FitSprings, find_the_knee_that_they_lose) {
  for (auto const* id : {"bilinear", "bouc-wen", "vaiana"}) {
    auto const& law = laws::find_law(id);
    auto record = cycles();
    std::vector<double> const parameters =
        law.info.id == "bilinear" ? std::vector{6.0, 0.9, 30.0 / 5.1}
        : law.info.id == "bouc-wen"
            ? std::vector{0.15, 6.0, 1.0, 0.08, 1.2, 0.08}
            : std::vector{9e5, 8e5, 3e4, 2.5e4, 60.0, 50.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    record.force_kN = LawOnMotion(law, record, laws::Integration::converged).force_kN(parameters);
    auto const box = make_box(law, BoxKind::scaled, scales_of(record, law.info), {});
    auto const springs = fitted_as_springs(law, record, box, parameters);
    EXPECT_LT(springs.law, 1e-12) << id;
    EXPECT_GT(springs.given, 0.004) << id;
    // The three parameters of bilinear cannot undo the rounding of the knee.
    EXPECT_LE(springs.fitted, (law.info.id == "bilinear" ? 1.0 : 0.6) * springs.given) << id;
    // The objective stated for the springs must be the one that they give when evaluated step by step, in motion along
    // the first spring.
    auto online = LawInPlane{&law, springs.parameters}.form(laws::Bidirectional::springs, {});
    PlaneMotion motion{.time_s = record.time_s, .disp_mm = {}, .vel_mm_s = {}};
    for (std::size_t i = 0; i < record.size(); ++i) {
      motion.disp_mm.push_back({record.disp_mm[i], 0.0});
      motion.vel_mm_s.push_back({record.vel_mm_s[i], 0.0});
    }
    auto const force = force_kN(law, online, motion);
    std::vector<double> along;
    for (auto const& f : force) {
      along.push_back(f.x);
      if (law.info.traits.odd) {
        EXPECT_NEAR(f.y, 0.0, 1e-9);
      }
    }
    EXPECT_NEAR(objective_on(record, along, {}), springs.fitted, 1e-6) << id;
  }
}

// The springs of a lot have one set of parameters for all its records. If the records are equal, the springs must fit
// as well as those of a single record. If the records differ, the parameters must be a compromise between them.
TEST(FitSprings, of_a_lot_are_fitted_to_all_its_records) {
  auto const& law = laws::find_law("bouc-wen");
  std::vector<double> const parameters{0.15, 6.0, 1.0, 0.08, 1.2, 0.08}, stiffer{0.15, 6.6, 1.0, 0.08, 1.2, 0.08};
  auto soft = cycles(), stiff = cycles();
  soft.force_kN = LawOnMotion(law, soft, laws::Integration::converged).force_kN(parameters);
  stiff.force_kN = LawOnMotion(law, stiff, laws::Integration::converged).force_kN(stiffer);
  auto const box = make_box(law, BoxKind::scaled, scales_of(soft, law.info), {});
  data::FitRecord const* const twice[]{&soft, &soft};
  data::FitRecord const* const both[]{&soft, &stiff};
  auto const one = fitted_as_springs(law, soft, box, parameters), same = fitted_as_springs(law, twice, box, parameters),
             lot = fitted_as_springs(law, both, box, parameters);
  EXPECT_NEAR(same.given, one.given, 1e-12);
  EXPECT_NEAR(same.fitted, one.fitted, 1e-4);
  EXPECT_LT(lot.fitted, lot.given);
  EXPECT_NEAR(lot.given, 0.5 * (one.given + fitted_as_springs(law, stiff, box, parameters).given), 1e-12);
  EXPECT_GT(lot.parameters[1], one.parameters[1]);
}

}  // namespace
}  // namespace isolaw::fit
