#include "isolaw/api/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <ranges>
#include <set>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/toml_reader.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/fit/box.hpp"

namespace isolaw {
namespace {

constexpr std::string_view file_advice = "name = value for each parameter; isolaw laws ID lists them";

std::string in_marks(std::string_view text) {
  return "'" + printable(text.substr(0, 100)) + "'";
}

std::string with_unit(laws::ParameterInfo const& p) {
  return p.unit == "1" ? std::string(p.name) : fmt::format("{} [{}]", p.name, p.unit);
}

std::string all_of(laws::LawEntry const& law) {
  return joined(law.parameters | std::views::transform([](laws::ParameterInfo const& p) {
                  return with_unit(p) + (p.fixed_by_default
                                             ? fmt::format(" ({:g} where it is left out)", *p.fixed_by_default)
                                             : std::string());
                }));
}

std::vector<NamedValue> read_toml(std::string const& text, std::string const& file, laws::LawEntry const& law) {
  auto const table = parse_toml(text, file, {.kind = "parameter file", .advice = file_advice});
  auto const* own = table.get_as<toml::table>(std::string(law.info.id));
  std::vector<NamedValue> values;
  std::vector<Complaint> complaints;
  for (auto const& [key, node] : own != nullptr ? *own : table) {
    auto const where = fmt::format("{}:{}", file, node.source().begin.line);
    if (auto const number = node.value<double>(); number && node.is_number())
      values.push_back({.name = std::string(key.str()), .value = *number, .where = where});
    else
      complaints.push_back({where,
                            fmt::format("{} is no number", in_marks(key.str())),
                            fmt::format("numbers, at the top or in a table [{}]", law.info.id),
                            {}});
  }
  throw_complaints(std::move(complaints), file);
  return values;
}

std::vector<NamedValue> read_json(std::string const& text, std::string const& file, laws::LawEntry const& law) {
  using Event = Json::parse_event_t;
  std::vector<Complaint> complaints;
  std::vector<std::set<std::string>> open;  // for each JSON object being read, the names seen in it
  auto const watch = [&](int, Event event, Json& parsed) {
    if (event == Event::object_start) open.emplace_back();
    if (event == Event::object_end) open.pop_back();
    if (event == Event::key && !open.back().insert(parsed.get<std::string>()).second)
      complaints.push_back({file, fmt::format("{} is given twice", in_marks(parsed.get<std::string>())), "once", {}});
    return true;
  };
  Json json;
  try {
    json = Json::parse(text, watch);
  } catch (Json::exception const& error) {
    throw Error({.where = file,
                 .found = printable(error.what()),
                 .allowed = "a parameter file in TOML or JSON",
                 .advice = std::string(file_advice)});
  }
  auto const own = json.is_object() ? json.find(std::string(law.info.id)) : json.end();
  auto const& table = json.is_object() && own != json.end() && own->is_object() ? *own : json;
  if (!table.is_object()) throw Error({.where = file, .found = "no JSON object", .allowed = "{\"name\": value, ...}"});
  std::vector<NamedValue> values;
  for (auto const& [key, value] : table.items())
    if (value.is_number())
      values.push_back({.name = key, .value = value.get<double>(), .where = file});
    else
      complaints.push_back({file,
                            fmt::format("{} is no number", in_marks(key)),
                            fmt::format("numbers, at the top or in an object \"{}\"", law.info.id),
                            {}});
  throw_complaints(std::move(complaints), file);
  return values;
}

}  // namespace

NamedValue parse_named_value(std::string_view text, std::string const& where) {
  auto const equals = text.find('=');
  auto const name = trimmed(text.substr(0, equals));
  auto const number = equals == std::string_view::npos ? std::string() : std::string(trimmed(text.substr(equals + 1)));
  auto const cell = data::parse_cell(number, '.');
  if (name.empty() || cell.kind != data::CellKind::number)
    throw Error({.where = where, .found = in_marks(text), .allowed = "PARAMETER=NUMBER", .advice = where + " Ke=2.5"});
  return {.name = std::string(name), .value = cell.value, .where = where};
}

std::vector<NamedValue> read_parameter_file(std::filesystem::path const& file, laws::LawEntry const& law) {
  auto const text = read_file(file, {.largest_bytes = 1 << 20,
                                     .allowed = "a parameter file in TOML or JSON",
                                     .when_too_large = "the parameters of one law"});
  auto const name = printable(file.generic_string());
  auto const start = text.find_first_not_of(" \t\r\n");
  bool const json = file.extension() == ".json" || (start != std::string::npos && text[start] == '{');
  return json ? read_json(text, name, law) : read_toml(text, name, law);
}

std::vector<double> parameters_in_order(laws::LawEntry const& law, std::vector<NamedValue> const& values,
                                        std::string const& where, JointLimits joint_limits) {
  std::vector<std::optional<double>> found(law.parameters.size());
  std::vector<Complaint> complaints;
  auto const advice = fmt::format("isolaw laws {}", law.info.id);
  for (auto const& given : values) {
    auto const& place = given.where.empty() ? where : given.where;
    auto const info = std::ranges::find(law.parameters, given.name, &laws::ParameterInfo::name);
    if (info == law.parameters.end()) {
      complaints.push_back(
          {place, fmt::format("{} has no parameter {}", law.info.id, in_marks(given.name)), all_of(law), advice});
      continue;
    }
    auto& slot = found[static_cast<std::size_t>(info - law.parameters.begin())];
    if (slot) complaints.push_back({place, fmt::format("{} is given twice", info->name), "once", {}});
    slot = given.value;
    if (!std::isfinite(given.value))
      complaints.push_back({place, fmt::format("{} = {}", info->name, given.value), "a finite number", {}});
    else if (given.value < info->physical.lower || given.value > info->physical.upper)
      complaints.push_back({place,
                            fmt::format("{} = {} leaves its physical limits", info->name, given.value),
                            fit::limits_text(info->physical, info->unit),
                            {}});
  }
  std::vector<double> ordered;
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < found.size(); ++i) {
    auto const& info = law.parameters[i];
    auto const value = found[i] ? found[i] : info.fixed_by_default;
    if (!value) missing.push_back(with_unit(info));
    ordered.push_back(value.value_or(0.0));
  }
  if (!missing.empty())
    complaints.push_back({where, fmt::format("{} also needs {}", law.info.id, joined(missing)), {}, advice});
  if (!complaints.empty()) throw Error(std::move(complaints));
  if (joint_limits == JointLimits::unchecked) return ordered;
  if (auto const beyond = law.unmet(ordered))
    throw Error({.where = where, .found = beyond->found, .allowed = std::string(beyond->statement)});
  return ordered;
}

}  // namespace isolaw
