// Compares the objective of every law with stored values: at three points of the published box, with both integrations,
// on the first record of the example lot. A change of the code may alter these objectives only on purpose.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <unistd.h>

#include "isolaw/app/example_lot.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/fit/objective.hpp"

namespace {

using namespace isolaw;

data::FitRecord example_record() {
  auto const path = std::filesystem::temp_directory_path() / fmt::format("isolaw-regression-{}.csv", getpid());
  for (auto const& file : app::example_lot())
    if (file.name == "device-01.csv") std::ofstream(path, std::ios::binary) << file.text;
  auto const record = data::clean(data::read_record(path), {.smooth = 5});
  std::filesystem::remove(path);
  return record;
}

// Returns the objectives by the key "law,integration,share". The share says where in its box every parameter lies: 0 is
// the lower end, 1 the upper end.
std::map<std::string, double> objectives() {
  auto const record = example_record();
  std::map<std::string, double> values;
  std::vector<double> work;
  for (auto const& law : laws::catalogue()) {
    auto const box = fit::make_box(law, fit::BoxKind::published, fit::scales_of(record, law.info), {});
    for (auto const integration : {laws::Integration::converged, laws::Integration::paper}) {
      fit::LawOnRecord const model(law, record, integration);
      for (double const share : {0.25, 0.5, 0.75}) {
        std::vector<double> const point(box.free_count(), share);
        std::vector<double> parameters(box.parameters.size());
        box.expand(point, parameters);
        auto const name = integration == laws::Integration::paper ? "paper" : "converged";
        values[fmt::format("{},{},{}", law.info.id, name, share)] = model.objective(parameters, work);
      }
    }
  }
  return values;
}

std::map<std::string, double> expected() {
  std::map<std::string, double> values;
  std::ifstream file(ISOLAW_EXPECTED);
  std::string line;
  std::getline(file, line);  // skips the header line
  while (std::getline(file, line)) {
    auto const comma = line.rfind(',');
    values[line.substr(0, comma)] = std::strtod(line.c_str() + comma + 1, nullptr);
  }
  return values;
}

TEST(Regression, Objectives) {
  auto const now = objectives();
  if (std::getenv("ISOLAW_REGENERATE") != nullptr) {
    std::ofstream file(ISOLAW_EXPECTED);
    file << "law,integration,share of the box,objective\n";
    for (auto const& [key, value] : now) file << fmt::format("{},{:.17g}\n", key, value);
  }
  auto const before = expected();
  ASSERT_EQ(before.size(), now.size());
  // Another compiler or mathematical library changes only the last digits, within the tolerance. A changed model
  // changes the first digits.
  for (auto const& [key, value] : now)
    EXPECT_NEAR(value, before.at(key), fit::evaluation_tolerance * before.at(key)) << key;
}

}  // namespace
