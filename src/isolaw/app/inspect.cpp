// `isolaw inspect` and `isolaw init`: what a file holds, before anything is identified.
#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/data/properties.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/report/write.hpp"

namespace isolaw::app {
namespace {

using Json = nlohmann::ordered_json;

struct Extremes {
  double lowest, highest;
};
Extremes extremes(std::vector<double> const& values) {
  auto const [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

std::string inspection_json(data::TestRecord const& record, data::Properties const& properties) {
  Json json;
  json["file"] = record.file;
  json["sha256"] = record.sha256;
  json["samples"] = record.size();
  Json columns = Json::object(), units = Json::object();
  for (auto const& [channel, column] : record.layout.columns) columns[std::string(data::name(channel))] = column;
  for (auto const& [channel, unit] : record.layout.units) units[std::string(data::name(channel))] = unit;
  json["columns"] = columns;
  json["units"] = units;
  json["recognised"] = record.recognised;
  json["warnings"] = record.warnings;
  auto const optional = [](auto const& value) { return value ? Json(*value) : Json(nullptr); };
  json["samples_per_cycle"] = optional(properties.samples_per_cycle);
  json["refusal"] = properties.refusal.empty() ? Json(nullptr) : Json(properties.refusal);
  json["reported_cycle"] = properties.reported ? Json(properties.reported->number) : Json(nullptr);
  Json cycles = Json::array();
  for (auto const& c : properties.cycles)
    cycles.push_back({{"number", c.number},
                      {"first_sample", c.first},
                      {"last_sample", c.last},
                      {"amplitude_mm", c.amplitude_mm},
                      {"K_eff_kN_per_mm", c.K_eff_kN_per_mm},
                      {"energy_kN_mm", c.energy_kN_mm},
                      {"damping_percent", c.damping_percent}});
  json["cycles"] = cycles;
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

void print_channel(char const* name, std::vector<double> const& values, char const* unit) {
  if (values.empty()) return;
  auto const e = extremes(values);
  fmt::print("  {:<14}{:>12.4g} to {:>10.4g} {}\n", name, e.lowest, e.highest, unit);
}

void print_inspection(data::TestRecord const& record, data::Properties const& properties) {
  fmt::print("{}: {} samples, sha256 {}\n\nRecognised\n", printable(record.file), record.size(),
             record.sha256.substr(0, 16));
  for (auto const& line : record.recognised) fmt::print("  {}\n", line);
  fmt::print("\nChannels\n");
  print_channel("time", record.time_s, "s");
  print_channel("displacement", record.disp_mm, "mm");
  print_channel("force", record.force_kN, "kN");
  print_channel("vertical load", record.load_kN, "kN");

  fmt::print("\nCycles, from raw values\n");
  if (!properties.cycles.empty()) {
    fmt::print("  {:>5} {:>14} {:>16} {:>16} {:>12}\n", "cycle", "amplitude mm", "K_eff kN/mm", "energy kN mm",
               "damping %");
    for (auto const& c : properties.cycles)
      fmt::print("  {:>5} {:>14.2f} {:>16.4f} {:>16.0f} {:>12.2f}{}\n", c.number, c.amplitude_mm, c.K_eff_kN_per_mm,
                 c.energy_kN_mm, c.damping_percent,
                 properties.reported && properties.reported->number == c.number ? "  reported" : "");
  }
  if (!properties.refusal.empty()) fmt::print("  not reported: {}\n", properties.refusal);
  if (record.warnings.empty()) return;
  fmt::print("\nWarnings\n");
  for (auto const& line : record.warnings) fmt::print("  {}\n", line);
}

}  // namespace

int inspect(InspectArguments const& arguments) {
  data::ReadOptions options;
  apply(arguments.read, options);
  auto const record = data::read_record(arguments.file, options);
  auto const properties = data::cyclic_properties(record.disp_mm, record.force_kN);
  if (arguments.json)
    fmt::print("{}\n", inspection_json(record, properties));
  else
    print_inspection(record, properties);
  return exit_done;
}

int init(InitArguments const& arguments) {
  if (std::filesystem::exists(arguments.out) && !arguments.force)
    throw Error({.where = arguments.out.string(),
                 .found = "exists already",
                 .advice = "--force to overwrite it, or --out FILE"});
  auto lot = campaign::lot_of_files(arguments.files);
  lot.title = printable(std::filesystem::absolute(arguments.out).parent_path().filename().string());
  std::vector<Complaint> complaints;
  for (auto& device : lot.devices) {
    if (!is_printable(device.files.front().string())) {
      complaints.push_back({.where = device.files.front().string(),
                            .found = "a file name that no lot file can hold",
                            .allowed = "printable text in UTF-8",
                            .advice = "rename the file"});
      continue;
    }
    apply(arguments.read, device.read);
    try {
      auto const record = data::read_record(device.files.front(), device.read);
      device.read.columns = record.layout.columns;
      device.read.units = record.layout.units;
      device.read.dt_s = record.layout.dt_s;
      device.read.flip_force = record.layout.flip_force;
      fmt::print("{}: {} samples\n", device.shown_file, record.size());
      for (auto const& line : record.recognised) fmt::print("  {}\n", line);
    } catch (Error const& error) {
      complaints.insert(complaints.end(), error.complaints().begin(), error.complaints().end());
    }
  }
  if (!complaints.empty()) throw Error(complaints);
  auto const folder = std::filesystem::absolute(arguments.out).parent_path();
  report::write_file(arguments.out, campaign::lot_file_text(lot, folder));
  for (auto const& device : lot.devices)
    if (leads_outside(device.files.front(), folder))
      fmt::print(stderr, "{}: not in the folder of {} or below it: isolaw calibrate will need --allow-outside\n",
                 printable(device.files.front().string()), printable(arguments.out.string()));
  fmt::print("\nwritten: {}; next: isolaw calibrate {}\n", arguments.out.string(), arguments.out.string());
  return exit_done;
}

}  // namespace isolaw::app
