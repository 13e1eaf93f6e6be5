// Joins the parts of reading: the format and its tables, columns, rows, then what the values tell. Problems are
// collected as far as reading can go on; the first problem that hides the rest is thrown at once.
#include "isolaw/data/read.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/checks.hpp"
#include "isolaw/data/columns.hpp"
#include "isolaw/data/dialect.hpp"
#include "isolaw/data/json_table.hpp"
#include "isolaw/data/mat_table.hpp"
#include "isolaw/data/record_parts.hpp"
#include "isolaw/data/sheet_choice.hpp"
#include "isolaw/data/table.hpp"
#include "isolaw/data/text.hpp"
#include "isolaw/data/text_table.hpp"
#include "isolaw/data/workbook.hpp"

namespace isolaw::data {
namespace {

// --- sentences ------------------------------------------------------------------------------------------------------

void describe_part(Rows const& rows, RowRange const& range, std::vector<std::string>& recognised) {
  if (range == RowRange{}) return;
  recognised.push_back(fmt::format("rows {} to {} of {} are read (--rows {})", range.first,
                                   range.last.value_or(rows.of), rows.of, rows_text(range)));
}

void describe_rows(Rows const& rows, std::string_view row, TestRecord const& record, bool timed,
                   std::vector<std::string>& recognised) {
  recognised.push_back(fmt::format("{}, {}s {} to {}", counted(rows.numbers.size(), "sample"), row,
                                   rows.numbers.front(), rows.numbers.back()));
  if (rows.comments > 0)
    recognised.push_back(fmt::format("{} among the rows {} passed over", counted(rows.comments, "comment line"),
                                     rows.comments == 1 ? "is" : "are"));
  if (!timed) return;
  if (!record.has_time()) {
    recognised.push_back("no time column: rate-dependent laws need --dt SECONDS, the sampling interval");
    return;
  }
  double const mean = (record.time_s.back() - record.time_s.front()) / static_cast<double>(record.time_s.size() - 1);
  recognised.push_back(fmt::format("sampling interval {:.6g} s ({:.6g} Hz), {}", mean, 1.0 / mean,
                                   record.layout.dt_s ? fmt::format("as asked for (--dt {})", *record.layout.dt_s)
                                                      : "on average over the time column"));
}

// Of a file without a time column: counted from the first row of the file, whatever part of it is read.
double time_of_row(std::size_t sample, ReadOptions const& options) {
  return static_cast<double>(sample + options.rows.value_or(RowRange{}).first - 1) * *options.dt_s;
}

// What the times asked for count from, where that is the first time stamp of another file.
struct FirstStamp {
  double since_s = 0.0;
  bool dated = false;
};

// Takes off what lies outside the time asked for.
std::optional<Span> cut_time(Rows& rows, Columns const& columns, ReadOptions const& options, std::string const& place,
                             std::optional<FirstStamp> const& origin, std::vector<Complaint>& complaints,
                             Wanted wanted) {
  if (!options.from_s && !options.to_s) return Span{0, rows.numbers.size()};
  std::vector<double> time_s;
  for (auto const& raw : rows.channels)
    if (raw.channel == Channel::time) {
      time_s = raw.values;
      for (auto& t : time_s) t *= columns.channels.at(Channel::time).unit->in_record_units;
    }
  if (origin && rows.origin_s && origin->dated == rows.dated)
    for (auto& t : time_s) t += *rows.origin_s - origin->since_s;
  if (time_s.empty() && options.dt_s)
    for (std::size_t i = 0; i < rows.numbers.size(); ++i) time_s.push_back(time_of_row(i, options));
  std::string_view const dashes = wanted.force || wanted.part ? "--" : "--motion-";
  auto const of = rows.numbers.size();
  auto const span = span_of_time(time_s, options, place, complaints, dashes);
  if (!span) return span;
  for (auto& raw : rows.channels) keep(*span, raw.values);
  keep(*span, rows.numbers);
  describe_span(*span, of, options, rows.recognised, dashes);
  return span;
}

void check_range(Rows const& rows, RowRange const& range, std::vector<Complaint>& complaints) {
  if (range.first <= rows.of && range.last.value_or(rows.of) <= rows.of) return;
  complaints.push_back(
      {"--rows",
       fmt::format("'{}', but there {} {}", rows_text(range), rows.of == 1 ? "is" : "are", counted(rows.of, "row")),
       fmt::format("1 to {}", rows.of),
       {}});
}

// --- assembly -------------------------------------------------------------------------------------------------------

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
  layout.sheet = sheet;
  layout.test.reset();
  for (auto const& [channel, column] : columns.channels) {
    layout.columns[channel] = column_key(column.index, header);
    if (column.unit) layout.units[channel] = column.unit->symbol;
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

void store_channels(Rows& rows, Columns const& columns, std::size_t skipped, TestRecord& record) {
  for (auto& raw : rows.channels) {
    double const factor = columns.channels.at(raw.channel).unit->in_record_units;
    for (double& value : raw.values) value *= factor;
    values_of(record, raw.channel) = std::move(raw.values);
  }
  if (record.layout.dt_s)
    for (std::size_t i = 0; i < rows.numbers.size(); ++i)
      record.time_s.push_back(time_of_row(i + skipped, record.layout));
  if (!record.layout.flip_force || record.force_kN.empty()) return;
  for (double& value : record.force_kN) value = -value;
  record.recognised.push_back("the force is multiplied by -1, as asked for (--flip-force)");
}

// --- formats --------------------------------------------------------------------------------------------------------

// Told by the first bytes: names of files change more easily.
Tests open_tests(std::string_view bytes, std::string const& file, ReadOptions const& options,
                 Wanted wanted = Wanted::test()) {
  auto const& sheet = options.sheet;
  if (is_zip(bytes)) return workbook_tests(bytes, file, sheet);
  if (is_mat(bytes)) return mat_tests(bytes, file, sheet);
  if (is_json(bytes)) return json_tests(bytes, file, sheet);
  auto tests = text_tests(
      bytes, file, {.thousands = options.thousands, .one_column = wanted.part || (!wanted.force && options.dt_s)});
  if (sheet)
    throw Error(Complaint{.where = "--sheet",
                          .found = fmt::format("{}, but {} is delimited text", in_quotes(*sheet), file),
                          .allowed = "a sheet of a workbook, a struct of a .mat file, a key of JSON",
                          .advice = "leave --sheet out"});
  return tests;
}

// Options that do nothing in a file of its kind, as they are typed.
std::vector<std::string> idle_options(std::string_view bytes, ReadOptions const& options) {
  bool const numbers = is_mat(bytes) || is_json(bytes);
  if (!numbers && !is_zip(bytes)) return {};
  std::vector<std::string> found;
  if (options.thousands) found.push_back(fmt::format("--thousands {}", digit_group(*options.thousands).typed));
  if (numbers && options.skip_footer) found.emplace_back("--footer skip");
  if (numbers && options.date_order)
    found.push_back(fmt::format("--date-order {}", date_order_word(*options.date_order)));
  return found;
}

void refuse_idle(std::vector<std::string> const& idle, std::string const& file) {
  std::vector<Complaint> complaints;
  for (auto const& option : idle)
    complaints.push_back({.where = option,
                          .found = file + " holds numbers, not their text",
                          .allowed = "delimited text",
                          .advice = "leave it out, or give it to other files alone"});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

// A name for the command line, quoted where a shell would take it apart.
std::string typed(std::string const& name) {
  auto const plain = name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.-");
  return plain == std::string::npos ? name : "\"" + printable(name) + "\"";
}

bool columns_are_told(ReadOptions const& options, Wanted wanted) {
  return options.columns.contains(Channel::disp) && (!wanted.force || options.columns.contains(Channel::force));
}

void require_one_sheet(Tests const& tests, std::string const& file, ReadOptions const& options, Wanted wanted) {
  bool const columns_told = columns_are_told(options, wanted);
  bool const by_name = tests.tables.front()->header().by_name;
  auto sheets = tests.sheets;
  if (columns_told)  // which need no names
    sheets.insert(sheets.end(), tests.sheets_passed_over.begin(), tests.sheets_passed_over.end());
  if (options.sheet || sheets.size() < 2 || (by_name && columns_told)) return;
  throw Error(Complaint{
      .where = file,
      .found = fmt::format("{} may each be the test", sheet_list(sheets, "tables")),
      .allowed = "one of them",
      .advice = fmt::format("--sheet {}, or isolaw init, which makes a device of each", typed(sheets.front()))});
}

bool have_titles(Tests const& tests) {
  return !tests.tables.front()->title().empty();
}

// "lines 2, 206", or the titles that tests of a list have.
std::string starts_of(Tests const& tests) {
  constexpr std::size_t shown = 10;
  std::vector<std::string> texts;
  for (auto const& table : tests.tables)
    if (texts.size() < shown) texts.push_back(have_titles(tests) ? table->title() : std::to_string(table->start()));
  return fmt::format("{}{}{}",
                     have_titles(tests) ? std::string() : fmt::format("{}s ", tests.tables.front()->header().row),
                     fmt::join(texts, ", "),
                     tests.tables.size() > shown ? fmt::format(" and {} more", tests.tables.size() - shown) : "");
}

// The tests to read, as positions; throws Error where nothing says which of several.
std::vector<std::size_t> chosen_tests(Tests const& tests, std::string const& file, ReadOptions const& options) {
  auto const count = tests.tables.size();
  auto const& place = have_titles(tests) ? file : tests.tables.front()->place();
  if (!options.test && count > 1)
    throw Error(Complaint{.where = place,
                          .found = fmt::format("{} tests in one file: {}{}", count,
                                               have_titles(tests) ? "" : "they start at ", starts_of(tests)),
                          .allowed = "one of them, or all as one history",
                          .advice = "--test all, or --test 2, or isolaw init, which makes a device of each"});
  std::vector<std::size_t> chosen;
  if (!options.test || parse_test(*options.test) == "all") {
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(i);
    return chosen;
  }
  auto const number = std::stoul(*options.test);
  if (number > count)
    throw Error(Complaint{
        .where = place,
        .found = fmt::format("no test {}", number),
        .allowed = count == 1 ? "1, the only one"
                              : fmt::format("1 to {}{} {}", count, have_titles(tests) ? ":" : ", at", starts_of(tests)),
        .advice = "--test 1"});
  return {number - 1};
}

// The channels of one table, before anything is asked of them together.
RecordPart read_channels(Tests const& tests, Table const& table, TestRecord record, ReadOptions const& options,
                         Wanted wanted, std::optional<FirstStamp> const& origin = {}) {
  auto const& place = table.place();
  auto const columns = recognise_columns(place, table.header(), table.columns(), options, wanted);
  auto complaints = columns.complaints;
  table.check(complaints);
  check_interval(place, options, table.header(), columns, complaints);
  auto const range = options.rows.value_or(RowRange{});
  auto rows = table.read(
      columns, {.range = range, .skip_footer = options.skip_footer, .date_order = options.date_order}, complaints);
  if (options.rows && complaints.empty()) check_range(rows, range, complaints);
  std::size_t skipped = 0;
  if (complaints.empty())
    if (auto const span = cut_time(rows, columns, options, place, origin, complaints, wanted)) skipped = span->first;
  if (rows.numbers.size() < least_samples && complaints.empty())
    complaints.push_back({place, counted(rows.numbers.size(), "sample"), fmt::format("{} or more", least_samples), {}});
  for (auto const& raw : rows.channels)
    check_channel(table.place_of(columns.channels.at(raw.channel).index), raw, rows.numbers, complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));

  RecordPart part{.record = std::move(record), .origin_s = rows.origin_s, .dated = rows.dated};
  auto& made = part.record;
  made.layout = resolved_layout(columns, table.header(), options, tests.sheet);
  made.particulars = table.particulars();
  for (auto const& each : tests.particulars)
    if (std::ranges::find(made.particulars, each.first, &ParticularList::value_type::first) == made.particulars.end())
      made.particulars.push_back(each);
  append(made.recognised, tests.recognised);
  append(made.recognised, table.recognised());
  append(made.recognised, columns.recognised);
  append(made.warnings, columns.warnings);
  store_channels(rows, columns, skipped, made);
  describe_part(rows, range, made.recognised);
  append(made.recognised, rows.recognised);
  describe_rows(rows, table.header().row, made, wanted.time, made.recognised);
  if (wanted.disp && wanted.force) part.exchange_advice = exchange_advice(columns, table.header());
  return part;
}

// What the two channels of a test say together.
TestRecord finished(TestRecord record, ReadOptions const& options, std::string const& advice) {
  std::vector<Complaint> complaints;
  repair(record, options.corrections);
  record.faults = signal_faults(record.disp_mm, record.force_kN, record.time_s);
  correct(record, options.corrections);
  check_physics(record, advice, complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));
  add_warnings(record);
  return record;
}

TestRecord read_table(Tests const& tests, Table const& table, TestRecord record, ReadOptions const& options,
                      Wanted wanted) {
  auto part = read_channels(tests, table, std::move(record), options, wanted);
  if (!wanted.force) return std::move(part.record);
  return finished(std::move(part.record), options, part.exchange_advice);
}

TestRecord read_tests(std::string_view bytes, std::string const& name, ReadOptions const& options, Wanted wanted) {
  TestRecord start;
  start.file = name;
  start.sha256 = sha256(bytes);
  refuse_idle(idle_options(bytes, options), name);
  auto const tests = open_tests(bytes, name, options, wanted);
  require_one_sheet(tests, name, options, wanted);
  std::optional<TestRecord> history;
  auto const chosen = chosen_tests(tests, name, options);
  for (auto const i : chosen) {
    auto record = read_table(tests, *tests.tables[i], start, options, wanted);
    if (!history)
      history = std::move(record);
    else
      continue_with(*history, record, fmt::format("test {}", i + 1));
  }
  history->sha256 = start.sha256;
  if (tests.tables.size() > 1) {
    history->layout.test = parse_test(*options.test);
    history->recognised.push_back(
        fmt::format("{} tests in the file, {} is read", tests.tables.size(),
                    chosen.size() > 1 ? "one history of all" : fmt::format("test {}", chosen.front() + 1)));
  }
  return *std::move(history);
}

// --- channels in several files -------------------------------------------------------------------------------------

// One of the files that the channels of a test are in, opened.
struct Opened {
  std::unique_ptr<std::string> bytes;  // which the tables look into
  TestRecord start;
  Tests tests;
  ReadOptions options;
  Wanted wanted;
  bool chooses_sheet = false, chooses_test = false;  // it has several, of which --sheet or --test names one

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

