// Times the evaluation of every law: a block of candidates over one record of 600 samples, for every instruction set of
// this machine, two block widths (numbers of candidates that are computed together) and two ways of integration. The
// case `scalar` computes one candidate at a time. The counter `per_sample` is the time per sample and candidate. Only
// ratios of times from one run of the program are comparable.
#include <benchmark/benchmark.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "candidates.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/fit/workload.hpp"

namespace {

using namespace isolaw;

constexpr std::size_t samples = 600, drawn = 4 * fit::wide_block;

struct Subject {
  laws::LawEntry const& law;
  laws::Integration integration;

  std::vector<double> candidates(data::FitRecord const& record) const {
    return bench::candidates(fit::make_box(law, fit::BoxKind::published, fit::scales_of(record, law.info), {}), drawn);
  }
};

void count(benchmark::State& state, std::size_t candidates) {
  state.counters["per_sample"] =
      benchmark::Counter(static_cast<double>(samples * candidates),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void one_at_a_time(benchmark::State& state, Subject const& subject) {
  auto const record = fit::workload(samples);
  auto const candidates = subject.candidates(record);
  fit::LawOnRecord const model(subject.law, record, subject.integration);
  std::size_t const parameters = subject.law.parameters.size();
  std::vector<double> force;
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(model.objective(std::span(candidates).subspan(next * parameters, parameters), force));
    next = (next + 1) % drawn;
  }
  count(state, 1);
}

void in_blocks(benchmark::State& state, Subject const& subject, fit::Kernel::Objectives kernel, std::size_t width) {
  auto const record = fit::workload(samples);
  auto const candidates = subject.candidates(record);
  auto const& info = subject.law.info;
  auto const path = laws::make_path(bench::divided(record.disp_mm, info.length.in_record_units),
                                    bench::divided(record.vel_mm_s, info.length.in_record_units));
  auto const measured = bench::divided(record.force_kN, info.force.in_record_units);
  std::vector<double> const weight(samples, 1.0 / samples);
  std::vector<std::vector<double>> blocks;
  for (std::size_t first = 0; first < drawn; first += width)
    blocks.push_back(bench::block(candidates, subject.law.parameters.size(), first, width));
  std::array<double, fit::wide_block> objectives{};
  std::size_t next = 0;
  for (auto _ : state) {
    kernel(blocks[next].data(), {path, measured, weight}, subject.integration, objectives.data());
    benchmark::DoNotOptimize(objectives.data());
    benchmark::ClobberMemory();
    next = (next + 1) % blocks.size();
  }
  count(state, width);
}

int const registered = [] {
  for (auto const& law : laws::catalogue())
    for (auto const integration : {laws::Integration::converged, laws::Integration::paper})
      for (auto const set : fit::available_instruction_sets()) {
        Subject const subject{law, integration};
        auto const name = std::string(law.info.id) +
                          (integration == laws::Integration::paper ? "/paper/" : "/converged/") +
                          std::string(fit::name(set));
        if (set == fit::InstructionSet::scalar) {
          benchmark::RegisterBenchmark(name.c_str(), [=](auto& state) { one_at_a_time(state, subject); });
          continue;
        }
        auto const kernel = fit::kernel(set, law.index);
        benchmark::RegisterBenchmark((name + "/wide").c_str(),
                                     [=](auto& state) { in_blocks(state, subject, kernel.wide, fit::wide_block); });
        benchmark::RegisterBenchmark((name + "/narrow").c_str(),
                                     [=](auto& state) { in_blocks(state, subject, kernel.narrow, fit::narrow_block); });
      }
  return 0;
}();

}  // namespace
