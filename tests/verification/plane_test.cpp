// The laws for motion in two horizontal directions are compared with closed forms and with an independent solver of
// their differential equations. An independent script computed the expected numbers from the formulas.
#include "isolaw/laws/plane/plane.hpp"

#include <gtest/gtest.h>

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace isolaw::plane_oracles {
namespace {

namespace odeint = boost::numeric::odeint;
using laws::plane::Vector;
constexpr double pi = std::numbers::pi, without_bound = std::numeric_limits<double>::infinity();

template <class Law>
using P = typename Law::template Params<double>;
template <class Law>
using S = typename Law::template State<double>;

// Returns Bouc-Wen parameters with alpha = 0, Ke = 1 and A = 1, so that the force is z.
laws::BoucWen::Params<double> bouc_wen(double n, double beta, double gamma) {
  return {.alpha = 0.0, .Ke = 1.0, .A = 1.0, .beta = beta, .n = n, .gamma = gamma};
}
// Returns Abe parameters for the hysteretic force alone, with strength 1 and yield length U.
laws::AbeY0::Params<double> abe(double n, double U) {
  laws::AbeY0::Params<double> p{};
  p.n = n;
  p.alpha = p.Y0 = p.Uh = 1.0;
  p.U0 = U;
  p.Us = without_bound;
  return p;
}

TEST(PlaneLaws, a_straight_step_of_bouc_wen_with_n_2_is_hyperbolic) {
  using Law = laws::plane::BoucWen;
  auto const p = bouc_wen(2.0, 0.5, 0.5);
  auto state = Law::start<double>(p);
  state.z = {0.6, 0.5};
  auto const z = Law::step<double>(p, state, {0.0, 0.0}, {0.7, 0.0}, 0.01);
  EXPECT_NEAR(z.x, 0.883861376045, 1e-12);
  EXPECT_NEAR(z.y, 0.292343085539, 1e-12);
}

TEST(PlaneLaws, a_straight_step_of_bouc_wen_switches_where_the_component_along_it_is_none) {
  using Law = laws::plane::BoucWen;
  auto const p = bouc_wen(2.0, 0.9, 0.1);
  auto state = Law::start<double>(p);
  state.z = {-0.6, 0.5};
  auto const z = Law::step<double>(p, state, {0.0, 0.0}, {1.5, 0.0}, 0.01);
  EXPECT_NEAR(z.x, 0.739476218300, 1e-12);
  EXPECT_NEAR(z.y, 0.296582148814, 1e-12);
  state.z = {-0.6, 0.5};
  auto const at_zero = Law::step<double>(p, state, {0.0, 0.0}, {0.550677413306, 0.0}, 0.01);
  EXPECT_NEAR(at_zero.x, 0.0, 1e-12);
  EXPECT_NEAR(at_zero.y, 0.440567110531, 1e-12);
}

// Results of the last of several rounds along a polygon with `corners` corners. At the last corner, `size` is the size
// of the force and `lag` its angle behind the direction of motion. `work` is the work of the whole round.
struct Turn {
  double size, lag, work;
};
template <class Law>
Turn turn(P<Law> const& p, double radius, int corners, int turns = 4) {
  auto state = Law::template start<double>(p);
  Vector<double> from{0.0, 0.0}, force{0.0, 0.0};
  Turn last_turn{};
  for (int k = 0; k <= turns * corners; ++k) {
    double const angle = 2.0 * pi * k / corners;
    Vector<double> const to{radius * std::cos(angle), radius * std::sin(angle)};
    auto const before = force;
    force = Law::template step<double>(p, state, from, to, 0.01);
    if (k > (turns - 1) * corners) last_turn.work += 0.5 * laws::plane::dot(before + force, to - from);
    from = to;
  }
  last_turn.size = std::hypot(force.x, force.y);
  last_turn.lag = std::atan2(-force.x, force.y);  // at the last corner the motion is along y
  last_turn.lag = std::abs(last_turn.lag) * 180.0 / pi;
  return last_turn;
}
// The error of a polygon against the circle grows with the square of the angle of one side. Two polygons, one with
// twice as many corners, therefore give the values for the circle by extrapolation.
template <class Law>
Turn circle(P<Law> const& p, double radius, int corners = 4000) {
  auto const once = turn<Law>(p, radius, corners), twice = turn<Law>(p, radius, 2 * corners);
  auto const limit = [](double a, double b) { return b + (b - a) / 3.0; };
  return {limit(once.size, twice.size), limit(once.lag, twice.lag), limit(once.work, twice.work)};
}

// On a circle of radius R the hysteretic force of strength 1, exponent n and yield length U has the size q with q^n =
// cos(lag). Its angle behind the motion, the lag, obeys sin(lag) = U q / R.
TEST(PlaneLaws, circles_of_the_core) {
  struct Expected {
    double radius, size, lag;
  };
  for (auto const& e : {Expected{0.5, 0.863114152, 25.566417}, Expected{1.0, 0.958629357, 13.866317},
                        Expected{2.0, 0.989058189, 7.101778}}) {
    auto const got = circle<laws::plane::AbeY0>(abe(0.7, 0.25), e.radius);
    EXPECT_NEAR(got.size, e.size, 2e-9) << e.radius;
    EXPECT_NEAR(got.lag, e.lag, 1e-6) << e.radius;
  }
  P<laws::plane::Vaiana> memory{};
  memory.f0_p = memory.f0_m = 1.0;
  memory.alpha_p = memory.alpha_m = 4.0;
  auto const got = circle<laws::plane::Vaiana>(memory, 1.0);
  EXPECT_NEAR(got.size, 0.970142500, 1e-9);
  EXPECT_NEAR(got.lag, 14.036243, 1e-6);
  EXPECT_NEAR(got.work, 5.913586171, 1e-8);
}

// The parameters are K1 6 kN/mm, K2 0.9 kN/mm and Qd 30 kN.
TEST(PlaneLaws, a_circle_of_plasticity) {
  laws::Bilinear::Params<double> const p{6.0, 0.9, 30.0 / 5.1};
  EXPECT_NEAR(circle<laws::plane::Bilinear>(p, 150.0).work, 28252.6, 0.06);
}

TEST(PlaneLaws, a_path_of_two_memories) {
  using Law = laws::plane::HistoryIntegral;
  laws::HistoryIntegral::Params<double> const p{
      .K = 0.4 * laws::reference_mm, .g = 1.0, .S = 0.15, .D = 0.8, .s = 2.0 / 3.0, .u = 0.25};
  auto state = Law::start<double>(p);
  Vector<double> from{0.0, 0.0};
  struct Corner {
    Vector<double> at, force;
  };
  for (auto const& corner :
       {Corner{{1, 0}, {0.535000965, 0.0}}, Corner{{1, 1}, {0.410890245, 0.535000965}},
        Corner{{-1, 1}, {-0.545052190, 0.402932872}}, Corner{{-1, -1}, {-0.403703024, -0.545650835}},
        Corner{{0, 0}, {0.099338931, 0.092091387}}}) {
    auto const force = Law::step<double>(p, state, from, corner.at, 0.01);
    EXPECT_NEAR(force.x, corner.force.x, 1e-9);
    EXPECT_NEAR(force.y, corner.force.y, 1e-9);
    from = corner.at;
  }
}

// Integrates dz/ds = slope(z, n) along a straight path of the given length in the direction n.
template <class Slope>
Vector<double> integrated(Vector<double> const& z, Vector<double> const& n, double length, Slope const& slope) {
  using State = std::array<double, 2>;
  State at{z.x, z.y};
  if (length > 0.0)
    odeint::integrate_adaptive(
        odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<State>()),
        [&](State const& now, State& dz, double) {
          Vector<double> const d = slope(Vector<double>{now[0], now[1]}, n);
          dz = {d.x, d.y};
        },
        at, 0.0, length, 1e-4 * length);
  return {at[0], at[1]};
}

// Integrates as integrated() does, but stops and starts again where the component of z along n passes 0. The slope may
// have a corner there, which the step control would not notice.
template <class Slope>
Vector<double> integrated_to_the_corner(Vector<double> z, Vector<double> const& n, double length, Slope const& slope) {
  double done = 0.0;
  if (laws::plane::dot(z, n) < 0.0) {
    double low = 0.0, high = length;
    auto const along_after = [&](double way) { return laws::plane::dot(integrated(z, n, way, slope), n); };
    if (along_after(length) < 0.0) low = high;
    while (high - low > 1e-14 * length) {
      double const middle = 0.5 * (low + high);
      (along_after(middle) < 0.0 ? low : high) = middle;
    }
    done = high;
    z = integrated(z, n, done, slope);
  }
  return integrated(z, n, length - done, slope);
}

// Moves a law along random straight steps, short and long. For each step the differential equation is integrated from
// the law's own state at the start of the step, so that errors do not add up. Returns the largest difference of the
// state at the end of a step.
template <class Law, class Slope>
double worst_over_a_walk(P<Law> const& p, Vector<double> S<Law>::*q, Slope const& slope) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  auto state = Law::template start<double>(p);
  double worst = 0.0;
  for (int i = 0; i < 200; ++i) {
    double const length = std::exp(normal(random) - 1.0);
    double const angle = 0.3 * pi * normal(random) + (i % 7 == 0 ? pi : 0.0);
    Vector<double> const n{std::cos(angle), std::sin(angle)};
    auto const expected = integrated_to_the_corner(state.*q, n, length, slope);
    Law::template step<double>(p, state, {0.0, 0.0}, length * n, 0.01);
    worst = std::max(worst, std::hypot((state.*q).x - expected.x, (state.*q).y - expected.y));
  }
  return worst;
}

