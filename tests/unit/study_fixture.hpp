// A small made-up lot for the tests of the report. The devices differ a little, and the loops of the laws differ from
// the records in different ways. One device is refused; its name contains characters that could break every output
// format.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study::fixture {

inline std::string const nasty_name = "</script><img src=x onerror=alert(1)>\"'\n=1+1";

// A made-up law with its accuracy, robustness and parameters, and how far its loops differ from the record.
struct LawSketch {
  std::string id, title;
  double objective, beta;
  bool on_front;
  double stiffness, strength;  // of the law, divided by the values of the record
  std::vector<ParameterFit> parameters;
};

inline ParameterFit parameter(std::string name, std::string unit, double mean, double lower, double upper) {
  ParameterFit fit;
  fit.name = std::move(name);
  fit.unit = std::move(unit);
  fit.lower = lower;
  fit.upper = upper;
  fit.value = {mean, 0.04 * std::abs(mean), 1.01 * mean};
  return fit;
}

// lot() takes the first of these laws, three unless a test asks for more. The later laws fill the page for browser
// tests. The seventh law, abe-y0, has made-up numbers. The objectives and betas of the other laws are those of the
// published table.
inline std::vector<LawSketch> sketches() {
  return {
      {"bilinear",
       "Bilinear, kinematic hardening",
       0.137,
       0.1421,
       true,
       1.04,
       0.82,
       {parameter("K1", "kN/mm", 1.69, 1.0, 1.9), parameter("K2", "kN/mm", 0.416, 0.35, 0.95),
        parameter("xy", "mm", 42.2, 30.0, 80.0)}},
      {"vaiana",
       "Vaiana, rate-independent, asymmetric",
       0.088,
       0.2164,
       true,
       1.01,
       0.95,
       {parameter("kb+", "N/m", 4.37e5, 1e5, 1e6), parameter("f0+", "N", 43500.0, 1e4, 1e5),
        parameter("alpha+", "1/m", 49.9, 10.0, 50.0), parameter("beta1-", "N/m", -0.49, -1.0, -0.05),
        parameter("beta2+", "1/m", 24.5, 10.0, 50.0)}},
      {"hwang-wu",
       "Hwang and Wu, rate-dependent",
       0.117,
       0.3341,
       false,
       0.97,
       1.14,
       {parameter("a1", "N/cm", 4590.0, 1e3, 1e4), parameter("a3", "1/cm^2", 0.01, 0.001, 0.1),
        parameter("a9", "N/cm^3", -2.5e-6, -1e-5, -1e-7)}},
      {"jankowski",
       "Jankowski, non-linear spring and dashpot",
       0.079,
       0.3030,
       true,
       0.995,
       1.02,
       {parameter("a1", "N/m", 2.88e5, 1e4, 1e6), parameter("a2", "N/m^3", 4.18e6, 1e6, 9e6),
        parameter("a3", "N/m^5", 5.48e6, 1e6, 9e6), parameter("a7", "-", 4.4, 1.0, 10.0),
        parameter("a11", "-", 0.44, 0.1, 1.0)}},
      {"bouc-wen",
       "Bouc-Wen, smooth hysteresis with post-yield stiffness",
       0.089,
       0.2171,
       false,
       1.02,
       0.93,
       {parameter("alpha", "-", 0.149, 0.05, 0.5), parameter("Ke", "kN/mm", 3.09, 1.0, 5.0),
        parameter("n", "-", 1.01, 1.0, 2.0)}},
      {"abe",
       "Abe, elastoplastic with displacement-dependent yield",
       0.085,
       0.2590,
       true,
       1.0,
       1.06,
       {parameter("K1", "kN/mm", 7.1, 3.0, 10.0), parameter("Y0", "kN", 50.3, 30.0, 80.0),
        parameter("Xh", "mm", 115.0, 80.0, 150.0)}},
      {"abe-y0",
       "Abe, yield force Y0 throughout",
       0.091,
       0.2490,
       false,
       1.01,
       1.09,
       {parameter("K1", "kN/mm", 7.2, 3.0, 10.0), parameter("Y0", "kN", 49.1, 30.0, 80.0)}},
  };
}

// Returns the force on three cycles of ±208 mm at 0.5 Hz. `stiffness` and `strength` are factors; both are 1 for a
// device at the mean of the lot. `scragging` is the share by which the stiffness is larger at the start. It fades
// within seconds.
inline std::vector<double> loop_force(data::FitRecord const& record, double stiffness, double strength,
                                      double scragging) {
  std::vector<double> force;
  double hysteresis = 0.0;
  for (std::size_t i = 0; i < record.size(); ++i) {
    double const dx = i > 0 ? record.disp_mm[i] - record.disp_mm[i - 1] : 0.0;
    hysteresis += dx / 18.0 - std::abs(dx) / 18.0 * hysteresis;
    double const x = record.disp_mm[i] / 208.0;
    double const fading = 1.0 + scragging * std::exp(-record.time_s[i]);
    force.push_back(stiffness * fading * (78.0 * x + 14.0 * x * x * x) + strength * 38.0 * hysteresis);
  }
  return force;
}

