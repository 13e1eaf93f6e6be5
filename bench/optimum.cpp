// How often, and at what cost, the best objective is found: every run of every law of a lot, with the method `best`.
// Usage: optimum LOT.toml RUNS [LAW...]; CSV: law, device, run, objective, evaluations, hits, seconds.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/opt/multistart.hpp"

using namespace isolaw;

int main(int argc, char** argv) try {
  auto lot = campaign::read_lot_file(argv[1], {.allow_outside = true});
  int const runs = std::atoi(argv[2]);
  if (argc > 3) lot.settings.laws.assign(argv + 3, argv + argc);
  auto const contents = campaign::prepare(lot);
  std::puts("law,device,run,objective,evaluations,starts,hits,seconds");
  for (auto const& search : contents.searches) {
    auto const& device = contents.devices[search.device];
    auto const& law = laws::find_law(search.law);
    auto const box = fit::on_logarithmic_scales(search.box, laws::find_law(search.law));
    fit::LawOnRecord const model(law, device.record, contents.settings.integration);
    fit::IdentificationProblem const problem(model, box);
    auto const stream =
        num::Stream(contents.settings.seed).split(stable_hash(device.name)).split(stable_hash(search.law));
    for (int run = 1; run <= runs; ++run) {
      auto const start = std::chrono::steady_clock::now();
      auto const r = opt::minimise_multistart(problem, stream.split(static_cast<std::uint64_t>(run)));
      double const s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      fmt::print("{},{},{},{:.8g},{},{},{},{:.4f}\n", search.law, device.name, run, r.best_value, r.evaluations,
                 r.starts, r.hits, s);
      std::fflush(stdout);
      if (std::getenv("ISOLAW_SHOW")) {
        std::vector<double> p(box.parameters.size());
        box.expand(r.best, p);
        for (std::size_t i = 0; i < p.size(); ++i)
          fmt::print("#   {} = {:.6g}{}\n", box.parameters[i].name, p[i],
                     fit::at_bound(box.parameters[i], p[i]) == fit::AtBound::no ? "" : " (bound)");
      }
    }
  }
} catch (std::exception const& error) {
  std::fputs(error.what(), stderr);
  return 2;
}
