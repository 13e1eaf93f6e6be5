// Errors of usage in our own words: what was found, what is allowed, what was probably meant.
#pragma once

#include <vector>

#include "isolaw/base/error.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace isolaw::app {

// Throws Error if the first word is neither a command of `app` nor an option.
void require_known_command(CLI::App& app, int argc, char** argv);

// The complaints about a command line that `app` refused with `error`; never empty.
std::vector<Complaint> usage_complaints(CLI::App& app, CLI::ParseError const& error);

}  // namespace isolaw::app
