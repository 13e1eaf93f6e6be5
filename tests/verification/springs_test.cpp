// For motion in two directions a law without a two-dimensional form becomes a set of one-directional springs around a
// circle. Stiffness, strength and energy of bilinear springs are compared with values that an independent script
// computed from the formulas. Further tests turn the springs and compare tangents with difference quotients.
#include "isolaw/laws/plane/springs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace isolaw::springs_oracles {
namespace {

using laws::Springs;
using laws::plane::Vector;
constexpr double pi = std::numbers::pi;

// Returns a bilinear law with K1 6 kN/mm, K2 0.9 kN/mm (or the given one) and Qd 30 kN.
laws::Online bilinear(double K2 = 0.9) {
  return {"bilinear", std::vector{6.0, K2, 30.0 / (6.0 - K2)}};
}

// The force at every point of the path, and the work over its last `round` steps.
struct Walked {
  std::vector<Vector<double>> forces;
  double work = 0.0;
};
Walked walked(Springs springs, std::vector<Vector<double>> const& path, std::size_t round = 0) {
  Walked response;
  Vector<double> from{0.0, 0.0}, force{0.0, 0.0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    auto const before = force;
    force = springs.trial(path[i], {0.0, 0.0}).force;
    springs.commit();
    if (i + round >= path.size()) response.work += 0.5 * laws::plane::dot(before + force, path[i] - from);
    response.forces.push_back(force);
    from = path[i];
  }
  return response;
}

TEST(Springs, strength_depends_on_the_angle_by_so_much) {
  struct Expected {
    int springs;
    double anisotropy;  // by how many percent the strongest direction exceeds the weakest
  };
  for (auto const& e : {Expected{8, 1.96}, Expected{16, 0.48}, Expected{32, 0.12}}) {
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (int i = 0; i <= 32; ++i) {
      double const angle = pi / e.springs * i / 32;
      auto const f =
          walked(Springs(bilinear(0.0), e.springs), {{1e5 * std::cos(angle), 1e5 * std::sin(angle)}}).forces.back();
      least = std::min(least, std::hypot(f.x, f.y));
      most = std::max(most, std::hypot(f.x, f.y));
    }
    EXPECT_NEAR(100.0 * (most / least - 1.0), e.anisotropy, 0.005) << e.springs;
    EXPECT_NEAR(std::max(std::abs(most - 30.0), std::abs(least - 30.0)), 0.0, 0.6);
  }
}

TEST(Springs, energies_of_bilinear_ones) {
  std::vector<Vector<double>> cycles, circles;
  constexpr int steps = 3000;
  for (int i = 1; i <= 3 * steps; ++i) cycles.push_back({150.0 * std::sin(2.0 * pi * i / steps), 0.0});
  for (int i = 0; i <= 3 * steps; ++i)
    circles.push_back({150.0 * std::cos(2.0 * pi * i / steps), 150.0 * std::sin(2.0 * pi * i / steps)});
  struct Expected {
    int springs;
    double energy;
  };
  auto const work = [&](int springs, auto const& path) {
    return walked(Springs(bilinear(), springs), path, steps).work;
  };
  for (auto const& e : {Expected{8, 17218.0}, Expected{32, 17155.0}})
    EXPECT_NEAR(work(e.springs, cycles), e.energy, 0.3) << e.springs;
  for (auto const& e : {Expected{8, 27749.7}, Expected{16, 27489.1}, Expected{32, 27424.8}})
    EXPECT_NEAR(work(e.springs, circles), e.energy, 0.3) << e.springs;
}

// The sixteen springs yield one after another, which rounds the knee of the loop. At small amplitudes the loop
// therefore dissipates less than the law. docs/bidirectional.md quotes these numbers.
TEST(Springs, lose_work_at_small_amplitudes) {
  constexpr int steps = 2000;
  auto const change_percent = [&](double size) {
    std::vector<Vector<double>> path;
    for (int i = 1; i <= 2 * steps; ++i) path.push_back({size * std::sin(2.0 * pi * i / steps), 0.0});
    laws::Online law = bilinear();
    double of_law = 0.0, before = 0.0, x = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      double const force = law.trial(path[i].x, 0.0).force;
      law.commit();
      if (i >= steps) of_law += 0.5 * (force + before) * (path[i].x - x);
      before = force;
      x = path[i].x;
    }
    return 100.0 * (walked(Springs(bilinear()), path, steps).work / of_law - 1.0);
  };
  double const Dy = 30.0 / 5.1;
  EXPECT_NEAR(change_percent(2.0 * Dy), -8.1, 0.1);
  EXPECT_NEAR(change_percent(25.0 * Dy), -0.68, 0.02);
}

