// Tests the explicit integration of many draws at once; a draw is the building with randomly drawn bearings. The
// results are compared with those of the implicit integration, and those of the vectorised code with those of the
// scalar code.
#include "isolaw/building/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/num/random.hpp"
#include "unit/building_fixture.hpp"

namespace isolaw::building {
namespace {

constexpr std::size_t bearings = 6, draws = 2 * lane_width + 3;

Model usual_model() {
  return {Structure(three_floors()), grid(3, 2, 6000.0)};
}

Values scattered(std::string_view law, Values const& nominal, double scatter) {
  Values values;
  for (std::size_t draw = 0; draw < draws; ++draw)
    for (std::size_t j = 0; j < bearings; ++j) {
      num::Draws numbers(num::Stream(3), static_cast<std::uint32_t>(draw), static_cast<std::uint32_t>(j));
      double const factor = std::exp(scatter * numbers.normal());
      // Scale only the parameters that are proportional to the force, so the device keeps the shape of its loop.
      for (std::size_t i = 0; i < nominal.size(); ++i)
        values.push_back(nominal[i] * (law == "bilinear" ? (i < 2 ? factor : 1.0) : (i == 1 ? factor : 1.0)));
    }
  return values;
}

Values row(Values const& all, std::size_t draw, std::size_t count) {
  auto const first = all.begin() + static_cast<std::ptrdiff_t>(draw * count);
  return {first, first + static_cast<std::ptrdiff_t>(count)};
}

TEST(BuildingLanes, lanes_are_the_scalar_path) {
  auto const model = usual_model();
  auto const motion = shaking();
  auto const count = model.layout().count();
  auto const values = scattered("bilinear", usual_bilinear(bearings), 0.2);
  auto const scalar = respond(model, "bilinear", values, motion, {}, Coupling::coupled, num::InstructionSet::scalar);
  for (auto const set : num::available_instruction_sets()) {
    auto const lanes = respond(model, "bilinear", values, motion, {}, Coupling::coupled, set);
    ASSERT_EQ(lanes.size(), draws * count);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
      if (i % count == static_cast<std::size_t>(Measure::balance)) continue;
      EXPECT_NEAR(lanes[i], scalar[i], 1e-7 * std::abs(scalar[i]) + 1e-9) << num::name(set) << " " << i % count;
    }
  }
}

// The caller may ask a run to stop, and the run must then stop long before its end. An explicit run calls `interrupted`
// every 4096 steps and once after its last step. An implicit run, here one with springs, calls it at every step.
TEST(BuildingLanes, an_interrupted_run_ends_within_the_run) {
  auto const model = usual_model();
  auto const motion = shaking();
  auto const values = scattered("bilinear", usual_bilinear(bearings), 0.2);
  std::size_t asked = 0;
  Options const options{.longest_step_s = 0.001, .rest_s = 50.0, .interrupted = [&] { return ++asked >= 2; }};
  ASSERT_GT(steps_of(motion, options.longest_step_s, options.rest_s).count, std::size_t{8 * 4096});
  auto sets = num::available_instruction_sets();
  sets.push_back(num::InstructionSet::scalar);
  for (auto const set : sets) {
    asked = 0;
    EXPECT_THROW(respond(model, "bilinear", values, motion, options, Coupling::coupled, set), InterruptedRun);
    EXPECT_EQ(asked, 3u) << num::name(set);
  }
  asked = 0;
  EXPECT_THROW(respond(model, "bilinear", values, motion, options, Coupling::springs), InterruptedRun);
  EXPECT_EQ(asked, 2u);
}

TEST(BuildingLanes, no_draw_notices_another) {
  auto const model = usual_model();
  auto const motion = shaking();
  auto const count = model.layout().count(), each = bearings * usual_bilinear(1).size();
  auto values = scattered("bilinear", usual_bilinear(bearings), 0.2);
  auto const together = respond(model, "bilinear", values, motion, {});
  for (std::size_t const draw : {std::size_t{0}, lane_width + 2, draws - 1})
    EXPECT_EQ(respond(model, "bilinear", row(values, draw, each), motion, {}), row(together, draw, count)) << draw;
  // A draw whose parameters are not finite must not change the results of the other draws.
  values[each] = std::nan("");
  auto const with_nan = respond(model, "bilinear", values, motion, {});
  EXPECT_EQ(row(with_nan, 0, count), row(together, 0, count));
  EXPECT_FALSE(std::isfinite(with_nan[count + static_cast<std::size_t>(Measure::balance)]));
}

TEST(BuildingLanes, held_to_the_implicit_path) {
  auto const model = usual_model();
  auto const motion = shaking();
  auto const values = scattered("bilinear", usual_bilinear(bearings), 0.2);
  auto const each = bearings * usual_bilinear(1).size(), count = model.layout().count();
  auto const lanes = respond(model, "bilinear", values, motion, {});
  for (std::size_t const draw : {std::size_t{0}, std::size_t{5}}) {
    Bearings drawn_bearings;
    for (std::size_t j = 0; j < bearings; ++j) {
      auto const of_draw = row(values, draw, each);
      drawn_bearings.push_back(make_bearing("bilinear", row(of_draw, j, 3), Coupling::coupled));
    }
    auto const implicit = integrate(model, drawn_bearings, motion);
    for (std::size_t i = 0; i < count; ++i) {
      if (i == static_cast<std::size_t>(Measure::balance)) continue;
      // Compare the error of the residual displacement with the largest displacement, since the residual displacement
      // is small itself.
      double const size =
          i == static_cast<std::size_t>(Measure::end) ? implicit.value(Measure::isolator) : implicit.measured[i];
      EXPECT_NEAR(lanes[draw * count + i], implicit.measured[i], 3e-3 * std::abs(size)) << i;
    }
    EXPECT_LT(std::abs(lanes[draw * count + static_cast<std::size_t>(Measure::balance)]), 1e-3);
  }
}

// Most of the mass lies on floors whose periods are too short for the explicit steps to follow. The integration must
// stay stable and agree with the implicit integration.
TEST(BuildingLanes, stable_below_stiff_floors) {
  for (double const period_s : {0.012, 0.02, 0.03}) {
    Diaphragm const light{.mass_Mg = 80.0, .gyration_mm = 7000.0}, heavy{.mass_Mg = 1520.0, .gyration_mm = 7000.0};
    Model const model(Structure({.base = light, .floors = equal_floors(1, heavy, period_s, period_s)}),
                      grid(3, 2, 6000.0));
    Values values;
    for (std::size_t j = 0; j < bearings; ++j) {
      auto const one = usual_bilinear(bearings);
      values.insert(values.end(), one.begin(), one.end());
    }
    auto const lanes = respond(model, "bilinear", values, shaking(), {});
    EXPECT_LT(std::abs(lanes[static_cast<std::size_t>(Measure::balance)]), 1e-3) << period_s;
    auto const implicit = integrate(model, equal_bearings(bearings, "bilinear", usual_bilinear(bearings)), shaking());
    EXPECT_NEAR(lanes[static_cast<std::size_t>(Measure::isolator)], implicit.value(Measure::isolator),
                2e-3 * implicit.value(Measure::isolator));
  }
}

// Each law of the catalogue in turn carries a building on two bearings. The law's parameters lie near the middle of a
// search box that is scaled to one device. The bearings use the law's two-dimensional form, or a set of springs if the
// law has none. Explicit and implicit integration must agree and keep the balance of energy.
TEST(BuildingLanes, every_law_carries_a_building) {
  Model const model(Structure(three_floors()), {.bearings = {{-3000.0, 0.0}, {3000.0, 0.0}}});
  auto const motion = shaking(0.01, 6.0, 0.12);
  for (auto const& law : laws::catalogue()) {
    SCOPED_TRACE(law.info.id);
    double const length = law.info.length.in_record_units, force = law.info.force.in_record_units;
    laws::RecordScales const scales{150.0 / length, 1200.0 / force, 8.0 * length / force,
                                    400.0 / force,  400.0 / length, 5e5 / length / force};
    Values values, both;
    for (auto const& p : law.parameters) {
      auto const box = p.scaled(scales);
      bool const logarithmic = p.scaled_search == laws::Scale::logarithmic && box.lower * box.upper > 0.0;
      double const middle =
          logarithmic ? std::copysign(std::sqrt(box.lower * box.upper), box.lower) : 0.7 * box.lower + 0.3 * box.upper;
      // In the middle of the box vaiana would have larger exponential terms than any bearing has, so they are left out.
      bool const exponential = law.info.id == "vaiana" && (p.name.starts_with("beta") || p.name.starts_with("gamma"));
      values.push_back(exponential ? 0.0 : p.fixed_by_default.value_or(middle));
    }
    for (int i = 0; i < 2; ++i) both.insert(both.end(), values.begin(), values.end());
    auto const coupling = coupling_of(law.info.id, values);
    Bearings pair;
    for (int i = 0; i < 2; ++i) pair.push_back(make_bearing(law.info.id, values, coupling));
    auto const implicit = integrate(model, pair, motion);
    EXPECT_EQ(implicit.outcome, Outcome::completed) << implicit.stop_reason;
    if (implicit.outcome != Outcome::completed) continue;
    EXPECT_LT(std::abs(implicit.value(Measure::balance)), 1e-3);
    auto const drawn = respond(model, law.info.id, both, motion, {}, coupling);
    EXPECT_LT(std::abs(drawn[static_cast<std::size_t>(Measure::balance)]), 2e-3);
    EXPECT_NEAR(drawn[0], implicit.value(Measure::isolator), 0.01 * implicit.value(Measure::isolator));
  }
}

}  // namespace
}  // namespace isolaw::building
