// Compares the functions of num/elementary.hpp with results in long double. On every instruction set that this
// processor has, the errors must be within those that the header states.
#include "isolaw/num/elementary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "unit/elementary_arrays.hpp"

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

using namespace isolaw::num;
using Arrays = ElementaryArrays;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t samples = 1 << 18, samples_of_bits = 1 << 20;

// Applies a scalar function to each element of an array, one at a time, as other files of the project call scalar
// functions.
template <double (*function)(double, double)>
void one_by_one(double const* x, double const* p, double* y) {
  for (std::size_t i = 0; i < Arrays::lanes; ++i) y[i] = function(x[i], p[i]);
}
double exp2_here(double x, double) {
  return fast_exp2(x);
}
double exp_here(double x, double) {
  return fast_exp(x);
}
double log2_here(double x, double) {
  return fast_log2(x);
}
double power_here(double x, double p) {
  return fast_power(x, p);
}

struct Route {
  std::string name;
  bool fused;  // whether it uses fused multiply-add
  Arrays::Function exp2, exp, log2, power;
};

std::vector<Route> routes() {
#ifdef __FMA__
  constexpr bool fused_here = true;
#else
  constexpr bool fused_here = false;
#endif
  std::vector<Route> all{
      {"here", fused_here, one_by_one<exp2_here>, one_by_one<exp_here>, one_by_one<log2_here>, one_by_one<power_here>}};
  auto const add = [&](std::string const& set, bool fused, Arrays const& a) {
    all.push_back({set + " loop", fused, a.exp2, a.exp, a.log2, a.power});
    all.push_back({set + " vectors", fused, a.vector_exp2, a.vector_exp, a.vector_log2, a.vector_power});
  };
  add("baseline", false, elementary_baseline);
  if (runs_v3()) add("v3", true, elementary_v3);
  if (runs_v4()) add("v4", true, elementary_v4);
  return all;
}

std::vector<double> apply(Arrays::Function f, std::vector<double> x, std::vector<double> p = {}) {
  std::size_t const count = x.size(), whole = (count + Arrays::lanes - 1) / Arrays::lanes * Arrays::lanes;
  x.resize(whole, 1.0);
  p.resize(whole, 1.0);
  std::vector<double> y(whole);
  for (std::size_t i = 0; i < whole; i += Arrays::lanes) f(&x[i], &p[i], &y[i]);
  y.resize(count);
  return y;
}

std::vector<double> uniform(double lower, double upper, std::uint64_t seed = 1, std::size_t count = samples) {
  std::mt19937_64 engine(seed);
  std::uniform_real_distribution<double> distribution(lower, upper);
  std::vector<double> values(count);
  for (double& v : values) v = distribution(engine);
  return values;
}
// Returns values that are evenly spread on a logarithmic scale.
std::vector<double> binades(double lower, double upper) {
  auto values = uniform(std::log2(lower), std::log2(upper));
  for (double& v : values) v = std::exp2(v);
  return values;
}

long double ulp_of(long double exact) {
  double const size = std::abs(static_cast<double>(exact));
  int exponent = 0;
  std::frexp(size, &exponent);
  return std::ldexp(1.0L, std::max(exponent, -1021) - 53);
}

// Holds arguments with their exact results. The exact results take most of the test's time, so they are computed once
// for all variants of a function.
template <class Exact>
struct Checked {
  std::vector<double> x;
  std::vector<long double> truth;

  Checked(std::vector<double> arguments, Exact exact) : x(std::move(arguments)) {
    for (double v : x) truth.push_back(exact(static_cast<long double>(v)));
  }
  double largest_ulp(Arrays::Function f) const {
    auto const y = apply(f, x);
    double largest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      auto const error = static_cast<double>(std::abs(static_cast<long double>(y[i]) - truth[i]) / ulp_of(truth[i]));
      if (!(error <= largest)) largest = error;  // the comparison is written so that NaN becomes the largest error
    }
    return largest;
  }
};

constexpr auto exact_exp2 = [](long double x) { return std::exp2(x); };
constexpr auto exact_exp = [](long double x) { return std::exp(x); };
constexpr auto exact_log2 = [](long double x) { return std::log2(x); };

// Returns the largest relative error of a function that is called here with one argument at a time. Calls with batches
// of arguments are left to the tests of the laws, which compare batches with single calls.
template <class F, class Exact>
double largest_relative(std::vector<double> const& arguments, F f, Exact exact) {
  double largest = 0.0;
  for (double const x : arguments) {
    long double const truth = exact(static_cast<long double>(x));
    auto const error = static_cast<double>(std::abs((static_cast<long double>(f(x)) - truth) / truth));
    if (!(error <= largest)) largest = error;  // the comparison is written so that NaN becomes the largest error
  }
  return largest;
}

