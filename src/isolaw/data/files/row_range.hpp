// The rows of numbers to read (option --rows), and texts that advise the user to read only some of them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace isolaw::data {

// A range of rows of numbers, counted from 1 below the header without blank lines and comments.
struct RowRange {
  std::size_t first = 1;
  std::optional<std::size_t> last;  // nullopt: up to the last row
  bool operator==(RowRange const&) const = default;
};

// How to treat rows in which a channel has no value: refuse them, leave them out, or fill them by linear interpolation
// in time, or between rows if there is no time (option --missing).
enum class MissingValues { refused, left_out, interpolated };
inline constexpr std::string_view or_missing = "; --missing leave-out or --missing interpolate";

// Parses "101:700", "101:" and ":700" (option --rows); throws Error on anything else.
RowRange parse_rows(std::string_view text);
std::string rows_text(RowRange const& range);

inline constexpr std::size_t least_samples = 3;

// Advice for a file of `of` rows whose row `row` cannot be read: to read only the rows before it, or only those after
// it. If these are too few, the advice is to export the record again.
std::string without_row(RowRange const& range, std::size_t row, std::size_t of);

// Advice like that of without_row(), for several rows that cannot be read. They must be in rising order and within the
// range.
std::string without_rows(RowRange const& range, std::vector<std::size_t> const& rows, std::size_t of);

}  // namespace isolaw::data
