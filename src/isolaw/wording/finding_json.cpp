#include "isolaw/wording/finding_json.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::wording {
namespace {

using Json = nlohmann::ordered_json;  // keeps the order of numbers and words

Json json_of(Finding const& finding) {
  Json object{{"kind", row(finding.kind).key}};
  auto const add = [&](char const* key, auto const& value) {
    if (!value.empty()) object[key] = value;
  };
  add("law", finding.law);
  add("other_laws", finding.other_laws);
  add("devices", finding.devices);
  add("parameters", finding.parameters);
  add("blocks", finding.blocks);
  Json numbers = Json::object(), words = Json::object();
  for (auto const& [name, value] : finding.numbers) numbers[name] = value;
  for (auto const& [name, text] : finding.words) words[name] = text;
  add("numbers", numbers);
  add("words", words);
  return object;
}

Finding finding_of(Json const& object) {
  Finding finding;
  for (auto const& [key, value] : object.items()) {
    if (key == "kind") {
      auto const* kind = find_row(value.get<std::string>());
      if (kind == nullptr)
        throw Error({.found = fmt::format("a finding of kind {}", in_quotes(value.get<std::string>()))});
      finding.kind = kind->kind;
    } else if (key == "law") {
      value.get_to(finding.law);
    } else if (key == "other_laws") {
      value.get_to(finding.other_laws);
    } else if (key == "devices") {
      value.get_to(finding.devices);
    } else if (key == "parameters") {
      value.get_to(finding.parameters);
    } else if (key == "blocks") {
      value.get_to(finding.blocks);
    } else if (key == "numbers") {
      // A number that is not finite is stored as null.
      for (auto const& [name, number] : value.items())
        finding.numbers.push_back(
            {name, number.is_null() ? std::numeric_limits<double>::quiet_NaN() : number.get<double>()});
    } else if (key == "words") {
      for (auto const& [name, text] : value.items()) finding.words.push_back({name, text.get<std::string>()});
    } else {
      throw Error({.found = fmt::format("a finding with {}", in_quotes(key))});
    }
  }
  if (!object.is_object() || !object.contains("kind")) throw Error({.found = "a finding without its kind"});
  return finding;
}

}  // namespace

std::string findings_json(std::vector<Finding> const& findings) {
  Json all = Json::array();
  for (auto const& finding : findings) all.push_back(json_of(finding));
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::vector<Finding> findings_of(std::string_view json) {
  auto const all = Json::parse(json);
  if (!all.is_array()) throw Error({.found = "findings that are no list"});
  std::vector<Finding> findings;
  for (auto const& each : all) findings.push_back(finding_of(each));
  return findings;
}

}  // namespace isolaw::wording
