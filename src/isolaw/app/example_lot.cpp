// Computes the records of the example lot. Each force is the mean of the forces of jankowski, vaiana, hwang-wu and
// abe-y0 with a device's mean parameters (Cucuzza et al. 2025, Table A.5), under three cycles of +-208 mm at 0.5 Hz,
// 100 samples per second. The displacement that the laws follow includes the actuator's tremor but not the sensors'
// noise.
#include "isolaw/app/example_lot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <sstream>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"
#include "isolaw/study/table_a5.hpp"

namespace isolaw::app {
namespace {

constexpr double amplitude_mm = 208.0, frequency_Hz = 0.5, sampling_Hz = 100.0, load_kN = 1632.0;
constexpr int cycles = 3;
constexpr double tremor_mm = 0.10, tremor_Hz = 7.3;
constexpr double disp_noise_mm = 0.02, force_noise_kN = 0.30, load_noise_kN = 2.0;  // standard deviations
constexpr std::uint64_t noise_seed = 208;

struct Sample {
  double time_s, disp_mm, force_kN, load_kN;
};

std::vector<double> published_force(std::string_view law_id, std::size_t device, std::vector<double> const& disp_mm,
                                    std::vector<double> const& vel_mm_s) {
  auto const printed = std::ranges::find(table_a5::laws, law_id, &table_a5::Law::id);
  std::map<std::string_view, double> parameters;
  for (auto const& parameter : printed->parameters) parameters[parameter.name] = parameter.mean[device];
  return force_of(law_id, {.time_s = {}, .disp_mm = disp_mm, .vel_mm_s = vel_mm_s}, parameters);
}

std::vector<Sample> record_of(std::size_t device) {
  num::Draws noise(num::Stream(noise_seed), static_cast<std::uint32_t>(device), 0);
  double const tremor_phase = 2.0 * std::numbers::pi * noise.uniform();
  auto const count = static_cast<std::size_t>(std::lround(cycles / frequency_Hz * sampling_Hz)) + 1;
  double const w = 2.0 * std::numbers::pi * frequency_Hz, wt = 2.0 * std::numbers::pi * tremor_Hz;
  std::vector<double> time, x, v;
  for (std::size_t i = 0; i < count; ++i) {
    double const t = static_cast<double>(i) / sampling_Hz;
    // Subtracting the first value makes the tremor start at zero.
    double const sway = std::sin(wt * t + tremor_phase) - std::sin(tremor_phase);
    time.push_back(t);
    x.push_back(amplitude_mm * std::sin(w * t) + tremor_mm * sway);
    v.push_back(amplitude_mm * w * std::cos(w * t) + tremor_mm * wt * std::cos(wt * t + tremor_phase));
  }
  std::array const forces{published_force("jankowski", device, x, v), published_force("vaiana", device, x, v),
                          published_force("hwang-wu", device, x, v), published_force("abe-y0", device, x, v)};
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < count; ++i) {
    double const force = (forces[0][i] + forces[1][i] + forces[2][i] + forces[3][i]) / 4.0;
    samples.push_back({time[i], x[i] + disp_noise_mm * noise.normal(), force + force_noise_kN * noise.normal(),
                       load_kN + load_noise_kN * noise.normal()});
  }
  return samples;
}

struct Dialect {
  std::string head;
  std::string separator;
  bool decimal_comma = false;
  std::string end = "\n";
  std::function<std::vector<std::string>(Sample const&, std::size_t)> cells;
};

std::string decimals(double value, int digits) {
  return fmt::format("{:.{}f}", value, digits);
}

// Returns a function that writes time, displacement, force and load of a sample as the cells of a row. The arguments
// give the size of each unit in s, mm or kN, for example 10.0 for cm.
auto plain(double disp_unit, double force_unit, double load_unit, int disp_digits, int force_digits,
           double time_unit = 1.0, int time_digits = 2) {
  return [=](Sample const& s, std::size_t) {
    return std::vector{decimals(s.time_s / time_unit, time_digits), decimals(s.disp_mm / disp_unit, disp_digits),
                       decimals(s.force_kN / force_unit, force_digits), decimals(s.load_kN / load_unit, force_digits)};
  };
}

std::vector<Dialect> dialects() {
  constexpr double N_ = 1e-3, tonf = 9.80665, kip = 4.4482216152605, kgf = 9.80665e-3, inch = 25.4;
  return {
      {"Time [s],Displacement [mm],Force [kN],Vertical load [kN]\n", ",", false, "\n", plain(1, 1, 1, 3, 3)},
      {"Prova di taglio ciclico\r\nDispositivo;ISI-S 600/208 n\xb0 02\r\nTempo [s];Spostamento [mm];Forza [kN];Carico verticale [kN]\r\n",
       ";", true, "\r\n", plain(1, 1, 1, 3, 3)},
      {"Time\tDisplacement\tForce\tVertical load\ns\tmm\tkN\tkN\n", "\t", false, "\n", plain(1, 1, 1, 3, 3)},
      {"# Cyclic shear test, device 04\ntime_s displacement_mm force_kN load_kN\n", "  ", false, "\n",
       plain(1, 1, 1, 3, 3)},
      {"Specimen;05\nDate;2023-05-11\nTime (s);Displacement (m);Force (N);Vertical load (N)\n", ";", false, "\n",
       plain(1000, N_, N_, 6, 0)},
      {"\"Time (s)\",\"Displacement (cm)\",\"Force (tonf)\",\"Vertical load (tonf)\"\n", ",", false, "\n",
       plain(10, tonf, tonf, 4, 4)},
      {"\xef\xbb\xbfZeit [s]\tWeg [mm]\tKraft [kN]\tVertikallast [kN]\r\n", "\t", true, "\r\n", plain(1, 1, 1, 3, 3)},
      {"time,displacement,force,vertical load\nsec,in,kip,kip\n", ",", false, "\n", plain(inch, kip, kip, 5, 4)},
      {"Tempo (ms);Spostamento (mm);Forza (kgf);Carico verticale (kgf)\n", ";", true, "\n",
       plain(1, kgf, kgf, 3, 1, 1e-3, 0)},
      {"sample,time [s],displacement [mm],force [kN],vertical load [kN],\n", ",", false, "\n",
       [](Sample const& s, std::size_t i) {
         return std::vector{std::to_string(i),       decimals(s.time_s, 2),  decimals(s.disp_mm, 3),
                            decimals(s.force_kN, 3), decimals(s.load_kN, 3), std::string()};
       }},
  };
}

std::string record_text(Dialect const& dialect, std::vector<Sample> const& samples) {
  std::string text = dialect.head;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    auto row = joined(dialect.cells(samples[i], i), dialect.separator);
    if (dialect.decimal_comma) std::ranges::replace(row, '.', ',');
    text += row + dialect.end;
  }
  return text;
}

