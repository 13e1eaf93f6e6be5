#include "best_known.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/toml_reader.hpp"

namespace isolaw::bench {
namespace {

constexpr std::size_t key_length = 64;
constexpr int digits = 9;

// Returns the number with nine significant digits. Adding 0.0 turns -0 into 0, so that both give the same text.
std::string rounded(double value) {
  return fmt::format("{:.{}e}", value + 0.0, digits - 1);
}

int decade(double value) {
  auto const text = rounded(value);
  int exponent = 0;
  auto const at = text.find('e') + 1;
  std::from_chars(text.data() + at + (text[at] == '+' ? 1 : 0), text.data() + text.size(), exponent);
  return exponent;
}

// Writes each value as a whole number of steps, rounded down; a step is one unit in the ninth digit of the largest
// value. Values in a file are often short decimal numbers or means of a few such numbers, so many would lie exactly on
// the edge of a step. The function therefore first adds 0.318 (1 / pi) of a step to each value. Rounding errors then do
// not move a value into the next step.
void add_channel(std::string& text, std::string_view name, std::vector<double> const& values) {
  constexpr double shift = 0.318309886;
  double largest = 0.0;
  for (double const value : values) largest = std::max(largest, std::abs(value));
  auto const out = std::back_inserter(text);
  fmt::format_to(out, "{} {}", name, values.size());
  if (largest > 0.0 && std::isfinite(largest)) {
    int const power = decade(largest) - (digits - 1);
    double const step = std::pow(10.0, power);
    fmt::format_to(out, " e{}:", power);
    for (double const value : values) fmt::format_to(out, " {:.0f}", std::floor(value / step + shift) + 0.0);
  }
  text += '\n';
}

void add_box(std::string& text, fit::SearchBox const& box) {
  for (auto const& p : box.parameters)
    text += p.free ? fmt::format("{} free {} {}\n", p.name, rounded(p.lower), rounded(p.upper))
                   : fmt::format("{} fixed {}\n", p.name, rounded(p.value));
}

class EntryTable : public TomlTable {
 public:
  using TomlTable::TomlTable;

  void text(std::string_view key, std::string& target) {
    if (find(key) == nullptr) return complain(fmt::format("'{}' is missing", key), "text");
    value<std::string>(key, "text", [&](std::string const& found) {
      if (found.empty()) throw Error({.found = "empty", .allowed = "text"});
      target = found;
    });
  }
  void number(std::string_view key, double& target) {
    if (find(key) == nullptr) return complain(fmt::format("'{}' is missing", key), "a number");
    value<double>(key, "a number", [&](double found) {
      if (!std::isfinite(found)) throw Error({.found = fmt::format("found {}", found), .allowed = "a finite number"});
      target = found;
    });
  }
};

class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  std::vector<BestKnown> read(toml::table const& root) {
    TomlTable table(root, file_, "", complaints_);
    if (auto const* node = table.find("best")) {
      auto const* list = node->as_array();
      bool const right =
          list != nullptr && std::ranges::all_of(*list, [](auto const& item) { return item.is_table(); });
      if (!right)
        table.complain(*node, "'best' is no list of tables", "[[best]]");
      else
        for (auto const& item : *list) entry(*item.as_table());
    }
    table.refuse_unknown();
    throw_complaints(std::move(complaints_), file_);
    return std::move(entries_);
  }

 private:
  void entry(toml::table const& source) {
    EntryTable table(source, file_, "[[best]]", complaints_);
    BestKnown best;
    table.text("record", best.record);
    table.text("settings", best.settings);
    table.text("law", best.law);
    table.text("key", best.key);
    table.number("objective", best.objective);
    table.text("found_by", best.found_by);
    if (best.objective < 0.0) table.complain(fmt::format("an objective of {}", best.objective), "0 or more");
    bool const is_hash =
        best.key.size() == key_length && best.key.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!best.key.empty() && !is_hash) table.complain("'key' is no SHA-256", "64 hexadecimal digits");
    if (std::ranges::any_of(entries_, [&](BestKnown const& other) { return other.key == best.key; }))
      table.complain("a key for the second time", "one entry for each problem");
    parameters(table, best);
    table.refuse_unknown();
    entries_.push_back(std::move(best));
  }