  // What its samples have of a time: nothing, an interval or seconds, or stamps.
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

// The other files that `options` name channels of, with what is asked of each.
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
    auto [place, made] = others.try_emplace(split->file, shared);
    if (made) place->second.columns.clear();
    place->second.columns[channel] = split->column;
  }
  std::erase_if(options.columns, [](auto const& entry) { return file_column(entry.second).has_value(); });
  return others;
}

TestRecord read_joined(std::filesystem::path const& file, ReadOptions options,
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
    if (more.dt_s || untimed) more.columns[Channel::time] = "none";  // one sampling interval, for both
    auto const time_unit = more.units.extract(Channel::time);        // where the file states none
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
  // What does something in one of the files may be given.
  auto const idle_in = [&](Opened const& each) { return idle_options(*each.bytes, asked); };
  auto idle = idle_in(first);
  for (auto const& more : rest)
    std::erase_if(idle, [&](auto const& option) { return std::ranges::count(idle_in(more), option) == 0; });
  refuse_idle(idle, first.start.file);
  // A choice that no file needs is taken, or refused, as of one file.
  if (asked.sheet && !first.chooses_sheet && !sheet_of_another) {
    first.options.sheet = asked.sheet;
    first.open(file);
  }
  if (asked.test && !first.chooses_test && !test_of_another) first.options.test = asked.test;
  // Each file's own time tells what lies outside, unless rows are joined one by one.
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
    for (auto* values : {&record.time_s, &record.disp_mm, &record.force_kN, &record.load_kN}) keep(*span, *values);
  }
  return finished(std::move(record), asked, "the columns of the two files the other way round");
}

