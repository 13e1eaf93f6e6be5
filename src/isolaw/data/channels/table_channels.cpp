#include "isolaw/data/channels/table_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/channels/value_checks.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

void describe_part(Rows const& rows, RowRange const& range, std::vector<Finding>& recognised) {
  if (range == RowRange{}) return;
  recognised.push_back(
      decision(FindingKind::rows_read,
               fmt::format("rows {} to {} of {} are read (--rows {})", range.first,
                           range.last.value_or(rows.rows_in_file), rows.rows_in_file, rows_text(range)),
               "--rows"));
}

void describe_rows(Rows const& rows, Header const& header, TestRecord const& record, bool timed, bool of_header,
                   std::vector<Finding>& recognised) {
  auto const row = header.row;
  recognised.push_back(
      decision(FindingKind::rows_read, fmt::format("{}, {}s {} to {}", counted(rows.numbers.size(), "sample"), row,
                                                   rows.numbers.front(), rows.numbers.back())));
  if (rows.comments > 0)
    recognised.push_back(decision(
        FindingKind::rows_read, fmt::format("{} among the rows {} passed over", counted(rows.comments, "comment line"),
                                            rows.comments == 1 ? "is" : "are")));
  if (!timed) return;
  if (!record.has_time()) {
    recognised.push_back({.kind = FindingKind::no_time_column});
    return;
  }
  double const interval = record.layout.dt_s.value_or((record.time_s.back() - record.time_s.front()) /
                                                      static_cast<double>(record.time_s.size() - 1));
  auto const source = of_header            ? std::string("as the header of the file has it (Delta_X)")
                      : record.layout.dt_s ? fmt::format("as asked for (--dt {})", *record.layout.dt_s)
                                           : "on average over the time column";
  recognised.push_back(
      decision(FindingKind::time_scale,
               fmt::format("sampling interval {:.6g} s ({:.6g} Hz), {}", interval, 1.0 / interval, source),
               record.layout.dt_s && !of_header ? "--dt" : ""));
}

// The time of a sample in a file without a time column. Time 0 is at the file's first row, even if --rows leaves that
// row out.
double time_of_row(std::size_t sample, ReadOptions const& options) {
  return static_cast<double>(sample + options.rows.value_or(RowRange{}).first - 1) * *options.dt_s;
}

// Leaves out the rows in which a channel has no value, or fills them by linear interpolation. Always leaves out rows
// without a time or a cycle number, and rows before a channel's first value or after its last. Returns the index that
// each kept row had among all rows.
std::vector<std::size_t> settle_missing(Rows& rows, MissingValues missing) {
  auto const count = rows.numbers.size();
  std::vector<std::size_t> places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  if (missing == MissingValues::refused) return places;
  std::vector<double> const* time = nullptr;
  for (auto const& raw : rows.channels)
    if (raw.channel == Channel::time) time = &raw.values;
  std::vector<bool> has_all(count, true), is_kept(count, true);
  for (auto const& raw : rows.channels)
    for (std::size_t i = 0; i < count; ++i) has_all[i] = has_all[i] && std::isfinite(raw.values[i]);
  std::size_t filled = 0, left_out = 0, longest_gap = 0, gap = 0;
  for (auto& raw : rows.channels) {
    std::size_t before = count;  // the last row with a value
    for (std::size_t i = 0; i < count; ++i) {
      if (time != nullptr && !std::isfinite((*time)[i])) {
        is_kept[i] = false;
        continue;
      }
      if (!std::isfinite(raw.values[i])) {
        bool const may_be_filled = raw.channel != Channel::cycle;
        if (missing == MissingValues::left_out || !may_be_filled) is_kept[i] = false;
        continue;
      }
      for (std::size_t k = before == count ? 0 : before + 1; k < i; ++k) {
        if (before == count) is_kept[k] = false;
        if (!is_kept[k]) continue;
        auto const at = [&](std::size_t row) { return time != nullptr ? (*time)[row] : static_cast<double>(row); };
        double const share = (at(k) - at(before)) / (at(i) - at(before));
        raw.values[k] = raw.values[before] + share * (raw.values[i] - raw.values[before]);
      }
      before = i;
    }
    for (std::size_t k = before == count ? 0 : before + 1; k < count; ++k) is_kept[k] = false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    gap = has_all[i] ? 0 : gap + 1;
    longest_gap = std::max(longest_gap, gap);
    left_out += is_kept[i] ? 0u : 1u;
    filled += is_kept[i] && !has_all[i] ? 1u : 0u;
  }
  std::size_t to = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_kept[i]) continue;
    for (auto& raw : rows.channels) raw.values[to] = raw.values[i];
    places[to] = i;
    rows.numbers[to++] = rows.numbers[i];
  }
  for (auto& raw : rows.channels) raw.values.resize(to);
  rows.numbers.resize(to);
  places.resize(to);
  auto const option = missing == MissingValues::left_out ? "leave-out" : "interpolate";
  auto text =
      filled + left_out == 0
          ? std::string("no row lacks a value")
          : fmt::format("{} of {} rows lack a value, at most {} in a row: ", filled + left_out, count, longest_gap);
  if (left_out > 0) text += fmt::format("{} left out", left_out);
  if (filled > 0) text += fmt::format("{}{} filled by interpolation", left_out > 0 ? ", " : "", filled);
  rows.recognised.push_back(
      decision(FindingKind::rows_read, fmt::format("{} (--missing {})", text, option), "--missing"));
  return places;
}

