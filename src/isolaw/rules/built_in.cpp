// Gives access to the files of rules/, which the build embeds into the library.
#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "isolaw/base/embedded.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::rules {

std::span<Embedded const> files();

namespace {

std::vector<Embedded> const& texts() {  // names have no ".toml"
  static std::vector<Embedded> const all = [] {
    std::vector<Embedded> named;
    for (auto const& file : files()) named.push_back({file.name.substr(0, file.name.rfind('.')), file.text});
    return named;
  }();
  return all;
}

constexpr std::string_view template_name = "template";

}  // namespace

std::span<RuleSet const> built_in_rule_sets() {
  static std::vector<RuleSet> const all = [] {
    std::vector<RuleSet> sets;
    for (auto const& [name, toml] : texts()) {
      if (name == template_name) continue;
      sets.push_back(read_rule_text(toml, fmt::format("rules/{}.toml", name)));
      sets.back().origin = "built in";
    }
    return sets;
  }();
  return all;
}

std::vector<std::string> built_in_names() {
  std::vector<std::string> names;
  for (auto const& [name, toml] : texts())
    if (name != template_name) names.emplace_back(name);
  return names;
}

std::string load_rule_text(std::string_view name_or_file) {
  auto const names = built_in_names();
  if (std::ranges::find(names, name_or_file) != names.end()) return std::string(rule_set_text(name_or_file));
  auto const allowed = fmt::format("{}, or a rule file", joined(names));
  auto text =
      read_file(std::string(name_or_file),
                {.largest_bytes = largest_rule_file,
                 .allowed = allowed,
                 .when_too_large = "a rule file holds one set of limits, not data",
                 .when_missing = "isolaw rules lists the sets, isolaw rules template prints a file to start from"});
  // A rule file must not be empty, because an empty text in a campaign means that it has no rule set.
  if (text.empty())
    throw Error({.where = std::string(name_or_file),
                 .found = "an empty file",
                 .allowed = allowed,
                 .advice = "isolaw rules template prints a file to start from"});
  return text;
}

RuleSet find_rule_set(std::string_view name_or_file) {
  for (auto const& set : built_in_rule_sets())
    if (set.id == name_or_file) return set;
  return read_rule_text(load_rule_text(name_or_file), std::string(name_or_file));
}

std::string_view rule_set_text(std::string_view name) {
  auto const found = std::ranges::find(texts(), name, &Embedded::name);
  if (found == texts().end())
    throw Error({.where = "",
                 .found = fmt::format("no rule set {}", in_quotes(name)),
                 .allowed = joined(texts() | std::views::transform(&Embedded::name))});
  return found->text;
}

}  // namespace isolaw::rules
