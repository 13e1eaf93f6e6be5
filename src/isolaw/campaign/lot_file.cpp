#include "isolaw/campaign/lot_file.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/nearest_word.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/toml_reader.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/device_info.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/stated_quantity.hpp"
#include "isolaw/data/files/time_stamp.hpp"
#include "isolaw/data/reading.hpp"

namespace isolaw::campaign {
namespace {

constexpr std::size_t longest_path = 4096;
constexpr std::size_t most_wrong_letters = 2;  // in a misspelt name that is still recognised

bool is_among(std::vector<std::string> const& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

void read_settings(TomlTable& table, Settings& settings) {
  bool method_given = false;
  for (auto const& setting : setting_table()) {
    if (setting.stored_only) continue;
    table.json(setting.option(), [&](Json const& value) {
      take(setting, value, method_given, settings);
      method_given = method_given || setting.key == "method";
    });
  }
}

bool has_tests(TomlTable& device) {
  auto const* tests = device.find("test");
  return tests != nullptr && tests->is_array_of_tables();
}

// With `skip_tests` the key `test` is not read. As a reading option it chooses one of the tests in a file, but in a
// device with [[device.test]] tables it holds these tables.
void read_reading(TomlTable& table, data::ReadOptions& options, bool skip_tests = false) {
  for (auto const& option : data::reading_table())
    if (!skip_tests || option.option() != "test")
      table.json(option.option(), [&](Json const& value) { option.set(options, value); });
  try {
    options.corrections.validate();
  } catch (Error const& error) {
    for (auto const& complaint : error.complaints())
      table.complain(fmt::format("{}: {}", complaint.where.substr(2), complaint.found), complaint.allowed);
  }
}

void require_rules(TomlTable& table, toml::node const& node, std::string const& name, std::filesystem::path const& file,
                   LotFileOptions const& options) {
  std::error_code unknown;
  auto const near = nearest_word(name, options.built_in_rules, most_wrong_letters);
  if (!options.built_in_rules.empty() && !std::filesystem::exists(file, unknown))
    table.complain(
        node, fmt::format("rules: {} is neither a built-in rule set nor a file here", in_quotes(name)),
        fmt::format("{}, or a file in the folder of the lot file or below it", joined(options.built_in_rules)),
        near.empty() ? "isolaw rules lists the sets, isolaw rules template prints a file to start from" : near);
}

// Complains if the table [conditions] names a rule set that is not built in.
void require_built_in(toml::table const& conditions, std::string const& file, std::vector<std::string> const& built_in,
                      std::string const& name, std::vector<Complaint>& complaints) {
  if (name.empty() || built_in.empty() || is_among(built_in, name)) return;
  TomlTable table(conditions, file, "[conditions]", complaints);
  table.complain(*table.find("rules"), fmt::format("rules: no built-in rule set {}", in_quotes(name)), joined(built_in),
                 nearest_word(name, built_in, most_wrong_letters));
}

// Returns a complaint if the file `name` is not in the folder of the lot file or below it.
std::optional<Complaint> outside_of(std::filesystem::path const& directory, std::string const& name) {
  auto const place = leads_outside(directory / name, directory);
  if (!place) return std::nullopt;
  return Complaint{.found = fmt::format("{} leads outside, to {}", in_quotes(name), place->generic_string()),
                   .allowed = "a file in the folder of the lot file or below it",
                   .advice = "copying the file there, or --allow-outside on the command line"};
}

void read_acceptance(TomlTable& table, std::filesystem::path const& directory, LotFileOptions const& options,
                     Lot& lot) {
  auto& acceptance = lot.acceptance;
  for (auto const& option : acceptance_table())
    table.json(
        option.option(), [&](Json const& value) { option.set(acceptance, value); }, longest_path);
  if (auto const* design = table.find("design"); design != nullptr && options.check_design) try {
      options.check_design(acceptance.design);
    } catch (Error const& error) {
      for (auto const& complaint : error.complaints())
        table.complain(*design, "design: " + complaint.found, complaint.allowed, complaint.advice);
    }
  if (auto& file = acceptance.letterhead_file; !file.empty()) {
    if (auto const outside = options.allow_outside ? std::nullopt : outside_of(directory, file))
      table.complain(*table.find("letterhead"), "letterhead: " + outside->found, outside->allowed, outside->advice);
    file = (directory / file).string();
  }
  auto const* rules = table.find("rules");
  if (rules == nullptr || acceptance.rules_file.empty()) return;
  auto const name = std::exchange(acceptance.rules_file, {});
  lot.rules_are_file = !is_among(options.built_in_rules, name);
  acceptance.rules_file = lot.rules_are_file ? (directory / name).string() : name;
  if (!lot.rules_are_file) return;
  if (options.allow_outside) return require_rules(table, *rules, name, acceptance.rules_file, options);
  // A path that leads outside is refused whether or not the file exists, so a lot file cannot probe for files.
  if (auto const outside = outside_of(directory, name))
    table.complain(*rules, "rules: " + outside->found, "a built-in rule set, or " + outside->allowed, outside->advice);
  else
    require_rules(table, *rules, name, acceptance.rules_file, options);
}

// Reads what a device states about its vertical stiffness: K_v = 1234.0, vertical = "file.csv", or vertical = a table
// of file, loads and options. `take_file` may refuse a file.
void read_vertical_input(TomlTable& table, std::filesystem::path const& directory,
                         std::function<void(std::string const&)> const& take_file, std::string const& lot_file,
                         std::vector<Complaint>& complaints, VerticalInput& vertical) {
  table.value<double>("K_v", "vertical stiffness in kN/mm, above 0", [&](double value) {
    if (!(value > 0.0) || !std::isfinite(value))
      throw Error({.where = {}, .found = fmt::format("{}", value), .allowed = "vertical stiffness in kN/mm, above 0"});
    vertical.stated_kN_per_mm = value;
  });
  auto const* node = table.find("vertical");
  if (node == nullptr) return;
  if (vertical.stated_kN_per_mm)
    table.complain(*node, "K_v and vertical for one device", "the stiffness, or the test that it follows from");
  auto const take = [&](std::string const& name) {
    take_file(name);
    vertical.file = directory / name;
    vertical.shown_file = name;
  };
  if (!node->is_table()) return table.value<std::string>("vertical", "a file, or a table with one", take, longest_path);
  TomlTable inside(*node->as_table(), lot_file, "vertical", complaints);
  inside.value<std::string>("file", "text", take, longest_path);
  inside.value<std::string>("loads", "text",
                            [&](std::string const& text) { vertical.loads = data::parse_loads(text); });
  for_each_vertical_option([&](auto const& option) {
    inside.json(option.option(), [&](Json const& value) { option.set(vertical.read, value); });
  });
  inside.refuse_unknown();
  if (inside.find("file") == nullptr) inside.complain("a vertical test without a file", "file = \"...\"");
}

// Makes a name for a device to which the lot file gives none: the name of the first file of its only test, or a name
// made of the names of its tests.
std::string name_of(std::vector<TestInput> const& tests) {
  if (tests.size() == 1) return tests.front().files.empty() ? std::string() : name_of_file(tests.front().files.front());
  std::vector<data::TestSource> sources;
  for (auto const& test : tests) sources.push_back({.name = test.name, .file = {}, .sha256 = {}});
  return sources.empty() ? std::string() : name_of_tests(sources);
}

// Reads the tables of a device. Files outside the lot file's folder are refused unless the user allows them.
class DeviceReader {
 public:
  // `conditions` is the table [conditions] of the lot file, or nullptr if the lot file has none.
  DeviceReader(std::filesystem::path directory, LotFileOptions const& options, std::string file,
               StatedConditions const* conditions, std::vector<Complaint>& complaints)
      : directory_(std::move(directory)),
        options_(options),
        file_(std::move(file)),
        conditions_(conditions),
        complaints_(complaints) {}

  DeviceInput read(TomlTable& table, toml::table const& source, data::ReadOptions const& defaults) {
    DeviceInput device;
    device.directory = directory_;
    device.tests.clear();
    device.name = name_in(table);
    for (auto const& option : info_table())
      table.json(option.option(), [&](Json const& value) { option.set(device.info, value); });
    if (conditions_ != nullptr)
      for (auto const& option : compared_devices_table())
        table.json(option.option(), [&](Json const& value) { option.set(device.stated, value); });
    else
      refuse_conditions(table, source, compared_devices_table());
    auto const complaints_before = complaints_.size();
    auto only = test_in(table, defaults, has_tests(table));
    if (has_tests(table)) {
      auto const* tests = table.find("test");
      if (!only.files.empty())
        table.complain(*tests, "a device with a file and with tests", "a file, or [[device.test]] tables with files");
      for (auto const& node : *tests->as_array())
        device.tests.push_back(named_test(*node.as_table(), only.read, table.file()));
      refuse_same_names(table, *tests, device.tests);
    } else {
      if (only.files.empty())
        table.complain(source, "a device without a file", "file = \"...\" or files = [...]",
                       "a [[device.test]] table for each test of a device with several");
      find_columns(table, source, only);
      device.tests.push_back(std::move(only));
    }
    if (device.name.empty()) device.name = name_of(device.tests);
    if (conditions_ != nullptr) take_history(table, source, device, complaints_.size() == complaints_before);
    read_vertical_input(
        table, directory_, [&](std::string const& name) { check_inside(name); }, file_, complaints_, device.vertical);
    table.refuse_unknown();
    return device;
  }

 private:
  void check_inside(std::string const& name) const {
    if (auto const outside = options_.allow_outside ? std::nullopt : outside_of(directory_, name))
      throw Error(*outside);
  }

  static std::string name_in(TomlTable& table) {
    std::string found;
    table.value<std::string>("name", "text", [&](std::string const& name) {
      auto const plain = trimmed(name);
      if (plain.empty())
        throw Error({.where = {}, .found = "empty", .allowed = "a name, or no such line: then the file's"});
      if (plain != name)
        throw Error({.where = {},
                     .found = fmt::format("{} begins or ends with a blank", in_quotes(name)),
                     .allowed = "a name without blanks around it",
                     .advice = fmt::format("name = \"{}\"", plain)});
      found = name;
    });
    return found;
  }

  // Reads from a table which files one test has and how to read them. In a device with [[device.test]] tables, the
  // device's own table names no file and only states how to read all tests; then `skip_tests` is true.
  TestInput test_in(TomlTable& table, data::ReadOptions const& defaults, bool skip_tests) const {
    TestInput test;
    test.read = defaults;
    auto const take_file = [&](std::string const& name) {
      test.files.push_back(directory_ / name);
      test.shown_file += (test.shown_file.empty() ? "" : ", ") + name;
      check_inside(name);
    };
    auto const *one = table.find("file"), *several = table.find("files");
    if (one != nullptr && several != nullptr)
      table.complain(*several, "both file and files", "one of them",
                     "files = [\"...\", \"...\"], read one after another as one history");
    table.strings("file", take_file, longest_path);
    table.strings("files", take_file, longest_path);
    read_reading(table, test.read, skip_tests);
    return test;
  }

  // Some channels may be in files of their own. Puts the lot file's folder before the names of these files and refuses
  // files outside the folder. Such a name may come from the table of the test, of its device, or from [read].
  void find_columns(TomlTable& table, toml::table const& source, TestInput& test) const {
    for (auto& [channel, column] : test.read.columns)
      if (auto const other = data::file_column(column)) {
        try {
          check_inside(other->file);
        } catch (Error const& error) {
          auto const& complaint = error.complaints().front();
          table.complain(source, fmt::format("columns: {}", complaint.found), complaint.allowed, complaint.advice);
        }
        test.shown_file += ", " + other->file;
        column = data::FileColumn{(directory_ / other->file).generic_string(), other->column}.text();
      }
  }

  TestInput named_test(toml::table const& source, data::ReadOptions const& defaults, std::string const& file) {
    TomlTable table(source, file, "[[device.test]]", complaints_);
    auto test = test_in(table, defaults, false);
    // Tables from a Python program have no line numbers, so their tests get no place.
    if (auto const line = source.source().begin.line; line > 0)
      test.place = fmt::format("{}:{}", std::filesystem::path(file_).filename().string(), line);
    find_columns(table, source, test);
    test.name = name_in(table);
    if (conditions_ != nullptr) {
      for (auto const& option : test_table())
        table.json(option.option(), [&](Json const& value) { option.set(test.stated, value); });
      test.stated.aged = read_aged(table, file_, complaints_);
      if (table.find("order") == nullptr && table.find("started") == nullptr)
        table.complain(
            source, "a test without its order",
            "order = 1, 2, ... as the device was tested, or started = \"2026-03-01T09:00:00\" in every test");
      if (test.stated.scale && !test.stated.is_scaled)
        table.complain(source, "a scale, and the specimen is not scaled", "specimen = \"scaled\" with a scale");
    } else {
      if (source.contains("aged")) table.find("aged");
      refuse_conditions(table, source, test_table());
    }
    if (test.files.empty()) table.complain(source, "a test without a file", "file = \"...\" or files = [...]");
    if (test.name.empty() && !test.files.empty()) test.name = name_of_file(test.files.front());
    table.refuse_unknown();
    return test;
  }

  // For a lot file without a table [conditions]: complains about its first key that needs this table, and about no
  // other. table.find() marks each such key as known, so that table.refuse_unknown() does not complain about it.
  void refuse_conditions(TomlTable& table, toml::table const& source, auto const& options) {
    for (auto const& option : options) {
      if (!source.contains(option.option())) continue;
      auto const* node = table.find(option.option());
      if (std::exchange(lacks_conditions_, true)) continue;
      table.complain(*node,
                     fmt::format("{} is about the conditions of tests, and the file has no table [conditions]",
                                 in_quotes(option.option())),
                     "a table [conditions] with a reference, or no such keys", "docs/conditions.md");
    }
  }

  // Sorts the tests by their `order`. Chooses the test to which a campaign fits laws: the test with stands-for =
  // "acceptance", else the first one at the reference temperature that is not aged, else the first one. Laws are also
  // fitted to tests with fit = true. `is_sound` is true if there was no complaint about the tests' tables.
  void take_history(TomlTable& table, toml::table const& source, DeviceInput& device, bool is_sound) const {
    auto& all = device.history = std::move(device.tests);
    device.tests.clear();
    if (all.size() == 1) {
      auto& only = all.front();
      if (only.name.empty() && !only.files.empty()) only.name = name_of_file(only.files.front());
      if (!only.stated.temperature_C) only.stated.temperature_C = device.info.temperature_C;
      only.stated.order = only.stated.order.value_or(1);
    }
    if (is_sound) order_by_start(table, source, all);
    std::map<int, TestInput const*> orders;
    auto const named = [](TestInput const& test) {
      return fmt::format("'{}'{}", printable(test.name), test.place.empty() ? "" : " (" + test.place + ")");
    };
    for (auto const& test : all) {
      if (!test.stated.order) continue;
      auto const [other, is_new] = orders.emplace(*test.stated.order, &test);
      if (!is_new)
        table.complain(source,
                       fmt::format("test {} has the order of another test, {}: {}", named(test), named(*other->second),
                                   *test.stated.order),
                       "order = 1, 2, ... as the device was tested");
    }
    std::ranges::stable_sort(all, {}, [](TestInput const& test) { return test.stated.order.value_or(0); });
    std::vector<double> starts;
    for (auto const& test : all)
      if (auto const start = start_h(test.stated.started)) starts.push_back(*start);
    if (!std::ranges::is_sorted(starts))
      table.complain(source, "a test began before another one that comes earlier in the order",
                     "order and started that agree");
    if (std::ranges::count_if(all, [](TestInput const& test) { return test.stated.is_acceptance; }) > 1)
      table.complain(source, "two tests of a device with stands-for = \"acceptance\"", "one of them");
    auto const chosen = [&](auto const& stands) { return std::ranges::find_if(all, stands); };
    auto acceptance = chosen([](TestInput const& test) { return test.stated.is_acceptance; });
    if (acceptance == all.end())
      acceptance = chosen([&](TestInput const& test) {
        return test.stated.temperature_C && !test.stated.aged &&
               std::abs(*test.stated.temperature_C - conditions_->reference.temperature_C) <=
                   conditions_->tolerance.temperature_C;
      });
    if (acceptance == all.end()) acceptance = all.begin();
    if (acceptance == all.end()) return;  // there is no test; another function has complained about this
    acceptance->stated.is_acceptance = true;
    device.tests.push_back(*acceptance);
    for (auto const& test : all)
      if (test.stated.takes_part_in_fit && &test != &*acceptance) device.tests.push_back(test);
    if (device.tests.size() == 1) device.tests.front().name.clear();
    if (!device.info.temperature_C) device.info.temperature_C = acceptance->stated.temperature_C;
  }

  // Numbers the tests by the time when they began, if all of them state it and none states its order.
  static void order_by_start(TomlTable& table, toml::table const& source, std::vector<TestInput>& all) {
    auto const states_start = [](TestInput const& test) { return !test.stated.started.empty(); };
    if (std::ranges::none_of(all, states_start)) return;
    bool const has_orders =
        std::ranges::any_of(all, [](TestInput const& test) { return test.stated.order.has_value(); });
    if (has_orders && all.size() > 1) return;  // the stated order counts; starts only give the times at rest
    if (!std::ranges::all_of(all, states_start))
      return table.complain(source, "some tests of a device have neither an order nor a start",
                            "order in every test, or started in every test");
    std::ranges::stable_sort(all, {}, [](TestInput const& test) { return *start_h(test.stated.started); });
    for (int order = 1; auto& test : all) test.stated.order = order++;
  }

  static void refuse_same_names(TomlTable& table, toml::node const& node, std::vector<TestInput> const& tests) {
    std::set<std::string> names;
    for (auto const& test : tests)
      if (!names.insert(test.name).second)
        table.complain(node, fmt::format("two tests of a device are named '{}'", printable(test.name)),
                       "a name of its own for each test of a device");
  }

  std::filesystem::path directory_;
  LotFileOptions const& options_;
  std::string file_;
  StatedConditions const* conditions_;
  std::vector<Complaint>& complaints_;
  bool lacks_conditions_ = false;  // a complaint already says that the file has no table [conditions]
};

// Complains about each value that Settings::validate() refuses, at the line of its key.
void refuse_settings(TomlTable const& reader, toml::table const& table, Settings const& settings,
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

// Finds a table whose name is nearly "conditions". It is read as the table [conditions], so that only its name is
// complained about.
toml::table const* misspelt_conditions(toml::table const& root) {
  for (auto const& [key, node] : root)
    if (node.is_table() && !nearest_word(key.str(), std::vector<std::string>{"conditions"}, most_wrong_letters).empty())
      return node.as_table();
  return nullptr;
}

// A lot file from someone else must not write its results outside the current directory.
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

constexpr TomlMessages messages{.kind = "lot file", .advice = "isolaw init FILES... writes one"};

Lot read_parsed(toml::table const& root, std::string const& file, std::filesystem::path const& folder,
                LotFileOptions const& options) {
  std::vector<Complaint> complaints;
  Lot lot;
  data::ReadOptions defaults;
  TomlTable top(root, file, "", complaints);
  top.value<std::string>("title", "text", [&](std::string const& title) { lot.title = title; });
  if (auto const* table = top.table("calibrate")) {
    TomlTable reader(*table, file, "[calibrate]", complaints);
    read_settings(reader, lot.settings);
    read_reading(reader, defaults);
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
    TomlTable reader(*table, file, "[acceptance]", complaints);
    read_acceptance(reader, folder, options, lot);
    reader.refuse_unknown();
  }
  if (auto const* table = top.table("read")) {
    TomlTable reader(*table, file, "[read]", complaints);
    read_reading(reader, defaults);
    reader.refuse_unknown();
  }
  lot.read = defaults;
  auto const* conditions = top.table("conditions");
  if (conditions == nullptr) conditions = misspelt_conditions(root);
  if (conditions != nullptr) {
    lot.conditions = read_conditions(*conditions, file, complaints);
    require_built_in(*conditions, file, options.built_in_rules, lot.conditions->rules, complaints);
  }
  auto const* devices = top.find("device");
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
    DeviceReader device_reader(folder, options, file, lot.conditions ? &*lot.conditions : nullptr, complaints);
    for (auto const& node : tables) {
      TomlTable reader(*node.as_table(), file, "[[device]]", complaints);
      auto device = device_reader.read(reader, *node.as_table(), defaults);
      if (!names.insert(device.name).second)
        reader.complain(node, fmt::format("two devices are named '{}'", printable(device.name)),
                        "a name of its own for each device");
      lot.devices.push_back(std::move(device));
    }
  }
  top.refuse_unknown();
  throw_complaints(std::move(complaints), file);
  return lot;
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
  return read_parsed(parse_toml(text, file, messages), file, path.parent_path(), options);
}

Lot lot_of_tables(Json const& tables, std::filesystem::path const& folder, LotFileOptions const& options) {
  return read_parsed(toml_of(tables, "lot", messages), "lot", folder, options);
}

std::vector<std::filesystem::path> files_of(DeviceInput const& device) {
  std::vector<std::filesystem::path> files;
  for (auto const& test : device.tests) {
    files.insert(files.end(), test.files.begin(), test.files.end());
    for (auto const& [channel, column] : test.read.columns)
      if (auto const other = data::file_column(column)) {
        std::filesystem::path file = other->file;
        if (std::ranges::find(files, file) == files.end()) files.push_back(std::move(file));
      }
  }
  return files;
}

std::string DeviceInput::shown_file() const {
  std::vector<std::string> files;
  for (auto const& test : tests) files.push_back(test.shown_file);
  return joined(files);
}

std::string name_of_file(std::filesystem::path const& file) {
  auto const stem = printable(file.stem().string());
  auto const name = trimmed(stem);
  return name.empty() ? printable(file.extension().string()) : std::string(name);
}

Lot lot_of_files(std::vector<std::filesystem::path> const& files) {
  Lot lot;
  std::set<std::string> names;
  for (auto const& file : files) {
    DeviceInput device;
    auto const stem = name_of_file(file);
    device.name = stem;
    // If two files have the same name, the second device gets the name of its folder in front or, if that name is taken
    // too, a number after it.
    if (names.contains(device.name))
      device.name = trimmed(printable(file.parent_path().filename().string()) + "/" + stem);
    for (int i = 2; !names.insert(device.name).second; ++i) device.name = fmt::format("{} ({})", stem, i);
    device.tests.front().files = {file};
    device.tests.front().shown_file = printable(file.filename().string());
    lot.devices.push_back(std::move(device));
  }
  return lot;
}

StatedFacts make_one_device(Lot& lot) {
  DeviceInput one;
  StatedFacts disputed;
  for (auto const& option : info_table()) {
    std::set<Json> values;
    std::vector<std::string> stated;
    for (auto const& device : lot.devices) {
      auto const value = option.get(device.info);
      if (value.is_null()) continue;
      values.insert(value);
      stated.push_back(
          fmt::format("{} in {}", value.is_string() ? value.get<std::string>() : value.dump(), device.name));
    }
    if (values.size() == 1) option.set(one.info, *values.begin());
    if (values.size() > 1) disputed[std::string(option.key)] = joined(stated);
  }
  one.tests.clear();
  for (auto& device : lot.devices)
    for (auto& test : device.tests) {
      test.name = device.name;
      one.tests.push_back(std::move(test));
    }
  one.name = name_of(one.tests);
  if (one.tests.size() == 1) one.tests.front().name.clear();
  lot.devices = {std::move(one)};
  return disputed;
}

std::string name_of_tests(std::span<data::TestSource const> tests) {
  constexpr std::size_t most_named = 3;
  if (tests.size() > most_named) return fmt::format("{} and {} more tests", tests.front().name, tests.size() - 1);
  std::vector<std::string> names;
  for (auto const& test : tests) names.push_back(test.name);
  return joined(names, " + ");
}

StatedFacts take_device_facts(std::vector<std::pair<std::string, std::string>> const& device_facts, DeviceInfo& info) {
  StatedFacts left;
  for (auto const& [key, text] : device_facts) {
    auto const& table = info_table();
    auto const option = std::ranges::find(table, key, [](auto const& each) { return std::string(each.key); });
    if (option == table.end() || !option->get(info).is_null()) continue;
    Json value = text;
    if (option->measure != Measure::text) {
      auto const number = stated(text, option->measure);
      value = number ? Json(*number) : Json();
    }
    try {
      if (value.is_null() || (value.is_string() && !is_printable(text)))
        throw Error({.where = {}, .found = "no such value"});
      option->set(info, value);
    } catch (Error const& error) {
      left[key] = text;
      auto const& why = error.complaints().front();
      // If a value was understood but is not allowed, the text adds what is allowed.
      if (!value.is_null()) left[key] += fmt::format("; allowed: {}", why.allowed);
    }
  }
  return left;
}

}  // namespace isolaw::campaign
