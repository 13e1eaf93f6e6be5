// Writes the outputs of a made-up building for the browser tests. In `make_building DIR [LAWS]`, LAWS is 1 or 2.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <tuple>

#include "isolaw/base/error.hpp"
#include "isolaw/building/answers.hpp"
#include "isolaw/render/write.hpp"
#include "unit/building_study_fixture.hpp"

namespace {

using namespace isolaw;

// Makes a bouc-wen law from a bilinear law, with a smooth curve instead of the corner and 90 % of the first stiffness.
// In the draws of the building, alpha and Ke vary as the first two parameters of the bilinear law do.
building::LawSource smooth(building::LawSource const& of) {
  auto law = of;
  auto const& [K1, K2, Dy] = std::tie(of.median[0], of.median[1], of.median[2]);
  law.law = "bouc-wen";
  law.median = {K2 / K1, 0.9 * K1, 1.0, 0.5 / Dy, 1.0, 0.5 / Dy};
  law.lot = law.median;
  law.population.names = {"alpha", "Ke"};
  law.population.medians = {law.median[0], law.median[1]};
  law.population.mean = {std::log(law.median[0]), std::log(law.median[1])};
  law.place = {0, 1, std::nullopt, std::nullopt, std::nullopt, std::nullopt};
  return law;
}

void write(std::filesystem::path const& dir, int laws) {
  auto study = building::usual_study(0.07, 80, 3);
  study.file.settings.title = "Hospital <img src=x onerror=alert(1)> north";
  study.file.frame.base.centre = {600.0, 0.0};
  study.file.motions[1].name = "<b>a motion</b> with a long name";
  study.file.bearings[0] = {
      .at = study.file.bearings[0].at, .kind = building::BearingKind::device, .device = "constructor"};
  study.laws[0].tested_mm = 10.0;
  study.laws[0].devices["constructor"] = study.laws[0].median;
  if (laws > 1) {
    study.laws.push_back(smooth(study.laws[0]));
    study.laws[1].devices["constructor"] = study.laws[1].median;
  }
  std::filesystem::create_directories(dir);
  building::RunStore store(dir / "building.sqlite", building::properties_of(study), true);
  building::run_all(study, store, 1);
  render::write_building_outputs(study, building::answer(study, store), dir);
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 2) return 2;
  write(arguments[1], count > 2 ? std::atoi(arguments[2]) : 1);
  return 0;
} catch (isolaw::Error const& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
