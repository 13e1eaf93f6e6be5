// The files of rules/, embedded when the library is built.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/rules/rule_set.hpp"

// Defined in the assembly file that CMake makes from texts.s.in.
extern "C" {
extern char const isolaw_rules_aashto[];
extern std::uint64_t const isolaw_rules_aashto_size;
extern char const isolaw_rules_asce_7_22[];
extern std::uint64_t const isolaw_rules_asce_7_22_size;
extern char const isolaw_rules_en_15129[];
extern std::uint64_t const isolaw_rules_en_15129_size;
extern char const isolaw_rules_iso_22762_sa[];
extern std::uint64_t const isolaw_rules_iso_22762_sa_size;
extern char const isolaw_rules_iso_22762_sb[];
extern std::uint64_t const isolaw_rules_iso_22762_sb_size;
extern char const isolaw_rules_ntc_2018[];
extern std::uint64_t const isolaw_rules_ntc_2018_size;
extern char const isolaw_rules_template[];
extern std::uint64_t const isolaw_rules_template_size;
}

namespace isolaw::rules {
namespace {

struct Text {
  std::string_view name, toml;
};

std::array<Text, 7> const& texts() {
  static std::array<Text, 7> const all{{
      {"aashto", {isolaw_rules_aashto, std::size_t{isolaw_rules_aashto_size}}},
      {"asce-7-22", {isolaw_rules_asce_7_22, std::size_t{isolaw_rules_asce_7_22_size}}},
      {"en-15129", {isolaw_rules_en_15129, std::size_t{isolaw_rules_en_15129_size}}},
      {"iso-22762-sa", {isolaw_rules_iso_22762_sa, std::size_t{isolaw_rules_iso_22762_sa_size}}},
      {"iso-22762-sb", {isolaw_rules_iso_22762_sb, std::size_t{isolaw_rules_iso_22762_sb_size}}},
      {"ntc-2018", {isolaw_rules_ntc_2018, std::size_t{isolaw_rules_ntc_2018_size}}},
      {"template", {isolaw_rules_template, std::size_t{isolaw_rules_template_size}}},
  }};
  return all;
}

constexpr std::string_view template_name = "template";

std::string names(bool with_template) {
  std::string list;
  for (auto const& text : texts())
    if (with_template || text.name != template_name) list += (list.empty() ? "" : ", ") + std::string(text.name);
  return list;
}

std::vector<RuleSet> const& parsed() {
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

}  // namespace

std::vector<RuleSet const*> built_in_rule_sets() {
  std::vector<RuleSet const*> sets;
  for (auto const& set : parsed()) sets.push_back(&set);
  return sets;
}

bool is_built_in(std::string_view name) {
  return name != template_name && std::ranges::find(texts(), name, &Text::name) != texts().end();
}

RuleText load_rule_text(std::string_view name_or_file) {
  if (is_built_in(name_or_file)) return {std::string(name_or_file), std::string(rule_set_text(name_or_file))};
  auto const allowed = fmt::format("{}, or a rule file", names(false));
  return {
      std::string(name_or_file),
      read_file(std::string(name_or_file),
                {.largest_bytes = largest_rule_file,
                 .allowed = allowed,
                 .when_too_large = "a rule file holds one set of limits, not data",
                 .when_missing = "isolaw rules lists the sets, isolaw rules template prints a file to start from"})};
}

RuleSet find_rule_set(std::string_view name_or_file) {
  for (auto const& set : parsed())
    if (set.id == name_or_file) return set;
  auto const text = load_rule_text(name_or_file);
  return read_rule_text(text.toml, text.name);
}

std::string_view rule_set_text(std::string_view name) {
  auto const found = std::ranges::find(texts(), name, &Text::name);
  if (found == texts().end())
    throw Error({.where = "", .found = fmt::format("no rule set {}", in_quotes(name)), .allowed = names(true)});
  return found->toml;
}

}  // namespace isolaw::rules