TEST(Elementary, Expm1) {
  auto const exact = [](long double x) { return std::expm1(x); };
  auto const here = [](double x) { return fast_expm1(x); };
  EXPECT_LE(largest_relative(uniform(-700.0, 700.0), here, exact), 4e-16);
  EXPECT_LE(largest_relative(uniform(-2.0, 2.0), here, exact), 4e-16);
  EXPECT_LE(largest_relative(binades(1e-300, 1.0), here, exact), 4e-16);
  EXPECT_EQ(fast_expm1(0.0), 0.0);
  EXPECT_EQ(fast_expm1(-1e9), -1.0);
  EXPECT_EQ(fast_expm1(1e9), fast_expm1(700.0));
  EXPECT_TRUE(std::isnan(fast_expm1(not_a_number)));
}

TEST(Elementary, FifthRoot) {
  auto const exact = [](long double x) { return std::pow(x, 0.2L); };
  auto const here = [](double x) { return fast_fifth_root(x); };
  EXPECT_LE(largest_relative(uniform(0.0, 40.0), here, exact), 6.5e-14);
  EXPECT_LE(largest_relative(binades(1e-290, 1e290), here, exact), 6.5e-14);
  EXPECT_EQ(fast_fifth_root(0.0), 0.0);
  EXPECT_TRUE(std::isnan(fast_fifth_root(not_a_number)));
}

TEST(Elementary, Exp2) {
  Checked const wide(uniform(-1022.0, 1023.4999), exact_exp2), narrow(uniform(-2.0, 2.0), exact_exp2);
  for (auto const& route : routes()) {
    double const bound = route.fused ? 0.9 : 1.2;
    EXPECT_LE(wide.largest_ulp(route.exp2), bound) << route.name;
    EXPECT_LE(narrow.largest_ulp(route.exp2), bound) << route.name;
    auto const whole = apply(route.exp2, {0.0, -0.0, 1.0, 10.0, -1022.0, 1023.0});
    EXPECT_EQ(whole, (std::vector{1.0, 1.0, 2.0, 1024.0, 0x1p-1022, 0x1p1023})) << route.name;
  }
}

TEST(Elementary, Exp) {
  Checked const wide(uniform(-708.3, 709.4), exact_exp), narrow(uniform(-2.0, 2.0), exact_exp);
  for (auto const& route : routes()) {
    double const bound = route.fused ? 0.9 : 1.2;
    EXPECT_LE(wide.largest_ulp(route.exp), bound) << route.name;
    EXPECT_LE(narrow.largest_ulp(route.exp), bound) << route.name;
    EXPECT_EQ(apply(route.exp, {0.0, -0.0}), (std::vector{1.0, 1.0})) << route.name;
  }
}

TEST(Elementary, ExponentialsBeyondTheirRange) {
  double const huge = std::numeric_limits<double>::max();
  for (auto const& route : routes()) {
    EXPECT_EQ(apply(route.exp2, {1023.5, 1024.0, 3000.0, 1e9, huge, infinity}), std::vector(6, infinity)) << route.name;
    EXPECT_EQ(apply(route.exp2, {-1022.6, -1075.0, -3000.0, -1e9, -huge, -infinity}), std::vector(6, 0.0))
        << route.name;
    EXPECT_EQ(apply(route.exp, {709.44, 710.0, 3000.0, 1e9, huge, infinity}), std::vector(6, infinity)) << route.name;
    EXPECT_EQ(apply(route.exp, {-708.75, -745.2, -3000.0, -1e9, -huge, -infinity}), std::vector(6, 0.0)) << route.name;
    // Subnormal results have fewer bits, and these bits must be right.
    EXPECT_LE(Checked({-1022.4, -1022.2}, exact_exp2).largest_ulp(route.exp2), 1.2) << route.name;
    for (auto const f : {route.exp2, route.exp})
      for (double y : apply(f, {not_a_number, -not_a_number})) EXPECT_TRUE(std::isnan(y)) << route.name;
  }
}

TEST(Elementary, Log2) {
  auto arguments = uniform(-30.0, -2.0);
  for (std::size_t i = 0; i < arguments.size(); ++i)
    arguments[i] = 1.0 + (i % 2 ? 1.0 : -1.0) * std::exp2(arguments[i]);
  Checked const wide(binades(0x1p-1022, 0x1.fffp1023), exact_log2), near(uniform(0.5, 2.0), exact_log2),
      nearer(arguments, exact_log2);
  for (auto const& route : routes()) {
    double const bound = route.fused ? 1.6 : 1.8;
    EXPECT_LE(wide.largest_ulp(route.log2), bound) << route.name;
    EXPECT_LE(near.largest_ulp(route.log2), bound) << route.name;
    EXPECT_LE(nearer.largest_ulp(route.log2), bound) << route.name;
    EXPECT_EQ(apply(route.log2, {1.0, 2.0, 0.5, 1024.0, 0x1p-1022, 0x1p1023, infinity}),
              (std::vector{0.0, 1.0, -1.0, 10.0, -1022.0, 1023.0, infinity}))
        << route.name;
    for (double y : apply(route.log2, {0.0, -0.0, -1.0, -1e300, -1e-300, 1e-310, -infinity, not_a_number}))
      EXPECT_TRUE(std::isnan(y)) << route.name;
  }
}

