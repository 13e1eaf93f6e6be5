// Text for Markdown pages that the program writes.
#pragma once

#include <string>
#include <string_view>

namespace isolaw::app {

// Escapes the characters that Markdown would read as markup, in prose or in a cell of a table.
inline std::string plain_markdown(std::string_view text) {
  std::string out;
  for (char const c : text) {
    if (c == '|' || c == '*' || c == '_' || c == '<' || c == '`') out += '\\';
    out += c;
  }
  return out;
}

}  // namespace isolaw::app
