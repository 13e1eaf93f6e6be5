// Prints messages to standard error and results to standard output.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "isolaw/base/printable.hpp"

namespace isolaw::app {

// Prints a message to standard error. It flushes standard output first, so that a message never stands within a line of
// results if both streams go to the same file. It ignores failures, so that a campaign still ends properly after its
// terminal was closed.
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  fmt::memory_buffer text;  // a message of usual length needs no allocation, which could fail when memory is full
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
  std::fflush(stdout);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

inline bool has_printed = false;  // set by print(). If true, an error is not printed as JSON after the results

inline void print(std::string_view text) {
  has_printed = true;
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (!text.ends_with('\n')) std::fputc('\n', stdout);
}

// Returns a file name for use in a message, with control characters as visible codes.
inline std::string shown(std::filesystem::path const& path) {
  return printable(path.string());
}

}  // namespace isolaw::app
