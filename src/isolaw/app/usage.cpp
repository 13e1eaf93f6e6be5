#include "isolaw/app/usage.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <string_view>

#include "isolaw/base/nearest_word.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::app {
namespace {

std::vector<std::string> names_of_options(CLI::App const& command) {
  std::vector<std::string> names;
  for (auto const* option : command.get_options())
    for (auto const& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// Returns the names of the commands. A command without a group is only for developers of isolaw and is left out, except
// with `hidden_too`.
std::vector<std::string> names_of_commands(CLI::App& app, bool hidden_too = false) {
  std::vector<std::string> names;
  for (auto const* command :
       app.get_subcommands([=](CLI::App* each) { return hidden_too || !each->get_group().empty(); }))
    names.push_back(command->get_name());
  return names;
}

std::vector<Complaint> about_extra_words(CLI::App const& command, std::string const& advice) {
  std::vector<Complaint> complaints;
  constexpr std::size_t longest = 100;
  for (auto const& word : command.remaining(true)) {
    if (!word.starts_with('-')) {
      complaints.push_back({word, "one argument too many", {}, advice});
      continue;
    }
    auto const name = word.substr(0, std::min(word.find('='), longest));
    auto const known = names_of_options(command);
    auto const near = nearest_word(name, known, 3);
    complaints.push_back({name, "no such option", joined(known), near.empty() ? advice : near + ", or " + advice});
  }
  return complaints;
}

// Finds the option that a message of CLI11 names: "Could not convert: --runs = many", "--out: 1 required TEXT missing".
CLI::Option const* option_of(CLI::App const& command, std::string_view message) {
  for (auto const* option : command.get_options()) {
    auto const name = option->get_name();
    auto const at = message.find(name);
    if (at == std::string_view::npos) continue;
    auto const after = message.substr(at + name.size());
    if (after.empty() || after.front() == ':' || after.front() == ' ') return option;
  }
  return nullptr;
}

}  // namespace

void require_known_command(CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  auto const all = names_of_commands(app, true), known = names_of_commands(app);
  if (std::ranges::find(all, argv[1]) != all.end()) return;
  auto const word = std::string(argv[1]).substr(0, 100);
  auto const near = nearest_word(word, known, 2);
  throw Error({.where = word,
               .found = "no such command",
               .allowed = joined(known),
               .advice = (near.empty() ? "" : "isolaw " + near + ", or ") + "isolaw --help"});
}

std::vector<Complaint> usage_complaints(CLI::App& app, CLI::ParseError const& error) {
  auto const chosen = app.get_subcommands();
  auto const& command = chosen.empty() ? app : *chosen.front();
  auto const advice = chosen.empty() ? std::string("isolaw --help") : "isolaw " + command.get_name() + " --help";
  bool const required = dynamic_cast<CLI::RequiredError const*>(&error) != nullptr;
  if (required || dynamic_cast<CLI::ExtrasError const*>(&error) != nullptr)
    if (auto complaints = about_extra_words(command, advice); !complaints.empty()) return complaints;
  if (chosen.empty()) return {{{}, "no command given", joined(names_of_commands(app)), advice}};
  std::string const message = error.what();
  if (required) return {{"isolaw " + command.get_name(), message, {}, advice}};
  auto const* option = option_of(command, message);
  if (option == nullptr) return {{"isolaw " + command.get_name(), message, {}, advice}};
  if (auto const times = option->results().size(); times > 1 && option->get_items_expected_max() == 1)
    return {
        {option->get_name(), fmt::format("is given {} times: {}", times, joined(option->results())), "once", advice}};
  bool const number = dynamic_cast<CLI::ConversionError const*>(&error) != nullptr;
  bool const whole = number && option->get_type_name() == "INT";
  auto const value = option->results().empty() ? std::string() : option->results().back();
  bool const out_of_range = whole && value.find_first_not_of("+-0123456789") == std::string::npos;
  auto const problem = out_of_range ? "out of range"
                       : whole      ? "not a whole number"
                       : number     ? "not a number"
                                    : "not allowed";
  auto const found = value.empty() ? std::string("needs a value") : fmt::format("'{}' is {}", value, problem);
  return {{option->get_name(), found, option->get_description(), advice}};
}

}  // namespace isolaw::app
