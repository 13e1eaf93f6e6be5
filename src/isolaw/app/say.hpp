// Messages to standard error, and names in them; outputs.
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

// Flushes standard output first: in one file, no message stands within a line of the output. Failures are ignored: a
// terminal that was closed must not cost a campaign its orderly end.
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  fmt::memory_buffer text;  // without an allocation for a message of usual length: memory may be what is missing
  fmt::format_to(std::back_inserter(text), format, std::forward<Args>(args)...);
  std::fflush(stdout);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

inline bool has_printed = false;  // by print(): what follows on standard output is no longer the only thing there

inline void print(std::string_view text) {
  has_printed = true;
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (!text.ends_with('\n')) std::fputc('\n', stdout);
}

// 80 where the descriptor leads to no terminal, or to one too narrow for our lines.
inline int terminal_width(int descriptor) {
  winsize size{};
  return ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col >= 40 ? size.ws_col : 80;
}

// A file's name as a message shows it, control characters spelled out.
inline std::string shown(std::filesystem::path const& path) {
  return printable(path.string());
}

}  // namespace isolaw::app