void cut_time(Rows& rows, std::vector<std::size_t>& places, Columns const& columns, ReadOptions const& options,
              std::string const& place, std::optional<FirstStamp> const& origin, std::vector<Complaint>& complaints,
              Wanted wanted) {
  if (!options.from_s && !options.to_s) return;
  std::vector<double> time_s;
  for (auto const& raw : rows.channels)
    if (raw.channel == Channel::time) {
      time_s = raw.values;
      for (auto& t : time_s) t *= columns.channels.at(Channel::time).in_record_units();
    }
  if (origin && rows.origin_s && origin->dated == rows.dated)
    for (auto& t : time_s) t += *rows.origin_s - origin->since_s;
  if (time_s.empty() && options.dt_s)
    for (auto const i : places) time_s.push_back(time_of_row(i, options));
  std::string_view const dashes = wanted.force || wanted.part ? "--" : "--motion-";
  auto const of = rows.numbers.size();
  auto const span = span_of_time(time_s, options, place, complaints, dashes);
  if (!span) return;
  for (auto& raw : rows.channels) keep(*span, raw.values);
  keep(*span, rows.numbers);
  keep(*span, places);
  describe_span(*span, of, options, rows.recognised, dashes);
}

void check_range(Rows const& rows, RowRange const& range, std::vector<Complaint>& complaints) {
  if (range.first <= rows.rows_in_file && range.last.value_or(rows.rows_in_file) <= rows.rows_in_file) return;
  complaints.push_back({"--rows",
                        fmt::format("'{}', but there {} {}", rows_text(range), rows.rows_in_file == 1 ? "is" : "are",
                                    counted(rows.rows_in_file, "row")),
                        fmt::format("1 to {}", rows.rows_in_file),
                        {}});
}

void check_interval(std::string const& file, ReadOptions const& options, Header const& header, Columns const& columns,
                    std::vector<Complaint>& complaints) {
  if (!options.dt_s) return;
  if (!(*options.dt_s >= 1e-9 && *options.dt_s <= 1e6))
    complaints.push_back({"--dt", fmt::format("{}", *options.dt_s), "a positive number of seconds, 1e-9 to 1e6", {}});
  if (auto const time = columns.channels.find(Channel::time); time != columns.channels.end())
    complaints.push_back(
        {file,
         fmt::format("--dt {} is given, but {} is the time", *options.dt_s, column_text(time->second.index, header)),
         "--dt for a file without a time column", "leave --dt out, or leave the column out with --columns time=none"});
}

ReadOptions resolved_layout(Columns const& columns, Header const& header, ReadOptions const& options,
                            std::optional<std::string> const& sheet) {
  ReadOptions layout = options;
  layout.units.clear();
  layout.scales.clear();
  layout.sheet = sheet;
  layout.test.reset();
  for (auto const& [channel, column] : columns.channels) {
    layout.columns[channel] = column_key(column.index, header);
    if (column.unit && channel != Channel::cycle) layout.units[channel] = column.unit->symbol;
    if (column.scale != 1.0) layout.scales[channel] = fmt::format("{}", column.scale);
  }
  return layout;
}

