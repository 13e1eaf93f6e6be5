// Implements the commands `isolaw laws` and `isolaw example`.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <ranges>

#include "isolaw/api/catalogue_json.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/example_lot.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/app/usage.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/laws/memory/open_branches.hpp"
#include "isolaw/render/terminal/terminal.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::app {
namespace {

std::string markdown_interval(std::optional<laws::Interval> const& interval) {
  return interval ? fmt::format("{:g} to {:g}", interval->lower, interval->upper) : std::string("–");
}

std::string in_the_paper(laws::ParameterInfo const& parameter) {
  return parameter.paper_name.empty() ? std::string() : fmt::format("; {} in the paper's tables", parameter.paper_name);
}

std::string together(laws::LawEntry const& law) {
  return joined(law.joint_limits | std::views::transform(&laws::JointLimitEntry::statement));
}
void print_markdown() {
  fmt::print(
      "# The laws\n\nEvery law with its formula and parameters, as `isolaw laws ID` prints it; `./isolaw.sh docs` writes this page. In the formulas x is the\ndisplacement, v the velocity and F the force, in the law's own units. dx and -> stand for a step from one sample to the next. A state\nstarts at zero unless the formula says otherwise. The column *paper* has the bounds of Table 4 of Cucuzza et al. 2025. If a history\nstarts at another displacement than zero, the device is virgin there. A law that remembers its path then takes the way from zero to\nthis displacement as its first motion. Analysis programs start at zero.\n\nA law that remembers turning points keeps at most {} whose loops are still open. Records have a few tens of them. After thousands of\never smaller turns the law drops those that change the force least. Its force then differs by up to 0.4 % of the peak, until the\nmotion has grown again.\n",
      laws::OpenBranches::most);
  for (auto const& law : laws::catalogue()) {
    fmt::print(
        "\n## {}: {}\n\nSource: {}. Units: {}, {}, s. The law {}{}. `--laws {}` includes it.\n\n```\n{}\n```\n\n",
        law.info.id, plain_markdown(law.info.title), plain_markdown(law.info.source), law.info.force.symbol,
        law.info.length.symbol,
        law.info.traits.rate_independent ? "needs displacement alone" : "needs displacement and time",
        law.info.traits.remembers ? fmt::format(" and remembers {}", laws::memory_of(law.info)) : "",
        laws::name(law.info.set), law.info.formula);
    if (!law.info.note.empty()) fmt::print("{}\n", render::wrapped("", plain_markdown(law.info.note), 0, 120));
    fmt::print("| parameter | unit | meaning | paper |\n|---|---|---|---|\n");
    for (auto const& p : law.parameters)
      fmt::print("| {} | {} | {}{}{} | {} |\n", plain_markdown(p.name), p.unit, plain_markdown(p.meaning),
                 plain_markdown(in_the_paper(p)),
                 p.fixed_by_default ? fmt::format("; fixed at {:g} unless freed", *p.fixed_by_default) : "",
                 markdown_interval(p.published));
    if (!law.joint_limits.empty()) fmt::print("\nThe parameters must satisfy {}.\n", plain_markdown(together(law)));
  }
}

void print_law(laws::LawEntry const& law) {
  fmt::print("{}: {}\n  source  {}\n  units   {}, {}, s\n  needs   {}\n  memory  {}\n  runs    with --laws {}\n",
             law.info.id, law.info.title, law.info.source, law.info.force.symbol, law.info.length.symbol,
             law.info.traits.rate_independent ? "displacement" : "displacement and time",
             law.info.traits.remembers ? laws::memory_of(law.info)
                                       : "nothing but what the formula itself carries from one step to the next",
             laws::name(law.info.set));
  fmt::print("  formula\n");
  for (auto const line : law.info.formula | std::views::split('\n'))
    fmt::print("    {}\n", std::string(line.begin(), line.end()));
  if (!law.info.note.empty()) fmt::print("  reading\n{}", render::wrapped("", law.info.note, 4, 96));
  fmt::print("\n  {:<10} {:<10} {:>12} {:>12}  {}\n", "parameter", "unit", "paper from", "to", "meaning");
  for (auto const& p : law.parameters) {
    auto const bound = [&](double laws::Interval::*end) {
      return p.published ? fmt::format("{:g}", (*p.published).*end) : std::string("-");
    };
    fmt::print("  {:<10} {:<10} {:>12} {:>12}  {}{}{}\n", p.name, p.unit, bound(&laws::Interval::lower),
               bound(&laws::Interval::upper), p.meaning, in_the_paper(p),
               p.fixed_by_default ? fmt::format(" (fixed at {:g})", *p.fixed_by_default) : "");
  }
  if (!law.joint_limits.empty()) fmt::print("  together: {}\n", together(law));
}

}  // namespace

int list_laws(std::string const& id, bool json, bool markdown) {
  if (markdown) {
    print_markdown();
    return exit_done;
  }
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
  std::size_t widest = 0;
  for (auto const& law : laws::catalogue()) widest = std::max(widest, law.info.id.size());
  for (auto const& law : laws::catalogue())
    fmt::print("{:<{}} {:<5} {:>2} parameters  {}\n", law.info.id, widest, laws::name(law.info.set),
               law.parameters.size(), law.info.title);
  return exit_done;
}

int example(ExampleArguments const& arguments) {
  auto const& directory = arguments.directory;
  if (arguments.building + arguments.tests + arguments.conditions > 1)
    throw Error(
        {.where = arguments.building ? "--building" : "--tests",
         .found = arguments.tests && arguments.building ? "is given with --tests" : "is given with --conditions",
         .allowed = "one of them"});
  if (arguments.building) {
    write_example_building(directory);
    fmt::print("written: {0}\nnext: isolaw building {1} --from CAMPAIGN\n", shown(directory),
               shown(directory / "building.toml"));
    return exit_done;
  }
  write_example(directory, arguments.conditions ? example_conditions()
                           : arguments.tests    ? example_tests()
                                                : example_lot());
  fmt::print("written: {0}\nnext: isolaw {1} {2}\n", shown(directory),
             arguments.conditions ? "conditions" : "calibrate", shown(directory / "lot.toml"));
  return exit_done;
}

int list_rules(std::string const& name, bool json) {
  if (!name.empty()) {
    if (json)
      throw Error({.where = "--json", .found = "is given with " + in_quotes(name), .allowed = "the list alone"});
    auto const text = rule_text(name);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return exit_done;
  }
  if (json) {
    print(rule_sets_json());
    return exit_done;
  }
  auto const sets = rules::built_in_rule_sets();
  auto const longest = std::ranges::max(sets, {}, [](auto const& set) { return set.id.size(); }).id.size();
  for (auto const& set : sets)
    fmt::print("{:<{}} {}{}\n", set.id, longest, set.title,
               set.verified() ? "" : "; limits not verified: information, no verdict");
  fmt::print("{:<{}} {}\n", "template", longest,
             "a commented file to write the contract's own from: isolaw rules template");
  return exit_done;
}

}  // namespace isolaw::app
