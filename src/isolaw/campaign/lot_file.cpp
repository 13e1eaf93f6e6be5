#include "isolaw/campaign/lot_file.hpp"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/data/text.hpp"

namespace isolaw::campaign {
namespace {

using data::in_quotes;

constexpr std::size_t longest_path = 4096;
constexpr std::size_t most_complaints = 50;
constexpr std::size_t most_items = 1000;  // files of a device, laws
constexpr int most_jobs = 4096;

// How deep a statement nests, tables by their dots included: toml++ takes tables apart by recursion, and a name of a
// hundred thousand parts ends its stack. Quoted text and comments do not count; what is no TOML is left to the parser.
class NestingCheck {
 public:
  explicit NestingCheck(std::string_view text) : text_(text) {}

  // The first line that nests deeper than any lot file does; 0 when there is none.
  std::size_t deep_line() {
    constexpr int deepest = 64;
    int depth = 0;
    std::vector<int> dots{0};  // of the name being read, in every table and list that is open
    auto const end_name = [&] {
      depth -= dots.back();
      dots.back() = 0;
    };
    for (; at_ < text_.size(); ++at_) {
      char const c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_quoted(c);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size()) - 1;
      } else if (c == ',' || c == '\n') {
        end_name();
        line_ += c == '\n' ? 1 : 0;
      } else if (c == '.') {
        ++dots.back();
        ++depth;
      } else if (c == '[' || c == '{') {
        dots.push_back(0);
        ++depth;
      } else if ((c == ']' || c == '}') && dots.size() > 1) {
        end_name();
        dots.pop_back();
        --depth;
      }
      if (depth > deepest) return line_;
    }
    return 0;
  }