// --- motions --------------------------------------------------------------------------------------------------------

// The line among the first ones of a text that speaks of acceleration, as files of ground motions do.
std::optional<std::string> line_about_acceleration(std::string_view bytes) {
  constexpr std::size_t head = 4000, longest = 100;
  if (is_zip(bytes) || is_mat(bytes)) return std::nullopt;
  std::string_view left = bytes.substr(0, head);
  while (!left.empty()) {
    auto const line = left.substr(0, left.find_first_of("\r\n"));
    left.remove_prefix(std::min(left.size(), line.size() + 1));
    auto const small = lower(without_accents(line));
    for (auto const* word : {"acceler", "beschleunigung", "aceler"})
      if (small.find(word) != std::string::npos) return std::string(trimmed(line.substr(0, longest)));
  }
  return std::nullopt;
}

constexpr std::string_view displacement_needed =
    "the displacement of the device, one face against the other, over time";

}  // namespace

std::string parse_test(std::string_view text) {
  auto const word = lower(trimmed(text));
  if (word == "all") return word;
  auto const number = number_in<std::size_t>(word);
  if (number && *number >= 1 && *number <= most_tests) return std::to_string(*number);
  throw Error(Complaint{.where = "--test",
                        .found = in_quotes(text),
                        .allowed = fmt::format("all, or the number of a test, from 1 to {}", most_tests)});
}

