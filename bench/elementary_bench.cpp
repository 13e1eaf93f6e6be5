// Times the functions of num/elementary.hpp and of the standard library for each instruction set, on arrays of 32
// numbers, which fit into the first-level cache. The counter `per_element` is the time per number.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <random>
#include <string>

#include "unit/elementary_arrays.hpp"

namespace {

using isolaw::num::ElementaryArrays;
using Array = std::array<double, ElementaryArrays::lanes>;

template <class F>
void standard(double const* x, double const* p, double* y, F f) {
  for (std::size_t i = 0; i < ElementaryArrays::lanes; ++i) y[i] = f(x[i], p[i]);
}
ElementaryArrays::Function const standard_exp2 = [](double const* x, double const* p, double* y) {
  standard(x, p, y, [](double a, double) { return std::exp2(a); });
};
ElementaryArrays::Function const standard_exp = [](double const* x, double const* p, double* y) {
  standard(x, p, y, [](double a, double) { return std::exp(a); });
};
ElementaryArrays::Function const standard_log2 = [](double const* x, double const* p, double* y) {
  standard(x, p, y, [](double a, double) { return std::log2(a); });
};
ElementaryArrays::Function const standard_power = [](double const* x, double const* p, double* y) {
  standard(x, p, y, [](double a, double b) { return std::pow(a, b); });
};

void run(benchmark::State& state, ElementaryArrays::Function function, bool exponents) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> log2_x(-20.0, 5.0), power(0.5, 2.0);
  Array x, p, y;
  for (double& v : x) v = exponents ? log2_x(engine) : std::exp2(log2_x(engine));
  for (double& v : p) v = power(engine);
  for (auto _ : state) {
    function(x.data(), p.data(), y.data());
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  state.counters["per_element"] =
      benchmark::Counter(static_cast<double>(ElementaryArrays::lanes),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void add(std::string const& name, ElementaryArrays::Function function, bool exponents) {
  benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) { run(state, function, exponents); });
}

int const registered = [] {
  using namespace isolaw::num;
  add("exp2/std", standard_exp2, true);
  add("exp/std", standard_exp, true);
  add("log2/std", standard_log2, false);
  add("power/std", standard_power, false);
  auto const set = [](std::string const& name, ElementaryArrays const& a) {
    add("exp2/" + name + "/loop", a.exp2, true);
    add("exp2/" + name + "/vectors", a.vector_exp2, true);
    add("exp/" + name + "/loop", a.exp, true);
    add("exp/" + name + "/vectors", a.vector_exp, true);
    add("log2/" + name + "/loop", a.log2, false);
    add("log2/" + name + "/vectors", a.vector_log2, false);
    add("power/" + name + "/loop", a.power, false);
    add("power/" + name + "/vectors", a.vector_power, false);
  };
  set("baseline", elementary_baseline);
  if (runs_v3()) set("v3", elementary_v3);
  if (runs_v4()) set("v4", elementary_v4);
  return 0;
}();

}  // namespace
