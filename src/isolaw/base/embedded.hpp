// Files compiled into the library: cmake/embed.cmake writes them as tables of names and texts during the build.
#pragma once

#include <span>
#include <string_view>

namespace isolaw {

struct Embedded {
  std::string_view name, text;
};

// The text of the named file. A missing file is our own mistake: std::logic_error.
std::string_view embedded_text(std::span<Embedded const> files, std::string_view name);

}  // namespace isolaw
