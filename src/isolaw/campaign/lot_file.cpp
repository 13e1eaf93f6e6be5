#include "isolaw/campaign/lot_file.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/toml_reader.hpp"

namespace isolaw::campaign {
namespace {

constexpr std::size_t longest_path = 4096;
constexpr int most_jobs = 4096;

// The lot file's own kind of value beside those of every TOML file of others.
class TableReader : public TomlTable {
 public:
  using TomlTable::TomlTable;

  // A sub-table of text by channel, or the command line's text "time=...,disp=...".
  void channels(std::string_view key,
                std::function<std::map<data::Channel, std::string>(std::string_view)> const& parse,
                std::map<data::Channel, std::string>& target) {
    auto const* node = find(key);
    if (node == nullptr) return;
    if (node->is_string()) {
      if (!accept_text(*node, key, *node->value<std::string>(), longest_name)) return;
      guarded(*node, key, [&] {
        for (auto const& [channel, name] : parse(*node->value<std::string>())) target[channel] = name;
      });
      return;
    }
    auto const* sub = node->as_table();
    if (sub == nullptr)
      return complain(*node, fmt::format("'{}' is neither a table nor text", key),
                      "{ time = \"...\", disp = \"...\", force = \"...\" }");
    for (auto const& [key_of_item, item] : *sub) {
      auto const channel = printable(key_of_item.str());
      auto const number = item.is_integer() ? item.value<std::int64_t>() : std::nullopt;
      auto const name = item.is_string() ? *item.value<std::string>()
                        : number         ? std::to_string(*number)
                                         : std::string();
      if (name.empty()) {
        complain(item, fmt::format("'{}.{}' is neither text nor a number", key, channel), "a name or a 1-based number");
        continue;
      }
      if (!accept_text(item, key, name, longest_name)) continue;
      // A column's name may hold a comma, which the command line's form could not carry.
      bool const comma = name.find(',') != std::string::npos;
      guarded(item, key, [&] {
        for (auto const& [known, value] : parse(fmt::format("{}={}", channel, comma ? "1" : name)))
          target[known] = comma ? name : value;
      });
    }
  }
};

void read_settings(TableReader& table, Settings& s) {
  table.strings("laws", [&](std::string const& text) {
    for (auto const& id : parse_laws(text))
      if (std::ranges::find(s.laws, id) == s.laws.end()) s.laws.push_back(id);
  });
  bool named = false;
  table.value<std::string>("method", "text", [&](auto const& v) {
    s.method = parse_method(v);
    named = true;
  });
  table.value<std::string>("integration", "text", [&](auto const& v) { s.integration = parse_integration(v); });
  table.value<std::string>("turning-points", "text",
                           [&](auto const& v) { s.turning_points = parse_turning_points(v); });
  table.value<int>("runs", "a whole number from 1 to 100000", [&](int v) { s.runs = checked_runs(v); });
  // What only the genetic algorithm has also chooses it.
  auto const of_genetic = [&]<class T>(std::string_view key, std::string_view allowed, T& target) {
    table.value<T>(key, allowed, [&](T v) {
      if (named && s.method != Method::genetic)
        throw Error({.where = {},
                     .found = fmt::format("{} of the genetic algorithm, with method = \"{}\"", key, name(s.method)),
                     .allowed = "with method = \"ga\" alone"});
      s.method = Method::genetic;
      target = v;
    });
  };
  of_genetic("population", "an even number from 4 to 100000", s.genetic.population);
  of_genetic("generations", "a whole number from 1 to 20000", s.genetic.generations);
  of_genetic("stagnation-tolerance", "a number", s.genetic.stagnation_tolerance);
  table.value<std::int64_t>("seed", "a whole number", [&](std::int64_t v) { s.seed = parse_seed(std::to_string(v)); });
  table.value<std::string>("box", "text", [&](auto const& v) { s.box = parse_box(v); });
  table.strings("set", [&](std::string const& text) {
    auto const change = fit::parse_override(text);
    for (auto const& other : s.overrides)
      if (other.law == change.law && other.parameter == change.parameter)
        throw Error({.where = {},
                     .found = fmt::format("{}.{} is set twice: {} and {}", change.law, change.parameter, other.text(),
                                          change.text()),
                     .allowed = "each parameter once"});
    s.overrides.push_back(change);
  });
  table.set<int>("smooth", "an odd number of samples, 1 for none, below 2147483648", s.clean.smooth);
  table.set<bool>("center", "true or false", s.clean.center);
  table.value<std::string>("fit-blocks", "text",
                           [&](auto const& v) { s.clean.scored.blocks = data::parse_numbers("--fit-blocks", v); });
  table.value<std::string>("fit-cycles", "text",
                           [&](auto const& v) { s.clean.scored.cycles = data::parse_numbers("--fit-cycles", v); });
  table.value<std::string>("score-blocks", "text",
                           [&](auto const& v) { s.clean.scored.predicted = data::parse_numbers("--score-blocks", v); });
  table.value<std::string>("analysis", "\"full\" or \"none\"", [&](auto const& v) { s.analysis = parse_analysis(v); });
  table.value<int>("replicates", "a whole number, 0 for no bootstrap",
                   [&](int v) { s.replicates = checked_replicates(v); });
}

// samples-per-cycle is a number or the word "all".
void read_thinning(TableReader& table, toml::table const& source, data::CleanOptions& clean) {
  auto const* node = source.get("samples-per-cycle");
  if (node != nullptr && node->is_string())
    table.value<std::string>("samples-per-cycle", "a whole number or \"all\"",
                             [&](auto const& v) { clean.samples_per_cycle = parse_samples_per_cycle(v); });
  else
    table.value<int>("samples-per-cycle", "a whole number from 20 to 2147483647, or \"all\"",
                     [&](int v) { clean.samples_per_cycle = v; });
}

// A name, or a number without quotes.
void read_choice(TableReader& table, toml::table const& source, std::string_view key, std::string_view expected,
                 std::function<void(std::string const&)> const& take) {
  auto const* node = source.get(key);
  if (node != nullptr && node->is_integer())
    table.value<std::int64_t>(key, expected, [&](std::int64_t v) { take(std::to_string(v)); });
  else
    table.value<std::string>(key, expected, take);
}

void read_reading(TableReader& table, toml::table const& source, data::ReadOptions& options) {
  table.channels("columns", data::parse_columns, options.columns);
  table.channels("units", data::parse_units, options.units);
  table.set("dt", options.dt_s);
  table.set<bool>("flip-force", "true or false", options.flip_force);
  auto& corrections = options.corrections;
  std::optional<double> skew_ms;
  table.set("skew-ms", skew_ms);
  if (skew_ms) corrections.skew_s = *skew_ms / 1000.0;
  table.set("rig-friction", corrections.friction_kN);
  table.set("rig-friction-coefficient", corrections.friction_coefficient);
  table.set("moving-mass", corrections.moving_mass_kg);
  table.set("force-factor", corrections.force_factor);
  try {
    corrections.validate();
  } catch (Error const& error) {
    for (auto const& complaint : error.complaints())
      table.complain(fmt::format("{}: {}", complaint.where.substr(2), complaint.found), complaint.allowed);
  }
  read_choice(table, source, "sheet", "a name or a whole number", [&](auto const& v) { options.sheet = v; });
  read_choice(table, source, "test", "a whole number or \"all\"",
              [&](auto const& v) { options.test = data::parse_test(v); });
}

// What the tests are held to: a built-in rule set by its name or a file beside the lot file, design values, lot size.
void read_acceptance(TableReader& table, toml::table const& source, std::filesystem::path const& directory,
                     LotFileOptions const& options, Lot& lot) {
  auto& acceptance = lot.acceptance;
  table.value<std::string>(
      "rules", "text",
      [&](std::string const& name) {
        constexpr char const* allowed = "a built-in rule set, or a file in the folder of the lot file or below it";
        if (name.empty()) throw Error({.where = {}, .found = "empty", .allowed = allowed});
        lot.rules_are_file = !options.is_built_in_rules || !options.is_built_in_rules(name);
        acceptance.rules_file = lot.rules_are_file ? (directory / name).string() : name;
        if (!lot.rules_are_file || options.allow_outside) return;
        // Also of a file that is not there: what the name would lead to must not be told apart from what is there.
        if (auto const outside = leads_outside(directory / name, directory))
          throw Error({.where = {},
                       .found = fmt::format("{} leads outside, to {}", in_quotes(name), outside->generic_string()),
                       .allowed = allowed,
                       .advice = "copying the file there, or --allow-outside on the command line"});
      },
      longest_path);
  table.value<std::int64_t>("lot-size", "a whole number",
                            [&](std::int64_t v) { acceptance.lot_size = parse_lot_size(std::to_string(v)); });
  auto const* design = source.get("design");
  if (design == nullptr || !design->is_table()) {
    table.set<std::string>("design", "a table of numbers, or text", acceptance.design);
    return;
  }
  table.know("design");
  for (auto const& [key, node] : *design->as_table()) {
    auto const value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) {
      table.complain(node, fmt::format("design.{} is no number", printable(key.str())), "K_eff = 1.2, damping = 15.0");
      continue;
    }
    acceptance.design += fmt::format("{}{}={}", acceptance.design.empty() ? "" : ",", printable(key.str()), *value);
  }
}

DeviceInput read_device(TableReader& table, toml::table const& source, std::filesystem::path const& directory,
                        data::ReadOptions const& defaults, LotFileOptions const& options) {
  DeviceInput device;
  device.read = defaults;
  device.directory = directory;
  auto const take_file = [&](std::string const& name) {
    device.files.push_back(directory / name);
    device.shown_file += (device.shown_file.empty() ? "" : ", ") + name;
    if (auto const outside = options.allow_outside ? std::nullopt : leads_outside(directory / name, directory))
      throw Error({.where = {},
                   .found = fmt::format("{} leads outside, to {}", in_quotes(name), outside->generic_string()),
                   .allowed = "files in the folder of the lot file or below it",
                   .advice = "copying the record there, or --allow-outside on the command line"});
  };
  table.value<std::string>("name", "text", [&](std::string const& name) {
    if (name.find_first_not_of(' ') == std::string::npos)
      throw Error({.where = {}, .found = "empty", .allowed = "a name, or no such line: then the file's"});
    device.name = name;
  });
  table.strings("file", take_file, longest_path);
  table.strings("files", take_file, longest_path);
  table.set<std::string>("serial", "text", device.info.serial);
  table.set<std::string>("lot", "text", device.info.lot);
  if (auto const* date = source.get("test-date"); date != nullptr && date->is_date()) {
    std::ostringstream text;
    text << *date->as_date();
    device.info.test_date = text.str();
    table.know("test-date");
  } else {
    table.set<std::string>("test-date", "a date or text", device.info.test_date);
  }
  auto const above = [&](std::string_view key, double limit, std::string_view allowed, std::optional<double>& target) {
    table.value<double>(key, "a number", [&](double v) {
      if (!std::isfinite(v) || v <= limit)
        throw Error({.where = {}, .found = fmt::format("{}", v), .allowed = std::string(allowed)});
      target = v;
    });
  };
  constexpr double absolute_zero_C = -273.15;
  above("temperature-C", absolute_zero_C, "degrees Celsius, above -273.15", device.info.temperature_C);
  above("rubber-thickness-mm", 0.0, "total thickness of the rubber in mm, above 0", device.info.rubber_thickness_mm);
  above("rubber-area-mm2", 0.0, "area of the rubber in mm2, above 0", device.info.rubber_area_mm2);
  read_reading(table, source, device.read);
  table.refuse_unknown();
  if (device.files.empty()) table.complain(source, "a device without a file", "file = \"...\" or files = [...]");
  if (device.name.empty() && !device.files.empty()) device.name = device.files.front().stem().string();
  return device;
}

// Values that each read well but are not allowed: at the line of their key, named as in the file.
void refuse_settings(TableReader const& reader, toml::table const& table, Settings const& settings,
                     std::vector<Complaint>& complaints) {
  try {
    settings.validate();
  } catch (Error const& error) {
    for (auto complaint : error.complaints()) {
      auto const key = complaint.where.substr(complaint.where.starts_with("--") ? 2 : 0);
      auto const* node = table.get(key);
      complaint.where = reader.where(node != nullptr ? *node : table);
      complaint.found = fmt::format("{}: {}", key, complaint.found);
      complaints.push_back(std::move(complaint));
    }
  }
}

// The results of a lot file of others must not be written over what lies elsewhere.
void take_out(Lot& lot, std::string const& out, LotFileOptions const& options) {
  lot.out = out;
  if (options.other_out) return;
  std::filesystem::path const directory = out;
  auto const inside = directory.lexically_normal();
  bool const below = directory.is_relative() && !inside.empty() && inside != "." && *inside.begin() != "..";
  auto const outside = below ? leads_outside(directory, ".") : std::optional(inside);
  if (outside)
    throw Error(
        {.where = "--out",
         .found = fmt::format("{} {}", in_quotes(out),
                              below ? "leads to " + outside->generic_string() : "is not below the current directory"),
         .allowed = "in a lot file, a directory below the current one",
         .advice = "--out DIR on the command line, which is free"});
}

std::string relative_name(std::filesystem::path const& file, std::filesystem::path const& directory) {
  auto const inside = std::filesystem::absolute(file).lexically_normal().lexically_relative(
      std::filesystem::absolute(directory).lexically_normal());
  bool const below = !inside.empty() && *inside.begin() != "..";
  return (below ? inside : std::filesystem::absolute(file).lexically_normal()).generic_string();
}

toml::table channel_table(std::map<data::Channel, std::string> const& channels) {
  toml::table table;
  for (auto const& [channel, value] : channels) table.insert(data::name(channel), value);
  table.is_inline(true);
  return table;
}

// What all devices are read by, key by key: one that a single device lacks stays out, since the device could not take
// it back.
data::ReadOptions shared_reading(Lot const& lot) {
  data::ReadOptions shared;
  if (lot.devices.empty()) return shared;
  auto const share = [&](auto const& key_of) {
    auto const& value = key_of(lot.devices.front().read);
    auto const same = [&](DeviceInput const& device) { return key_of(device.read) == value; };
    if (std::ranges::all_of(lot.devices, same)) key_of(shared) = value;
  };
  share([](auto& read) -> auto& { return read.columns; });
  share([](auto& read) -> auto& { return read.units; });
  share([](auto& read) -> auto& { return read.dt_s; });
  share([](auto& read) -> auto& { return read.flip_force; });
  share([](auto& read) -> auto& { return read.sheet; });
  share([](auto& read) -> auto& { return read.test; });
  share([](auto& read) -> auto& { return read.corrections.skew_s; });
  share([](auto& read) -> auto& { return read.corrections.friction_kN; });
  share([](auto& read) -> auto& { return read.corrections.friction_coefficient; });
  share([](auto& read) -> auto& { return read.corrections.moving_mass_kg; });
  share([](auto& read) -> auto& { return read.corrections.force_factor; });
  return shared;
}

// The keys in which `read` differs from what [read] says already.
void insert_reading(toml::table& table, data::ReadOptions const& read, data::ReadOptions const& said) {
  auto const number = [&](char const* key, std::optional<double> value, std::optional<double> there,
                          double unit = 1.0) {
    if (value && value != there) table.insert(key, *value / unit);
  };
  number("dt", read.dt_s, said.dt_s);
  if (read.flip_force && !said.flip_force) table.insert("flip-force", true);
  if (read.sheet && read.sheet != said.sheet) table.insert("sheet", *read.sheet);
  if (read.test && read.test != said.test) {
    if (*read.test == "all")
      table.insert("test", "all");
    else
      table.insert("test", static_cast<std::int64_t>(std::stol(*read.test)));
  }
  auto const &made = read.corrections, &before = said.corrections;
  number("skew-ms", made.skew_s, before.skew_s, 1e-3);
  number("rig-friction", made.friction_kN, before.friction_kN);
  number("rig-friction-coefficient", made.friction_coefficient, before.friction_coefficient);
  number("moving-mass", made.moving_mass_kg, before.moving_mass_kg);
  number("force-factor", made.force_factor, before.force_factor);
  if (read.columns != said.columns) table.insert("columns", channel_table(read.columns));
  if (read.units != said.units) table.insert("units", channel_table(read.units));
}

toml::table acceptance_table(Lot const& lot, std::filesystem::path const& directory) {
  auto const& asked = lot.acceptance;
  toml::table table;
  if (!asked.rules_file.empty())
    table.insert("rules", lot.rules_are_file ? relative_name(asked.rules_file, directory) : asked.rules_file);
  if (!asked.design.empty()) table.insert("design", asked.design);
  if (asked.lot_size) table.insert("lot-size", *asked.lot_size);
  return table;
}

}  // namespace

