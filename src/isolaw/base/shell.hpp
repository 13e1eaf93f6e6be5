// Writes command lines that a reader can paste into a POSIX shell.
#pragma once

#include <string>
#include <vector>

namespace isolaw {

std::string shell_quoted(std::vector<std::string> const& words);

}  // namespace isolaw