TEST(Springs, turn_by_their_own_angle_exactly_and_by_any_within_a_spring) {
  std::vector<Vector<double>> path;
  for (int i = 1; i <= 500; ++i)
    path.push_back({100.0 * std::sin(0.05 * i) * i / 500.0, 80.0 * std::sin(0.083 * i) * i / 500.0});
  auto const straight = walked(Springs(bilinear()), path);
  for (double const share : {1.0, 3.0, 0.5, 0.2}) {
    double const angle = share * pi / laws::usual_springs, c = std::cos(angle), s = std::sin(angle);
    auto const turned = [&](Vector<double> const& a, double sign) {
      return Vector<double>{c * a.x - sign * s * a.y, sign * s * a.x + c * a.y};
    };
    std::vector<Vector<double>> other;
    for (auto const& at : path) other.push_back(turned(at, 1.0));
    auto const got = walked(Springs(bilinear()), other);
    // If the path is turned by a multiple of the angle between two springs, its forces are exactly turned with it. If
    // it is turned by a fraction of that angle, at most one spring more or less has yielded.
    bool const exact = share == std::floor(share);
    double worst = 0.0;
    for (std::size_t i = 0; i < path.size(); ++i) {
      auto const f = turned(got.forces[i], -1.0) - straight.forces[i];
      worst = std::max(worst, std::hypot(f.x, f.y));
    }
    EXPECT_LE(worst, exact ? 1e-9 : 2.0 / laws::usual_springs * 30.0) << share;
    if (!exact) {
      EXPECT_GT(worst, 1e-6) << share;
    }
  }
}

TEST(Springs, tangents_and_damping_are_slopes) {
  bool damped = false;
  // The force of power-masing-viscous starts with an unbounded slope when a spring enters a side where it has not been,
  // so only the tangent of its dashpot is compared.
  struct Subject {
    laws::Online law;
    bool has_slopes;
  };
  for (auto const& [law, has_slopes] :
       {Subject{bilinear(), true},
        Subject{{"power-masing-viscous", std::vector{40.0, 0.6, 50.0, 2.0, 1.0, 5.0, 0.02}}, false},
        Subject{{"bouc-wen", std::vector{0.1, 3.0, 1.0, 0.05, 1.2, 0.05}}, true}}) {
    Springs springs(law);
    for (auto const& at : {Vector<double>{3.0, 1.0}, {20.0, -8.0}, {60.0, 9.0}, {55.0, 12.0}, {-10.0, 40.0}}) {
      constexpr double h = 1e-6;
      Vector<double> const v{100.0, 50.0};
      auto const here = springs.trial(at, v);
      for (std::size_t k = 0; k < 2; ++k) {
        Vector<double> const d{k == 0 ? h : 0.0, k == 1 ? h : 0.0};
        auto const ahead = springs.trial(at + d, v).force, behind = springs.trial(at - d, v).force;
        if (has_slopes) {
          EXPECT_NEAR(here.by_displacement[0][k], (ahead.x - behind.x) / (2.0 * h), 1e-5);
          EXPECT_NEAR(here.by_displacement[1][k], (ahead.y - behind.y) / (2.0 * h), 1e-5);
        }
        auto const faster = springs.trial(at, v + d).force, slower = springs.trial(at, v - d).force;
        EXPECT_NEAR(here.by_velocity[0][k], (faster.x - slower.x) / (2.0 * h), 1e-6);
        EXPECT_NEAR(here.by_velocity[1][k], (faster.y - slower.y) / (2.0 * h), 1e-6);
        damped = damped || here.by_velocity[0][k] != 0.0;
      }
      springs.trial(at, v);
      springs.commit();
    }
  }
  EXPECT_TRUE(damped);
}

}  // namespace
}  // namespace isolaw::springs_oracles
