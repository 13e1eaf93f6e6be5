// Makes records of tests as CSV text, sound ones and bad ones.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace isolaw::cli_test {

struct Sample {
  double time_s, disp_mm, force_kN;
};

struct RecordShape {
  int samples = 601, per_cycle = 200;
  double amplitude_mm = 100.0, stiffness_kN_per_mm = 0.5, strength_kN = 20.0, yield_mm = 10.0, interval_s = 0.01;
};

// Returns the record of a device with a constant stiffness and an elastic-plastic element under a sine. The energy of a
// cycle is about 4 Qd (D - Dy).
inline std::vector<Sample> record(RecordShape const& shape = {}) {
  std::vector<Sample> samples;
  double z = 0.0, before = 0.0;
  for (int i = 0; i < shape.samples; ++i) {
    double const x = shape.amplitude_mm * std::sin(2.0 * std::numbers::pi * i / shape.per_cycle);
    z = std::clamp(z + (x - before) / shape.yield_mm, -1.0, 1.0);
    before = x;
    samples.push_back({i * shape.interval_s, x, shape.stiffness_kN_per_mm * x + shape.strength_kN * z});
  }
  return samples;
}

inline std::string row(Sample const& s) {
  return fmt::format("{:.4f},{:.5f},{:.5f}", s.time_s, s.disp_mm, s.force_kN);
}

inline constexpr char const* header = "time [s],displacement [mm],force [kN]";

// Returns the samples as CSV text with the header in line 1, so that sample i is in line i + 2. `change` may write the
// row of a sample in another form.
inline std::string csv(std::vector<Sample> const& samples, std::string const& head = header,
                       std::function<std::string(std::size_t, Sample const&)> const& change = {}) {
  std::string text = head + "\n";
  for (std::size_t i = 0; i < samples.size(); ++i) text += (change ? change(i, samples[i]) : row(samples[i])) + "\n";
  return text;
}

// Returns the CSV text of the standard record, in which `text` replaces one line.
inline std::string csv_with_line(int line, std::string const& text) {
  return csv(record(), header,
             [&](std::size_t i, Sample const& s) { return static_cast<int>(i) + 2 == line ? text : row(s); });
}

inline std::string csv_without_time() {
  return csv(record(), "displacement [mm],force [kN]",
             [](std::size_t, Sample const& s) { return fmt::format("{:.5f},{:.5f}", s.disp_mm, s.force_kN); });
}

}  // namespace isolaw::cli_test
