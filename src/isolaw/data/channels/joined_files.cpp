#include "isolaw/data/channels/joined_files.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/channels/columns.hpp"
#include "isolaw/data/channels/table_channels.hpp"
#include "isolaw/data/channels/tests_in_file.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {
struct Opened {
  std::unique_ptr<std::string> bytes;  // on the heap, because `tests` points into them
  TestRecord start;
  Tests tests;
  ReadOptions options;
  Wanted wanted;
  bool chooses_sheet = false, chooses_test = false;  // the user chooses a sheet (test) and this file has several

  Opened(std::filesystem::path const& file, ReadOptions const& asked, Wanted what) : options(asked), wanted(what) {
    options.sheet.reset();
    open(file);
    auto const may_be =
        tests.sheets.size() + (columns_are_told(options, wanted) ? tests.sheets_passed_over.size() : 0u);
    chooses_sheet = asked.sheet && may_be > 1;
    options.sheet = asked.sheet;
    if (chooses_sheet)
      open(file);
    else
      options.sheet.reset();
    chooses_test = asked.test && tests.tables.size() > 1;
    if (!chooses_test) options.test.reset();
  }

  void open(std::filesystem::path const& file) {
    bytes = std::make_unique<std::string>(load_text(file));
    start.file = file.generic_string();
    start.sha256 = sha256(*bytes);
    tests = open_tests(*bytes, start.file, options, wanted);
  }

  Table const& table() const {
    require_one_sheet(tests, start.file, options, wanted);
    auto const chosen = chosen_tests(tests, start.file, options);
    if (chosen.size() > 1)
      throw Error(Complaint{.where = start.file,
                            .found = "several tests, and channels in another file",
                            .allowed = "one test",
                            .advice = "--test 1"});
    return *tests.tables[chosen.front()];
  }

  Columns columns() const {
    auto const& chosen = table();
    return recognise_columns(chosen.place(), chosen.header(), chosen.columns(), options, wanted);
  }
  enum class Clock { none, seconds, stamps };
  Clock clock() const {
    auto const found = columns();
    auto const time = found.channels.find(Channel::time);
    if (time == found.channels.end()) return options.dt_s ? Clock::seconds : Clock::none;
    return time->second.stamp == StampKind::none ? Clock::seconds : Clock::stamps;
  }

  RecordPart read(std::optional<FirstStamp> const& origin = {}) const {
    auto part = read_channels(tests, table(), start, options, wanted, origin);
    if (tests.tables.size() > 1) part.record.layout.test = parse_test(*options.test);
    return part;
  }
};

}  // namespace

std::map<std::string, ReadOptions> other_files(std::filesystem::path const& file, ReadOptions& options) {
  std::map<std::string, ReadOptions> others;
  auto const shared = options;
  for (auto& [channel, spec] : options.columns) {
    auto const split = file_column(spec);
    if (!split) continue;
    std::error_code none;
    if (std::filesystem::equivalent(file, split->file, none)) {
      spec = split->column;
      continue;
    }
    if (channel == Channel::time)
      throw Error(Complaint{.where = "--columns time",
                            .found = in_quotes(spec),
                            .allowed = "a column of the file itself: every file has its own time",
                            .advice = "--columns time=COLUMN"});
    auto [place, is_new] = others.try_emplace(split->file, shared);
    if (is_new) place->second.columns.clear();
    place->second.columns[channel] = split->column;
  }
  std::erase_if(options.columns, [](auto const& entry) { return file_column(entry.second).has_value(); });
  return others;
}

RecordPart read_joined(std::filesystem::path const& file, ReadOptions options,
                       std::map<std::string, ReadOptions> const& others) {
  Wanted own{.part = true};
  for (auto const& [name, more] : others) {
    own.disp = own.disp && !more.columns.contains(Channel::disp);
    own.force = own.force && !more.columns.contains(Channel::force);
    own.load = own.load && !more.columns.contains(Channel::load);
  }
  if (!own.disp && !own.force)
    throw Error(Complaint{.where = file.generic_string(),
                          .found = "displacement and force are both read from other files",
                          .allowed = "one of them from the file itself",
                          .advice = "naming the file of the displacement as the record"});
  auto const asked = options;
  Opened first(file, options, own);
  std::vector<Opened> rest;
  bool const untimed = asked.columns.contains(Channel::time) && lower(asked.columns.at(Channel::time)) == "none";
  for (auto const& [other, of_other] : others) {
    auto more = of_other;
    if (more.dt_s || untimed) more.columns[Channel::time] = "none";  // the time of this file is not read
    auto const time_unit = more.units.extract(Channel::time);        // used if this file's time column has no unit
    Wanted const wanted{.time = true,
                        .disp = more.columns.contains(Channel::disp),
                        .force = more.columns.contains(Channel::force),
                        .load = more.columns.contains(Channel::load),
                        .part = true};
    rest.emplace_back(other, more, wanted);
    auto const columns = rest.back().columns();
    auto const time = columns.channels.find(Channel::time);
    if (time_unit && time != columns.channels.end() && !time->second.unit)
      rest.back().options.units[Channel::time] = time_unit.mapped();
  }
  bool const sheet_of_another = std::ranges::any_of(rest, &Opened::chooses_sheet);
  bool const test_of_another = std::ranges::any_of(rest, &Opened::chooses_test);
  // Refuses options that have no effect in any of the files.
  auto const idle_in = [&](Opened const& each) { return idle_options(*each.bytes, asked); };
  auto idle = idle_in(first);
  for (auto const& more : rest)
    std::erase_if(idle, [&](auto const& option) { return std::ranges::count(idle_in(more), option) == 0; });
  refuse_idle(idle, first.start.file);
  // If no file has several sheets (tests), --sheet (--test) is applied to the first file. It is refused if it does not
  // fit the only sheet (test) of that file.
  if (asked.sheet && !first.chooses_sheet && !sheet_of_another) {
    first.options.sheet = asked.sheet;
    first.open(file);
  }
  if (asked.test && !first.chooses_test && !test_of_another) first.options.test = asked.test;
  // If the files are joined by time, --from and --to cut each file by its own time. If they are joined row by row,
  // these options are removed here and cut the joined record below.
  auto const clock = first.clock();
  bool const by_time = clock != Opened::Clock::none &&
                       std::ranges::all_of(rest, [&](auto const& more) { return more.clock() == clock; });
  if (!by_time) {
    first.options.from_s = first.options.to_s = std::nullopt;
    for (auto& more : rest) more.options.from_s = more.options.to_s = std::nullopt;
  }
  auto main = first.read();
  std::optional<FirstStamp> origin;
  if (main.origin_s) origin = {.since_s = *main.origin_s, .dated = main.dated};
  for (auto const& more : rest) join_channels(main, more.read(origin));
  auto& record = main.record;
  if (sheet_of_another) record.layout.sheet = asked.sheet;
  if (test_of_another) record.layout.test = parse_test(*asked.test);
  if (!by_time && (asked.from_s || asked.to_s)) {
    record.layout.from_s = asked.from_s;
    record.layout.to_s = asked.to_s;
    std::vector<Complaint> complaints;
    auto const span = span_of_time(record.time_s, asked, record.file, complaints);
    if (!complaints.empty()) throw Error(std::move(complaints));
    describe_span(*span, record.size(), asked, record.recognised);
    for (auto const channel : all_channels) keep(*span, values_of(record, channel));
  }
  main.exchange_advice = "the columns of the two files the other way round";
  return main;
}

}  // namespace isolaw::data
