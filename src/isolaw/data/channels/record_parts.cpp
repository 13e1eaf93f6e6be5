#include "isolaw/data/channels/record_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "isolaw/base/hash.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/channels/columns.hpp"
#include "isolaw/data/channels/time_gaps.hpp"

namespace isolaw::data {
namespace {

std::string asked_time(ReadOptions const& options, std::string_view dashes) {
  return fmt::format("{}{}{}", options.from_s ? fmt::format("{}from {}", dashes, *options.from_s) : "",
                     options.from_s && options.to_s ? " " : "",
                     options.to_s ? fmt::format("{}to {}", dashes, *options.to_s) : "");
}
std::vector<double> at_times(std::vector<double> const& at, std::vector<double> const& time,
                             std::vector<double> const& values) {
  std::vector<double> interpolated;
  interpolated.reserve(at.size());
  std::size_t k = 0;
  for (double const t : at) {
    while (k + 2 < time.size() && time[k + 1] < t) ++k;
    double const share = std::clamp((t - time[k]) / (time[k + 1] - time[k]), 0.0, 1.0);
    interpolated.push_back(values[k] + share * (values[k + 1] - values[k]));
  }
  return interpolated;
}

double mean_interval(std::vector<double> const& time_s) {
  return (time_s.back() - time_s.front()) / static_cast<double>(time_s.size() - 1);
}

std::size_t sample_count(TestRecord const& record) {
  return std::max({record.time_s.size(), record.disp_mm.size(), record.force_kN.size(), record.load_kN.size()});
}

constexpr Channel measured_channels[] = {Channel::disp, Channel::force, Channel::load, Channel::second_disp};

// Refuses a record with a gap in time between `first` and `last`: values in the gap cannot be interpolated.
void require_without_gaps(TestRecord const& other, double first, double last) {
  double const longest = most_intervals * usual_interval(other.time_s);
  for (std::size_t i = 1; i < other.time_s.size(); ++i) {
    double const from = other.time_s[i - 1], to = other.time_s[i];
    if (to - from <= longest || to <= first || from >= last) continue;
    throw Error(Complaint{.where = other.file,
                          .found = fmt::format("nothing from {:.6g} to {:.6g} s", from, to),
                          .allowed = "values at all times of the other file, to be interpolated between",
                          .advice = "--from and --to for a part that both files have"});
  }
}

}  // namespace

std::optional<Span> span_of_time(std::vector<double> const& time_s, ReadOptions const& options,
                                 std::string const& place, std::vector<Complaint>& complaints,
                                 std::string_view dashes) {
  if (!options.from_s && !options.to_s) return Span{0, time_s.size()};
  auto const asked = asked_time(options, dashes);
  if (time_s.empty()) {
    complaints.push_back({place, fmt::format("{} is given, but no time is read", asked),
                          "a time column, or --dt SECONDS", "--rows A:B"});
    return std::nullopt;
  }
  auto const [least, most] = std::ranges::minmax(time_s);
  double const rounding = 1e-9 * std::max(std::abs(least), std::abs(most));
  auto const inside = [&](double t) {
    return (!options.from_s || t >= *options.from_s - rounding) && (!options.to_s || t <= *options.to_s + rounding);
  };
  auto const first = std::ranges::find_if(time_s, inside);
  auto const end = std::find_if_not(first, time_s.end(), inside);
  if (first == time_s.end() || std::find_if(end, time_s.end(), inside) != time_s.end()) {
    complaints.push_back({place,
                          first == time_s.end() ? fmt::format("no sample lies within {}", asked)
                                                : fmt::format("the time passes through {} more than once", asked),
                          fmt::format("times of the file, {:.6g} to {:.6g} s", least, most),
                          first == time_s.end() ? "" : "--rows A:B"});
    return std::nullopt;
  }
  return Span{static_cast<std::size_t>(first - time_s.begin()), static_cast<std::size_t>(end - first)};
}

void describe_span(Span const& span, std::size_t of, ReadOptions const& options, std::vector<Finding>& recognised,
                   std::string_view dashes) {
  if (options.from_s || options.to_s)
    recognised.push_back(decision(FindingKind::rows_read,
                                  fmt::format("samples {} to {} of {} are read ({})", span.first + 1,
                                              span.first + span.count, of, asked_time(options, dashes)),
                                  std::string(dashes) + (options.from_s ? "from" : "to")));
}

std::vector<double>& values_of(TestRecord& record, Channel channel) {
  switch (channel) {
    case Channel::time:
      return record.time_s;
    case Channel::disp:
      return record.disp_mm;
    case Channel::force:
      return record.force_kN;
    case Channel::cycle:
      return record.logged_cycle;
    case Channel::second_disp:
      return record.second_disp_mm;
    default:
      return record.load_kN;
  }
}

void append(std::vector<Finding>& findings, std::vector<Finding> const& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

void join_channels(RecordPart& main, RecordPart other) {
  auto& record = main.record;
  auto& more = other.record;
  auto const rows = sample_count(record), more_rows = sample_count(more);
  bool const timed = record.has_time() && more.has_time() && main.origin_s.has_value() == other.origin_s.has_value() &&
                     main.dated == other.dated;
  std::string how;
  if (timed) {
    double const offset = main.origin_s ? *other.origin_s - *main.origin_s : 0.0;
    for (auto& t : more.time_s) t += offset;
    double const interval = mean_interval(record.time_s);
    bool same = rows == more_rows;
    for (std::size_t i = 0; same && i < rows; ++i) same = std::abs(record.time_s[i] - more.time_s[i]) < 1e-3 * interval;
    how = "row by row, at the same times";
    if (!same) {
      double const first = std::max(record.time_s.front(), more.time_s.front());
      double const last = std::min(record.time_s.back(), more.time_s.back());
      std::vector<Complaint> complaints;
      ReadOptions both;
      both.from_s = first;
      both.to_s = last;
      auto const span =
          first < last ? span_of_time(record.time_s, both, record.file, complaints) : std::optional<Span>();
      if (!span || span->count < least_samples)
        throw Error(Complaint{.where = more.file,
                              .found = fmt::format("times from {:.6g} to {:.6g} s, those of {} from {:.6g} to {:.6g} s",
                                                   more.time_s.front(), more.time_s.back(), record.file,
                                                   record.time_s.front(), record.time_s.back()),
                              .allowed = "a time that both files share",
                              .advice = record.layout.rows || more.layout.rows
                                            ? "--from and --to in place of --rows, which counts in each file"
                                            : "--columns time=none, where the rows belong together"});
      require_without_gaps(more, first, last);
      for (auto const channel : all_channels) keep(*span, values_of(record, channel));
      for (auto const channel : measured_channels)
        if (auto& values = values_of(more, channel); !values.empty())
          values = at_times(record.time_s, more.time_s, values);
      double const share = static_cast<double>(span->count) / static_cast<double>(rows);
      how = fmt::format(
          "by time, interpolated from every {:.4g} s to every {:.4g} s; {} of {} samples lie in the time of both",
          mean_interval(more.time_s), interval, span->count, rows);
      constexpr double most_of_it = 0.9;
      if (share < most_of_it)
        record.warnings.push_back(
            {.kind = FindingKind::shared_time_short,
             .numbers = {{"samples", static_cast<double>(span->count)}, {"of", static_cast<double>(rows)}},
             .words = {{"file", more.file}}});
      if (mean_interval(more.time_s) > 1.5 * interval)
        record.warnings.push_back(
            {.kind = FindingKind::channel_interpolated,
             .numbers = {{"interval_s", mean_interval(more.time_s)}, {"other_interval_s", interval}},
             .words = {{"file", more.file}, {"other_file", record.file}}});
    }
  } else {
    if (rows != more_rows)
      throw Error(Complaint{.where = more.file,
                            .found = fmt::format("{} rows, {} in {}", more_rows, rows, record.file),
                            .allowed = "as many rows in both, or a time column of one kind in both",
                            .advice = "--rows A:B, which counts in both"});
    how = "row by row";
    if (!record.has_time()) {
      record.time_s = std::move(more.time_s);
      main.origin_s = other.origin_s;
      main.dated = other.dated;
    }
  }
  for (auto const channel : measured_channels)
    if (auto& values = values_of(more, channel); !values.empty()) values_of(record, channel) = std::move(values);
  append(record.warnings, more.warnings);
  for (auto& line : more.recognised) {
    line.words.push_back({"part", more.file});
    record.recognised.push_back(std::move(line));
  }
  std::vector<std::string> specs;
  for (auto const channel : measured_channels)
    if (auto const found = more.layout.columns.find(channel);
        found != more.layout.columns.end() && more.layout.units.contains(channel)) {
      record.layout.columns[channel] = fmt::format("{}:{}", more.file, found->second);
      record.layout.units[channel] = more.layout.units.at(channel);
      specs.push_back(fmt::format("{}={}:{}", name(channel), more.file, found->second));
    }
  record.recognised.push_back(
      decision(FindingKind::file_joined,
               fmt::format("{} is joined to {}, {} (--columns {}); SHA-256 {} and {}", more.file, record.file, how,
                           joined(specs, ","), more.sha256, record.sha256),
               "--columns"));
  record.sha256 = sha256(record.sha256 + more.sha256);
}

}  // namespace isolaw::data
