// Messages to standard error, and names in them.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

#include "isolaw/base/printable.hpp"

namespace isolaw::app {

// Nothing is done about a failure: a terminal that was closed must not cost a campaign its orderly end.
template <class... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  auto const text = fmt::format(format, std::forward<Args>(args)...);
  std::fwrite(text.data(), 1, text.size(), stderr);
}

// A file's name as a message shows it, control characters spelled out.
inline std::string shown(std::filesystem::path const& path) {
  return printable(path.string());
}

}  // namespace isolaw::app
