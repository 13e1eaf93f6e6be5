// Writes lot files. The readers are in lot_file.cpp.
#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <sstream>
#include <string_view>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/device_info.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"

namespace isolaw::campaign {
namespace {

std::string relative_name(std::filesystem::path const& file, std::filesystem::path const& directory) {
  auto const inside = std::filesystem::absolute(file).lexically_normal().lexically_relative(
      std::filesystem::absolute(directory).lexically_normal());
  bool const below = !inside.empty() && *inside.begin() != "..";
  return (below ? inside : std::filesystem::absolute(file).lexically_normal()).generic_string();
}

// Inserts a JSON value into a table. Leaves out null and empty lists. Whole numbers of TOML are signed 64-bit numbers,
// so larger ones are written as text.
void insert(toml::table& table, std::string const& key, Json const& value) {
  if (value.is_array()) {
    toml::array items;
    for (auto const& item : value) items.push_back(item.get<std::string>());
    if (!items.empty()) table.insert(key, std::move(items));
  } else if (value.is_object()) {
    toml::table inside;
    for (auto const& [name, item] : value.items()) insert(inside, name, item);
    inside.is_inline(true);
    table.insert(key, std::move(inside));
  } else if (value.is_boolean()) {
    table.insert(key, value.get<bool>());
  } else if (value.is_number_float()) {
    table.insert(key, value.get<double>());
  } else if (value.is_number() && std::in_range<std::int64_t>(value.get<std::uint64_t>())) {
    table.insert(key, value.get<std::int64_t>());
  } else if (!value.is_null()) {
    table.insert(key, text_of(value));
  }
}

// Returns the reading options that are the same for all devices, to write them in [read]. An option that only some
// devices have must not be in [read], since it would apply to all devices.
Json shared_reading(Lot const& lot) {
  Json shared = Json::object();
  for (auto const& option : data::reading_table()) {
    if (lot.devices.empty()) break;
    auto const value = option.get(lot.devices.front().tests.front().read);
    auto const same = [&](DeviceInput const& device) {
      return std::ranges::all_of(device.tests, [&](TestInput const& test) { return option.get(test.read) == value; });
    };
    if (std::ranges::all_of(lot.devices, same)) shared[option.option()] = value;
  }
  return shared;
}

void insert_reading(toml::table& table, data::ReadOptions const& read, Json const& shared) {
  for (auto const& option : data::reading_table()) {
    auto const key = option.option();
    auto const value = option.get(read);
    if (value != shared.value(key, option.get({}))) insert(table, key, value);
  }
}

toml::table written_acceptance(Lot const& lot, std::filesystem::path const& directory) {
  auto asked = lot.acceptance;
  if (lot.rules_are_file && !asked.rules_file.empty()) asked.rules_file = relative_name(asked.rules_file, directory);
  if (!asked.letterhead_file.empty()) asked.letterhead_file = relative_name(asked.letterhead_file, directory);
  toml::table table;
  for (auto const& option : acceptance_table()) insert(table, option.option(), option.get(asked));
  return table;
}

// Makes the paths of files with a single channel relative, like all paths in a lot file.
data::ReadOptions with_relative_files(data::ReadOptions read, std::filesystem::path const& directory) {
  for (auto& [channel, column] : read.columns)
    if (auto const other = data::file_column(column))
      column = data::FileColumn{relative_name(other->file, directory), other->column}.text();
  return read;
}

void insert_vertical(toml::table& device, VerticalInput const& vertical, std::filesystem::path const& directory) {
  if (vertical.stated_kN_per_mm) device.insert("K_v", *vertical.stated_kN_per_mm);
  if (vertical.file.empty()) return;
  auto const file = relative_name(vertical.file, directory);
  toml::table table{{"file", file}};
  if (vertical.loads) table.insert("loads", data::loads_text(*vertical.loads));
  for_each_vertical_option([&](auto const& option) {
    if (auto const value = option.get(vertical.read); value != option.get({})) insert(table, option.option(), value);
  });
  if (table.size() == 1) {
    device.insert("vertical", file);
  } else {
    table.is_inline(true);
    device.insert("vertical", std::move(table));
  }
}

void insert_test(toml::table& table, TestInput const& test, std::filesystem::path const& directory,
                 Json const& shared_reading) {
  if (test.files.size() == 1) {
    table.insert("file", relative_name(test.files.front(), directory));
  } else {
    toml::array files;
    for (auto const& file : test.files) files.push_back(relative_name(file, directory));
    table.insert("files", std::move(files));
  }
  insert_reading(table, test.read, shared_reading);
}

std::string open_keys(DeviceInfo const& info, StatedFacts const& hints) {  // lists keys without a value as comments
  std::string text;
  for (auto const& option : info_table()) {
    if (!option.get(info).is_null()) continue;
    auto const hint = hints.find(std::string(option.key));
    text += fmt::format("# {} = {}", option.option(), option.kind == Kind::real ? "0.0" : "\"\"");
    if (hint != hints.end()) text += fmt::format("  # the file says: {}", printable(hint->second));
    text += '\n';
  }
  return text;
}

std::string as_comment(std::string_view text) {
  std::istringstream lines{std::string(text)};
  std::string all;
  for (std::string line; std::getline(lines, line);) all += line.empty() ? "#\n" : "# " + line + '\n';
  return all;
}

// Returns the text of a lot file in which several records may be tests of one device under different conditions. The
// test of an aged device becomes a comment in the file, because the record's name does not say how long it was aged.
std::string proposed_tables(Lot const& lot, std::filesystem::path const& directory, Json const& shared_reading,
                            LotFileRemarks const& remarks) {
  std::vector<std::string> devices;
  for (auto const& test : remarks.tests)
    if (std::ranges::find(devices, test.device) == devices.end()) devices.push_back(test.device);
  auto text = fmt::format(
      "[conditions]\nreference = {}\n"
      "# design = {{ temperature-C = [-15.0, 45.0], rest = \"full\" }}  # the building's conditions; without them no bounds\n",
      remarks.reference);
  // Writes the tests near the reference temperature first and those after ageing last, which is their usual order.
  std::vector<std::size_t> order(remarks.tests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) {
    return std::pair(remarks.tests[i].is_aged, !remarks.tests[i].is_near_reference);
  });
  for (auto const& name : devices) {
    std::ostringstream head;
    head << toml::table{{"name", name}};
    text += fmt::format("\n[[device]]\n{}\n", head.str());
    int place = 0;
    for (auto const i : order) {
      auto const& proposed = remarks.tests[i];
      if (proposed.device != name) continue;
      toml::table table{{"name", lot.devices[i].name}, {"order", ++place}};
      insert_test(table, lot.devices[i].tests.front(), directory, shared_reading);
      if (proposed.temperature_C) table.insert("temperature-C", *proposed.temperature_C);
      if (proposed.load_kN) table.insert("load-kN", *proposed.load_kN);
      std::ostringstream test;
      test << "\n[[device.test]]\n" << table << '\n';
      if (!proposed.temperature_C) test << "# temperature-C = 0.0  # the name does not say it\n";
      if (proposed.lacks_load) test << "# load-kN = 0.0  # the record has no channel for it\n";
      if (place > 1) test << "# rest-h = 0.0  # hours since the test before\n";
      if (proposed.is_aged) test << "aged = { days = 0.0, at-C = 0.0 }  # the name does not say for how long\n";
      text += proposed.is_aged ? as_comment(test.str()) : test.str();
    }
  }
  return text;
}

}  // namespace

