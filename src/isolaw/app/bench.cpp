// Implements `isolaw bench`, which prints a hash of numbers that this program computes and measures its speed on this
// machine.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "isolaw/app/commands.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/processor_time.hpp"
#include "isolaw/fit/box.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/fit/workload.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::app {
namespace {

constexpr std::size_t bench_samples = 600, bench_candidates = 4 * fit::wide_block;

class SpeedTest {
 public:
  SpeedTest(laws::LawEntry const& law, laws::Integration integration)
      : model_(law, fit::workload(bench_samples), integration),
        box_(make_box(law, fit::BoxKind::published, fit::scales_of(fit::workload(bench_samples), law.info), {})),
        points_(bench_candidates * box_.free_count()) {
    num::Draws draws(num::Stream(1), 0, 0);
    for (double& coordinate : points_) coordinate = draws.uniform();
  }

  std::vector<double> objectives() const {
    std::vector<double> values(bench_candidates);
    auto const candidate = [&](std::size_t i, std::span<double> parameters) {
      box_.expand(std::span(points_).subspan(i * box_.free_count(), box_.free_count()), parameters);
    };
    model_.objectives(bench_candidates, candidate, values);
    return values;
  }

  // Returns the processor time [ns] for one sample and one parameter set, rounded to 0.001. It repeats the measurement.
  // Other work on the machine makes a repetition longer, but a shared host may also report a far too short time. The
  // second shortest repetition therefore counts.
  double ns() const {
    constexpr std::size_t least_passes = 5, most_passes = 2000;
    constexpr double enough_s = 0.15;
    std::vector<double> passes;
    double const start = thread_time_s();
    for (double now = start; passes.size() < least_passes || (now - start < enough_s && passes.size() < most_passes);) {
      double const before = thread_time_s();
      objectives();
      passes.push_back((now = thread_time_s()) - before);
    }
    std::ranges::nth_element(passes, passes.begin() + 1);
    return std::round(1e12 * passes[1] / static_cast<double>(bench_samples * bench_candidates)) / 1000.0;
  }

 private:
  fit::LawOnRecord model_;
  fit::SearchBox box_;
  std::vector<double> points_;
};

}  // namespace

int bench(bool json) {
  // The first seven digits of each objective are equal for all instruction sets and show whether a law has changed.
  std::string digits;
  nlohmann::ordered_json converged, paper;
  for (auto const& law : laws::catalogue())
    for (auto const integration : {laws::Integration::converged, laws::Integration::paper}) {
      SpeedTest const test(law, integration);
      for (double const value : test.objectives()) digits += fmt::format("{:.6e} ", value);
      (integration == laws::Integration::converged ? converged : paper)[std::string(law.info.id)] = test.ns();
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
