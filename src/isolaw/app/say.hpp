// Printing: messages to standard error, results to standard output, and names of files in them.
#pragma once

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include "isolaw/base/printable.hpp"

namespace isolaw::app {

// Flushes standard output first, so that in a common file no message interrupts a line of output. Ignores failures, so
// that a campaign ends in good order after its terminal was closed.
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  fmt::memory_buffer text;  // does not allocate for a message of usual length, as memory may be full
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
  std::fflush(stdout);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

inline bool has_printed = false;  // set by print(): an error as JSON would not be alone on standard output

inline void print(std::string_view text) {
  has_printed = true;
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (!text.ends_with('\n')) std::fputc('\n', stdout);
}

// The terminal's width; 80 if the descriptor is not a terminal, or if it has less than 40 columns.
inline int terminal_width(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col >= 40 ? size.ws_col : 80;
}

// A file's name for a message, with control characters spelled out.
inline std::string shown(std::filesystem::path const& path) {
  return printable(path.string());
}

}  // namespace isolaw::app