bool is_record_name(std::string_view file) {
  auto const small = lower(file);
  return std::ranges::any_of(record_extensions, [&](auto ending) { return small.ends_with(ending); });
}

std::optional<FileColumn> file_column(std::string_view text) {
  for (auto at = text.find(':'); at != std::string_view::npos; at = text.find(':', at + 1)) {
    auto const file = trimmed(text.substr(0, at)), column = trimmed(text.substr(at + 1));
    if (is_record_name(file) && !column.empty()) return FileColumn{std::string(file), std::string(column)};
  }
  return std::nullopt;
}

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

TestRecord read_record(std::filesystem::path const& file, ReadOptions const& options) {
  auto own = options;
  if (auto const others = other_files(file, own); !others.empty()) return read_joined(file, std::move(own), others);
  return read_record_text(load_text(file), file.generic_string(), own);
}

TestRecord read_record_text(std::string_view bytes, std::string const& name, ReadOptions const& options) {
  return read_tests(bytes, name, options, Wanted::test());
}

TestRecord read_motion(std::filesystem::path const& file, ReadOptions const& options) {
  return read_motion_text(load_text(file), file.generic_string(), options);
}

TestRecord read_motion_text(std::string_view bytes, std::string const& name, ReadOptions const& options) {
  auto const acceleration = line_about_acceleration(bytes);
  try {
    auto motion = read_tests(bytes, name, options, Wanted::motion());
    // A column of that name is one of displacements, whatever stands beside it.
    if (acceleration && options.columns.contains(Channel::disp))
      motion.warnings.push_back(fmt::format("the file speaks of acceleration ({}): what is read must be {}",
                                            in_quotes(*acceleration), displacement_needed));
    return motion;
  } catch (Error const& error) {
    if (!acceleration) throw;
    std::vector<Complaint> complaints{
        {.where = name,
         .found = fmt::format("a record of acceleration ({})", in_quotes(*acceleration)),
         .allowed = std::string(displacement_needed),
         .advice =
             "the response of the isolated structure to it, from an analysis with this law; or --columns disp=..., where the file holds that displacement too"}};
    if (options.columns.contains(Channel::disp))
      complaints.insert(complaints.end(), error.complaints().begin(), error.complaints().end());
    throw Error(std::move(complaints));
  }
}

