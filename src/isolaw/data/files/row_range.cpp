#include "isolaw/data/files/row_range.hpp"

#include <fmt/format.h>
#include <algorithm>
#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {

RowRange parse_rows(std::string_view text) {
  auto const colon = text.find(':');
  auto const first = trimmed(text.substr(0, colon));
  auto const last = colon == std::string_view::npos ? std::string_view{} : trimmed(text.substr(colon + 1));
  RowRange range;
  auto const from = first.empty() ? std::optional<std::size_t>(1) : number_in<std::size_t>(first);
  auto const to = last.empty() ? std::optional<std::size_t>() : number_in<std::size_t>(last);
  bool const good = colon != std::string_view::npos && from && *from >= 1 && *from <= most_lines &&
                    (last.empty() || (to && *to >= *from && *to <= most_lines)) && !(first.empty() && last.empty());
  if (!good)
    throw Error(
        Complaint{.where = "--rows",
                  .found = in_quotes(text),
                  .allowed = "A:B, rows of numbers counted from 1 below the header; A: to the end, :B from the start",
                  .advice = "--rows 101:700"});
  range.first = *from;
  range.last = to;
  return range;
}

std::string rows_text(RowRange const& range) {
  auto const last = range.last ? std::to_string(*range.last) : std::string();
  return range.first == 1 && range.last ? ":" + last : fmt::format("{}:{}", range.first, last);
}

std::string without_row(RowRange const& range, std::size_t row, std::size_t of) {
  auto const last = std::min(range.last.value_or(of), of);
  auto const before = row - range.first, behind = last - row;
  if (std::max(before, behind) < least_samples) return "export the record again";
  if (before >= behind) return fmt::format("--rows {}:{}, the rows before it", range.first, row - 1);
  return fmt::format("--rows {}, the rows behind it", rows_text({.first = row + 1, .last = range.last}));
}

std::string without_rows(RowRange const& range, std::vector<std::size_t> const& rows, std::size_t of) {
  if (rows.size() == 1) return without_row(range, rows.front(), of);
  auto const last = std::min(range.last.value_or(of), of);
  RowRange longest{.first = range.first, .last = rows.front() - 1};
  auto const length = [](RowRange const& one) { return *one.last + 1 - one.first; };
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (RowRange const between{.first = rows[i] + 1, .last = i + 1 < rows.size() ? rows[i + 1] - 1 : last};
        length(between) > length(longest))
      longest = between;
  // Advises to read only a part if it holds at least half of the rows. A shorter part would lose most of the test.
  if (2 * length(longest) >= last + 1 - range.first && length(longest) >= least_samples)
    return fmt::format("--rows {}, the longest part without such rows", rows_text(longest));
  return fmt::format("export the record again with a number in every cell, or delete these {} rows from a copy",
                     rows.size());
}

}  // namespace isolaw::data
