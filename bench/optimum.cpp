// How often, and at what cost, the search `best` finds the least objective: repeated with other random numbers for every law
// and device of a lot.
// Usage: optimum LOT.toml RUNS [LAW...]; prints CSV. The records may lie outside the lot file's folder.
#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <string_view>

#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/opt/multistart.hpp"

using namespace isolaw;

int main(int argc, char** argv) try {
  int runs = 0;
  std::string_view const count = argc > 2 ? argv[2] : "";
  std::from_chars(count.data(), count.data() + count.size(), runs);
  if (runs < 1) {
    std::fputs("usage: optimum LOT.toml RUNS [LAW...]\n", stderr);
    return 2;
  }
  auto lot = campaign::read_lot_file(argv[1], {.allow_outside = true});
  lot.settings.method = campaign::Method::best;
  if (argc > 3) lot.settings.laws.assign(argv + 3, argv + argc);
  auto const contents = campaign::prepare(lot);
  std::puts("law,device,run,objective,evaluations,starts,hits,seconds");
  for (auto const& search : contents.searches) {
    if (!search.refusal.empty()) continue;
    auto const& device = contents.devices[search.device];
    fit::LawOnRecord const model(laws::find_law(search.law), device.record, contents.settings.integration,
                                 contents.settings.turning_points);
    fit::IdentificationProblem const problem(model, search.box);
    auto const stream =
        num::Stream(contents.settings.seed).split(stable_hash(device.name)).split(stable_hash(search.law));
    for (int run = 1; run <= runs; ++run) {
      auto const start = std::chrono::steady_clock::now();
      auto const found = opt::minimise_multistart(problem, stream.split(static_cast<std::uint64_t>(run)),
                                                  contents.settings.multistart);
      std::chrono::duration<double> const seconds = std::chrono::steady_clock::now() - start;
      fmt::print("{},{},{},{:.8g},{},{},{},{:.4f}\n", search.law, device.name, run, found.best_value, found.evaluations,
                 found.starts, found.hits, seconds.count());
      std::fflush(stdout);
    }
  }
  return 0;
} catch (std::exception const& error) {
  std::fprintf(stderr, "optimum: %s\n", error.what());
  return 2;
}
