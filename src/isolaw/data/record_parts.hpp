// Builds a record while it is read: chooses its samples, and joins the channels of several files.
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
struct Span {
  std::size_t first = 0, count = 0;
};

// nullopt, with a complaint, if there are no such samples. `dashes` precedes the names of options in messages.
std::optional<Span> span_of_time(std::vector<double> const& time_s, ReadOptions const& options,
                                 std::string const& place, std::vector<Complaint>& complaints,
                                 std::string_view dashes = "--");
void describe_span(Span const& span, std::size_t of, ReadOptions const& options, std::vector<Finding>& recognised,
                   std::string_view dashes = "--");

// Advice on reading the `of` rows without this one: the longer part before or behind it, if long enough.
std::string without_row(RowRange const& range, std::size_t row, std::size_t of);

template <class T>
void keep(Span const& span, std::vector<T>& values) {
  if (values.empty()) return;
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(span.first + span.count), values.end());
  values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(span.first));
}

struct RecordPart {
  TestRecord record;
  std::optional<double> origin_s;
  bool dated = false;
  std::string exchange_advice = {};
};
std::vector<double>& values_of(TestRecord& record, Channel channel);

void append(std::vector<Finding>& findings, std::vector<Finding> const& more);

// Brings the channels of another file to the samples of `main`, by time or else row by row. Throws Error.
void join_channels(RecordPart& main, RecordPart other);

}  // namespace isolaw::data
