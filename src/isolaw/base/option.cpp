#include "isolaw/base/option.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/printable.hpp"

namespace isolaw {
namespace {

template <class Number>
Json parsed(std::string const& word) {
  auto const value = number_in<Number>(word);
  return value ? Json(*value) : Json(word);
}

[[noreturn]] void refuse_found(std::string found, std::string allowed) {
  throw Error({.where = {}, .found = std::move(found), .allowed = std::move(allowed)});
}

std::string with(std::string_view key, char from, char to) {
  std::string name(key);
  std::ranges::replace(name, from, to);
  return name;
}

}  // namespace

std::string_view title(Heading heading) {
  constexpr std::string_view titles[]{"Everyday options",
                                      "Reading records",
                                      "Correcting for the test rig",
                                      "Laws and search",
                                      "Two directions",
                                      "Analysis",
                                      "Acceptance",
                                      "Whole models (targets opensees-model and openseespy-model)",
                                      "Running and output"};
  return titles[static_cast<std::size_t>(heading)];
}

bool Limits::allow(double value) const {
  if (or_zero && value == 0.0) return true;
  return std::isfinite(value) && value >= least && value <= most &&
         (step == 1 || std::fmod(value - least, step) == 0.0);
}

std::string Limits::text() const {
  if (!words.empty() || !std::isfinite(least)) return words;
  return fmt::format("{} to {}", least, most);
}

std::string OptionInfo::option() const {
  return with(key, '_', '-');
}

std::string OptionInfo::python() const {
  return keyword.empty() ? with(key, '-', '_') : std::string(keyword);
}

std::string OptionInfo::python_type() const {
  if (!words.empty())
    return fmt::format("{}Literal[\"{}\"]", type.empty() ? "" : fmt::format("{} | ", type), fmt::join(words, "\", \""));
  if (!type.empty()) return std::string(type);
  switch (kind) {
    case Kind::flag:
      return "bool";
    case Kind::whole:
      return "int";
    case Kind::real:
      return "float";
    case Kind::text:
      return "str";
    case Kind::list:
    case Kind::repeated:
      return "str | Sequence[str]";
    case Kind::assignments:
      return "str | Mapping[str, str | int]";
  }
  return {};
}

Json value_of(Kind kind, std::vector<std::string> const& words) {
  if (kind == Kind::flag) return true;
  if (kind == Kind::repeated) return words;
  if (kind == Kind::whole) return parsed<std::int64_t>(words.back());
  return kind == Kind::real ? parsed<double>(words.back()) : Json(words.back());
}

std::string text_of(Json const& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::vector<std::string> items;
  for (auto const& item : value) items.push_back(text_of(item));
  return joined(items, ",");
}

std::vector<std::string> words_of(OptionInfo const& option, Json const& value) {
  auto const name = "--" + option.option();
  if (option.kind == Kind::flag) return value == true ? std::vector{name} : std::vector<std::string>{};
  std::vector<std::string> words;
  for (auto const& each : option.kind == Kind::repeated ? value : Json::array({value}))
    if (!each.is_null()) words.insert(words.end(), {name, text_of(each)});
  return words;
}

std::string shown(Json const& value) {
  if (value.is_string()) return in_quotes(value.get<std::string>());
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  return printable(value.dump(-1, ' ', false, Json::error_handler_t::replace).substr(0, 100));
}

void about(std::string const& where, std::vector<Complaint>& complaints, std::function<void()> const& judge) {
  try {
    judge();
  } catch (Error const& error) {
    for (auto complaint : error.complaints()) {
      if (!complaint.where.empty() && !complaint.where.starts_with("--"))
        complaint.found = complaint.where + ": " + complaint.found;
      if (!complaint.where.starts_with("--")) complaint.where = where;
      complaints.push_back(std::move(complaint));
    }
  }
}

int whole_of(Json const& value, Limits const& limits) {
  auto const fits = [](auto number) { return std::in_range<int>(number); };
  bool const whole = value.is_number_unsigned() ? fits(value.get<std::uint64_t>())
                                                : value.is_number_integer() && fits(value.get<std::int64_t>());
  if (!whole)
    refuse_found(shown(value) + (value.is_number_integer() ? " is out of range" : " is not a whole number"),
                 limits.text());
  if (!limits.allow(value.get<int>())) refuse(value, limits.text());
  return value.get<int>();
}

double real_of(Json const& value, Limits const& limits) {
  auto const allowed = limits.text().empty() ? std::string("a finite number") : limits.text();
  if (!value.is_number()) refuse_found(shown(value) + " is not a number", allowed);
  if (!limits.allow(value.get<double>())) refuse(value, allowed);
  return value.get<double>();
}

bool flag_of(Json const& value) {
  if (!value.is_boolean()) refuse(value, "true or false");
  return value.get<bool>();
}

std::string text_in(Json const& value) {
  if (!value.is_string()) refuse_found(shown(value) + " is not text", "text");
  return value.get<std::string>();
}

void refuse(Json const& value, std::string allowed) {
  refuse_found(shown(value), std::move(allowed));
}

std::string help_of(std::string help, std::string const& limits, std::string const& usual) {
  if (!limits.empty()) help += ", " + limits;
  return usual.empty() ? help : help + " (default " + usual + ")";
}

}  // namespace isolaw
