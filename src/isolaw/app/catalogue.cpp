// `isolaw laws` and `isolaw example`.
#include <fmt/format.h>

#include <cmath>

#include "isolaw/api/catalogue_json.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/example_lot.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::app {
namespace {

// Prose of at most `width` columns, every line indented.
std::string wrapped(std::string_view text, std::size_t indent, std::size_t width) {
  std::string out, line;
  while (!text.empty()) {
    auto const space = text.find(' ');
    auto const word = text.substr(0, space);
    if (!line.empty() && indent + line.size() + 1 + word.size() > width) {
      out += std::string(indent, ' ') + line + '\n';
      line.clear();
    }
    line += (line.empty() ? "" : " ") + std::string(word);
    text = space == std::string_view::npos ? std::string_view() : text.substr(space + 1);
  }
  return out + std::string(indent, ' ') + line + '\n';
}

void print_law(laws::LawEntry const& law) {
  fmt::print("{}: {}\n  source  {}\n  units   {}, {}, s\n  needs   {}\n", law.info.id, law.info.title, law.info.source,
             law.info.force.symbol, law.info.length.symbol,
             law.info.traits.rate_independent ? "displacement" : "displacement and time");
  if (!law.info.note.empty()) fmt::print("  reading\n{}", wrapped(law.info.note, 4, 96));
  fmt::print("\n  {:<10} {:<10} {:>12} {:>12}  {}\n", "parameter", "unit", "paper from", "to", "meaning");
  for (auto const& p : law.parameters) {
    auto const bound = [&](double laws::Interval::*end) {
      return p.published ? fmt::format("{:g}", (*p.published).*end) : std::string("-");
    };
    fmt::print("  {:<10} {:<10} {:>12} {:>12}  {}{}\n", p.name, p.unit, bound(&laws::Interval::lower),
               bound(&laws::Interval::upper), p.meaning,
               p.fixed_by_default ? fmt::format(" (fixed at {:g})", *p.fixed_by_default) : "");
  }
}

}  // namespace

int list_laws(std::string const& id, bool json) {
  if (!id.empty()) {
    auto const& law = laws::find_law(id);
    if (json)
      fmt::print("{}\n", law_json(law));
    else
      print_law(law);
    return exit_done;
  }
  if (json) {
    fmt::print("{}\n", catalogue_json());
    return exit_done;
  }
  for (auto const& law : laws::catalogue())
    fmt::print("{:<10} {:>2} parameters  {}\n", law.info.id, law.parameters.size(), law.info.title);
  return exit_done;
}

int example(std::filesystem::path const& directory) {
  write_example_lot(directory);
  fmt::print("written: {0}\nnext: isolaw calibrate {1}\n", shown(directory), shown(directory / "lot.toml"));
  return exit_done;
}

int list_rules(std::string const& name) {
  if (!name.empty()) {
    auto const text = rules::rule_set_text(name);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return exit_done;
  }
  for (auto const* set : rules::built_in_rule_sets())
    fmt::print("{:<14} {}{}\n", set->id, set->title,
               set->verified() ? "" : "; limits not verified: information, no verdict");
  fmt::print("{:<14} {}\n", "template", "a commented file to write the contract's own from: isolaw rules template");
  return exit_done;
}

}  // namespace isolaw::app
