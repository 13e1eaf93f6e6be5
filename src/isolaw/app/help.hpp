// The text of --help, and docs/cli.md.
#pragma once

#include <memory>
#include <string_view>

namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI

namespace isolaw::app {

// A command's footer is its example, after this mark.
inline constexpr std::string_view example_mark = "Example: ";

// Lists options under the headings of base/option.hpp, in their order; few options under a single heading.
std::shared_ptr<CLI::FormatterBase> help_format();

// Prints docs/cli.md: every command with its own options. The options that other commands share with calibrate stand in
// sections of their own, to which the commands refer.
void print_reference(CLI::App const& app);

}  // namespace isolaw::app