TestRecord read_compression(std::filesystem::path const& file, ReadOptions const& options) {
  return read_tests(load_text(file), file.generic_string(), options, Wanted::compression());
}

TestRecord record_of_values(std::string const& name, Values values) {
  std::vector<Complaint> complaints;
  std::vector<RawChannel> channels;
  std::string bytes;
  auto const samples = values.disp_mm.size();
  auto const add = [&](Channel channel, std::string_view unit, std::string const& text, std::vector<double>& given) {
    if (given.empty() && channel != Channel::disp) return;
    if (given.size() != samples)
      complaints.push_back(
          {name, fmt::format("{} values of {}, {} of disp_mm", given.size(), text, samples), "as many of each", {}});
    auto const odd = std::ranges::find_if_not(given, [](double value) { return std::isfinite(value); });
    if (odd != given.end())
      complaints.push_back({fmt::format("{}:{}", name, odd - given.begin() + 1),
                            fmt::format("{} is {}", text, *odd),
                            "finite numbers",
                            {}});
    bytes.append(reinterpret_cast<char const*>(given.data()), given.size() * sizeof(double));
    channels.push_back({.channel = channel, .column = text, .unit = std::string(unit), .values = std::move(given)});
  };
  add(Channel::disp, "mm", "disp_mm", values.disp_mm);
  add(Channel::force, "kN", "force_kN", values.force_kN);
  add(Channel::time, "s", "time_s", values.time_s);
  add(Channel::load, "kN", "load_kN", values.load_kN);
  if (samples < least_samples && complaints.empty())
    complaints.push_back({name, counted(samples, "sample"), fmt::format("{} or more", least_samples), {}});
  if (!complaints.empty()) throw Error(std::move(complaints));
  std::vector<std::size_t> numbers(samples);
  std::iota(numbers.begin(), numbers.end(), std::size_t{1});
  for (auto const& channel : channels) check_channel(name, channel, numbers, complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));

  TestRecord record;
  record.file = name;
  record.sha256 = sha256(bytes);
  record.recognised.push_back(fmt::format("{} samples given as values, in mm, kN and s", samples));
  for (auto& channel : channels) values_of(record, channel.channel) = std::move(channel.values);
  if (record.force_kN.empty()) return record;
  record.faults = signal_faults(record.disp_mm, record.force_kN, record.time_s);
  check_physics(record, "displacement and force the other way round", complaints);
  if (!complaints.empty()) throw Error(std::move(complaints));
  add_warnings(record);
  return record;
}

