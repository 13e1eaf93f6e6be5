// Writes command lines that a reader can paste into a shell.
#pragma once

#include <string>
#include <vector>

namespace isolaw {

// The words in POSIX shell syntax, each in single quotes if it needs them.
std::string shell_quoted(std::vector<std::string> const& words);

}  // namespace isolaw