std::string file_name(std::size_t device) {
  return fmt::format("device-{:02}.{}", device + 1, device == 2 || device == 3 || device == 6 ? "txt" : "csv");
}

constexpr std::string_view usual_settings = R"toml(laws = "paper"
smooth = 5
)toml";
constexpr std::string_view study_settings = R"toml(laws = "paper"
box = "published"        # Table 4 of the paper
method = "ga"            # the search of the paper, which stops early
runs = 20
population = 100
generations = 50
seed = 1
smooth = 5
)toml";

std::string lot_text(std::string_view settings) {
  std::string text = fmt::format(R"toml(# The example lot: reconstructions, not measurements. See README.md.
title = "Example lot: rebuilt from Table A.5, not measured"

[calibrate]              # the same keys as the options of `isolaw calibrate`
{}
)toml",
                                 settings);
  for (std::size_t d = 0; d < table_a5::devices; ++d)
    text += fmt::format(
        "[[device]]\nname = \"D{0:02}\"\nfile = \"{1}\"\nserial = \"{0}\"\nlot = \"published\"\n"
        "rubber-thickness-mm = 208.0\nrubber-area-mm2 = 282743.0\n\n",
        d + 1, file_name(d));
  return text;
}

std::string readme_text() {
  return fmt::format(R"md(# The example lot: reconstructions, not measurements

The laboratory's records of Cucuzza et al. (Structures 73, 2025, 108355) are not public. These ten files are rebuilt from
the mean parameters that the paper prints in Table A.5, so that everything here can be tried without any test data.
**Four of the laws generated them, so the ranking of the laws on this lot proves nothing about those laws**, and the
spread between devices is that of the printed means.

For device d, the force is the mean of the forces of `jankowski`, `vaiana`, `hwang-wu` and `abe-y0` with the device's
published means, under {cycles} cycles of +-{amplitude:g} mm at {frequency:g} Hz from rest, {rate:g} samples per second.
Added, with a fixed seed:

| what | size |
|---|---|
| tremor of the actuator, part of the motion that the forces follow | {tremor:g} mm at {tremor_f:g} Hz |
| noise of the displacement sensor, standard deviation | {disp_noise:g} mm |
| noise of the load cell, standard deviation | {force_noise:g} kN |
| vertical load and its noise | {load:g} kN, {load_noise:g} kN |

The files are in ten dialects of delimited text on purpose: separators, decimal commas, units, languages and headers
differ as they do between laboratories. `lot.toml` names them for isolaw, with the usual search and search box. For the
paper's own study (its genetic algorithm, 20 runs, its box) use `study.toml`. The geometry in both is that of the paper's
device, ISI-S 600/208 P40.

Made by `isolaw example DIR` (`src/isolaw/app/example_lot.cpp`); a test compares these files with what it writes.
)md",
                     fmt::arg("cycles", cycles), fmt::arg("amplitude", amplitude_mm),
                     fmt::arg("frequency", frequency_Hz), fmt::arg("rate", sampling_Hz), fmt::arg("tremor", tremor_mm),
                     fmt::arg("tremor_f", tremor_Hz), fmt::arg("disp_noise", disp_noise_mm),
                     fmt::arg("force_noise", force_noise_kN), fmt::arg("load", load_kN),
                     fmt::arg("load_noise", load_noise_kN));
}

}  // namespace

