// `isolaw bench`: a signature of the numbers that this program computes, and its speed on this machine.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "isolaw/app/commands.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/fit/block_cost.hpp"

namespace isolaw::app {
namespace {

constexpr std::size_t bench_samples = 600;
constexpr fit::SpeedTest::Effort effort{.least_passes = 5, .most_passes = 2000, .enough_s = 0.15};

}  // namespace

int bench(bool json) {
  // Seven digits of every objective: the same for all instruction sets, different as soon as a law changes.
  std::string digits;
  nlohmann::ordered_json converged, paper;
  for (auto const& law : laws::catalogue())
    for (auto const integration : {laws::Integration::converged, laws::Integration::paper}) {
      fit::SpeedTest const test(law, integration, bench_samples);
      for (double const value : test.objectives()) digits += fmt::format("{:.6e} ", value);
      double const block_s = test.seconds_per_sample(fit::Block::wide, fit::SpeedTest::candidates, effort);
      double const ns = 1e9 * block_s / static_cast<double>(fit::wide_block);  // per sample and candidate
      auto& table = integration == laws::Integration::converged ? converged : paper;
      table[std::string(law.info.id)] = std::round(ns * 1000.0) / 1000.0;
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
