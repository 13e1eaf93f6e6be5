// Texts about using the program: --help, docs/cli.md, and errors of usage in our own words.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"

namespace CLI {
class App;
class FormatterBase;
class ParseError;
}  // namespace CLI

namespace isolaw::app {

// A command's footer is its example, after this mark.
inline constexpr std::string_view example_mark = "Example: ";

// Lists options under the headings of base/option.hpp, in their order, or under a single heading if there are few.
std::shared_ptr<CLI::FormatterBase> help_format();

// Options that other commands share with calibrate get sections of their own, to which the commands refer.
void print_reference(CLI::App const& app);

std::string plain_markdown(std::string_view text);

// Throws Error if the first word is neither a command of `app` nor an option.
void require_known_command(CLI::App& app, int argc, char** argv);

// The complaints about a command line that `app` refused with `error`; never empty.
std::vector<Complaint> usage_complaints(CLI::App& app, CLI::ParseError const& error);

}  // namespace isolaw::app