std::vector<double> force_of(std::string_view law_id, data::FitRecord const& motion,
                             std::map<std::string_view, double> const& parameters) {
  auto const& law = laws::find_law(law_id);
  std::vector<double> values;
  for (auto const& info : law.parameters) {
    auto const given = parameters.find(info.name);
    values.push_back(given == parameters.end() ? info.fixed_by_default.value_or(0.0) : given->second);
  }
  return fit::LawOnMotion(law, motion, laws::Integration::converged).force_kN(values);
}

std::vector<TextFile> example_lot() {
  std::vector<TextFile> files{
      {"lot.toml", lot_text(usual_settings)}, {"study.toml", lot_text(study_settings)}, {"README.md", readme_text()}};
  auto const written_as = dialects();
  for (std::size_t d = 0; d < table_a5::devices; ++d)
    files.push_back({file_name(d), record_text(written_as[d], record_of(d))});
  return files;
}

void write_example(std::filesystem::path const& directory, std::vector<TextFile> const& files) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw Error({.where = directory.string(),
                 .found = "cannot make the directory: " + error.message(),
                 .advice = "another directory"});
  for (auto const& file : files) {
    auto const path = directory / file.name;
    if (std::ifstream present(path, std::ios::binary); present) {
      std::ostringstream content;
      content << present.rdbuf();
      if (content.str() == file.text) continue;
      throw Error({.where = path.string(),
                   .found = "a file of this name exists, with other content",
                   .advice = "an empty directory"});
    }
    std::ofstream out(path, std::ios::binary);
    out << file.text;
    if (!out.flush())
      throw Error({.where = path.string(), .found = "cannot be written", .advice = "check free space and permissions"});
  }
}

}  // namespace isolaw::app
