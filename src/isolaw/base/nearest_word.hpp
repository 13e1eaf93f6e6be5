// Finds the known word that a mistyped word most likely stands for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolaw {

// The number of insertions, deletions and replacements that turn `a` into `b`.
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      auto const exchanged = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, exchanged}));
    }
  }
  return row.back();
}

// Returns the word of `known` with the smallest edit distance to `word`, the first of equally near ones. Returns "" if
// even this distance is above `furthest`.
template <class Known>
std::string nearest_word(std::string_view word, Known const& known, std::size_t furthest) {
  std::string near;
  for (auto const& other : known)
    if (auto const distance = edit_distance(word, other); distance <= furthest) {
      near = other;
      if (distance == 0) break;
      furthest = distance - 1;
    }
  return near;
}

}  // namespace isolaw
