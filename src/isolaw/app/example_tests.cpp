// Computes the records of the example tests. Three quarters of the force come from power-masing-worn and one quarter
// from bouc-wen, so that no law of the catalogue fits the force exactly. Each bearing has its own stiffness. One is
// 23 % softer than the first, and the load cell of the last test clips.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isolaw/app/example_lot.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::app {
namespace {

// Says how the bearings are tested. The values of noise are standard deviations.
struct Plan {
  static constexpr double amplitudes_mm[]{60.0, 120.0, 180.0}, frequency_Hz = 0.5, sampling_Hz = 50.0, rest_s = 1.0;
  static constexpr int cycles = 3;
  static constexpr double load_kN = 1600.0, clipped_at_kN = 125.0;
  static constexpr double disp_noise_mm = 0.03, force_noise_kN = 0.4, load_noise_kN = 3.0;
  static constexpr std::uint64_t noise_seed = 180;
};

struct Bearing {
  double stiffness;     // divided by that of the first bearing
  double scragging_kN;  // the part of the force at 100 mm that is lost in the first cycles
};
constexpr Bearing bearings[]{{1.0, 26.0}, {1.03, 30.0}, {0.97, 22.0}, {0.77, 24.0}, {1.015, 28.0}};
constexpr std::size_t clipped = 4;  // index of the bearing whose force is clipped

// The displacement in a test: cycles of each amplitude, followed by a rest at zero.
data::FitRecord bearing_motion() {
  data::FitRecord record;
  auto const add = [&](double disp_mm) {
    record.time_s.push_back(static_cast<double>(record.time_s.size()) / Plan::sampling_Hz);
    record.disp_mm.push_back(disp_mm);
  };
  for (double const amplitude : Plan::amplitudes_mm) {
    for (int i = 0; i < static_cast<int>(Plan::cycles / Plan::frequency_Hz * Plan::sampling_Hz); ++i)
      add(amplitude * std::sin(2.0 * std::numbers::pi * Plan::frequency_Hz * i / Plan::sampling_Hz));
    for (int i = 0; i < static_cast<int>(Plan::rest_s * Plan::sampling_Hz); ++i) add(0.0);
  }
  return record;
}

std::string bearing_text(std::size_t bearing) {
  auto const& [s, scragging] = bearings[bearing];
  auto const path = bearing_motion();
  auto const masing =
      force_of("power-masing-worn", path,
               {{"Y", 68.0 * s}, {"g", 0.70}, {"K", 14.0 * s}, {"H", 6.0 * s}, {"C", scragging}, {"r", 0.03}});
  auto const smooth = force_of(
      "bouc-wen", path, {{"alpha", 0.13}, {"Ke", 3.2 * s}, {"A", 1.0}, {"beta", 0.035}, {"n", 1.0}, {"gamma", 0.03}});
  num::Draws noise(num::Stream(Plan::noise_seed), static_cast<std::uint32_t>(bearing), 0);
  std::string text = "Time [s],Displacement [mm],Force [kN],Vertical load [kN]\n";
  for (std::size_t i = 0; i < path.time_s.size(); ++i) {
    double force = 0.75 * masing[i] + 0.25 * smooth[i] + Plan::force_noise_kN * noise.normal();
    if (bearing == clipped) force = std::clamp(force, -Plan::clipped_at_kN, Plan::clipped_at_kN);
    double const disp = path.disp_mm[i] + Plan::disp_noise_mm * noise.normal();
    double const load = Plan::load_kN + Plan::load_noise_kN * noise.normal();
    text += fmt::format("{:.2f},{:.3f},{:.3f},{:.1f}\n", path.time_s[i], disp, force, load);
  }
  return text;
}

std::string tests_lot_text() {
  std::string text = R"toml(# A lot as laboratories test it. The records are computed, not measured. See README.md.
title = "Example tests: computed, not measured"

[calibrate]                # the same keys as the options of `isolaw calibrate`
laws = "bilinear,bouc-wen,jankowski,power-masing,power-masing-worn"
fit-blocks = "1-2"         # the laws are fitted to 60 and 120 mm and have to predict 180 mm

[acceptance]
rules = "ntc-2018"
design = { K_eff = 0.84, damping = 10.0, disp = 180.0 }
lot-size = 20

)toml";
  for (std::size_t i = 0; i < std::size(bearings); ++i)
    text += fmt::format(
        "[[device]]\nname = \"B{0}\"\nfile = \"bearing-{0}.csv\"\nserial = \"{0}\"\nrubber-thickness-mm = 120.0\n"
        "rubber-area-mm2 = 282743.0\n\n",
        i + 1);
  return text;
}

std::string tests_readme_text() {
  return fmt::format(R"md(# Example tests: computed, not measured

Five bearings of a lot of twenty, tested as laboratories test them: three cycles of {} mm at {:g} Hz each, with a rest
of {:g} s between. The first cycles are stiffer than the later ones (scragging). Bearing 4 is softer than the others. In
the test of bearing 5 the load cell clips at {:g} kN.

The force is the mean, three parts to one, of the laws `power-masing-worn` and `bouc-wen`, with noise. **So the ranking
of the laws on these tests proves nothing about those laws.**

Made by `isolaw example DIR --tests` (`src/isolaw/app/example_tests.cpp`).
)md",
                     fmt::join(Plan::amplitudes_mm, ", "), Plan::frequency_Hz, Plan::rest_s, Plan::clipped_at_kN);
}

}  // namespace

std::vector<TextFile> example_tests() {
  std::vector<TextFile> files{{"lot.toml", tests_lot_text()}, {"README.md", tests_readme_text()}};
  for (std::size_t i = 0; i < std::size(bearings); ++i)
    files.push_back({fmt::format("bearing-{}.csv", i + 1), bearing_text(i)});
  return files;
}

}  // namespace isolaw::app
