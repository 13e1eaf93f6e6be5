// Tests the implicit integration of a building. The results must not depend on how the building is described. The tests
// also check the balance of energy, convergence and failures.
#include "isolaw/building/integrate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <ranges>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/laws/online/online.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "unit/building_fixture.hpp"
#include "unit/building_whole.hpp"

namespace isolaw::building {
namespace {

Response run(Frame const& frame, Plan const& plan, Bearings const& bearings, Motion const& motion,
             Options const& options = {}) {
  return integrate(Model(Structure(frame), plan), bearings, motion, options);
}

TEST(BuildingIntegrate, many_bearings_are_one_of_their_sum) {
  auto const motion = shaking();
  auto const many = run(three_floors(), {.bearings = Plan{std::vector<Point>(7)}.bearings},
                        equal_bearings(7, "bilinear", usual_bilinear(7)), motion);
  auto const one =
      run(three_floors(), {.bearings = {{0.0, 0.0}}}, equal_bearings(1, "bilinear", usual_bilinear(1)), motion);
  for (std::size_t i = 0; i < measures_of_all; ++i) {
    if (i == static_cast<std::size_t>(Measure::balance)) continue;
    EXPECT_NEAR(many.measured[i], one.measured[i], 1e-9 * std::abs(one.measured[i]) + 1e-12) << i;
  }
}

// If the plan, the stiffness and the ground motion are turned together, the response must turn with them.
TEST(BuildingIntegrate, rotation_in_plan) {
  double const angle = 0.6, c = std::cos(angle), s = std::sin(angle);
  auto const turned = [&](Point p) { return Point{c * p.x_mm - s * p.y_mm, s * p.x_mm + c * p.y_mm}; };
  Matrix3 R = Matrix3::Identity();
  R.topLeftCorner<2, 2>() << c, -s, s, c;

  auto frame = three_floors();
  frame.floors[0].below.centre = {900.0, -400.0};
  frame.floors[1].slab.centre = {-300.0, 200.0};
  auto plan = grid(3, 2, 6000.0);
  plan.corners = {{6000.0, 3000.0}, {-6000.0, 3000.0}};
  auto motion = shaking();
  auto other_frame = frame;
  other_frame.base.centre = turned(frame.base.centre);
  for (auto& floor : other_frame.floors) {
    floor.slab.centre = turned(floor.slab.centre);
    floor.below.centre = turned(floor.below.centre);
    floor.below.stiffness = R * floor.below.stiffness * R.transpose();
  }
  auto other_plan = plan;
  for (auto& p : other_plan.bearings) p = turned(p);
  for (auto& p : other_plan.corners) p = turned(p);
  auto other_motion = motion;
  for (std::size_t i = 0; i < motion.x_mm_s2.size(); ++i) {
    other_motion.x_mm_s2[i] = c * motion.x_mm_s2[i] - s * motion.y_mm_s2[i];
    other_motion.y_mm_s2[i] = s * motion.x_mm_s2[i] + c * motion.y_mm_s2[i];
  }
  Bearings first, second;
  for (std::size_t j = 0; j < 6; ++j) {
    auto values = usual_bilinear(6);
    for (double& v : values) v *= 1.0 + 0.05 * static_cast<double>(j);
    first.push_back(make_bearing("bilinear", values, Coupling::coupled));
    second.push_back(make_bearing("bilinear", values, Coupling::coupled));
  }
  auto const before = run(frame, plan, first, motion), after = run(other_frame, other_plan, second, other_motion);
  ASSERT_EQ(before.outcome, Outcome::completed);
  for (std::size_t i = 0; i < before.measured.size(); ++i) {
    if (i == static_cast<std::size_t>(Measure::balance)) continue;
    EXPECT_NEAR(after.measured[i], before.measured[i], 1e-12 * std::abs(before.measured[i])) << i;
  }
  EXPECT_GT(before.value(Measure::rotation), 1e-6);
}

TEST(BuildingIntegrate, bearings_at_one_place_may_be_exchanged) {
  auto plan = grid(2, 2, 8000.0);
  plan.bearings.push_back(plan.bearings[0]);
  Bearings first, second;
  for (std::size_t j = 0; j < 5; ++j) {
    auto const stiffer = [](Values v, double by) {
      for (double& x : v) x *= by;
      return v;
    };
    auto const values = usual_bilinear(5);
    first.push_back(make_bearing("bilinear", stiffer(values, j == 0 ? 1.2 : 1.0), Coupling::coupled));
    second.push_back(make_bearing("bilinear", stiffer(values, j == 4 ? 1.2 : 1.0), Coupling::coupled));
  }
  auto const a = run(three_floors(), plan, first, shaking()), b = run(three_floors(), plan, second, shaking());
  for (std::size_t i = 0; i < measures_of_all - 1; ++i)
    EXPECT_NEAR(a.measured[i], b.measured[i], 1e-9 * std::abs(a.measured[i])) << i;
}

// With forces and masses ten times as large, the building must move the same. With yield displacement and acceleration
// ten times as large, it must move ten times as far.
TEST(BuildingIntegrate, scales) {
  auto frame = three_floors();
  auto const plan = grid(2, 2, 8000.0);
  auto const values = usual_bilinear(4);
  auto const base = run(frame, plan, equal_bearings(4, "bilinear", values), shaking());
  auto heavy = frame;
  heavy.base.mass_Mg *= 10.0;
  for (auto& floor : heavy.floors) {
    floor.slab.mass_Mg *= 10.0;
    floor.below.stiffness *= 10.0;
  }
  auto const heavier =
      run(heavy, plan, equal_bearings(4, "bilinear", {10.0 * values[0], 10.0 * values[1], values[2]}), shaking());
  EXPECT_NEAR(heavier.value(Measure::isolator), base.value(Measure::isolator), 1e-9 * base.value(Measure::isolator));
  EXPECT_NEAR(heavier.value(Measure::shear), 10.0 * base.value(Measure::shear), 1e-8 * base.value(Measure::shear));
  auto const larger = run(frame, plan, equal_bearings(4, "bilinear", {values[0], values[1], 10.0 * values[2]}),
                          shaking(0.01, 12.0, 1.5));
  EXPECT_NEAR(larger.value(Measure::isolator), 10.0 * base.value(Measure::isolator),
              1e-8 * base.value(Measure::isolator));
}

TEST(BuildingIntegrate, energy_and_order) {
  auto const plan = grid(3, 2, 6000.0);
  auto const at = [&](double step_s) {
    return run(three_floors(), plan, equal_bearings(6, "bilinear", usual_bilinear(6)), shaking(),
               {.longest_step_s = step_s});
  };
  auto const coarse = at(0.005), half = at(0.0025), fine = at(0.0025 / 16);
  EXPECT_LT(std::abs(coarse.value(Measure::balance)), 1e-3);
  EXPECT_LT(std::abs(half.value(Measure::balance)), 0.5 * std::abs(coarse.value(Measure::balance)));
  EXPECT_GT(coarse.value(Measure::input), 0.0);
  auto const told = richardson(coarse, half);
  for (auto const which : {Measure::isolator, Measure::shear}) {
    auto const i = static_cast<std::size_t>(which);
    double const missed = std::abs(half.measured[i] - fine.measured[i]);
    EXPECT_LT(missed, 2e-3 * fine.measured[i]) << i;
    EXPECT_LT(missed, 4.0 * told[i] + 1e-4 * fine.measured[i]) << i;
  }
}

// isolaw splits the equations of motion into modes. Newmark's method applied to the unsplit matrices must give the same
// motion.
TEST(BuildingIntegrate, modes_are_the_whole_equations) {
  auto frame = three_floors();
  frame.floors[0].below.centre = {900.0, -400.0};
  frame.floors[2].slab.centre = {-300.0, 200.0};
  Structure const structure(frame);
  auto const motion = shaking();
  double const k = 1.6 * std::pow(2.0 * std::numbers::pi / 2.0, 2);
  // The yield displacement of 1e9 mm keeps the bearing elastic.
  auto const response =
      integrate(Model(structure, {.bearings = {{0.0, 0.0}}}), equal_bearings(1, "bilinear", {k, 0.0, 1e9}), motion,
                {.longest_step_s = 0.01, .histories = true});

  constexpr int n = 12;
  auto const [mass, storeys, C] = whole_equations(frame, 0.02);
  num::Matrix const M = mass.asDiagonal();
  num::Matrix K = storeys;
  K.topLeftCorner<2, 2>() += k * Eigen::Matrix2d::Identity();

  using Column = Eigen::Matrix<double, n, 1>;
  double const dt = 0.01;
  Column u = Column::Zero(), v = u, a = u;
  auto const load = [&](std::size_t i) {
    Column p = Column::Zero();
    for (int d = 0; d < n; d += 3) p(d) = -M(d, d) * motion.x_mm_s2[i], p(d + 1) = -M(d + 1, d + 1) * motion.y_mm_s2[i];
    return p;
  };
  a = mass.cwiseInverse().asDiagonal() * load(0);
  num::Matrix const effective = K + 2.0 / dt * C + 4.0 / (dt * dt) * M;
  double worst = 0.0, largest = 0.0, worst_a = 0.0, largest_a = 0.0;
  for (std::size_t i = 1; i < motion.x_mm_s2.size(); ++i) {
    Column const right = load(i) + M * (4.0 / (dt * dt) * u + 4.0 / dt * v + a) + C * (2.0 / dt * u + v);
    Column const next = num::solve_symmetric(effective, right);
    Column const speed = 2.0 / dt * (next - u) - v;
    a = 4.0 / (dt * dt) * (next - u) - 4.0 / dt * v - a;
    u = next, v = speed;
    for (Eigen::Index d = 0; d < 2; ++d) {
      worst = std::max(worst, std::abs(u(d) - response.history.base[i][static_cast<std::size_t>(d)]));
      largest = std::max(largest, std::abs(u(d)));
      double const roof = a(9 + d) + (d == 0 ? motion.x_mm_s2[i] : motion.y_mm_s2[i]);
      worst_a = std::max(worst_a, std::abs(roof - response.history.acceleration[i][static_cast<std::size_t>(6 + d)]));
      largest_a = std::max(largest_a, std::abs(roof));
    }
  }
  EXPECT_LT(worst, 1e-7 * largest);
  EXPECT_LT(worst_a, 1e-6 * largest_a);
}

class Nothing final : public Bearing {
 public:
  BearingForce trial(Vector const& to, Vector const&, double) override {
    return {.force = {std::abs(to.x) > 5.0 ? std::nan("") : to.x, 0.0}, .by_displacement = {{1.0, 0.0}, {0.0, 1.0}}};
  }
  void commit() override {}
  std::unique_ptr<Bearing> copy() const override { return std::make_unique<Nothing>(*this); }
};

TEST(BuildingIntegrate, what_does_not_converge_is_an_outcome) {
  Bearings bearings;
  bearings.push_back(std::make_unique<Nothing>());
  auto const response = run(three_floors(), {.bearings = {{0.0, 0.0}}}, bearings, shaking());
  EXPECT_EQ(response.outcome, Outcome::not_converged);
  EXPECT_NE(response.stop_reason.find("no equilibrium at"), std::string::npos) << response.stop_reason;
  EXPECT_GT(response.halvings, 0u);
}

TEST(BuildingIntegrate, refuses_what_is_no_building) {
  auto frame = three_floors();
  frame.base.mass_Mg = -1.0;
  frame.floors[1].below.stiffness.setZero();
  frame.damping = {1.5};
  try {
    Structure const structure(frame);
    FAIL();
  } catch (Error const& e) {
    EXPECT_EQ(e.complaints().size(), 3u) << e.what();
  }
  EXPECT_THROW(Model(Structure(three_floors()), {.bearings = {}}), Error);
}

// The force of these laws rises from rest with a power of the displacement. Each bearing is a set of springs in
// directions all around the circle. A spring at right angles to the motion moves by rounding errors only, and the force
// of such a law is noise there. Every step must find its equilibrium all the same.
TEST(BuildingIntegrate, springs_of_laws_without_a_slope_at_rest) {
  std::pair<char const*, Values> const laws[]{
      {"power-masing", {87.86, 0.371, 46.69, 9.1, 62.65, 0.2578}},
      {"power-scragging", {29.22, 0.488, 55.57, 0.0, 0.0, 14.79, 1.6, 0.337, 0.1797}},
      {"kikuchi-aiken", {79.87, 0.7, 0.2621, -0.0003364, 0.55, -0.001442, 0.0, 53.72, 0.001501, 10.19, 2.0}}};
  auto motion = shaking();
  auto along_x = motion;
  std::ranges::fill(along_x.y_mm_s2, 0.0);
  for (auto const& [law, values] : laws)
    for (auto const* shaken : {&motion, &along_x}) {
      Bearings bearings;
      for (int j = 0; j < 6; ++j) bearings.push_back(make_bearing(law, values, Coupling::springs));
      auto const response = run(three_floors(), grid(3, 2, 6000.0), bearings, *shaken);
      EXPECT_EQ(response.outcome, Outcome::completed) << law << ": " << response.stop_reason;
      EXPECT_LT(std::abs(response.value(Measure::balance)), 1e-4) << law;
      EXPECT_GT(response.value(Measure::isolator), 10.0) << law;
    }
}

// If a law has a finite slope at rest, a bearing of springs uses laws::Springs as it is. The slope of power-masing at
// rest is infinite, so the force of each spring is linear until the spring first moves by more than 1e-6 mm. From then
// on the forces must be those of laws::Springs.
TEST(BuildingIntegrate, springs_at_rest_have_the_law_beyond_rest) {
  Values const values{87.86, 0.371, 46.69, 9.1, 62.65, 0.2578};
  auto const bearing = make_bearing("power-masing", values, Coupling::springs);
  auto springs = laws::InPlane::springs(laws::Online("power-masing", values));
  for (int i = 1; i <= 40; ++i) {
    Vector const to{20.0 * std::sin(0.3 * i) + 0.1, 12.0 * std::cos(0.2 * i)};
    auto const force = bearing->trial(to, {0.0, 0.0}, 0.01), other = [&] {
      auto const f = springs.trial({to.x, to.y}, {0.0, 0.0}, 0.01);
      return BearingForce{.force = {f.force.x, f.force.y}};
    }();
    EXPECT_NEAR(force.force.x, other.force.x, 1e-9) << i;
    EXPECT_NEAR(force.force.y, other.force.y, 1e-9) << i;
    bearing->commit();
    springs.commit();
  }
}

}  // namespace
}  // namespace isolaw::building
