// Makes texts on the usage of the program: --help, docs/cli.md, and isolaw's own messages for wrong usage in place of
// those of CLI11.
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

// The help of a command ends with this mark, followed by an example.
inline constexpr std::string_view example_mark = "Example: ";

// Lists options under the headings of base/option.hpp, in their order. A command with few options has a single heading.
std::shared_ptr<CLI::FormatterBase> help_format();

// Prints docs/cli.md. Options that calibrate shares with other commands get sections, and the commands refer to them.
void print_reference(CLI::App const& app);

std::string plain_markdown(std::string_view text);

// Throws Error if the first word is neither a command of `app` nor an option.
void require_known_command(CLI::App& app, int argc, char** argv);

// Explains why `app` refused a command line with `error`. Returns at least one complaint.
std::vector<Complaint> usage_complaints(CLI::App& app, CLI::ParseError const& error);

}  // namespace isolaw::app