std::string exchange_advice(Columns const& columns, Header const& header) {
  auto const& disp = columns.channels.at(Channel::disp);
  auto const& force = columns.channels.at(Channel::force);
  return fmt::format("--columns disp={},force={} --units disp={},force={}, with the units these columns have",
                     option_key(force.index, header), option_key(disp.index, header), disp.unit->symbol,
                     force.unit->symbol);
}

void store_channels(Rows& rows, Columns const& columns, std::span<std::size_t const> places, TestRecord& record) {
  for (auto& raw : rows.channels) {
    double const factor = columns.channels.at(raw.channel).in_record_units();
    for (double& value : raw.values) value *= factor;
    values_of(record, raw.channel) = std::move(raw.values);
  }
  if (record.layout.dt_s)
    for (auto const i : places) record.time_s.push_back(time_of_row(i, record.layout));
  if (record.layout.half_cycles && !record.force_kN.empty())
    record.recognised.push_back({.kind = FindingKind::half_cycles_count, .words = {{"option", "--half-cycles"}}});
  if (!record.layout.flip_force || record.force_kN.empty()) return;
  for (double& value : record.force_kN) value = -value;
  record.recognised.push_back({.kind = FindingKind::force_flipped, .words = {{"option", "--flip-force"}}});
}

}  // namespace

RecordPart read_channels(Tests const& tests, Table const& table, TestRecord record, ReadOptions const& asked,
                         Wanted wanted, std::optional<FirstStamp> const& origin) {
  auto const& place = table.place();
  auto const columns = recognise_columns(place, table.header(), table.columns(), asked, wanted);
  auto options = asked;
  bool const of_header = table.header().interval_s && !asked.dt_s && wanted.time &&
                         !asked.columns.contains(Channel::time) && !columns.channels.contains(Channel::time);
  if (of_header) options.dt_s = table.header().interval_s;
  auto complaints = columns.complaints;
  table.check(complaints);
  check_interval(place, options, table.header(), columns, complaints);
  auto const range = options.rows.value_or(RowRange{});
  auto const before = complaints.size();
  auto rows = table.read(columns.channels,
                         {.range = range,
                          .skip_footer = options.skip_footer,
                          .date_order = options.date_order,
                          .missing = options.missing},
                         complaints);
  if (auto const cycle = columns.channels.find(Channel::cycle); cycle != columns.channels.end())
    for (auto& complaint : std::span(complaints).subspan(before))
      if (complaint.found.find(column_text(cycle->second.index, table.header())) != std::string::npos)
        complaint.advice += "; --columns cycle=none leaves the numbers of the cycles out";
  std::vector<std::size_t> places;
  if (complaints.empty()) places = settle_missing(rows, options.missing);
  if (options.rows && complaints.empty()) check_range(rows, range, complaints);
  if (complaints.empty()) cut_time(rows, places, columns, options, place, origin, complaints, wanted);
  if (rows.numbers.size() < least_samples && complaints.empty())
    complaints.push_back({place, counted(rows.numbers.size(), "sample"), fmt::format("{} or more", least_samples), {}});
  for (auto const& raw : rows.channels)
    check_channel(table.place_of(columns.channels.at(raw.channel).index), raw, rows.numbers, complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));

  RecordPart part{.record = std::move(record), .origin_s = rows.origin_s, .dated = rows.dated};
  auto& part_record = part.record;
  part_record.layout = resolved_layout(columns, table.header(), options, tests.sheet);
  part_record.device_facts = table.device_facts();
  for (auto const& each : tests.device_facts)
    if (std::ranges::find(part_record.device_facts, each.first, &DeviceFacts::value_type::first) ==
        part_record.device_facts.end())
      part_record.device_facts.push_back(each);
  append(part_record.recognised, tests.recognised);
  append(part_record.recognised, table.recognised());
  append(part_record.recognised, columns.recognised);
  append(part_record.warnings, columns.warnings);
  store_channels(rows, columns, places, part_record);
  describe_part(rows, range, part_record.recognised);
  append(part_record.recognised, rows.recognised);
  describe_rows(rows, table.header(), part_record, wanted.time, of_header, part_record.recognised);
  if (wanted.disp && wanted.force) part.exchange_advice = exchange_advice(columns, table.header());
  return part;
}

}  // namespace isolaw::data