Lot read_lot_file(std::filesystem::path const& path, LotFileOptions const& options) {
  return read_lot_text(read_file(path, {.largest_bytes = largest_lot_file,
                                        .allowed = "a lot file in TOML, or test records",
                                        .when_too_large = "a lot file of its own for each production lot",
                                        .when_missing = "isolaw init FILES... writes a lot file"}),
                       path, options);
}

Lot read_lot_text(std::string_view text, std::filesystem::path const& path, LotFileOptions const& options) {
  auto const file = path.string();
  auto const root = parse_toml(text, file, {.kind = "lot file", .advice = "isolaw init FILES... writes one"});
  std::vector<Complaint> complaints;
  Lot lot;
  data::ReadOptions defaults;
  TableReader top(root, file, "", complaints);
  top.set<std::string>("title", "text", lot.title);
  if (auto const* table = top.table("calibrate")) {
    TableReader reader(*table, file, "[calibrate]", complaints);
    read_settings(reader, lot.settings);
    read_thinning(reader, *table, lot.settings.clean);
    read_reading(reader, *table, defaults);
    reader.value<std::string>(
        "out", "text", [&](auto const& v) { take_out(lot, v, options); }, longest_path);
    reader.value<int>("jobs", fmt::format("a whole number from 0 to {}", most_jobs), [&](int v) {
      if (v < 0 || v > most_jobs)
        throw Error({.where = "--jobs", .found = fmt::format("'{}'", v), .allowed = fmt::format("0 to {}", most_jobs)});
      lot.jobs = v;
    });
    reader.refuse_unknown();
    refuse_settings(reader, *table, lot.settings, complaints);
  }
  if (auto const* table = top.table("acceptance")) {
    TableReader reader(*table, file, "[acceptance]", complaints);
    read_acceptance(reader, *table, path.parent_path(), options, lot);
    reader.refuse_unknown();
  }
  if (auto const* table = top.table("read")) {
    TableReader reader(*table, file, "[read]", complaints);
    read_reading(reader, *table, defaults);
    reader.refuse_unknown();
  }
  lot.read = defaults;
  auto const* devices = root.get("device");
  if (devices == nullptr || !devices->is_array_of_tables()) {
    complaints.push_back({.where = file,
                          .found = "no devices",
                          .allowed = "one [[device]] table for each device",
                          .advice = "isolaw init FILES... writes a lot file"});
  } else {
    auto const& tables = *devices->as_array();
    if (tables.size() > most_devices)
      throw Error({.where = file,
                   .found = fmt::format("{} devices", tables.size()),
                   .allowed = fmt::format("{} or fewer", most_devices),
                   .advice = "a lot file of its own for each production lot"});
    std::set<std::string> names;
    for (auto const& node : tables) {
      TableReader reader(*node.as_table(), file, "[[device]]", complaints);
      auto device = read_device(reader, *node.as_table(), path.parent_path(), defaults, options);
      if (!names.insert(device.name).second)
        reader.complain(node, fmt::format("two devices are named '{}'", printable(device.name)),
                        "a name of its own for each device");
      lot.devices.push_back(std::move(device));
    }
  }
  top.know("device");
  top.refuse_unknown();
  throw_complaints(std::move(complaints), file);
  return lot;
}

