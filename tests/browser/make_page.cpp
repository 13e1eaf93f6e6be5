// Writes the outputs of a made-up lot for the browser tests: make_page DIR [DEVICES [LAWS [STATE]]]. STATE is one of
//   analysed     the results of the analyses are there
//   inadequate   the second law does not describe the devices
//   crowded      analysed; any number of laws with similar accuracy and robustness; the second law predicts huge forces
//   predicted    analysed; one block was left out of the fit, and the second law predicts huge forces in it
//   passing      an inspection in which every requirement of the rule set is met
//   failing      an inspection in which the devices miss their design values
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <string_view>
#include <utility>

#include "finding_text.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/render/write.hpp"
#include "unit/analysed_fixture.hpp"
#include "unit/study_fixture.hpp"

namespace {

using namespace isolaw;

// Adds copies of laws under names that are as long as those of real laws.
void add_laws(study::Summary& summary, std::size_t count) {
  constexpr std::string_view names[]{"power-masing", "power-masing-viscous", "history-integral", "kikuchi-aiken",
                                     "ramberg-osgood"};
  auto const first = summary.laws.size();
  for (auto i = first; i < count && i - first < std::size(names); ++i) {
    summary.laws.push_back(summary.laws[i - first]);
    summary.laws.back().id = names[i - first];
  }
}

void crowd(study::Summary& summary) {
  auto& laws = summary.laws;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    double const beta = 0.2 + 0.012 * static_cast<double>(j * 5 % 7),
                 objective = 0.08 + 0.002 * static_cast<double>(j * 3 % 5);
    laws[j].beta = laws[j].beta_converged = beta;
    laws[j].objective.mean = objective;
    laws[j].objective_converged = 0.98 * objective;
    laws[j].loo_objective = 0.1 + 0.1 * beta;
  }
  for (auto& law : laws) {
    auto const is_beaten = [&](auto const& x, auto const& y) {
      return std::ranges::any_of(laws, [&](auto const& other) {
        return x(other) <= x(law) && y(other) <= y(law) && (x(other) < x(law) || y(other) < y(law));
      });
    };
    auto const beta = [](auto const& one) { return *one.beta; };
    auto const left_out = [](auto const& one) { return *one.loo_objective; };
    auto const least = [](auto const& one) { return *one.objective_converged; };
    law.on_front = law.on_front_converged = !is_beaten(beta, least);
    law.on_front_loo = !is_beaten(left_out, least);
  }
}

void run_away(study::LawResult& law) {
  law.prediction_grade = study::PredictionGrade::unusable;
  law.predicted_objective = law.worst_predicted = law.larger_swings_objective = 60.0;
  for (auto& fit : law.devices)
    for (auto& block : fit.blocks)
      if (!block.fitted) block.objective = 60.0;
}

// Makes the last cycle of every record a block that was left out of the fit. The second law gives huge forces in it.
void keep_a_block(study::Summary& summary) {
  for (auto& device : summary.devices) {
    if (device.properties.blocks.empty()) continue;
    auto block = device.properties.blocks.front();
    auto cycle = block.cycles.back();
    auto const from = static_cast<std::size_t>(cycle.first);
    block.number = cycle.block = 2;
    cycle.number = 1;
    block.cycles = {cycle};
    device.properties.blocks.push_back(block);
    for (std::size_t i = 0; i < device.record.size(); ++i) device.record.scored.push_back(i < from ? 1.0 : 0.0);
    for (auto& fit : summary.laws.at(1).devices)
      if (fit.device == device.name)
        for (auto force = fit.force_kN.begin() + static_cast<std::ptrdiff_t>(from); force != fit.force_kN.end();
             ++force)
          *force *= 1e4;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: make_page DIR [DEVICES [LAWS [analysed|inadequate|crowded|predicted|passing|failing]]]\n";
    return 2;
  }
  int const devices = argc > 2 ? std::atoi(argv[2]) : 3;
  int const laws = argc > 3 ? std::atoi(argv[3]) : 3;
  std::string_view const state = argc > 4 ? argv[4] : "";
  try {
    auto summary = study::fixture::lot(devices, laws);
    if (state == "crowded") add_laws(summary, static_cast<std::size_t>(laws));
    if (state == "analysed" || state == "crowded" || state == "predicted")
      summary = study::fixture::analysed(std::move(summary));
    if (state == "crowded") crowd(summary);
    if (state == "crowded" || state == "predicted") run_away(summary.laws.at(1));
    if (state == "predicted") keep_a_block(summary);
    // The second law is on the front of accuracy and robustness. Its stiffness is 60 % off, so it is still not
    // adequate.
    if (state == "inadequate")
      for (auto& fit : summary.laws.at(1).devices) fit.K_eff_error_percent = 60.0;
    for (auto& law : summary.laws)
      for (auto& fit : law.devices)
        for (double const above : {1.3, 1.7})
          if (fit.objective.mean) fit.histories.push_back({above * *fit.objective.mean, *fit.objective.mean});
    // The states `passing` and `failing` make the page of an inspection: it has no laws, and the rule set requires only
    // what the records have. In `failing` the design stiffness is far off.
    if (argc > 4 && (std::string_view(argv[4]) == "passing" || std::string_view(argv[4]) == "failing")) {
      summary.laws.clear();
      summary.outliers.clear();
      summary.devices.pop_back();  // removes the refused device, so that the lot can pass
      auto rules = isolaw::rules::find_rule_set("ntc-2018");
      rules.load_variation.reset();
      rules.test = {};
      std::erase_if(rules.limits, [](auto const& limit) { return limit.quantity == isolaw::rules::Quantity::K_v; });
      // The cycles of the made-up records have no values per side, so the formulas from peak to peak are used.
      rules.stiffness_formula = rules.damping_formula = isolaw::rules::Formula::peak_to_peak;
      isolaw::rules::Design design;
      bool const fails = std::string_view(argv[4]) == "failing";
      design.K_eff_kN_per_mm = fails ? 0.72 : 0.6;
      design.damping_percent = 18.0;
      isolaw::study::add_acceptance(summary, rules, design, devices);
      isolaw::render::write_inspection(summary, argv[1]);
      std::filesystem::rename(std::filesystem::path(argv[1]) / "inspection.html",
                              std::filesystem::path(argv[1]) / "report.html");
      return 0;
    }
    // The report must warn of the three faults that are added here: a failed run, a coarse integration and a constant
    // load channel.
    summary.laws.back().devices.back().integration_shift = 0.0021;
    summary.laws.back().devices.front().failed_runs = 1;
    summary.laws.back().devices.front().failure = "the computed force became infinite";
    summary.devices.front().raw.warnings.push_back(stated("the vertical load column is constant"));
    render::write_outputs(summary, argv[1]);
    std::cout << render::ranking(summary);
  } catch (Error const& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