inline DeviceResult device(std::string name, double scatter, int samples_per_cycle) {
  DeviceResult device;
  device.name = std::move(name);
  device.file = "records/" + device.name + ".csv";
  device.sha256 = "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08";
  device.status = "ok";
  device.rubber_thickness_mm = 208.0;
  device.temperature_C = 21.5;
  device.record.cleaning = {stated("centred moving average over 5 samples on displacement and force")};
  for (int i = 0; i <= 3 * samples_per_cycle; ++i) {
    double const t = 2.0 * i / samples_per_cycle;
    device.record.time_s.push_back(t);
    device.record.disp_mm.push_back(208.0 * std::sin(std::numbers::pi * t));
    device.record.vel_mm_s.push_back(208.0 * std::numbers::pi * std::cos(std::numbers::pi * t));
  }
  device.record.force_kN = loop_force(device.record, 1.0 + scatter, 1.0 + 0.5 * scatter, 0.08);
  device.raw.file = device.file;
  device.raw.time_s = device.record.time_s;
  device.raw.disp_mm = device.record.disp_mm;
  device.raw.force_kN = device.record.force_kN;
  device.raw.recognised = {stated("comma separated, decimal point: one number per column in every row"),
                           stated("force in kN, displacement in mm, time in s: units stand in row 2")};
  auto& block = device.properties.blocks.emplace_back();
  block.number = 1;
  block.amplitude_mm = 208.0;
  for (int number = 1; number <= 3; ++number) {
    data::Cycle cycle;
    cycle.block = 1;
    cycle.number = number;
    cycle.first = static_cast<std::size_t>((number - 1) * samples_per_cycle);
    cycle.last = static_cast<std::size_t>(number * samples_per_cycle);
    cycle.amplitude_mm = 208.0;
    cycle.K_eff_kN_per_mm = (1.0 + scatter) * (0.66 - 0.02 * number);
    cycle.energy_kN_mm = (1.0 + 0.5 * scatter) * (29500.0 - 250.0 * number);
    cycle.damping_percent =
        100.0 * cycle.energy_kN_mm / (2.0 * std::numbers::pi * cycle.K_eff_kN_per_mm * 208.0 * 208.0);
    block.cycles.push_back(cycle);
  }
  device.properties.reported = block.cycles.back();
  device.properties.samples_per_cycle = samples_per_cycle;
  return device;
}

// Returns a lot with `law_count` laws on the devices D1, D2, ... and one refused device after them.
inline Summary lot(int device_count = 3, int law_count = 3) {
  Summary summary;
  summary.version = "0.1.0";
  summary.title = "Test lot";
  summary.seed = 7;
  summary.settings = {
      {"runs", "20"}, {"integration", "\"converged\""}, {"laws", R"(["bilinear","vaiana"])"}, {"smooth", "5"}};
  std::vector<double> scatters;
  for (int d = 0; d < device_count; ++d) {
    scatters.push_back(device_count == 1 ? 0.0 : 0.12 * (2.0 * ((d * 7) % device_count) / (device_count - 1) - 1.0));
    summary.devices.push_back(device("D" + std::to_string(d + 1), scatters.back(), 200));
  }
  DeviceResult refused;
  refused.name = nasty_name;
  refused.file = "records/<b>bad</b>.csv";
  refused.status = "refused";
  refused.message = "line 7: not a number: \"<script>alert(2)</script>\"";
  summary.devices.push_back(refused);

  refused.properties.refusal = {stated(refused.message)};
  summary.devices.back() = refused;
  rules::Design design;
  design.K_eff_kN_per_mm = 0.6;
  design.damping_percent = 18.0;
  design.disp_mm = 208.0;
  add_acceptance(summary, rules::find_rule_set("ntc-2018"), design, 160);

  auto const all = sketches();
  for (int j = 0; j < law_count && j < static_cast<int>(all.size()); ++j) {
    auto const& sketch = all[static_cast<std::size_t>(j)];
    LawResult law;
    law.id = sketch.id;
    law.title = sketch.title;
    law.objective = {sketch.objective, 0.0125, 0.94 * sketch.objective};
    if (device_count > 1) {
      law.beta = sketch.beta;
      law.on_front = sketch.on_front;
    } else {
      law.beta_note = "one device: the difference between devices is not defined";
    }
    law.notes = {"One line on how the source was read."};
    for (int d = 0; d < device_count; ++d) {
      auto const place = static_cast<std::size_t>(d);
      double const scatter = scatters[place];
      DeviceFit fit;
      fit.device = summary.devices[place].name;
      fit.runs = 20;
      double const objective = sketch.objective * (1.0 + 1.5 * scatter);
      fit.objective = {objective, 0.03 * sketch.objective * (1.0 + 0.3 * j), 0.96 * objective};
      fit.K_eff_error_percent = 100.0 * (sketch.stiffness - 1.0) + 3.0 * scatter;
      fit.energy_error_percent = 100.0 * (sketch.strength - 1.0) - 2.0 * scatter;
      fit.damping_error_percent = 80.0 * (sketch.strength - 1.0);
      fit.integration_shift = 2e-5;
      fit.force_kN = loop_force(summary.devices[place].record, sketch.stiffness * (1.0 + scatter),
                                sketch.strength * (1.0 + 0.5 * scatter), 0.0);
      for (std::size_t n = 0; n < sketch.parameters.size(); ++n) {
        auto parameter = sketch.parameters[n];
        double const difference = scatter * (1.0 + 0.4 * static_cast<double>(n));
        parameter.value.mean = *parameter.value.mean * (1.0 + difference);
        if (device_count > 1) parameter.percent_of_lot = 100.0 * difference;
        if (parameter.name == "alpha+" && d != 1) parameter.at_bound = fit::AtBound::upper;
        fit.parameters.push_back(parameter);
      }
      law.devices.push_back(fit);
    }
    summary.laws.push_back(law);
  }
  return summary;
}

}  // namespace isolaw::study::fixture
