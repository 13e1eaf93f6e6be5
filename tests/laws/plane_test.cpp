// Tests of the laws for motion in two horizontal directions. On a straight line each must equal its one-directional
// law. A rotated motion must give the rotated forces. Tangents must equal difference quotients, and each SIMD lane must
// equal the scalar law.
#include "isolaw/laws/plane/plane.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "isolaw/laws/catalogue.hpp"
#include "isolaw/num/batch.hpp"

namespace isolaw::plane_test {
namespace {

using laws::plane::Vector;
using Walk = std::vector<Vector<double>>;

// Returns a random polygon through points within +-`size`, divided into short steps. It starts at the origin.
Walk wander(double size, unsigned seed, std::size_t count = 400) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Walk walk{{0.0, 0.0}};
  Vector<double> goal{0.0, 0.0};
  while (walk.size() < count) {
    goal = {size * uniform(random), size * uniform(random)};
    auto const from = walk.back();
    int const pieces = 2 + static_cast<int>(random() % 12);
    for (int i = 1; i <= pieces; ++i) walk.push_back(from + (static_cast<double>(i) / pieces) * (goal - from));
  }
  return walk;
}

Vector<double> rotated(Vector<double> const& a, double angle) {
  double const c = std::cos(angle), s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

template <class Law>
std::vector<Vector<double>> forces(typename Law::template Params<double> const& p, Walk const& walk) {
  auto state = Law::template start<double>(p);
  std::vector<Vector<double>> response;
  auto from = walk.front();
  for (auto const& to : walk) {
    response.push_back(Law::template step<double>(p, state, from, to, 0.005));
    from = to;
  }
  return response;
}

double peak_of(std::vector<Vector<double>> const& forces) {
  double peak = 0.0;
  for (auto const& f : forces) peak = std::max(peak, std::hypot(f.x, f.y));
  return peak;
}

template <class Law>
struct Case;
template <>
struct Case<laws::plane::Bilinear> {
  static constexpr laws::Bilinear::Params<double> parameters[] = {{6.0, 0.9, 5.9}, {1.5, 0.5, 30.0}, {2.0, 2.0, 5.0}};
  static constexpr double size = 100.0, line_tolerance = 1e-12;
};
template <>
struct Case<laws::plane::BoucWen> {
  static constexpr laws::BoucWen::Params<double> parameters[] = {
      {0.1, 3.0, 1.0, 0.05, 2.0, 0.05},  {0.2, 2.0, 1.5, 0.09, 2.0, -0.05}, {0.2, 2.0, 1.5, 0.03, 2.0, 0.05},
      {0.1, 3.0, 1.0, 0.05, 1.0, 0.05},  {0.1, 3.0, 1.2, 0.09, 0.6, -0.05}, {0.1, 3.0, 1.0, 0.03, 1.4, 0.05},
      {0.1, 3.0, 1.0, 0.002, 3.0, 0.001}};
  static constexpr double size = 100.0, line_tolerance = 1e-6;
};
template <>
struct Case<laws::plane::AbeY0> {
  static constexpr laws::AbeY0::Params<double> parameters[] = {
      {0.5, 8.0, 0.3, 0.8, 7.0, 0.3, 40.0, 100.0, 4.0, 20.0, 0.2, 0.1},
      {0.5, 80.0, 0.3, 0.8, 7.0, 0.1, 40.0, 100.0, 4.0, 20.0, 0.2, 0.1},
      {0.5, 8.0, 0.3, 0.8, 7.0, 1.0, 40.0, 100.0, 8.0, 20.0, 0.2, 0.1}};
  static constexpr double size = 100.0, line_tolerance = 1e-6;
};
template <>
struct Case<laws::plane::Abe> {
  static constexpr laws::Abe::Params<double> parameters[] = {
      {0.5, 8.0, 0.3, 0.8, 7.0, 0.3, 20.0, 100.0, 0.8, 4.0, 20.0, 0.2, 0.1},
      {0.5, 8.0, 0.3, 0.8, 7.0, 0.7, 20.0, 100.0, 1.5, 4.0, 20.0, 0.2, 0.1}};
  static constexpr double size = 100.0, line_tolerance = 1e-4;
};
template <>
struct Case<laws::plane::Vaiana> {
  static constexpr laws::Vaiana::Params<double> parameters[] = {
      {3e5, 3e5, 4e4, 4e4, 30.0, 30.0, 0.0, 0.0, 20.0, 20.0, 0, 0, 0, 0, 0, 0}};
  static constexpr double size = 0.1, line_tolerance = 1e-12;
};
template <>
struct Case<laws::plane::HistoryIntegral> {
  static constexpr laws::HistoryIntegral::Params<double> parameters[] = {{40.0, 0.6, 30.0, 12.0, 0.4, 0.2},
                                                                         {40.0, 1.0, 30.0, 12.0, 0.0, 0.2}};
  static constexpr double size = 100.0, line_tolerance = 1e-12;
};

template <class Law>
class PlaneLaw : public testing::Test {};
template <class Tuple>
struct TypesOf;
template <class... Law>
struct TypesOf<std::tuple<Law...>> {
  using Types = testing::Types<Law...>;
};
TYPED_TEST_SUITE(PlaneLaw, TypesOf<laws::plane::AllLaws>::Types);

TYPED_TEST(PlaneLaw, on_a_line_is_the_law_of_one_direction) {
  auto const& law = laws::find_law(TypeParam::info.id);
  for (auto const& p : Case<TypeParam>::parameters)
    for (double const angle : {0.0, 0.7, 2.5}) {
      auto const walk = wander(Case<TypeParam>::size, 7);
      std::vector<double> x, values, expected(walk.size());
      for (auto const& at : walk) x.push_back(at.x);
      for (auto const member : laws::members<typename TypeParam::OneDirection, double>) values.push_back(p.*member);
      law.evaluate(values, laws::make_path(x, {}), laws::Integration::converged, expected);
      Walk line;
      for (double const at : x) line.push_back(rotated({at, 0.0}, angle));
      auto const got = forces<TypeParam>(p, line);
      double const peak = peak_of(got);
      for (std::size_t i = 0; i < x.size(); ++i) {
        auto const f = rotated(got[i], -angle);
        ASSERT_NEAR(f.x, expected[i], Case<TypeParam>::line_tolerance * peak) << i;
        ASSERT_NEAR(f.y, 0.0, Case<TypeParam>::line_tolerance * peak) << i;
      }
    }
}

TYPED_TEST(PlaneLaw, turns_with_the_motion) {
  for (auto const& p : Case<TypeParam>::parameters) {
    auto const walk = wander(Case<TypeParam>::size, 3);
    auto const straight = forces<TypeParam>(p, walk);
    double const peak = peak_of(straight);
    for (double const angle : {0.1, 1.0, std::numbers::pi / 2, 4.0}) {
      Walk other;
      for (auto const& at : walk) other.push_back(rotated(at, angle));
      auto const got = forces<TypeParam>(p, other);
      for (std::size_t i = 0; i < walk.size(); ++i) {
        auto const f = rotated(got[i], -angle);
        ASSERT_NEAR(f.x, straight[i].x, 1e-12 * peak) << i;
        ASSERT_NEAR(f.y, straight[i].y, 1e-12 * peak) << i;
      }
    }
  }
}

// Tangents must equal central differences of the computed steps. Steps near a kink of the law are left out.
TYPED_TEST(PlaneLaw, tangents_are_slopes) {
  for (auto const& p : Case<TypeParam>::parameters) {
    auto const walk = wander(Case<TypeParam>::size, 5);
    auto state = TypeParam::template start<double>(p);
    double const h = 1e-6 * Case<TypeParam>::size;
    std::size_t compared = 0;
    double peak = 0.0;
    for (std::size_t i = 1; i < walk.size(); ++i) {
      auto const trial = laws::plane::force_and_tangent(TypeParam{}, p, state, walk[i - 1], walk[i], 0.005);
      auto const at = [&](double dx, double dy) {
        auto copy = state;
        return TypeParam::template step<double>(p, copy, walk[i - 1], walk[i] + Vector<double>{dx, dy}, 0.005);
      };
      peak = std::max(peak, std::hypot(trial.force.x, trial.force.y));
      double const stiff = peak / Case<TypeParam>::size;
      Vector<double> const right = at(h, 0.0), left = at(-h, 0.0), up = at(0.0, h), down = at(0.0, -h),
                           here = at(0.0, 0.0);
      EXPECT_NEAR(here.x, trial.force.x, 1e-13 * peak);
      EXPECT_NEAR(here.y, trial.force.y, 1e-13 * peak);
      double const slopes[2][2] = {{(right.x - left.x) / (2 * h), (up.x - down.x) / (2 * h)},
                                   {(right.y - left.y) / (2 * h), (up.y - down.y) / (2 * h)}};
      double const bend = std::abs(right.x + left.x - 2 * here.x) + std::abs(up.y + down.y - 2 * here.y);
      if (bend < 1e-4 * h * stiff) {
        ++compared;
        for (std::size_t r = 0; r < 2; ++r)
          for (std::size_t c = 0; c < 2; ++c) ASSERT_NEAR(trial.tangent[r][c], slopes[r][c], 1e-4 * stiff) << i;
      }
      state = trial.after;
    }
    EXPECT_GT(compared, walk.size() / 2);
  }
}

// Each SIMD lane has its own parameters and motion and must give the force of the scalar law.
TYPED_TEST(PlaneLaw, lanes_are_scalars) {
  constexpr std::size_t lanes = 8;
  using T = num::Batch<lanes>;
  using Params = typename TypeParam::template Params<double>;
  std::vector<Params> each;
  std::vector<Walk> walks;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    each.push_back(Case<TypeParam>::parameters[lane % std::size(Case<TypeParam>::parameters)]);
    walks.push_back(wander(Case<TypeParam>::size, 11 + static_cast<unsigned>(lane)));
  }
  auto const lanes_of = [&](auto&& one) {
    double values[lanes];
    for (std::size_t lane = 0; lane < lanes; ++lane) values[lane] = one(lane);
    return T::load(values);
  };
  typename TypeParam::template Params<T> p;
  for (std::size_t k = 0; k < laws::members<typename TypeParam::OneDirection, T>.size(); ++k)
    p.*laws::members<typename TypeParam::OneDirection, T>[k] = lanes_of(
        [&](std::size_t lane) { return each[lane].*laws::members<typename TypeParam::OneDirection, double>[k]; });
  auto state = TypeParam::template start<T>(p);
  std::vector<std::vector<Vector<double>>> expected;
  for (std::size_t lane = 0; lane < lanes; ++lane) expected.push_back(forces<TypeParam>(each[lane], walks[lane]));
  auto const point = [&](std::size_t i) {
    return Vector<T>{lanes_of([&](std::size_t lane) { return walks[lane][i].x; }),
                     lanes_of([&](std::size_t lane) { return walks[lane][i].y; })};
  };
  for (std::size_t i = 1; i < 400; ++i) {
    Vector<T> const f = TypeParam::template step<T>(p, state, point(i - 1), point(i), 0.005);
    double x[lanes], y[lanes];
    f.x.store(x);
    f.y.store(y);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      double const peak = peak_of(expected[lane]);
      ASSERT_NEAR(x[lane], expected[lane][i].x, 1e-11 * peak) << i << " lane " << lane;
      ASSERT_NEAR(y[lane], expected[lane][i].y, 1e-11 * peak) << i << " lane " << lane;
    }
  }
}

