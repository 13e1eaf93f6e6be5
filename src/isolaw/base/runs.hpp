// Divides rows into groups of neighbours that belong together, such as the tests of one device.
#pragma once

#include <algorithm>
#include <functional>
#include <span>

namespace isolaw {

// Calls `take` with each group of neighbouring rows that have the same key, as a std::span.
template <class Row, class Key>
void each_run(std::span<Row const> rows, Key const& key, auto const& take) {
  while (!rows.empty()) {
    auto const is_of_first = [&](Row const& row) { return std::invoke(key, row) == std::invoke(key, rows.front()); };
    auto const count = static_cast<std::size_t>(std::ranges::find_if_not(rows, is_of_first) - rows.begin());
    take(rows.first(count));
    rows = rows.subspan(count);
  }
}

}  // namespace isolaw