std::string lot_file_text(Lot const& written, std::filesystem::path const& directory, LotFileRemarks const& remarks) {
  auto lot = written;
  for (auto& device : lot.devices)
    for (auto& test : device.tests) test.read = with_relative_files(test.read, directory);
  auto s = lot.settings;
  s.complete();
  toml::table calibrate;
  for (auto const& setting : setting_table())
    if (!setting.stored_only && setting.belongs_to(s.method)) insert(calibrate, setting.option(), setting.get(s));
  auto const shared = shared_reading(lot);
  std::ostringstream devices;
  for (std::size_t i = 0; i < lot.devices.size(); ++i) {
    auto const& input = lot.devices[i];
    toml::table device{{"name", input.name}};
    if (input.tests.size() == 1) insert_test(device, input.tests.front(), directory, shared);
    for (auto const& option : info_table()) insert(device, option.option(), option.get(input.info));
    insert_vertical(device, input.vertical, directory);
    devices << "\n[[device]]\n" << device << '\n';
    if (remarks.open_keys)
      devices << open_keys(input.info, i < remarks.stated.size() ? remarks.stated[i] : StatedFacts{});
    for (auto const& test : input.tests) {
      if (input.tests.size() == 1) break;
      toml::table table{{"name", test.name}};
      insert_test(table, test, directory, shared);
      devices << "[[device.test]]\n" << table << '\n';
    }
  }
  toml::table read;
  for (auto const& [key, value] : shared.items())
    if (value != false) insert(read, key, value);
  toml::table root{{"title", lot.title}, {"calibrate", std::move(calibrate)}};
  if (auto acceptance = written_acceptance(lot, directory); !acceptance.empty())
    root.insert("acceptance", std::move(acceptance));
  if (!read.empty()) root.insert("read", std::move(read));
  std::ostringstream out;
  out << root << '\n' << devices.str();
  if (!remarks.left_out.empty()) out << "\n# Not read, and no device here:\n";
  for (auto const& [file, reason] : remarks.left_out)
    out << "# file = " << toml::value(printable(relative_name(file, directory))) << "  # " << printable(reason) << '\n';
  if (!remarks.tests.empty())
    out << "\n# The names of these records look like conditions of tests. If each [[device]] below is one device, delete\n"
           "# the [[device]] tables above, take the first \"# \" away from every line below, and check all values and the\n"
           "# order of the tests. Lines that then still begin with \"# \", such as that of an ageing, need a value of yours.\n"
           "# docs/conditions.md explains them. Then: isolaw conditions\n#\n"
        << as_comment(proposed_tables(lot, directory, shared, remarks));
  return out.str();
}

}  // namespace isolaw::campaign