// Lane 0 must give the same bits whether the other lanes hold its own copy or other parameters and motions. A NaN in
// lane 5 must stay in lane 5.
TYPED_TEST(PlaneLaw, lanes_do_not_know_one_another) {
  constexpr std::size_t lanes = 8;
  using T = num::Batch<lanes>;
  auto const run = [](bool alone) {
    auto const& known = Case<TypeParam>::parameters;
    typename TypeParam::template Params<T> p;
    for (std::size_t k = 0; k < laws::members<typename TypeParam::OneDirection, T>.size(); ++k) {
      double values[lanes];
      for (std::size_t lane = 0; lane < lanes; ++lane)
        values[lane] =
            known[alone ? 0 : lane % std::size(known)].*laws::members<typename TypeParam::OneDirection, double>[k];
      if (!alone) values[5] = std::nan("");
      p.*laws::members<typename TypeParam::OneDirection, T>[k] = T::load(values);
    }
    auto state = TypeParam::template start<T>(p);
    std::vector<Walk> walks;
    for (unsigned lane = 0; lane < lanes; ++lane)
      walks.push_back(wander(Case<TypeParam>::size, alone ? 20 : 20 + lane));
    std::vector<double> response;
    for (std::size_t i = 1; i < 100; ++i) {
      auto const at = [&](std::size_t index) {
        double x[lanes], y[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          x[lane] = walks[lane][index].x;
          y[lane] = walks[lane][index].y;
        }
        return Vector<T>{T::load(x), T::load(y)};
      };
      auto const f = TypeParam::template step<T>(p, state, at(i - 1), at(i), 0.005);
      double x[lanes], y[lanes];
      f.x.store(x);
      f.y.store(y);
      response.insert(response.end(), {x[0], y[0]});
      EXPECT_EQ(alone, std::isfinite(x[5])) << i;
    }
    return response;
  };
  EXPECT_EQ(run(true), run(false));
}

// Without motion the force stays the same and the stiffness in both directions is positive. A single step to 100,000
// times the amplitude of the other tests gives a finite force.
TYPED_TEST(PlaneLaw, at_rest_and_far_away) {
  auto const& p = Case<TypeParam>::parameters[0];
  auto state = TypeParam::template start<double>(p);
  double const size = Case<TypeParam>::size;
  Vector<double> const a{0.3 * size, -0.2 * size}, far{1e5 * size, 0.0};
  auto const first = TypeParam::template step<double>(p, state, {0.0, 0.0}, a, 0.005);
  auto const again = TypeParam::template step<double>(p, state, a, a, 0.005);
  EXPECT_DOUBLE_EQ(again.x, first.x);
  EXPECT_DOUBLE_EQ(again.y, first.y);
  auto const rest = laws::plane::force_and_tangent(TypeParam{}, p, state, a, a, 0.005);
  EXPECT_GT(rest.tangent[0][0], 0.0);
  EXPECT_GT(rest.tangent[1][1], 0.0);
  auto const there = TypeParam::template step<double>(p, state, a, far, 0.005);
  EXPECT_TRUE(std::isfinite(there.x) && std::isfinite(there.y));
}

}  // namespace
}  // namespace isolaw::plane_test
