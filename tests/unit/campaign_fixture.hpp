// Helps tests that need a small campaign. Writes records to a temporary folder of each test, and compares the contents
// of campaigns (settings, devices, boxes, runs) exactly.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <stdlib.h>  // declares mkdtemp

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::campaign::testing {

class Folder : public ::testing::Test {
 protected:
  void SetUp() override {
    auto const* info = ::testing::UnitTest::GetInstance()->current_test_info();
    auto pattern = (std::filesystem::temp_directory_path() /
                    fmt::format("isolaw-{}-{}-XXXXXX", info->test_suite_name(), info->name()))
                       .string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder = pattern;
  }
  void TearDown() override {
    if (!folder.empty()) std::filesystem::remove_all(folder);
  }

  std::filesystem::path write(std::string_view name, std::string_view bytes) const {
    auto const file = folder / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
  }
  static std::string bytes_of(std::filesystem::path const& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
  }
  std::vector<std::string> names() const {  // the names of all entries of the folder
    std::vector<std::string> found;
    for (auto const& entry : std::filesystem::directory_iterator(folder))
      found.push_back(entry.path().filename().string());
    std::ranges::sort(found);
    return found;
  }

  std::filesystem::path folder;
};

// Returns a record of three cycles of a wide loop at 0.5 Hz. The devices of a campaign differ in `stiffness`.
inline std::string record_text(double stiffness, bool with_time = true, int samples_per_cycle = 40) {
  std::string text = with_time ? "time [s],disp [mm],force [kN]\n" : "disp [mm],force [kN]\n";
  for (int i = 0; i <= 3 * samples_per_cycle; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / samples_per_cycle;
    if (with_time) text += fmt::format("{:.4f},", 2.0 * i / samples_per_cycle);
    text += fmt::format(
        "{:.4f},{:.4f}\n", 150.0 * std::sin(phase),
        stiffness * (100.0 * std::sin(phase) + 30.0 * std::cos(phase) + 10.0 * std::pow(std::sin(phase), 3)));
  }
  return text;
}

inline DeviceInput device_input(std::string name, std::vector<std::filesystem::path> files) {
  DeviceInput input;
  input.name = std::move(name);
  input.tests.front().shown_file = files.empty() ? "" : files.front().filename().string();
  input.tests.front().files = std::move(files);
  return input;
}

// Returns a run in which no candidate gave a finite force.
inline Run failed_run(std::size_t device, std::string law, int number, std::string failure) {
  return {.device = device,
          .law = std::move(law),
          .number = number,
          .outcome = Outcome::no_finite_value,
          .objective = std::nan(""),
          .integration_shift = std::nan(""),
          .evaluations = 100,
          .failed_evaluations = 100,
          .failure = std::move(failure),
          .parameters = {},
          .history = {std::numeric_limits<double>::infinity()}};
}

inline bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b));
}

// Expects exactly equal values; NaN counts as equal to NaN.
inline void expect_same(std::vector<double> const& a, std::vector<double> const& b, std::string const& what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_TRUE(same(a[i], b[i])) << what << "[" << i << "]: " << a[i] << ", " << b[i];
}

inline void expect_same(Run const& a, Run const& b) {
  auto const what = fmt::format("device {} law {} run {}", a.device, a.law, a.number);
  EXPECT_EQ(a.device, b.device) << what;
  EXPECT_EQ(a.law, b.law) << what;
  EXPECT_EQ(a.number, b.number) << what;
  EXPECT_EQ(a.outcome, b.outcome) << what;
  EXPECT_TRUE(same(a.objective, b.objective)) << what << ": " << a.objective << ", " << b.objective;
  EXPECT_TRUE(same(a.integration_shift, b.integration_shift))
      << what << ": " << a.integration_shift << ", " << b.integration_shift;
  EXPECT_EQ(a.evaluations, b.evaluations) << what;
  EXPECT_EQ(a.failed_evaluations, b.failed_evaluations) << what;
  EXPECT_EQ(a.failure, b.failure) << what;
  expect_same(a.parameters, b.parameters, what + " parameters");
  expect_same(a.history, b.history, what + " history");
}

inline void expect_same(std::vector<Run> const& a, std::vector<Run> const& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) expect_same(a[i], b[i]);
}

inline void expect_same(fit::SearchBox const& a, fit::SearchBox const& b, std::string const& what) {
  ASSERT_EQ(a.parameters.size(), b.parameters.size()) << what;
  for (std::size_t i = 0; i < a.parameters.size(); ++i) {
    auto const &p = a.parameters[i], &q = b.parameters[i];
    EXPECT_EQ(p.name, q.name) << what;
    EXPECT_EQ(p.unit, q.unit) << what << " " << p.name;
    EXPECT_EQ(p.free, q.free) << what << " " << p.name;
    EXPECT_EQ(p.value, q.value) << what << " " << p.name;
    EXPECT_EQ(p.lower, q.lower) << what << " " << p.name;
    EXPECT_EQ(p.upper, q.upper) << what << " " << p.name;
    EXPECT_EQ(p.scale, q.scale) << what << " " << p.name;
  }
}

