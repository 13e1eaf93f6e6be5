#include "isolaw/base/shell.hpp"

namespace isolaw {

std::string shell_quoted(std::vector<std::string> const& words) {
  std::string line;
  for (auto const& word : words) {
    bool const simple =
        !word.empty() &&
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=,:+@%") ==
            std::string::npos;
    line += (line.empty() ? "" : " ");
    if (simple) {
      line += word;
      continue;
    }
    line += '\'';
    for (char const c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace isolaw
