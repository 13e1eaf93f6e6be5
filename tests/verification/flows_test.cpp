// ozdemir and bwbn are compared with closed forms, with the equations of their sources, which this file integrates in
// many steps, and with values of another implementation.
#include "isolaw/num/error_function.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>
#include <vector>

#include "laws/candidates.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {
namespace {

using laws::Bwbn;
using laws::Ozdemir;

// Integrates dy/dx = slope(x, y, direction) along the path through the given corners, by `steps` classical Runge-Kutta
// steps from corner to corner, and returns y at each corner.
template <std::size_t N, class Slope>
std::vector<std::array<double, N>> integrated(std::vector<double> const& corner, int steps, Slope const& slope) {
  using Y = std::array<double, N>;
  auto const plus = [](Y y, double h, Y const& k) {
    for (std::size_t i = 0; i < N; ++i) y[i] += h * k[i];
    return y;
  };
  std::vector<Y> at{Y{}};
  for (std::size_t c = 1; c < corner.size(); ++c) {
    double const h = (corner[c] - corner[c - 1]) / steps, direction = sign(h);
    Y y = at.back();
    for (int i = 0; i < steps; ++i) {
      double const x = corner[c - 1] + h * i;
      Y const k1 = slope(x, y, direction), k2 = slope(x + h / 2, plus(y, h / 2, k1), direction);
      Y const k3 = slope(x + h / 2, plus(y, h / 2, k2), direction), k4 = slope(x + h, plus(y, h, k3), direction);
      y = plus(plus(plus(plus(y, h / 6, k1), h / 3, k2), h / 3, k3), h / 6, k4);
    }
    at.push_back(y);
  }
  return at;
}

double energy(std::vector<double> const& x, std::vector<double> const& force, std::size_t from) {
  double sum = 0.0;
  for (std::size_t k = from; k + 1 < x.size(); ++k) sum += 0.5 * (force[k] + force[k + 1]) * (x[k + 1] - x[k]);
  return sum;
}

// num::erf is compared with the C library's at dense points of both signs, where one rational function takes over from
// the other, and where the result reaches 1.
TEST(ErrorFunction, IsThatOfTheLibrary) {
  for (double u = 1e-300; u < 1e3; u *= 1.0007) {
    EXPECT_NEAR(num::erf(u), std::erf(u), 4e-16 * std::min(1.0, 2.0 * u)) << u;
    EXPECT_EQ(num::erf(-u), -num::erf(u)) << u;
  }
  for (double const u : {0.0, 0.46874999, 0.46875, 0.46875001, 5.99999, 6.0, 6.1, 1e300})
    EXPECT_NEAR(num::erf(u), std::erf(u), 4e-16) << u;
  EXPECT_TRUE(std::isnan(num::erf(std::nan(""))));
}

// For n = 1 the hysteretic force z approaches its saturation value +-Y as exp(-K |dx| / Y), for either sign of z. For n
// = 2, z follows a tanh on loading and a tan on unloading. saturating_flow.hpp errs by 1e-9 for these n, and by 1e-5 at
// worst for other n.
TEST(Ozdemir, ClosedForms) {
  double const K = 3.0, Y = 40.0, alpha = 0.2;
  double z1 = 0.0, z2 = 0.0;
  auto const at1 = forces<Ozdemir>({K, Y, 1.0, alpha, 0, 0, 0}, laws::make_path(corners, {}));
  auto const at2 = forces<Ozdemir>({K, Y, 2.0, alpha, 0, 0, 0}, laws::make_path(corners, {}));
  for (std::size_t i = 1; i < corners.size(); ++i) {
    double const dx = corners[i] - corners[i - 1], d = sign(dx), t = K * std::abs(dx) / Y;
    z1 = d * Y + (z1 - d * Y) * std::exp(-t);
    double const u = d * z2 / Y, to_zero = u < 0.0 ? std::atan(-u) : 0.0;
    z2 = d * Y *
         (u >= 0.0      ? std::tanh(std::atanh(u) + t)
          : t < to_zero ? -std::tan(to_zero - t)
                        : std::tanh(t - to_zero));
    EXPECT_NEAR(at1[i], alpha * K * corners[i] + z1, 1e-8 * Y) << i;
    EXPECT_NEAR(at2[i], alpha * K * corners[i] + z2, 1e-7 * Y) << i;
  }
}

// The source writes the law with its own stiffness Ks and strength Ys, and with the force s that is left after the
// backstress: F' = Ks (x' - |x'| |s/Ys|^n sgn(s)), s = F - Ks alpha (x - F/Ks).
TEST(Ozdemir, IsTheSourceWithItsBackstress) {
  double const Ks = 3.6, Ys = 30.0, alpha = 0.25;
  for (double const n : {1.0, 1.7, 3.0}) {
    auto const oracle = integrated<1>(corners, 20000, [&](double x, std::array<double, 1> const& F, double d) {
      double const s = F[0] - Ks * alpha * (x - F[0] / Ks);
      return std::array{Ks * (1.0 - d * std::pow(std::abs(s / Ys), n) * sign(s))};
    });
    double const K = Ks / (1.0 + alpha), Y = Ys * std::pow(1.0 + alpha, -1.0 - 1.0 / n);
    auto const found = forces<Ozdemir>({K, Y, n, alpha, 0, 0, 0}, laws::make_path(corners, {}));
    // The law's curve between reversals errs by 9e-8 for these parameters, and the 20,000 Runge-Kutta steps far less.
    for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_NEAR(found[i], oracle[i][0], 1e-6 * Ys) << n << ", " << i;
  }
}

TEST(Ozdemir, TheTermOfAlloysIsElastic) {
  double const K = 3.0, alpha = 0.2;
  auto const x = through(corners, 7);
  auto const path = laws::make_path(x, {});
  auto const without = forces<Ozdemir>({K, 40.0, 0.7, alpha, 0, 0, 0}, path);
  for (double const c : {0.0, 0.4, 2.0}) {
    auto const with = forces<Ozdemir>({K, 40.0, 0.7, alpha, 25.0, c, 0.03}, path);
    for (std::size_t i = 0; i < x.size(); ++i)
      EXPECT_NEAR(with[i] - without[i], alpha * K * 25.0 * std::pow(std::abs(x[i]) / 100.0, c) * std::erf(0.03 * x[i]),
                  1e-13);
  }
}

// For other programs, `export` writes an ozdemir law as a bouc-wen law. This bouc-wen law must give the same forces. An
// ozdemir law with the term for superelastic alloys cannot be written as a bouc-wen law.
TEST(Ozdemir, IsBoucWen) {
  auto const x = through(corners, 7);
  auto const path = laws::make_path(x, {});
  for (std::uint32_t i = 0; i < 50; ++i) {
    auto const values = scaled_candidate<Ozdemir>(i);
    auto const form = std::get<laws::BoucWenForm>(Ozdemir::canonical(laws::unpack<Ozdemir, double>(values)));
    auto const force = forces<Ozdemir>(values, path);
    // The forces differ by rounding only. bouc-wen computes the saturation value of z as (1 / beta)^(1/n), which
    // multiplies the rounding of beta by 1/n, that is by ten for n = 0.1.
    EXPECT_LT(largest_difference(forces<laws::BoucWen>({form.alpha, form.Ke, 1.0, form.beta, form.n, form.gamma}, path),
                                 force),
              1e-11 * largest_magnitude(force));
  }
  EXPECT_TRUE(std::holds_alternative<laws::NoForm>(Ozdemir::canonical({3, 40, 1, 0.2, 10, 0.5, 0.01})));
}

// One step gives the same force as a thousand steps that cover the same displacement.
TEST(Ozdemir, StepsAdd) {
  for (std::uint32_t i = 0; i < 50; ++i) {
    auto const values = candidate<Ozdemir>(i);
    auto const whole = forces<Ozdemir>(values, laws::make_path(corners, {}));
    auto const cut = forces<Ozdemir>(values, laws::make_path(through(corners, 1000), {}));
    for (std::size_t k = 0; k < whole.size(); ++k)
      EXPECT_NEAR(cut[1000 * k], whole[k], 1e-12 * largest_magnitude(whole)) << i;
  }
}

// The force must be continuous: as the last step is halved, the change of the force over it tends to 0. `bound` gives
// the largest change that the law's slopes allow over a step of a given length.
template <class Law, class Bound>
void expect_continuous(Values<Law> const& values, Bound const& bound) {
  std::vector<std::vector<double>> const histories{
      {0}, {0, 50}, {0, 50, 10}, {0, 50, -50, 0}, {0, 50, -30, 50}, {0, 20, 5, 20}};
  for (auto const& history : histories)
    for (double const side : {1.0, -1.0})
      for (double d = 1.0; d > 1e-12; d *= 0.5) {
        auto x = history;
        x.push_back(x.back() + side * d);
        auto const force = forces<Law>(values, laws::make_path(x, {}));
        // At a reversal the law converts z to travel and back, which changes the force by up to 1e-11 of its value.
        EXPECT_LE(std::abs(force.back() - force[force.size() - 2]), bound(d) + 1e-9) << d << " from " << history.back();
      }
}

TEST(Ozdemir, IsContinuous) {
  double const K = 3.0, alpha = 0.2;
  // The slope of z is at most 2 K, and that of erf(a x) at most a times 2 / sqrt(pi), here below 2 x 0.03 / mm.
  for (double const n : {0.2, 1.0, 2.5})
    expect_continuous<Ozdemir>({K, 40.0, n, alpha, 25.0, 0.5, 0.03}, [&](double d) {
      return (2.0 * K + alpha * K * (1.0 + 25.0 * (2.0 * 0.03 + 0.01))) * d;
    });
}

// The hysteretic force z obeys dx = dz / K + |dx| |z/Y|^n sgn(z). So its work z dx is the change of the stored energy
// z^2 / 2K plus the loss |z| |z/Y|^n |dx|, which is never negative. From rest at x = 0, the first and the second cycle
// of 2, 50 and 208 mm must therefore lose energy for all parameters in the box.
TEST(Ozdemir, CyclesDissipate) {
  for (double const amplitude : {2.0, 50.0, 208.0})
    for (std::uint32_t i = 0; i < 200; ++i) {
      auto const x = through({0.0, amplitude, 0.0, -amplitude, 0.0, amplitude, 0.0, -amplitude, 0.0}, 100);
      auto const candidate = scaled_candidate<Ozdemir>(i);
      auto const force = forces<Ozdemir>(candidate, laws::make_path(x, {}));
      // A cycle that is almost elastic loses less than the numerical error of the law.
      double const error = 3e-7 * candidate[index_of<Ozdemir>("Y")] * amplitude;
      EXPECT_GT(energy(x, force, 0), -error) << amplitude << " mm, " << i;
      EXPECT_GT(energy(x, force, 400), -error) << amplitude << " mm, " << i;
    }
}

// Parameters of the test Bwbn.Values, whose expected values another implementation computed in many small steps.
Values<Bwbn> const joint{0.03, 24.877, 1.0, 0.5, 0.1, 1.0, 0.4, 0.9, 1.0, 0.2, 0.001, 0.05, 0.0, 0.0};

TEST(Bwbn, Values) {
  std::vector<double> const path{0, 1.57, -0.95, 1.64, -0.97, 3.19, -1.91};
  constexpr std::array<double, 6> F{16.6969329, -16.6824397, 17.1413822, -16.532185, 20.6176801, -21.1463602};
  constexpr std::array<double, 6> z{0.6433809, -0.6619556, 0.6596344, -0.6551103, 0.7557576, -0.8172542};
  constexpr std::array<double, 6> e{17.6159797, 36.62436, 55.99685, 75.43654, 120.80004, 179.58997};
  constexpr int steps = 1000;
  auto const params = laws::unpack<Bwbn, double>(joint);
  auto const fine_path = laws::make_path(through(path, steps), {});
  auto const constants = Bwbn::constants<double, double>(params);
  Bwbn::State<double> state;
  for (std::size_t i = 0; i < fine_path.steps.size(); ++i) {
    double const force = Bwbn::step(params, constants, state, fine_path.steps[i]);
    if (i == 0 || i % steps != 0) continue;
    std::size_t const corner = i / steps - 1;
    // The tolerances are a little more than half a unit of the last digit that the source prints. It prints some of the
    // energies e with only five decimals.
    EXPECT_NEAR(force, F[corner], 8e-8);
    EXPECT_NEAR(state.z, z[corner], 8e-8);
    EXPECT_NEAR(state.e, e[corner], corner == 0 ? 8e-8 : 6e-6);
  }
}

// The law, with degradation and pinching, is compared with its equations. This test integrates them by Runge-Kutta.
TEST(Bwbn, IsItsEquations) {
  Values<Bwbn> const bearing{0.15, 3.0, 1.0, 0.06, 0.02, 1.3, 0.25, 0.5, 2e-4, 3.0, 1e-4, 0.3, 2e-5, 1e-5};
  for (double const A : {1.0, 1.4}) {
    auto values = bearing;
    values[2] = A;
    auto const [alpha, ko, A_, beta, gamma, n, q, zs, p, psi, dpsi, lambda, dnu, deta] = values;
    auto const slope = [&, alpha = alpha, ko = ko, A = A_, beta = beta, gamma = gamma, n = n, q = q, zs = zs, p = p,
                        psi = psi, dpsi = dpsi, lambda = lambda, dnu = dnu,
                        deta = deta](double, std::array<double, 2> const& y, double d) {
      double const z = y[0], e = y[1], nu = 1.0 + dnu * e, zu = std::pow(A / (nu * (beta + gamma)), 1.0 / n);
      double const z1 = zs * (1.0 - std::exp(-p * e)), z2 = (psi + dpsi * e) * (lambda + z1);
      double const h = 1.0 - z1 * std::exp(-std::pow((z * d - q * zu) / z2, 2.0));
      return std::array{h * (A - nu * std::pow(std::abs(z), n) * (gamma + beta * sign(z * d))) / (1.0 + deta * e),
                        (1.0 - alpha) * ko * z};
    };
    std::vector<double> path{0, 50, -100, 150, -200, 200, -200, 100, 60, 130, -50};
    auto const oracle = integrated<2>(path, 40000, slope);
    auto const found = forces<Bwbn>(values, laws::make_path(through(path, 100), {}));
    for (std::size_t i = 0; i < path.size(); ++i) {
      double const expected = alpha * ko * path[i] + (1.0 - alpha) * ko * oracle[i][0];
      // The law holds the strength constant over each step, which changes the force by 8e-6 of its peak, 107 kN.
      EXPECT_NEAR(found[100 * i], expected, 3e-5 * 107.0) << A << ", " << path[i];
    }
  }
}

// Without pinching and degradation bwbn must equal bouc-wen with the parameters that canonical() returns.
TEST(Bwbn, IsBoucWenWithoutPinching) {
  auto const path = laws::make_path(through(corners, 7), {});
  for (std::uint32_t i = 0; i < 50; ++i) {
    auto values = scaled_candidate<Bwbn>(i);
    values[2] = 1.0 + 0.01 * i;
    for (auto const* name : {"zs", "dnu", "deta"}) values[index_of<Bwbn>(name)] = 0.0;
    auto const force = forces<Bwbn>(values, path);
    auto const params = laws::unpack<Bwbn, double>(values);
    auto const form = std::get<laws::BoucWenForm>(Bwbn::canonical(params));
    EXPECT_LT(largest_difference(forces<laws::BoucWen>({form.alpha, form.Ke, 1.0, form.beta, form.n, form.gamma}, path),
                                 force),
              1e-9 * largest_magnitude(force))
        << i;
  }
}

TEST(Bwbn, AIsRedundant) {
  auto const path = laws::make_path(through(corners, 20), {});
  for (std::uint32_t i = 0; i < 50; ++i) {
    auto values = scaled_candidate<Bwbn>(i);
    values[2] = 0.6 + 0.02 * i;
    auto const r = Bwbn::reduced(laws::unpack<Bwbn, double>(values));
    auto reduced = values;
    for (std::size_t k = 0; k < reduced.size(); ++k) reduced[k] = r.*(Bwbn::rows<double>[k].member);
    auto const force = forces<Bwbn>(values, path);
    EXPECT_EQ(r.A, 1.0);
    EXPECT_LT(largest_difference(forces<Bwbn>(reduced, path), force), 1e-10 * largest_magnitude(force)) << i;
  }
}

// At the same z unloading is at least as steep as loading, because pinching is strongest on loading, at z sgn(dx) = q
// zu with q >= 0. The dissipated energy e therefore never falls below 0, and cycles that start and end at x = 0 lose
// energy for all parameters in the box.
TEST(Bwbn, CyclesDissipate) {
  for (double const amplitude : {2.0, 50.0, 208.0})
    for (std::uint32_t i = 0; i < 200; ++i) {
      auto const x = through({0.0, amplitude, 0.0, -amplitude, 0.0, amplitude, 0.0, -amplitude, 0.0}, 100);
      auto const force = forces<Bwbn>(scaled_candidate<Bwbn>(i), laws::make_path(x, {}));
      EXPECT_GT(energy(x, force, 0), 0.0) << amplitude << " mm, " << i;
      EXPECT_GT(energy(x, force, 400), 0.0) << amplitude << " mm, " << i;
    }
}

TEST(Bwbn, IsContinuous) {
  Values<Bwbn> const bearing{0.15, 3.0, 1.0, 0.06, 0.02, 0.6, 0.25, 0.5, 2e-4, 3.0, 1e-4, 0.3, 2e-5, 1e-5};
  double const zu = std::pow(0.08, -1.0 / 0.6);
  // The law is steepest on unloading from saturation, where dz/dx = 1 + |z|^n (beta - gamma).
  expect_continuous<Bwbn>(bearing, [&](double d) { return 3.0 * (1.0 + 0.04 * std::pow(zu, 0.6)) * d; });
}

}  // namespace
}  // namespace isolaw::law_tests