TEST(PlaneLaws, bouc_wen_of_any_sharpness_follows_its_differential_form) {
  for (double const n : {0.6, 1.0, 1.5, 2.0, 3.0})
    for (double const beta : {0.3, 0.7, 0.95}) {
      double const gamma = 1.0 - beta;
      auto const slope = [&](Vector<double> const& z, Vector<double> const& d) {
        double const p = laws::plane::dot(z, d), size = std::hypot(z.x, z.y);
        double const pull = size > 0.0 ? std::pow(size, n - 2.0) * p * (gamma + (p < 0.0 ? -beta : beta)) : 0.0;
        return d - pull * z;
      };
      EXPECT_LT(worst_over_a_walk<laws::plane::BoucWen>(bouc_wen(n, beta, gamma), &S<laws::plane::BoucWen>::z, slope),
                n < 1.0 ? 1e-6 : 1e-7)
          << n << " " << beta;
    }
}

// Some programs write Bouc-Wen's equation with the absolute value of each component. This form is not isotropic: its
// forces change if motion and axes are turned. docs/bidirectional.md quotes these numbers.
TEST(PlaneLaws, the_form_in_components_turns_with_the_axes) {
  constexpr int samples = 10000;
  auto const force = [&](double angle, double beta, bool in_components) {
    double const c = std::cos(angle), s = std::sin(angle), gamma = 1.0 - beta;
    Vector<double> from{0.0, 0.0}, z{0.0, 0.0};
    std::vector<Vector<double>> forces;
    for (int i = 1; i <= 2 * samples; ++i) {
      double const phase = 2.0 * pi * i / samples, x = 5.0 * std::sin(phase), y = 2.5 * std::sin(2.0 * phase);
      Vector<double> const to{c * x - s * y, s * x + c * y}, d = to - from;
      double const along = laws::plane::dot(d, z);
      double const size = in_components ? std::abs(d.x * z.x) + std::abs(d.y * z.y) : std::abs(along);
      z = z + d - (beta * size + gamma * along) * z;
      from = to;
      if (i > samples) forces.push_back({c * z.x + s * z.y, c * z.y - s * z.x});
    }
    return forces;
  };
  for (double const beta : {0.5, 0.9})
    for (bool const in_components : {true, false}) {
      auto const straight = force(0.0, beta, in_components), turned = force(0.4, beta, in_components);
      double worst = 0.0;
      for (std::size_t i = 0; i < straight.size(); ++i)
        worst = std::max(worst, std::hypot(straight[i].x - turned[i].x, straight[i].y - turned[i].y));
      EXPECT_NEAR(worst, !in_components ? 0.0 : beta == 0.5 ? 0.041 : 0.070, in_components ? 1e-3 : 1e-12) << beta;
    }
}

TEST(PlaneLaws, abe_of_any_sharpness_follows_its_differential_form) {
  for (double const n : {0.01, 0.1, 0.3, 0.7, 1.0}) {
    auto const slope = [&](Vector<double> const& q, Vector<double> const& d) {
      double const size = std::hypot(q.x, q.y);
      return d - (size > 0.0 ? std::pow(size, n - 1.0) : 0.0) * q;
    };
    EXPECT_LT(worst_over_a_walk<laws::plane::AbeY0>(abe(n, 1.0), &S<laws::plane::AbeY0>::f, slope),
              n < 0.3 ? 1e-6 : 2e-7)
        << n;
  }
}

}  // namespace
}  // namespace isolaw::plane_oracles
