#include "isolaw/data/channels/read_options.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <vector>
#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/table.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

constexpr double largest_skew_s = 1.0;
constexpr double largest_friction_kN = 1e5;
constexpr double largest_coefficient = 0.2;
constexpr double largest_mass_kg = 1e6;
constexpr double largest_factor = 10.0;
constexpr double least_factor = 0.01;
constexpr double least_scale = 1e-9, largest_scale = 1e9;

void check(std::vector<Complaint>& complaints, std::string const& option, std::optional<double> value, double scale,
           double least, double largest, std::string const& unit, std::string const& advice) {
  if (!value || (std::isfinite(*value) && *value >= least && *value <= largest)) return;
  complaints.push_back({.where = option,
                        .found = fmt::format("{:.6g}{}", *value * scale, unit),
                        .allowed = fmt::format("{:.6g} to {:.6g}{}", least * scale, largest * scale, unit),
                        .advice = advice});
}

std::map<Channel, std::string> parse_assignments(std::string const& where, std::string_view text) {
  std::map<Channel, std::string> values;
  std::vector<Complaint> complaints;
  while (!text.empty()) {
    auto const part = trimmed(take_part(text, ','));
    auto const equals = part.find('=');
    auto const key = lower(trimmed(part.substr(0, equals)));
    auto const channel = std::ranges::find_if(all_channels, [&](Channel c) { return name(c) == key; });
    auto const value = equals == std::string_view::npos ? std::string_view{} : trimmed(part.substr(equals + 1));
    if (channel == std::end(all_channels))
      complaints.push_back(
          {where, "unknown channel " + in_quotes(key), "time, disp, force, load, cycle, second-disp", {}});
    else if (value.empty())
      complaints.push_back({where, key + " has no value", "CHANNEL=VALUE,...", {}});
    else if (!values.emplace(*channel, value).second)
      complaints.push_back({where, key + " is given twice", "one value per channel", {}});
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return values;
}

}  // namespace

bool Corrections::any() const {
  return repair_spikes || skew_s || friction_kN || friction_coefficient || moving_mass_kg || force_factor;
}

void Corrections::validate() const {
  std::vector<Complaint> complaints;
  check(complaints, "--skew-ms", skew_s, 1000.0, -largest_skew_s, largest_skew_s, " ms",
        "positive where the force is later than displacement");
  check(complaints, "--rig-friction", friction_kN, 1.0, 0.0, largest_friction_kN, " kN", "half the jump at a reversal");
  check(complaints, "--rig-friction-coefficient", friction_coefficient, 1.0, 0.0, largest_coefficient, "",
        "0.005 for well kept guides");
  check(complaints, "--moving-mass", moving_mass_kg, 1.0, 0.0, largest_mass_kg, " kg", "kilograms");
  check(complaints, "--force-factor", force_factor, 1.0, least_factor, largest_factor, "",
        "0.5 for two devices in double shear; --flip-force turns the sign");
  if (friction_kN && friction_coefficient)
    complaints.push_back({"--rig-friction", "given with --rig-friction-coefficient", "one of the two", {}});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

std::map<Channel, std::string> parse_columns(std::string_view text) {
  return parse_assignments("--columns", text);
}

std::map<Channel, std::string> parse_units(std::string_view text) {
  auto units = parse_assignments("--units", text);
  std::vector<Complaint> complaints;
  for (auto& [channel, value] : units) {
    auto const unit = parse_unit(value);
    if (unit && unit->dimension == dimension(channel))
      value = unit->symbol;
    else
      complaints.push_back({"--units " + std::string(name(channel)),
                            unit ? fmt::format("{} is a {}", unit->symbol, isolaw::name(unit->dimension))
                                 : "unknown unit " + in_quotes(value),
                            known_units(dimension(channel)),
                            {}});
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return units;
}

std::map<Channel, std::string> parse_scales(std::string_view text) {
  auto const scales = parse_assignments("--channel-scale", text);
  std::vector<Complaint> complaints;
  for (auto const& [channel, value] : scales) {
    auto const scale = number_in<double>(value);
    if (!scale || !(*scale >= least_scale && *scale <= largest_scale))
      complaints.push_back(
          {"--channel-scale " + std::string(name(channel)), in_quotes(value),
           fmt::format("a number from {:g} to {:g}", least_scale, largest_scale),
           "0.01 where a value of 1 in the file is 0.01 mm; --flip-force turns the sign of the force"});
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return scales;
}

std::optional<ReadOptions> without_corrections(ReadOptions options) {
  Corrections const kept{.force_factor = options.corrections.force_factor};
  if (options.corrections == kept) return std::nullopt;
  options.corrections = kept;
  options.checks_physics = false;
  return options;
}

std::string parse_test(std::string_view text) {
  auto const word = lower(trimmed(text));
  if (word == "all") return word;
  auto const number = number_in<std::size_t>(word);
  if (number && *number >= 1 && *number <= most_tests) return std::to_string(*number);
  throw Error(Complaint{.where = "--test",
                        .found = in_quotes(text),
                        .allowed = fmt::format("all, or the number of a test, from 1 to {}", most_tests)});
}

bool is_record_name(std::string_view file) {
  auto const small = lower(file);
  return std::ranges::any_of(record_extensions, [&](auto ending) { return small.ends_with(ending); });
}

// Whether the text before a colon is the name of a file: it has a usual ending, or a file of this name exists.
static bool names_a_file(std::string_view file) {
  constexpr std::array<std::string_view, 8> further{".out", ".res", ".prn", ".log", ".tab", ".data", ".rpt", ".ascii"};
  auto const small = lower(file);
  std::error_code none;
  return is_record_name(file) || std::ranges::any_of(further, [&](auto ending) { return small.ends_with(ending); }) ||
         (file.find('.') != std::string_view::npos && std::filesystem::is_regular_file(file, none));
}

std::optional<FileColumn> file_column(std::string_view text) {
  for (auto at = text.find(':'); at != std::string_view::npos; at = text.find(':', at + 1)) {
    auto const file = trimmed(text.substr(0, at)), column = trimmed(text.substr(at + 1));
    if (names_a_file(file) && !column.empty()) return FileColumn{std::string(file), std::string(column)};
  }
  return std::nullopt;
}

}  // namespace isolaw::data