  void parameters(EntryTable& table, BestKnown& best) {
    auto const* values = table.table("parameters");
    if (values == nullptr) return table.complain("'parameters' is missing", "a table: parameters = { K1 = 1.0, ... }");
    laws::LawEntry const* law = nullptr;
    for (auto const& known : laws::catalogue())
      if (known.info.id == best.law) law = &known;
    if (law == nullptr) {
      if (!best.law.empty()) table.complain(fmt::format("no law '{}'", best.law), "the id of a law");
      return;
    }
    EntryTable numbers(*values, file_, "parameters", complaints_);
    best.parameters.resize(law->parameters.size());
    for (std::size_t i = 0; i < best.parameters.size(); ++i)
      numbers.number(law->parameters[i].name, best.parameters[i]);
    numbers.refuse_unknown();
  }

  std::string file_;
  std::vector<Complaint> complaints_;
  std::vector<BestKnown> entries_;
};

// Writes a number with a decimal point or an exponent, because TOML reads a number with neither as an integer.
std::string number(double value) {
  auto const text = fmt::format("{}", value + 0.0);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (char const c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

// Returns the name as a TOML key. A name with other characters than letters, digits and _ gets quotes, for example
// "kb+".
std::string toml_key(std::string_view name) {
  bool const bare = std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  });
  return bare ? std::string(name) : toml_string(name);
}

}  // namespace

std::string problem_key(laws::LawEntry const& law, laws::Integration integration, laws::TurningPoints turning_points,
                        data::FitRecord const& record, fit::SearchBox const& box) {
  auto text = fmt::format("law {}\nintegration {}\nturning points {}\n", law.info.id,
                          integration == laws::Integration::paper ? "paper" : "converged",
                          turning_points == laws::TurningPoints::interpolated ? "interpolated" : "sampled");
  add_channel(text, "time", record.time_s);
  add_channel(text, "disp", record.disp_mm);
  add_channel(text, "vel", record.vel_mm_s);
  add_channel(text, "force", record.force_kN);
  add_channel(text, "scored", record.scored);
  // A record without weights adds nothing here, so that its key stays the one in files that were written before weights
  // existed.
  if (!record.weights.empty()) add_channel(text, "weights", record.weights);
  add_box(text, box);
  return sha256(text);
}

std::vector<BestKnown> load_best_known(std::string const& file) {
  return read_best_known(
      read_file(file, {.largest_bytes = std::size_t{16} << 20, .allowed = "TOML", .when_too_large = "another file"}),
      file);
}

std::vector<BestKnown> read_best_known(std::string_view text, std::string const& file) {
  return Reader(file).read(
      parse_toml(text, file, {.kind = "file of best objectives", .advice = "bench/optimum --update writes it"}));
}

std::string best_known_text(std::span<BestKnown const> entries) {
  std::string text =
      "# The least objective known for each problem, from all methods that were tried. bench/optimum --update adds problems\n"
      "# and lowers objectives. The key names the problem (bench/best_known.hpp). Parameters are in the units of the law.\n";
  for (auto const& entry : entries) {
    fmt::format_to(std::back_inserter(text),
                   "\n[[best]]\nrecord = {}\nsettings = {}\nlaw = \"{}\"\nkey = \"{}\"\nobjective = {}\n"
                   "found_by = {}\nparameters = {{ ",
                   toml_string(entry.record), toml_string(entry.settings), entry.law, entry.key,
                   number(entry.objective), toml_string(entry.found_by));
    auto const& law = laws::find_law(entry.law);
    for (std::size_t i = 0; i < law.parameters.size(); ++i)
      fmt::format_to(std::back_inserter(text), "{}{} = {}", i == 0 ? "" : ", ", toml_key(law.parameters[i].name),
                     number(entry.parameters.at(i)));
    text += " }\n";
  }
  return text;
}

Change lower(std::vector<BestKnown>& entries, BestKnown const& found) {
  auto const same = std::ranges::find(entries, found.key, &BestKnown::key);
  if (same != entries.end()) {
    if (!(found.objective < same->objective * (1.0 - least_lowering))) return Change::none;
    same->objective = found.objective;
    same->parameters = found.parameters;
    same->found_by = found.found_by;
    return Change::lowered;
  }
  auto const former = std::ranges::find_if(entries, [&](BestKnown const& entry) {
    return entry.record == found.record && entry.settings == found.settings && entry.law == found.law;
  });
  if (former != entries.end()) {
    *former = found;
    return Change::redefined;
  }
  entries.push_back(found);
  return Change::added;
}

}  // namespace isolaw::bench
