// Writes a campaign whose runs have the means and standard deviations that Table A.5 of the paper prints, and its
// reports: make_table_a5 DIR. Each law has two runs on each device. Their values are the mean plus and minus the
// printed standard deviation divided by the square root of two. The sample standard deviation of the two is then the
// printed one.
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "isolaw/base/error.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/table_a5.hpp"
#include "unit/campaign_fixture.hpp"

namespace {

namespace fs = std::filesystem;
using namespace isolaw;

campaign::Contents without_runs(fs::path const& dir) {
  campaign::Lot lot;
  lot.title = "Table A.5";
  lot.settings.laws.clear();
  for (auto const& law : table_a5::laws) lot.settings.laws.emplace_back(law.id);
  lot.settings.method = campaign::Method::genetic;
  lot.settings.runs = 2;
  lot.settings.box = fit::BoxKind::published;
  lot.settings.analysis = false;
  for (std::size_t d = 0; d < table_a5::devices; ++d) {
    auto const file = dir / ("device-" + std::to_string(d + 1) + ".csv");
    std::ofstream(file) << campaign::testing::record_text(1.0 + 0.01 * static_cast<double>(d));
    lot.devices.push_back(campaign::testing::device_input("device " + std::to_string(d + 1), {file}));
  }
  return campaign::prepare(lot);
}

campaign::Run run_of(table_a5::Law const& law, campaign::Search const& search, int number) {
  double const side = (number == 1 ? -1.0 : 1.0) / std::sqrt(2.0);
  auto const at = [&](table_a5::PerDevice const& mean, table_a5::PerDevice const& std) {
    return mean[search.device] + side * std[search.device];
  };
  campaign::Run run;
  run.device = search.device;
  run.law = search.law;
  run.number = number;
  run.outcome = campaign::Outcome::all_generations;
  run.objective = at(law.objective_mean, law.objective_std);
  run.evaluations = 5000;
  for (auto const& searched : search.box.parameters) {
    run.parameters.push_back(searched.value);
    for (auto const& printed : law.parameters)
      if (searched.name == printed.name) run.parameters.back() = at(printed.mean, printed.std);
  }
  run.history = {2.0 * run.objective, run.objective};
  return run;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_table_a5 DIR\n";
    return 2;
  }
  try {
    fs::path const dir = argv[1];
    fs::create_directories(dir);
    auto const contents = without_runs(dir);
    auto const file = dir / "campaign.sqlite";
    auto store = campaign::Store::create(file, contents);
    for (auto const& search : contents.searches)
      for (auto const& law : table_a5::laws)
        if (search.law == law.id)
          for (int number : {1, 2}) store.add(run_of(law, search, number));
    store.finish();
    render::write_outputs(study::build_summary(campaign::Store::read(file)), dir);
  } catch (Error const& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
