// Files that the library holds within it, as tables that cmake/embed.cmake makes when it is built.
#pragma once

#include <span>
#include <string_view>

namespace isolaw {

struct Embedded {
  std::string_view name, text;
};

// The text of a file that is surely there: std::logic_error otherwise.
std::string_view embedded_text(std::span<Embedded const> files, std::string_view name);

}  // namespace isolaw