std::vector<TestChoice> list_tests(std::filesystem::path const& file, ReadOptions const& options) {
  auto const bytes = load_text(file);
  auto const name = file.generic_string();
  auto const tests = open_tests(bytes, name, options);
  auto const asked = options.test ? std::optional(parse_test(*options.test)) : std::nullopt;
  std::vector<TestChoice> choices;
  auto const add = [&](Tests const& found) {
    for (std::size_t i = 0; i < found.tables.size(); ++i) {
      auto const& table = *found.tables[i];
      auto const test = asked.value_or(std::to_string(i + 1));
      if (test == std::to_string(i + 1) || (i == 0 && test == "all"))
        choices.push_back({.sheet = found.sheet,
                           .test = found.tables.size() == 1 ? std::nullopt : std::optional(test),
                           .place = fmt::format("{}:{}", table.place(), table.start())});
    }
  };
  if (options.sheet || tests.sheets.size() < 2 ||
      (columns_are_told(options, Wanted::test()) && tests.tables.front()->header().by_name))
    add(tests);
  else
    for (auto const& sheet : tests.sheets) {
      auto of_sheet = options;
      of_sheet.sheet = sheet;
      add(open_tests(bytes, name, of_sheet));
    }
  if (!choices.empty()) choices.front().passed_over = tests.sheets_passed_over;
  return choices;
}

void continue_with(TestRecord& history, TestRecord const& next, std::string const& label) {
  if (next.has_time() != history.has_time())
    throw Error(Complaint{.where = label,
                          .found = "only some of the device's files have a time channel",
                          .allowed = "all of them or none",
                          .advice = "--dt SECONDS"});
  if (history.has_time()) {
    double const pause = history.time_s.back() - history.time_s[history.time_s.size() - 2];
    double const offset = history.time_s.back() + pause - next.time_s.front();
    for (double const t : next.time_s) history.time_s.push_back(t + offset);
  }
  auto const before = history.size();
  bool const loads = !history.load_kN.empty() && !next.load_kN.empty();
  if (!loads) history.load_kN.clear();
  auto const add = [](std::vector<double>& to, std::vector<double> const& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  add(history.disp_mm, next.disp_mm);
  add(history.force_kN, next.force_kN);
  if (loads) add(history.load_kN, next.load_kN);
  history.recognised.push_back(fmt::format("{} continues the history with {} samples", label, next.size()));
  for (auto fault : next.faults) {
    for (auto& sample : fault.samples) sample += before;
    fault.sentence = label + ": " + fault.sentence;
    history.faults.push_back(std::move(fault));
  }
  for (auto const& line : next.warnings) history.warnings.push_back(label + ": " + line);
  history.sha256 = sha256(history.sha256 + next.sha256);
}

}  // namespace isolaw::data