TEST(Elementary, Power) {
  auto const p = uniform(-3.0, 3.0, 2);
  for (auto const& x : {binades(1e-290, 1e10), binades(1e-3, 1e3), uniform(0.9, 1.1)}) {
    std::vector<long double> exponent, truth;
    for (std::size_t i = 0; i < x.size(); ++i) {
      exponent.push_back(p[i] * std::log2(static_cast<long double>(x[i]) + 1e-290L));
      truth.push_back(std::pow(static_cast<long double>(x[i]) + 1e-290L, static_cast<long double>(p[i])));
    }
    for (auto const& route : routes()) {
      auto const y = apply(route.power, x, p);
      double largest = 0.0;  // largest error divided by the error that the header states
      for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::abs(exponent[i]) > 1021.0L) continue;
        double const lost = route.fused ? 0.0 : static_cast<double>(std::abs(exponent[i]));
        double const stated = 0x1p-53 * (2.0 + std::abs(p[i]) + lost);
        double const error =
            static_cast<double>(std::abs(static_cast<long double>(y[i]) - truth[i]) / truth[i]) / stated;
        if (!(error <= largest)) largest = error;
      }
      EXPECT_LE(largest, 1.0) << route.name;
    }
  }
}

TEST(Elementary, PowerOfSpecialValues) {
  for (auto const& route : routes()) {
    EXPECT_EQ(apply(route.power, {1.0, 1.0, -1.0, 2.0, -2.0, 2.0, 2.0, 0.5, 0.0, 1e300, 1e-300},
                    {0.5, 0.0, 1.5, 2.0, 2.0, 5000.0, -5000.0, 5000.0, 4.0, 2.0, 2.0}),
              (std::vector{1.0, 1.0, 1.0, 4.0, 4.0, infinity, 0.0, 0.0, 0.0, infinity, 0.0}))
        << route.name;
    EXPECT_NEAR(apply(route.power, {0.0}, {1.0})[0], 1e-290, 1e-304) << route.name;
    EXPECT_NEAR(apply(route.power, {0.0}, {0.01})[0], std::pow(1e-290, 0.01), 1e-15) << route.name;
    auto const nan = apply(route.power, {not_a_number, infinity, -infinity, 2.0, 2.0, not_a_number},
                           {2.0, 2.0, 2.0, not_a_number, infinity, 0.0});
    for (double y : nan) EXPECT_FALSE(std::isfinite(y)) << route.name;
  }
}

TEST(Elementary, EveryInstructionSetWithFusedMultiplyAddGivesTheSameBits) {
  if (!runs_v4()) GTEST_SKIP() << "this processor does not run x86-64-v4 (AVX-512): nothing to compare v3 with";
  std::vector<double> any(samples_of_bits);
  std::mt19937_64 engine(3);
  for (double& x : any) x = std::bit_cast<double>(engine());  // any bit pattern: subnormal, infinite, NaN
  auto const p = uniform(-3.0, 3.0, 2, samples_of_bits);
  auto const same = [&](Arrays::Function a, Arrays::Function b, std::vector<double> const& x) {
    auto const first = apply(a, x, p), second = apply(b, x, p);
    std::size_t different = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!(std::isnan(first[i]) && std::isnan(second[i])) &&
          std::bit_cast<std::uint64_t>(first[i]) != std::bit_cast<std::uint64_t>(second[i]))
        ++different;
    return different == 0;
  };
  Arrays const &v3 = elementary_v3, &v4 = elementary_v4;
  for (auto const& x : {any, uniform(-1100.0, 1100.0, 4, samples_of_bits), uniform(-4.0, 4.0, 5, samples_of_bits),
                        binades(1e-290, 1e10)}) {
    EXPECT_TRUE(same(v3.exp2, v4.exp2, x));
    EXPECT_TRUE(same(v3.exp, v4.exp, x));
    EXPECT_TRUE(same(v3.log2, v4.log2, x));
    EXPECT_TRUE(same(v3.power, v4.power, x));
    EXPECT_TRUE(same(v3.exp2, v4.vector_exp2, x) && same(v3.exp2, v3.vector_exp2, x));
    EXPECT_TRUE(same(v3.exp, v4.vector_exp, x) && same(v3.exp, v3.vector_exp, x));
    EXPECT_TRUE(same(v3.log2, v4.vector_log2, x) && same(v3.log2, v3.vector_log2, x));
    EXPECT_TRUE(same(v3.power, v4.vector_power, x) && same(v3.power, v3.vector_power, x));
  }
}

}  // namespace
