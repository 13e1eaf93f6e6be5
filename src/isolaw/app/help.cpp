// Writes the text of --help and docs/cli.md.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/app/usage.hpp"
#include "isolaw/base/option.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::app {
namespace {

using Options = std::vector<CLI::Option const*>;
using Sections = std::map<Heading, Options>;

Heading heading_of(CLI::Option const& option) {
  auto heading = Heading::running;
  while (heading != Heading::everyday && title(heading) != option.get_group())
    heading = static_cast<Heading>(static_cast<int>(heading) - 1);
  return heading;
}

Sections sections_of(CLI::App const& command) {
  Sections sections;
  for (auto const* option : command.get_options())
    if (option->nonpositional()) sections[heading_of(*option)].push_back(option);
  return sections;
}

class HelpFormat final : public CLI::Formatter {
 public:
  HelpFormat() {
    label("Positionals", "Arguments");
    label("REQUIRED", "(required)");
    label("OPTIONS", "options");
    label("SUBCOMMAND", "COMMAND");
  }

  std::string make_help(CLI::App const* command, std::string name, CLI::AppFormatMode mode) const override {
    return make_description(command) + make_usage(command, std::move(name)) + make_positionals(command) +
           options_of(*command) + make_subcommands(command, mode) + "\n" + make_footer(command);
  }

 private:
  std::string options_of(CLI::App const& command) const {
    constexpr std::size_t few = 14;
    auto const sections = sections_of(command);
    Options all;
    for (auto const& [heading, options] : sections) all.insert(all.end(), options.begin(), options.end());
    if (all.size() <= few || sections.size() == 1) return make_group("Options", false, all);
    std::string text;
    for (auto const& [heading, options] : sections) text += make_group(std::string(title(heading)), false, options);
    return text;
  }
};

std::string key_of(CLI::Option const& option) {
  return option.get_name() + "\n" + option.get_description();
}

// Returns an option as the user types it, such as "--jobs INT" or "inputs...".
std::string usage_of(CLI::Option const& option) {
  bool const positional = option.get_positional();
  auto text = option.get_name(positional);
  if (!positional && !option.get_type_name().empty()) text += " " + option.get_type_name();
  return text + (option.get_expected_max() > 1 ? "..." : "");
}

void print_list(Options const& options) {
  for (auto const* option : options)
    fmt::print("- `{}`: {}{}\n", usage_of(*option), plain_markdown(option->get_description()),
               option->get_required() ? " (required)" : "");
}

// Returns a link to the section of the options that several commands share, and says which of these options `command`
// has, for example "[Reading records](#reading-records) without `--to`". Returns "" if it has none of them.
std::string reference_to(Heading heading, Options const& shared, CLI::App const& command) {
  std::vector<std::string> with, without;
  for (auto const* option : shared) {
    auto const* const own = command.get_option_no_throw(option->get_name());
    bool const same = own != nullptr && key_of(*own) == key_of(*option);
    (same ? with : without).push_back(fmt::format("`{}`", option->get_name()));
  }
  auto anchor = lower(title(heading));
  std::ranges::replace(anchor, ' ', '-');
  auto const link = fmt::format("[{}](#{})", title(heading), anchor);
  if (with.empty() || without.empty()) return with.empty() ? std::string() : link;
  return without.size() <= 2 && with.size() > 3 ? fmt::format("{} without {}", link, joined(without))
                                                : fmt::format("{} ({})", joined(with), link);
}

void print_command(CLI::App const& command, std::set<std::string> const& shared_keys, Sections const& shared) {
  auto own = command.get_options([](CLI::Option const* option) { return option->get_positional(); });
  for (auto const& [heading, options] : sections_of(command))
    for (auto const* option : options)
      if (option != command.get_help_ptr() && !shared_keys.contains(key_of(*option))) own.push_back(option);
  auto usage = HelpFormat().make_usage(&command, "isolaw " + command.get_name());
  usage = usage.substr(usage.find(' ') + 1, usage.find('\n') - usage.find(' ') - 1);
  fmt::print("\n## {}\n\n{}. Use `{}`, such as `{}`.\n", command.get_name(), plain_markdown(command.get_description()),
             usage, command.get_footer().substr(example_mark.size()));
  print_list(own);
  std::vector<std::string> also;
  for (auto const& [heading, options] : shared)
    if (auto text = reference_to(heading, options, command); !text.empty()) also.push_back(std::move(text));
  if (!also.empty()) fmt::print("- Shared options: {}\n", joined(also, "; "));
}

}  // namespace

std::string plain_markdown(std::string_view text) {
  std::string out;
  for (char const c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '<' || c == '`') out += '\\';
    out += c;
  }
  return out;
}

std::shared_ptr<CLI::FormatterBase> help_format() {
  return std::make_shared<HelpFormat>();
}

void print_reference(CLI::App const& app) {
  auto const commands = app.get_subcommands([](CLI::App const* command) { return !command->get_group().empty(); });
  // The first command is calibrate. It has every option that gets a section.
  auto const& first = *commands.front();
  std::set<std::string> shared_keys;
  for (auto const* command : commands)
    for (auto const* option : command->get_options())
      if (command != &first && option->nonpositional() && option != command->get_help_ptr())
        shared_keys.insert(key_of(*option));
  auto shared = sections_of(first);
  for (auto& [heading, options] : shared)
    std::erase_if(options, [&](auto const* option) { return !shared_keys.contains(key_of(*option)); });
  shared_keys.clear();
  for (auto const& [heading, options] : shared)
    for (auto const* option : options) shared_keys.insert(key_of(*option));
  fmt::print(R"(# The command line

Every command of `isolaw` and every option, as the program describes them. To start:

```
isolaw inspect d01.csv d02.csv --rules ntc-2018 --design K_eff=0.62,damping=19.5,disp=208   # were the tests read right?
isolaw calibrate d01.csv d02.csv --out out/lot                                              # fit the laws, write the report
isolaw export out/lot --law bouc-wen --device lot --to opensees --out bearing.tcl           # take a law with you
```

`isolaw COMMAND --help` lists all options of a command in the terminal. Here the options that other
commands share with `calibrate` are described once, [at the end](#shared-options). Each section
shows the form of its command, then an example. `./isolaw.sh docs` writes this page.

Results go to standard output, messages and progress to standard error. Exit codes: 0, done; 1, done, but something was refused,
failed, was interrupted or is outside a limit; 2, wrong usage or nothing usable; 3, internal error.
)");
  for (auto const* command : commands) print_command(*command, shared_keys, shared);
  fmt::print("\n## Shared options\n");
  for (auto const& [heading, options] : shared) {
    fmt::print("\n### {}\n\n", title(heading));
    print_list(options);
  }
}

}  // namespace isolaw::app
