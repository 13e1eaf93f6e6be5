// A law in online form computes one step at a time, as an analysis program needs it. It must give the forces of the
// batch form, which computes a whole record at once, and trial steps must not change its state.
#include "isolaw/laws/online/online.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "laws/single_laws.hpp"

namespace isolaw::online_test {
namespace {

struct Motion {
  std::vector<double> x, v;
};

Motion motion_of(laws::LawEntry const& law) {
  Motion motion;
  double const size = 100.0 / law.info.length.in_record_units;
  for (double const share : {0.3, 1.0, 0.6, 1.5})
    for (int i = 0; i < 100; ++i) {
      double const phase = 2.0 * std::numbers::pi * i / 100.0;
      double const x = share * size * std::sin(phase);
      motion.x.push_back(std::abs(x) < 1e-9 * size ? 0.0 : x);
      motion.v.push_back(share * size * 2.0 * std::numbers::pi * std::cos(phase));
    }
  return motion;
}

std::vector<double> parameters_of(laws::LawEntry const& law, double share) {
  laws::RecordScales const scales{.disp = 100.0 / law.info.length.in_record_units,
                                  .force = 100.0 / law.info.force.in_record_units,
                                  .stiffness = law.info.length.in_record_units / law.info.force.in_record_units,
                                  .strength = 30.0 / law.info.force.in_record_units,
                                  .velocity = 600.0 / law.info.length.in_record_units,
                                  .work = 1e5 / law.info.length.in_record_units / law.info.force.in_record_units};
  std::vector<double> parameters;
  for (auto const& p : law.parameters) {
    auto const box = p.scaled(scales);
    parameters.push_back(p.fixed_by_default.value_or(box.lower + share * (box.upper - box.lower)));
  }
  return parameters;
}

std::vector<double> offline(laws::LawEntry const& law, std::vector<double> const& parameters, Motion const& motion) {
  std::vector<double> force(motion.x.size());
  law.evaluate(parameters, laws::make_path(motion.x, motion.v), laws::Integration::converged, force);
  return force;
}

bool finite(std::vector<double> const& values) {
  for (double const value : values)
    if (!std::isfinite(value)) return false;
  return true;
}

class EveryLaw : public testing::TestWithParam<std::string> {};
std::vector<std::string> ids() {
  std::vector<std::string> names;
  for (auto const& law : laws::catalogue()) names.emplace_back(law.info.id);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Online, EveryLaw, testing::ValuesIn(ids()));

TEST_P(EveryLaw, gives_the_force_of_the_law) {
  auto const& law = laws::find_law(GetParam());
  auto const motion = motion_of(law);
  int compared = 0;
  for (double const share : {0.1, 0.35, 0.6}) {
    auto const parameters = parameters_of(law, share);
    auto const expected = offline(law, parameters, motion);
    if (!finite(expected)) continue;
    ++compared;
    double peak = 0.0;
    for (double const f : expected) peak = std::max(peak, std::abs(f));
    laws::Online online(law.info.id, parameters);
    for (std::size_t i = 0; i < motion.x.size(); ++i) {
      // A trial step that nobody commits must not change the state, and steps of a copy must not change the original.
      online.trial(-2.0 * motion.x[i], motion.v[i]);
      laws::Online copy = online;
      copy.trial(3.0 * motion.x[i], 0.0);
      copy.commit();
      auto const got = online.trial(motion.x[i], motion.v[i]);
      ASSERT_NEAR(got.force, expected[i], law_tests::form_tolerance(law) * peak) << share << " " << i;
      online.commit();
    }
  }
  EXPECT_GE(compared, 2);
}

TEST_P(EveryLaw, goes_a_step_in_parts_as_a_refined_path_does) {
  auto const& law = laws::find_law(GetParam());
  auto const motion = motion_of(law);
  auto const parameters = parameters_of(law, 0.35);
  std::vector<double> expected(motion.x.size());
  law.evaluate(parameters, laws::make_path(motion.x, motion.v, 3), laws::Integration::converged, expected);
  double peak = 0.0;
  for (double const f : expected) peak = std::max(peak, std::abs(f));
  laws::Online online(law.info.id, parameters, 0.0, 3);
  for (std::size_t i = 0; i < motion.x.size(); ++i) {
    ASSERT_NEAR(online.trial(motion.x[i], motion.v[i]).force, expected[i], law_tests::form_tolerance(law) * peak) << i;
    online.commit();
  }
}

TEST_P(EveryLaw, lists_as_many_numbers_of_every_committed_state) {
  auto const& law = laws::find_law(GetParam());
  auto const motion = motion_of(law);
  laws::Online online(law.info.id, parameters_of(law, 0.35));
  auto const size = online.state().size();
  double peak = 0.0;
  for (std::size_t i = 0; i < motion.x.size(); ++i) {
    double const x = motion.x[i];
    auto const before = online.state();
    online.trial(2.0 * x, motion.v[i]);
    online.trial(x, motion.v[i]);
    ASSERT_EQ(online.state(), before);
    online.commit();
    peak = std::max(peak, std::abs(x));
    auto const state = online.state();
    ASSERT_EQ(state.size(), size);
    ASSERT_EQ(state[size - 4], x);
    ASSERT_EQ(state[size - 3], motion.v[i]);
    ASSERT_EQ(state[size - 1], peak);
  }
}

TEST(Online, state_holds_the_law_s_variable_and_the_open_turning_points) {
  laws::Online bilinear("bilinear", std::vector{2.0, 1.0, 10.0});  // K1, K2, xy
  bilinear.trial(30.0, 0.0);
  bilinear.commit();
  EXPECT_EQ(bilinear.state(), (std::vector{10.0, 30.0, 0.0, 1.0, 30.0}));  // z = (K1 - K2) xy, then the motion
  // From its sixth number on, the state holds the displacement without movements in the dead band, the last direction,
  // the number of open turning points and the last of them, and the motion: displacement, velocity, direction and peak.
  laws::Online remembering("ramberg-osgood", parameters_of(laws::find_law("ramberg-osgood"), 0.35));
  for (double const x : {30.0, -20.0, 10.0}) {
    remembering.trial(x, 0.0);
    remembering.commit();
  }
  auto const state = remembering.state();
  ASSERT_EQ(state.size(), 13U);
  EXPECT_EQ((std::vector(state.begin() + 5, state.end())), (std::vector{10.0, 1.0, 2.0, -20.0, 10.0, 0.0, 1.0, 30.0}));
}

TEST(Online, follows_with_the_dead_band_of_the_record) {
  auto const& law = laws::find_law("power-masing");
  auto const parameters = parameters_of(law, 0.35);
  auto const motion = motion_of(law);
  auto const expected = offline(law, parameters, {laws::followed(motion.x, 2.0), motion.v});
  laws::Online online(law.info.id, parameters, 2.0), without(law.info.id, parameters);
  double away = 0.0;
  for (std::size_t i = 0; i < motion.x.size(); ++i) {
    ASSERT_NEAR(online.trial(motion.x[i], motion.v[i]).force, expected[i], 1e-7 * 100.0) << i;
    away = std::max(away, std::abs(without.trial(motion.x[i], motion.v[i]).force - expected[i]));
    online.commit();
    without.commit();
  }
  EXPECT_GT(away, 0.1);
}

// Within the dead band the force rests. The tangent must nevertheless be the slope of the force for the motion that
// leaves the band, at the start and after a turn, so that the matrix of an analysis is not singular.
TEST_P(EveryLaw, has_within_the_dead_band_the_slope_with_which_the_motion_leaves_it) {
  auto const& law = laws::find_law(GetParam());
  double const size = 100.0 / law.info.length.in_record_units, band = 0.005 * size;
  int compared = 0;
  for (double const share : {0.1, 0.35, 0.6}) {
    laws::Online online(law.info.id, parameters_of(law, share), band);
    double const first = online.trial(0.0, 0.0).by_x;
    EXPECT_NE(first, 0.0) << share;
    if (!law.info.traits.remembers) continue;
    EXPECT_GT(first, 0.0) << share;
    for (double const to : {0.0, 0.5 * size, size, -0.7 * size}) {
      for (int part = 1; part <= 50; ++part) {
        online.trial(0.02 * part * to, 0.0);
        if (to != 0.0) online.commit();
      }
      // The motion turns within the band. It leaves the band at twice `band` from the turn, or `band` from the start.
      double const back = to > 0.0 ? -1.0 : 1.0, edge = to + (to == 0.0 ? 1.0 : 2.0) * back * band;
      auto const resting = online.trial(to, 0.0), turned = online.trial(to + 0.3 * back * band, 0.0);
      auto const left = online.trial(edge + 0.1 * back * band, 0.0);
      EXPECT_EQ(turned.force, resting.force) << share << " " << to;
      EXPECT_NEAR(turned.by_x, left.by_x, 1e-6 * std::abs(left.by_x)) << share << " " << to;
      EXPECT_NE(turned.by_x, 0.0) << share << " " << to;
      // Only two laws are compared with their slope. The slope of the others has no bound there, so isolaw limits their
      // tangent.
      if (law.info.id != "gallardo" && law.info.id != "ramberg-osgood") continue;
      double const h = 1e-4 * band;
      auto const at = [&](double x) { return online.trial(x, 0.0).force; };
      double const slope = (at(edge + 0.1 * back * band + h) - at(edge + 0.1 * back * band - h)) / (2.0 * h);
      EXPECT_NEAR(turned.by_x, slope, 1e-3 * std::abs(slope)) << share << " " << to;
      ++compared;
    }
  }
  if (law.info.id == "gallardo" || law.info.id == "ramberg-osgood") {
    EXPECT_EQ(compared, 12);
  }
}

TEST(Online, an_unknown_law_is_refused) {
  EXPECT_THROW(laws::Online("no-law", std::vector<double>{}), Error);
}

}  // namespace
}  // namespace isolaw::online_test
