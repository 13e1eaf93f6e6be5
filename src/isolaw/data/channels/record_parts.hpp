// Steps of reading a record: selects samples, and joins channels of several files.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/data/channels/record.hpp"

namespace isolaw::data {

struct Span {
  std::size_t first = 0, count = 0;
};

// Returns the samples from options.from_s to options.to_s. Returns nullopt, with a complaint, if there are none or if
// the time passes through this interval more than once. Messages write `dashes` before "from" and "to": for a motion it
// is "--motion-", because the options are then --motion-from and --motion-to.
std::optional<Span> span_of_time(std::vector<double> const& time_s, ReadOptions const& options,
                                 std::string const& place, std::vector<Complaint>& complaints,
                                 std::string_view dashes = "--");
void describe_span(Span const& span, std::size_t of, ReadOptions const& options, std::vector<Finding>& recognised,
                   std::string_view dashes = "--");

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

// Adds the channels of `other` to `main`. If both files have seconds, or both have time stamps, interpolates the
// channels at main's times. Otherwise joins the files row by row.
void join_channels(RecordPart& main, RecordPart other);

}  // namespace isolaw::data
