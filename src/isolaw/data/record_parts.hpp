// Parts of a record while it is read: some of its channels, some of its time, and another file's channels beside them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/data/read.hpp"

namespace isolaw::data {

inline constexpr std::size_t least_samples = 3;

// The samples whose time lies within what was asked for.
struct Span {
  std::size_t first = 0, count = 0;
};

// What --from and --to ask for; nullopt: it cannot be had, which is among the complaints. `dashes` is what stands
// before both names where the option is called otherwise.
std::optional<Span> span_of_time(std::vector<double> const& time_s, ReadOptions const& options,
                                 std::string const& place, std::vector<Complaint>& complaints,
                                 std::string_view dashes = "--");
void describe_span(Span const& span, std::size_t of, ReadOptions const& options, std::vector<Finding>& recognised,
                   std::string_view dashes = "--");

// What to type to read the others of `of` rows without this one: the longer part of what was asked for, before it or
// behind it, where that is enough.
std::string without_row(RowRange const& range, std::size_t row, std::size_t of);

template <class T>
void keep(Span const& span, std::vector<T>& values) {
  if (values.empty()) return;
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(span.first + span.count), values.end());
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(span.first));
}

// A record, and what its time counts from where it was read from time stamps.
struct RecordPart {
  TestRecord record;
  std::optional<double> origin_s;
  bool dated = false;
  std::string exchange_advice = {};
};

// The values of a channel.
std::vector<double>& values_of(TestRecord& record, Channel channel);

void append(std::vector<Finding>& findings, std::vector<Finding> const& more);

// Brings the channels of another file to the samples of `main`: by time where both have one, else row by row. Throws
// Error where they cannot be brought together.
void join_channels(RecordPart& main, RecordPart other);

}  // namespace isolaw::data
