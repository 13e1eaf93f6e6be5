// The hot path: one candidate of each law over one record of 600 samples, with both integrations.
// Compare ratios within one run; the counter `per_sample` is the time per sample and candidate.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace {

using namespace isolaw;

constexpr std::size_t samples = 600;

// +-208 mm at 0.5 Hz, 100 samples per second, in the law's units.
laws::Path record_path(laws::LawInfo const& law) {
  double const length = law.length.in_record_units, w = std::numbers::pi;
  std::vector<double> x, v;
  for (std::size_t i = 0; i < samples; ++i) {
    double const t = 0.01 * static_cast<double>(i);
    x.push_back(208.0 / length * std::sin(w * t));
    v.push_back(208.0 / length * w * std::cos(w * t));
  }
  return laws::make_path(x, v);
}

// The middle of the published box; the middle of nothing where the paper has none.
std::vector<double> middle(laws::LawEntry const& law) {
  std::vector<double> values;
  for (auto const& p : law.parameters)
    values.push_back(p.published ? 0.5 * (p.published->lower + p.published->upper) : p.fixed_by_default.value_or(0.0));
  return values;
}

void evaluate(benchmark::State& state, laws::LawEntry const& law, laws::Integration integration) {
  auto const path = record_path(law.info);
  auto const parameters = middle(law);
  std::vector<double> force(samples);
  for (auto _ : state) {
    law.evaluate(parameters, path, integration, force);
    benchmark::DoNotOptimize(force.data());
    benchmark::ClobberMemory();
  }
  state.counters["per_sample"] = benchmark::Counter(
      static_cast<double>(samples), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

int const registered = [] {
  for (auto const& law : laws::catalogue())
    for (auto const integration : {laws::Integration::converged, laws::Integration::paper})
      benchmark::RegisterBenchmark(
          (std::string(law.info.id) + (integration == laws::Integration::paper ? "/paper" : "/converged")).c_str(),
          [&law, integration](benchmark::State& state) { evaluate(state, law, integration); });
  return 0;
}();

}  // namespace
