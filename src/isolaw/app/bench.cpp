// `isolaw bench`: what this program computes, in one number, and how fast it does so here.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>

#include "isolaw/app/commands.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/fit/workload.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::app {
namespace {

constexpr std::size_t bench_samples = 600, candidates = 4 * fit::wide_block;

struct Measured {
  double ns = 0.0;  // per sample and candidate
  std::vector<double> objectives;
};

// Candidates drawn in the published box. The shortest of several passes: what else the machine does only adds time.
Measured measure(fit::LawOnRecord const& model, fit::SearchBox const& box) {
  std::vector<double> points(candidates * box.free_count());
  num::Draws draws(num::Stream(1), 0, 0);
  for (double& coordinate : points) coordinate = draws.uniform();
  auto const candidate = [&](std::size_t i, std::span<double> values) {
    box.expand(std::span(points).subspan(i * box.free_count(), box.free_count()), values);
  };
  Measured result;
  result.objectives.resize(candidates);
  using Clock = std::chrono::steady_clock;
  double best = std::numeric_limits<double>::infinity(), spent = 0.0;
  for (int pass = 0; pass < 5 || (spent < 0.15 && pass < 2000); ++pass) {
    auto const start = Clock::now();
    model.objectives(candidates, candidate, result.objectives);
    double const seconds = std::chrono::duration<double>(Clock::now() - start).count();
    best = std::min(best, seconds);
    spent += seconds;
  }
  result.ns = 1e9 * best / static_cast<double>(bench_samples * candidates);
  return result;
}

}  // namespace

int bench(bool json) {
  auto const measured_record = fit::workload(bench_samples);
  // Seven digits of every objective: the same for all instruction sets, and another one as soon as a law changes.
  std::string digits;
  nlohmann::ordered_json converged, paper;
  for (auto const& law : laws::catalogue())
    for (auto const integration : {laws::Integration::converged, laws::Integration::paper}) {
      fit::LawOnRecord const model(law, measured_record, integration);
      auto const box = fit::make_box(law, fit::BoxKind::published, fit::scales_of(measured_record, law.info), {});
      auto const result = measure(model, box);
      for (double const value : result.objectives) digits += fmt::format("{:.6e} ", value);
      auto& table = integration == laws::Integration::converged ? converged : paper;
      table[std::string(law.info.id)] = std::round(result.ns * 1000.0) / 1000.0;
    }
  auto const signature = sha256(digits).substr(0, 16);
  auto const isa = fit::name(fit::instruction_set());
  if (json) {
    nlohmann::ordered_json const all{
        {"isa", isa}, {"threads", 1}, {"signature", signature}, {"laws", converged}, {"laws_paper", paper}};
    fmt::print("{}\n", all.dump(2));
    return exit_done;
  }
  std::string sets;
  for (auto const set : fit::available_instruction_sets()) sets += fmt::format(" {}", fit::name(set));
  fmt::print("instruction set {} (of{}; ISOLAW_SIMD chooses), 1 thread, signature {}\n\n", isa, sets, signature);
  fmt::print("ns per sample and candidate   default    paper\n");
  for (auto const& [law, ns] : converged.items())
    fmt::print("  {:<24}{:>11.2f}{:>9.2f}\n", law, ns.get<double>(), paper[law].get<double>());
  return exit_done;
}

}  // namespace isolaw::app
