// Computes the example of `isolaw conditions`: six bearings. Formulas say how their stiffness and strength change with
// temperature, frequency, load, ageing and history. Nothing is random.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "isolaw/app/example_lot.hpp"

namespace isolaw::app {
namespace {

constexpr double stretch_mm = 208.0;

struct ConditionTest {
  char const* name;
  double temperature_C = 20.0, frequency_Hz = 0.5, load_kN = 2000.0;
  double off_percent = 0.0;  // deviation of this test's forces from the formulas, in addition to ConditionDevice::off
  double rest_h = 24.0;
  bool aged = false, acceptance = false;
  int cycles = 5;
  bool keeps_softening = false;  // the forces fall beyond cycle 3 too; otherwise they stay as in cycle 3
};

struct ConditionDevice {
  char const* name;
  double off;  // ln(forces of this device / forces by the formulas)
  std::vector<ConditionTest> tests;
};

std::vector<ConditionDevice> condition_devices() {
  auto const cold_and_warm = [](char const* name, double off, std::array<double, 4> const& percent) {
    return ConditionDevice{.name = name,
                           .off = off,
                           .tests = {{.name = "20C", .off_percent = percent[2]},
                                     {.name = "-20C", .temperature_C = -20.0, .off_percent = percent[0]},
                                     {.name = "0C", .temperature_C = 0.0, .off_percent = percent[1]},
                                     {.name = "40C", .temperature_C = 40.0, .off_percent = percent[3]}}};
  };
  return {cold_and_warm("P1", 0.03, {0.6, -0.4, 0.2, -0.7}),
          cold_and_warm("P2", -0.02, {0.5, 0.1, -0.3, 0.4}),
          cold_and_warm("P3", 0.005, {-0.6, 0.3, -0.1, 0.7}),
          {.name = "P4",
           .off = 0.0,
           .tests = {{.name = "reference"},
                     {.name = "slow", .frequency_Hz = 0.1},
                     {.name = "fast", .frequency_Hz = 2.0},
                     {.name = "0kN", .load_kN = 0.0},
                     {.name = "1000kN", .load_kN = 1000.0},
                     {.name = "3000kN", .load_kN = 3000.0},
                     {.name = "4000kN", .load_kN = 4000.0},
                     {.name = "again"},
                     {.name = "aged", .aged = true}}},
          {.name = "P5",
           .off = 0.0,
           .tests = {{.name = "ten-cycles", .cycles = 10, .keeps_softening = true},
                     {.name = "after-1h", .rest_h = 1.0},
                     {.name = "after-24h", .rest_h = 24.0},
                     {.name = "after-168h", .rest_h = 168.0}}},
          {.name = "P6",
           .off = 0.0,
           .tests = {{.name = "acceptance", .temperature_C = 26.0, .frequency_Hz = 0.1, .acceptance = true}}}};
}

std::string condition_record(ConditionDevice const& device, ConditionTest const& test, bool first) {
  constexpr int per_cycle = 400, settled = 3;
  constexpr double critical_load_kN = 7505.621896, usual_frequency_Hz = 0.5, first_over_second_stiffness = 5.0;
  double const warmer = test.temperature_C - 20.0, faster = test.frequency_Hz / usual_frequency_Hz;
  double const of_device = std::exp(device.off + test.off_percent / 100.0);
  double const K_2 = 0.6 * std::exp(-0.006 * warmer) * std::pow(faster, 0.04) *
                     (1.0 - std::pow(test.load_kN / critical_load_kN, 2.0)) * (test.aged ? 1.10 : 1.0) * of_device;
  double const Q = 25.0 * std::exp(-0.010 * warmer) * std::pow(faster, 0.08) * (test.aged ? 0.95 : 1.0) * of_device;
  double const D_y = Q / (first_over_second_stiffness * K_2);
  double const recovered = first ? 1.0 : std::min(1.0, 0.1 * std::log1p(test.rest_h / 0.5));
  auto const softening = [](double n) { return 1.0 + 0.45 * std::pow(n, -1.2); };
  auto const k = [&](int cycle) {
    double const n = test.keeps_softening ? cycle : std::min(cycle, settled);
    return 1.0 + recovered * (softening(n) / softening(settled) - 1.0);
  };
  auto text = fmt::format("# Computed: test {} of {}\nTime [s],Displacement [mm],Force [kN],Vertical load [kN]\n",
                          test.name, device.name);
  double z = 0.0, before = 0.0;
  for (int i = 0; i <= per_cycle * test.cycles; ++i) {
    double const d = stretch_mm * std::sin(2.0 * std::numbers::pi * i / per_cycle);
    z = std::clamp(z + (d - before) / D_y, -1.0, 1.0);
    before = d;
    double const force = k(std::min(i / per_cycle + 1, test.cycles)) * (K_2 * d + Q * z);
    text += fmt::format("{:.6f},{:.10g},{:.10g},{:g}\n", i / (per_cycle * test.frequency_Hz), d, force, test.load_kN);
  }
  return text;
}

std::string conditions_lot_text(std::vector<ConditionDevice> const& devices) {
  std::string text =
      R"toml(# Tests of six bearings under several conditions. The records are computed, not measured. See README.md.
title = "Example conditions: computed, not measured"

[acceptance]
rules = "ntc-2018"
design = { K_eff = 0.6776, damping = 10.8, disp = 208.0 }
lot-size = 28

[conditions]
# Every test is compared with the tests of the same device under these conditions.
reference = { temperature-C = 20, frequency-Hz = 0.5, load-kN = 2000, strain-percent = 100, cycle = 3 }
# The conditions that the bearings meet in the building.
design = { temperature-C = [-15, 45], frequency-Hz = [0.35, 0.65], load-kN = [1000, 3000], rest = "full", cycles = 10, aged = { days = 14, at-C = 70 } }

)toml";
  for (auto const& device : devices) {
    text += fmt::format("[[device]]\nname = \"{}\"\nrubber-thickness-mm = 208.0\nrubber-area-mm2 = 282743.0\n\n",
                        device.name);
    for (std::size_t i = 0; i < device.tests.size(); ++i) {
      auto const& test = device.tests[i];
      text += fmt::format("[[device.test]]\nname = \"{}\"\nfile = \"{}-{}.csv\"\norder = {}\ntemperature-C = {:g}\n",
                          test.name, device.name, test.name, i + 1, test.temperature_C);
      if (i > 0) text += fmt::format("rest-h = {:g}\n", test.rest_h);
      if (test.aged) text += "aged = { days = 14, at-C = 70 }\n";
      if (test.acceptance) text += "stands-for = \"acceptance\"\n";
      text += '\n';
    }
  }
  return text;
}

constexpr std::string_view conditions_readme = R"md(# Example conditions: computed, not measured

Six bearings, tested as a laboratory qualifies a type of device. P1, P2 and P3 were tested at -20, 0, 20 and 40 degrees.
P4 was tested at three frequencies and five vertical loads, and again after two weeks in an oven at 70 degrees. P5 was
tested for ten cycles, and again after rests of an hour, a day and a week. P6 has one test, in a warm laboratory at a low
frequency. Stiffness and strength follow closed formulas of the conditions, and nothing is random.

`isolaw conditions lot.toml` shows what each condition changes, and what all of them make together.

Made by `isolaw example DIR --conditions` (`src/isolaw/app/example_conditions.cpp`).
)md";

}  // namespace

std::vector<TextFile> example_conditions() {
  auto const devices = condition_devices();
  std::vector<TextFile> files{{"lot.toml", conditions_lot_text(devices)},
                              {"README.md", std::string(conditions_readme)}};
  for (auto const& device : devices)
    for (std::size_t i = 0; i < device.tests.size(); ++i)
      files.push_back({fmt::format("{}-{}.csv", device.name, device.tests[i].name),
                       condition_record(device, device.tests[i], i == 0)});
  return files;
}

}  // namespace isolaw::app