 private:
  // Leaves at_ on the last character of the quoted text.
  void skip_quoted(char quote) {
    auto const run = [&](std::size_t at) {
      std::size_t length = 0;
      while (at + length < text_.size() && text_[at + length] == quote && length < 5) ++length;
      return length;
    };
    auto const opening = run(at_);
    if (opening == 2) {  // empty
      ++at_;
      return;
    }
    std::size_t const marks = opening >= 3 ? 3 : 1;
    for (at_ += marks; at_ < text_.size(); ++at_) {
      char const c = text_[at_];
      if (c == '\n') {
        if (marks == 1) {  // not closed, which the parser complains about
          --at_;
          return;
        }
        ++line_;
      } else if (c == '\\' && quote == '"') {
        ++at_;
        if (at_ < text_.size() && text_[at_] == '\n') ++line_;
      } else if (c == quote && (marks == 1 || run(at_) >= 3)) {
        at_ += marks == 1 ? 0 : run(at_) - 1;  // up to two more quotes belong to the text
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

// Reads keys of one table, collects what is wrong with them, and remembers which keys are known.
class TableReader {
 public:
  TableReader(toml::table const& table, std::string file, std::string name, std::vector<Complaint>& complaints)
      : table_(table), file_(std::move(file)), name_(std::move(name)), complaints_(complaints) {}

  std::string where(toml::node const& node) const { return fmt::format("{}:{}", file_, node.source().begin.line); }

  // A key that is read elsewhere.
  void know(std::string_view key) { known_.emplace(key); }

  // Calls take(value) when the key is there and of type T.
  template <class T, class Take>
  void value(std::string_view key, std::string_view expected, Take&& take, std::size_t longest = longest_name) {
    known_.emplace(key);
    auto const* node = table_.get(key);
    if (node == nullptr) return;
    auto const found = node->value<T>();
    if (!found || !is_kind<T>(*node)) {
      complain(*node, fmt::format("'{}' is not {}", key, expected), std::string(expected));
      return;
    }
    if constexpr (std::is_same_v<T, std::string>)
      if (!accept_text(*node, key, *found, longest)) return;
    guarded(*node, key, [&] { take(*found); });
  }
  template <class T>
  void set(std::string_view key, std::string_view expected, T& target) {
    value<T>(key, expected, [&](T const& v) { target = v; });
  }
  void set(std::string_view key, std::optional<double>& target) {
    value<double>(key, "a number", [&](double v) { target = v; });
  }
  void strings(std::string_view key, std::function<void(std::string const&)> const& take,
               std::size_t longest = longest_name) {
    known_.emplace(key);
    auto const* node = table_.get(key);
    if (node == nullptr) return;
    if (auto const one = node->value<std::string>(); one && node->is_string()) {
      if (accept_text(*node, key, *one, longest)) guarded(*node, key, [&] { take(*one); });
      return;
    }
    auto const* array = node->as_array();
    if (array == nullptr || !array->is_homogeneous(toml::node_type::string))
      return complain(*node, fmt::format("'{}' is not text or a list of texts", key), "\"...\" or [\"...\", \"...\"]");
    if (array->size() > most_items)
      return complain(*node, fmt::format("'{}' lists {} texts", key, array->size()),
                      fmt::format("{} or fewer", most_items));
    for (auto const& item : *array) {
      auto const text = *item.value<std::string>();
      if (accept_text(item, key, text, longest)) guarded(item, key, [&] { take(text); });
    }
  }
  // A sub-table of text by channel, or the command line's text "time=...,disp=...".
  void channels(std::string_view key,
                std::function<std::map<data::Channel, std::string>(std::string_view)> const& parse,
                std::map<data::Channel, std::string>& target) {
    known_.emplace(key);
    auto const* node = table_.get(key);
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
  toml::table const* table(std::string_view key) {
    known_.emplace(key);
    auto const* node = table_.get(key);
    if (node == nullptr) return nullptr;
    if (!node->is_table()) complain(*node, fmt::format("'{}' is not a table", key), fmt::format("[{}]", key));
    return node->as_table();
  }
  // Every key that nobody asked for is a mistake.
  void refuse_unknown() {
    for (auto const& [key, node] : table_) {
      if (known_.contains(std::string(key.str()))) continue;
      if (complaints_.size() > most_complaints) return;
      std::string allowed;
      for (auto const& k : known_) allowed += (allowed.empty() ? "" : ", ") + k;
      complain(node, fmt::format("unknown key {}{}", in_quotes(key.str()), name_.empty() ? "" : " in " + name_),
               allowed);
    }
  }
  void complain(toml::node const& node, std::string found, std::string allowed, std::string advice = {}) {
    if (complaints_.size() > most_complaints) return;  // one more than is shown, so that the rest is mentioned
    complaints_.push_back(
        {.where = where(node), .found = std::move(found), .allowed = std::move(allowed), .advice = std::move(advice)});
  }

 private:
  // Names go to terminals, tables and pages.
  bool accept_text(toml::node const& node, std::string_view key, std::string const& text, std::size_t longest) {
    bool const fits = text.size() <= longest;
    if (fits && is_printable(text)) return true;
    complain(node,
             fits ? fmt::format("{}: {} holds control characters", key, in_quotes(text))
                  : fmt::format("{}: {} is {} bytes long", key, in_quotes(text), text.size()),
             fits ? "printable text, of one line" : fmt::format("{} or fewer", longest));
    return false;
  }

  // No conversions: true is no number, and 1 is not true.
  template <class T>
  static bool is_kind(toml::node const& node) {
    if constexpr (std::is_same_v<T, bool>)
      return node.is_boolean();
    else if constexpr (std::is_integral_v<T>)
      return node.is_integer();
    else if constexpr (std::is_floating_point_v<T>)
      return node.is_number();
    else
      return node.is_string();
  }

  template <class Action>
  void guarded(toml::node const& node, std::string_view key, Action&& action) {
    try {
      action();
    } catch (Error const& error) {
      for (auto complaint : error.complaints()) {
        if (complaints_.size() > most_complaints) return;
        bool const names_option = complaint.where.empty() || complaint.where.starts_with("--");
        complaint.found = names_option ? fmt::format("{}: {}", key, complaint.found)
                                       : fmt::format("{}: {}: {}", key, complaint.where, complaint.found);
        complaint.where = where(node);
        complaints_.push_back(std::move(complaint));
      }
    }
  }

  toml::table const& table_;
  std::string file_, name_;
  std::vector<Complaint>& complaints_;
  std::set<std::string> known_;
};

void read_settings(TableReader& table, Settings& s) {
  table.strings("laws", [&](std::string const& text) {
    for (auto const& id : parse_laws(text))
      if (std::ranges::find(s.laws, id) == s.laws.end()) s.laws.push_back(id);
  });
  table.set<std::string>("method", "text", s.method);
  table.value<std::string>("integration", "text", [&](auto const& v) { s.integration = parse_integration(v); });
  table.value<std::string>("turning-points", "text",
                           [&](auto const& v) { s.turning_points = parse_turning_points(v); });
  table.set<int>("runs", "a whole number", s.runs);
  table.set<int>("population", "a whole number", s.genetic.population);
  table.set<int>("generations", "a whole number", s.genetic.generations);
  table.set<double>("stagnation-tolerance", "a number", s.genetic.stagnation_tolerance);
  table.value<std::int64_t>("seed", "a whole number", [&](std::int64_t v) { s.seed = parse_seed(std::to_string(v)); });
  table.value<std::string>("box", "text", [&](auto const& v) { s.box = parse_box(v); });
  table.strings("set", [&](std::string const& text) { s.overrides.push_back(fit::parse_override(text)); });
  table.set<int>("smooth", "a whole number", s.clean.smooth);
  table.set<bool>("center", "true or false", s.clean.center);
}

// samples-per-cycle is a number or the word "all".
void read_thinning(TableReader& table, toml::table const& source, data::CleanOptions& clean) {
  auto const* node = source.get("samples-per-cycle");
  if (node != nullptr && node->is_string())
    table.value<std::string>("samples-per-cycle", "a whole number or \"all\"",
                             [&](auto const& v) { clean.samples_per_cycle = parse_samples_per_cycle(v); });
  else
    table.value<int>("samples-per-cycle", "a whole number or \"all\"", [&](int v) { clean.samples_per_cycle = v; });
}

void read_reading(TableReader& table, data::ReadOptions& options) {
  table.channels("columns", data::parse_columns, options.columns);
  table.channels("units", data::parse_units, options.units);
  table.set("dt", options.dt_s);
  table.set<bool>("flip-force", "true or false", options.flip_force);
}

DeviceInput read_device(TableReader& table, toml::table const& source, std::filesystem::path const& directory,
                        data::ReadOptions const& defaults, LotFileOptions const& options) {
  DeviceInput device;
  device.read = defaults;
  device.directory = directory;
  auto const take_file = [&](std::string const& name) {
    if (auto const outside = options.allow_outside ? std::nullopt : leads_outside(directory / name, directory))
      table.complain(source, fmt::format("file {} leads outside, to {}", in_quotes(name), outside->generic_string()),
                     "files in the folder of the lot file or below it",
                     "copying the record there, or --allow-outside on the command line");
    device.files.push_back(directory / name);
    device.shown_file += (device.shown_file.empty() ? "" : ", ") + name;
  };
  table.set<std::string>("name", "text", device.name);
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
  table.set("temperature-C", device.info.temperature_C);
  table.set("rubber-thickness-mm", device.info.rubber_thickness_mm);
  table.set("rubber-area-mm2", device.info.rubber_area_mm2);
  read_reading(table, device.read);
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
  if (auto const line = NestingCheck(text).deep_line())
    throw Error({.where = fmt::format("{}:{}", file, line),
                 .found = "tables or lists nested deeper than any lot file needs",
                 .allowed = "a lot file in TOML",
                 .advice = "isolaw init FILES... writes one"});
  toml::table root;
  try {
    root = toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    throw Error({.where = fmt::format("{}:{}", file, error.source().begin.line),
                 .found = std::string(error.description()),
                 .allowed = "a lot file in TOML",
                 .advice = "isolaw init FILES... writes one"});
  }
  std::vector<Complaint> complaints;
  Lot lot;
  data::ReadOptions defaults;
  TableReader top(root, file, "", complaints);
  top.set<std::string>("title", "text", lot.title);
  if (auto const* table = top.table("calibrate")) {
    TableReader reader(*table, file, "[calibrate]", complaints);
    read_settings(reader, lot.settings);
    read_thinning(reader, *table, lot.settings.clean);
    read_reading(reader, defaults);
    reader.value<std::string>(
        "out", "text", [&](auto const& v) { take_out(lot, v, options); }, longest_path);
    reader.value<int>("jobs", "a whole number", [&](int v) {
      if (v < 0 || v > most_jobs)
        throw Error({.where = "--jobs", .found = fmt::format("'{}'", v), .allowed = fmt::format("0 to {}", most_jobs)});
      lot.jobs = v;
    });
    reader.refuse_unknown();
    refuse_settings(reader, *table, lot.settings, complaints);
  }
  if (auto const* table = top.table("read")) {
    TableReader reader(*table, file, "[read]", complaints);
    read_reading(reader, defaults);
    reader.refuse_unknown();
  }
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
  if (complaints.size() > most_complaints) {
    complaints.resize(most_complaints);
    complaints.push_back({.where = file, .found = "and more of the kind"});
  }
  if (!complaints.empty()) throw Error(complaints);
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
  auto const& s = lot.settings;
  toml::array laws, sets;
  for (auto const& id : s.laws) laws.push_back(id);
  for (auto const& change : s.overrides) sets.push_back(change.text());
  toml::table calibrate{{"method", s.method},
                        {"integration", name(s.integration)},
                        {"turning-points", name(s.turning_points)},
                        {"box", name(s.box)},
                        {"runs", s.runs},
                        {"population", s.genetic.population},
                        {"generations", s.genetic.generations},
                        {"stagnation-tolerance", s.genetic.stagnation_tolerance},
                        {"seed", static_cast<std::int64_t>(s.seed)},
                        {"smooth", s.clean.smooth},
                        {"center", s.clean.center}};
  if (!laws.empty()) calibrate.insert("laws", std::move(laws));
  if (!sets.empty()) calibrate.insert("set", std::move(sets));
  if (s.clean.samples_per_cycle)
    calibrate.insert("samples-per-cycle", *s.clean.samples_per_cycle);
  else
    calibrate.insert("samples-per-cycle", "all");
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
    number("dt", input.read.dt_s);
    if (input.read.flip_force) device.insert("flip-force", true);
    if (!input.read.columns.empty()) device.insert("columns", channel_table(input.read.columns));
    if (!input.read.units.empty()) device.insert("units", channel_table(input.read.units));
    devices.push_back(std::move(device));
  }
  toml::table root{{"title", lot.title}, {"calibrate", std::move(calibrate)}, {"device", std::move(devices)}};
  std::ostringstream out;
  out << root << '\n';
  return out.str();
}

}  // namespace isolaw::campaign
