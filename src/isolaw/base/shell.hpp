// Command lines that a reader can paste into a shell.
#pragma once

#include <string>
#include <vector>

namespace isolaw {

// The words as a POSIX shell reads them back, each in single quotes where it needs them.
std::string shell_quoted(std::vector<std::string> const& words);

}  // namespace isolaw