// Compares all members but the layout of the raw record. Only `isolaw init` writes the layout, and no report needs it.
inline void expect_same(Device const& a, Device const& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.file, b.file);
  EXPECT_EQ(a.refusal, b.refusal);
  EXPECT_EQ(a.info.serial, b.info.serial);
  EXPECT_EQ(a.info.lot, b.info.lot);
  EXPECT_EQ(a.info.test_date, b.info.test_date);
  EXPECT_EQ(a.info.temperature_C, b.info.temperature_C);
  EXPECT_EQ(a.info.rubber_thickness_mm, b.info.rubber_thickness_mm);
  EXPECT_EQ(a.info.rubber_area_mm2, b.info.rubber_area_mm2);
  EXPECT_EQ(a.raw.file, b.raw.file);
  EXPECT_EQ(a.raw.sha256, b.raw.sha256);
  EXPECT_EQ(a.raw.recognised, b.raw.recognised);
  EXPECT_EQ(a.raw.corrections, b.raw.corrections);
  EXPECT_EQ(a.raw.warnings, b.raw.warnings);
  ASSERT_EQ(a.raw.faults.size(), b.raw.faults.size()) << a.name;
  for (std::size_t i = 0; i < a.raw.faults.size(); ++i) {
    auto const &fault = a.raw.faults[i], &other = b.raw.faults[i];
    EXPECT_EQ(fault.kind, other.kind);
    EXPECT_EQ(fault.channel, other.channel);
    EXPECT_EQ(fault.samples, other.samples);
    EXPECT_EQ(fault.finding, other.finding);
  }
  expect_same(a.raw.time_s, b.raw.time_s, a.name + " raw time");
  expect_same(a.raw.disp_mm, b.raw.disp_mm, a.name + " raw disp");
  expect_same(a.raw.force_kN, b.raw.force_kN, a.name + " raw force");
  expect_same(a.raw.load_kN, b.raw.load_kN, a.name + " raw load");
  EXPECT_EQ(a.record.cleaning, b.record.cleaning);
  expect_same(a.record.time_s, b.record.time_s, a.name + " time");
  expect_same(a.record.disp_mm, b.record.disp_mm, a.name + " disp");
  expect_same(a.record.vel_mm_s, b.record.vel_mm_s, a.name + " velocity");
  expect_same(a.record.force_kN, b.record.force_kN, a.name + " force");
  expect_same(a.record.scored, b.record.scored, a.name + " scored");
  EXPECT_TRUE(a.vertical == b.vertical) << a.name;
}

inline void expect_same(Settings const& a, Settings const& b) {
  EXPECT_EQ(a.laws, b.laws);
  EXPECT_EQ(a.method, b.method);
  EXPECT_EQ(a.integration, b.integration);
  EXPECT_EQ(a.runs, b.runs);
  EXPECT_EQ(a.genetic.population, b.genetic.population);
  EXPECT_EQ(a.genetic.generations, b.genetic.generations);
  EXPECT_EQ(a.genetic.mutation_rate, b.genetic.mutation_rate);
  EXPECT_EQ(a.genetic.stagnation, b.genetic.stagnation);
  EXPECT_EQ(a.genetic.stagnation_tolerance, b.genetic.stagnation_tolerance);
  EXPECT_EQ(a.genetic.selection_pressure, b.genetic.selection_pressure);
  EXPECT_EQ(a.multistart.least_starts, b.multistart.least_starts);
  EXPECT_EQ(a.multistart.starts, b.multistart.starts);
  EXPECT_EQ(a.multistart.hits, b.multistart.hits);
  EXPECT_EQ(a.multistart.hit_tolerance, b.multistart.hit_tolerance);
  EXPECT_EQ(a.multistart.most_evaluations, b.multistart.most_evaluations);
  EXPECT_EQ(a.multistart.scattered, b.multistart.scattered);
  EXPECT_EQ(a.multistart.hops, b.multistart.hops);
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.box, b.box);
  ASSERT_EQ(a.overrides.size(), b.overrides.size());
  for (std::size_t i = 0; i < a.overrides.size(); ++i) EXPECT_EQ(a.overrides[i].text(), b.overrides[i].text());
  EXPECT_EQ(a.clean.smooth, b.clean.smooth);
  EXPECT_EQ(a.clean.samples_per_cycle, b.clean.samples_per_cycle);
  EXPECT_EQ(a.clean.center, b.clean.center);
  EXPECT_EQ(a.clean.scored.blocks, b.clean.scored.blocks);
  EXPECT_EQ(a.clean.scored.cycles, b.clean.scored.cycles);
}

inline void expect_same(Contents const& a, Contents const& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.acceptance, b.acceptance);
  expect_same(a.settings, b.settings);
  ASSERT_EQ(a.devices.size(), b.devices.size());
  for (std::size_t i = 0; i < a.devices.size(); ++i) expect_same(a.devices[i], b.devices[i]);
  ASSERT_EQ(a.searches.size(), b.searches.size());
  for (std::size_t i = 0; i < a.searches.size(); ++i) {
    auto const &s = a.searches[i], &t = b.searches[i];
    EXPECT_EQ(s.device, t.device);
    EXPECT_EQ(s.law, t.law);
    EXPECT_EQ(s.refusal, t.refusal);
    expect_same(s.box, t.box, fmt::format("box of device {} law {}", s.device, s.law));
  }
  expect_same(a.runs, b.runs);
}

}  // namespace isolaw::campaign::testing