Lot lot_of_files(std::vector<std::filesystem::path> const& files) {
  Lot lot;
  std::set<std::string> names;
  for (auto const& file : files) {
    DeviceInput device;
    auto const stem = printable(file.stem().string());
    device.name = stem;
    // Files of one name in several folders: the folder tells them apart, a number where that is not enough.
    if (names.contains(device.name)) device.name = printable(file.parent_path().filename().string()) + "/" + stem;
    for (int i = 2; !names.insert(device.name).second; ++i) device.name = fmt::format("{} ({})", stem, i);
    device.files = {file};
    device.shown_file = printable(file.filename().string());
    lot.devices.push_back(std::move(device));
  }
  return lot;
}

std::string lot_file_text(Lot const& lot, std::filesystem::path const& directory) {
  auto s = lot.settings;
  s.complete();
  toml::array laws, sets;
  for (auto const& id : s.laws) laws.push_back(id);
  for (auto const& change : s.overrides) sets.push_back(change.text());
  toml::table calibrate{{"method", name(s.method)},
                        {"integration", name(s.integration)},
                        {"turning-points", name(s.turning_points)},
                        {"box", name(s.box)},
                        {"seed", static_cast<std::int64_t>(s.seed)},
                        {"smooth", s.clean.smooth},
                        {"center", s.clean.center},
                        {"fit-blocks", s.clean.scored.blocks.text()},
                        {"fit-cycles", s.clean.scored.cycles.text()},
                        {"score-blocks", s.clean.scored.predicted.text()},
                        {"analysis", s.analysis ? "full" : "none"},
                        {"replicates", s.replicates}};
  calibrate.insert("runs", s.runs);
  if (s.method == Method::genetic) {
    calibrate.insert("population", s.genetic.population);
    calibrate.insert("generations", s.genetic.generations);
    calibrate.insert("stagnation-tolerance", s.genetic.stagnation_tolerance);
  }
  if (!laws.empty()) calibrate.insert("laws", std::move(laws));
  if (!sets.empty()) calibrate.insert("set", std::move(sets));
  if (s.clean.samples_per_cycle)
    calibrate.insert("samples-per-cycle", *s.clean.samples_per_cycle);
  else
    calibrate.insert("samples-per-cycle", "all");
  auto const shared = shared_reading(lot);
  toml::array devices;
  for (auto const& input : lot.devices) {
    toml::table device{{"name", input.name}};
    if (input.files.size() == 1) {
      device.insert("file", relative_name(input.files.front(), directory));
    } else {
      toml::array files;
      for (auto const& file : input.files) files.push_back(relative_name(file, directory));
      device.insert("files", std::move(files));
    }
    auto const text = [&](char const* key, std::string const& value) {
      if (!value.empty()) device.insert(key, value);
    };
    auto const number = [&](char const* key, std::optional<double> value) {
      if (value) device.insert(key, *value);
    };
    text("serial", input.info.serial);
    text("lot", input.info.lot);
    text("test-date", input.info.test_date);
    number("temperature-C", input.info.temperature_C);
    number("rubber-thickness-mm", input.info.rubber_thickness_mm);
    number("rubber-area-mm2", input.info.rubber_area_mm2);
    insert_reading(device, input.read, shared);
    devices.push_back(std::move(device));
  }
  toml::table read;
  insert_reading(read, shared, {});
  toml::table root{{"title", lot.title}, {"calibrate", std::move(calibrate)}};
  if (auto acceptance = acceptance_table(lot, directory); !acceptance.empty())
    root.insert("acceptance", std::move(acceptance));
  if (!read.empty()) root.insert("read", std::move(read));
  root.insert("device", std::move(devices));
  std::ostringstream out;
  out << root << '\n';
  return out.str();
}

}  // namespace isolaw::campaign
