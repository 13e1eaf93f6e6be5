// Files compiled into the library: cmake/embed.cmake writes them as tables of names and texts during the build.
#pragma once

#include <span>
#include <string_view>

namespace isolaw {

struct Embedded {
  std::string_view name, text;
};

// Returns the text of the file `name`. Throws std::logic_error if there is no such file, which is a mistake in isolaw.
std::string_view embedded_text(std::span<Embedded const> files, std::string_view name);

}  // namespace isolaw
