// Fits a law to some devices of a lot, puts devices drawn from that lot under a building, shakes the building, and
// prints whether bound analyses cover the scatter of its response. docs/python.md shows the same in Python.
//   isolated_building RECORD RECORD...
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <isolaw/api/isolaw.hpp>
#include <string>
#include <vector>

namespace {

constexpr char const* text = R"toml(
[building]
lower = 0.9
upper = 1.1
laws = ["bilinear"]
[base]
mass_Mg = 300.0
gyration_m = 5.0
[floors]
count = 3
mass_Mg = 300.0
gyration_m = 5.0
period_x_s = 0.4
period_y_s = 0.4
[grid]
along = 3
across = 2
spacing_x_m = 6.0
spacing_y_m = 6.0
)toml";

// Returns an artificial motion of the ground in two directions, whose periods depend on `number`.
isolaw::GroundMotion swinging(int number) {
  isolaw::GroundMotion motion{.name = "made " + std::to_string(number), .step_s = 0.01, .x_m_s2 = {}};
  for (int i = 0; i <= 1000; ++i) {
    double const t = motion.step_s * i, envelope = std::sin(0.314159 * t);
    motion.x_m_s2.push_back(2.0 * envelope * std::sin((2.0 + 0.4 * number) * t));
    motion.y_m_s2.push_back(1.0 * envelope * std::cos((2.5 + 0.3 * number) * t));
  }
  return motion;
}

}  // namespace

int main(int count, char** words) try {
  if (count < 3)
    throw isolaw::Error({.where = "isolated_building",
                         .found = "fewer than two files",
                         .allowed = "isolated_building RECORD RECORD..."});
  std::vector<isolaw::campaign::NamedRecord> records;
  for (int i = 1; i < count; ++i) {
    auto const name = std::filesystem::path(words[i]).stem().string();
    records.push_back({.name = name, .record = isolaw::data::read_record(words[i])});
  }
  isolaw::campaign::Settings settings;
  settings.laws = {"bilinear"};
  settings.runs = 1;
  settings.replicates = 40;
  auto const campaign = isolaw::calibrate(std::move(records), settings);

  isolaw::BuildingInput input{.text = text, .settings = {{"draws", "60"}}};
  for (int number = 1; number <= 7; ++number) input.motions.push_back(swinging(number));
  auto const building = isolaw::study_building(input, campaign);
  std::printf("%s\n", building.verdict().c_str());

  // Gets the largest storey drift of every draw under every motion, sorted by law, then by draw, then by motion.
  auto const peaks = building.peaks("drift_mm");
  double mean = 0.0;
  for (double const drift : peaks) mean += drift / static_cast<double>(peaks.size());
  auto const nominal = building.history(0, 0);
  std::printf("drift of a storey %.3f mm on the mean of %zu draws and %zu motions; %zu steps of the nominal building\n",
              mean, building.draws(), building.motions(), nominal.time_s.size());
  return 0;
} catch (isolaw::Error const& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
