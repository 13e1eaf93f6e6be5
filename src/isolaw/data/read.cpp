// Reads a record step by step. Collects problems until one of them prevents the next step, and then throws all at once.
#include "isolaw/data/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/channels/columns.hpp"
#include "isolaw/data/channels/joined_files.hpp"
#include "isolaw/data/channels/record_parts.hpp"
#include "isolaw/data/channels/table_channels.hpp"
#include "isolaw/data/channels/tests_in_file.hpp"
#include "isolaw/data/channels/value_checks.hpp"
#include "isolaw/data/checks.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/mat_table.hpp"
#include "isolaw/data/files/table.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/data/files/workbook.hpp"
#include "isolaw/data/signals/corrections.hpp"
#include "isolaw/data/signals/signal_faults.hpp"

namespace isolaw::data {
namespace {

TestRecord finished(TestRecord record, ReadOptions const& options, std::string const& advice) {
  repair(record, options.corrections);
  record.faults = signal_faults(record.disp_mm, record.force_kN, record.time_s);
  correct(record, options.corrections);
  auto const properties = cyclic_properties(record);
  if (options.checks_physics) check_physics(record, properties, advice);
  add_warnings(record, properties);
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
        decision(FindingKind::test_chosen,
                 fmt::format("{} tests in the file, {} is read", tests.tables.size(),
                             chosen.size() > 1 ? "one history of all" : fmt::format("test {}", chosen.front() + 1))));
  }
  return *std::move(history);
}

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

// Appends the channels, faults, warnings and corrections of `next`. The load is kept only if both records have it.
void append_record(TestRecord& history, TestRecord const& next, std::string const& label) {
  if (next.has_time() != history.has_time())
    throw Error(Complaint{
        .where = label,
        .found = "only some of the device's files have a time channel",
        .allowed = "all of them or none",
        .advice =
            "a lot file with a [[device.test]] table for each file, and dt = SECONDS in that of the file without time"});
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
  for (auto const channel : {&TestRecord::logged_cycle, &TestRecord::second_disp_mm})
    if (!(history.*channel).empty() && !(next.*channel).empty())
      add(history.*channel, next.*channel);
    else
      (history.*channel).clear();
  for (auto fault : next.faults) {
    for (auto& sample : fault.samples) sample += before;
    fault.finding.words.push_back({"part", label});
    history.faults.push_back(std::move(fault));
  }
  for (auto warning : next.warnings) {
    warning.words.push_back({"part", label});
    history.warnings.push_back(std::move(warning));
  }
  for (auto correction : next.corrections) {
    correction.words.push_back({"part", label});
    history.corrections.push_back(std::move(correction));
  }
  history.sha256 = sha256(history.sha256 + next.sha256);
}

// Refuses a test that has the same name or the same values as an earlier test.
void refuse_repeated(NamedTest const& test, std::span<NamedTest const> earlier) {
  for (auto const& other : earlier) {
    if (other.name == test.name)
      throw Error(Complaint{.where = test.name,
                            .found = "two tests of this name",
                            .allowed = "a name of its own for each test of a device"});
    if (other.record.disp_mm == test.record.disp_mm && other.record.force_kN == test.record.force_kN)
      throw Error(Complaint{
          .where = test.name, .found = "the same record as " + other.name, .allowed = "each test of a device once"});
  }
}

// Finds the facts about the device that the files of its tests state differently.
std::vector<Finding> disputed_facts(std::span<NamedTest const> tests) {
  std::vector<Finding> warnings;
  // For each fact, the names of the tests and the texts that they state.
  std::map<std::string, std::vector<std::pair<std::string, std::string>>> stated;
  for (auto const& test : tests)
    for (auto const& [fact, text] : test.record.device_facts) stated[fact].emplace_back(test.name, text);
  for (auto const& [fact, said] : stated) {
    auto const& first = said.front().second;
    if (std::ranges::all_of(said, [&](auto const& one) { return one.second == first; })) continue;
    std::vector<std::string> values;
    for (auto const& [test, text] : said) values.push_back(fmt::format("{} in {}", printable(text), test));
    warnings.push_back(
        {.kind = FindingKind::tests_state_differently, .words = {{"fact", fact}, {"values", joined(values)}}});
  }
  return warnings;
}

}  // namespace

TestRecord read_record(std::filesystem::path const& file, ReadOptions const& options) {
  auto own = options;
  if (auto const others = other_files(file, own); !others.empty()) {
    auto part = read_joined(file, own, others);
    return finished(std::move(part.record), own, part.exchange_advice);
  }
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
    // A file with displacements may also mention acceleration. If --columns names the displacement, isolaw only warns
    // of this.
    if (acceleration && options.columns.contains(Channel::disp))
      motion.warnings.push_back({.kind = FindingKind::about_acceleration, .words = {{"line", *acceleration}}});
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

VerticalTest read_vertical(std::filesystem::path const& file, ReadOptions const& options,
                           std::optional<LoadRange> const& loads) {
  try {
    auto record = read_tests(load_text(file), file.generic_string(), options, Wanted::compression());
    VerticalTest test{.file = std::move(record.file), .sha256 = std::move(record.sha256)};
    test.disp_mm = std::move(record.disp_mm);
    test.load_kN = std::move(record.load_kN);
    test.recognised = std::move(record.recognised);
    for (auto& warning : record.warnings) test.recognised.push_back(std::move(warning));
    test.loads = loads;
    return test;
  } catch (Error const& error) {
    auto complaints = error.complaints();
    // The advice names options of the command line, which are for shear tests. A compression test has keys of the same
    // names in the lot file, so the advice points to these.
    for (auto& complaint : complaints)
      if (complaint.advice.find("--") != std::string::npos)
        complaint.advice += ", as keys of the device's table 'vertical' in a lot file";
    throw Error(std::move(complaints));
  }
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
  record.recognised.push_back(
      decision(FindingKind::rows_read, fmt::format("{} samples given as values, in mm, kN and s", samples)));
  for (auto& channel : channels) values_of(record, channel.channel) = std::move(channel.values);
  if (record.force_kN.empty()) return record;
  return finished(std::move(record), {}, "displacement and force the other way round");
}

void continue_with(TestRecord& history, TestRecord const& next, std::string const& label) {
  auto const corrections = history.corrections.size();
  append_record(history, next, label);
  history.recognised.push_back(
      decision(FindingKind::test_chosen, fmt::format("{} continues the history with {} samples", label, next.size())));
  for (std::size_t i = corrections; i < history.corrections.size(); ++i)
    history.recognised.push_back(history.corrections[i]);
}

TestRecord record_of_tests(std::vector<NamedTest> tests) {
  if (tests.size() == 1) return std::move(tests.front().record);
  for (auto const& test : tests)
    if (!test.record.starts.empty())
      throw Error(
          Complaint{.where = test.name, .found = "a record of several tests", .allowed = "records of one test each"});
  for (std::size_t t = 1; t < tests.size(); ++t) refuse_repeated(tests[t], std::span(tests).first(t));
  auto const about_facts = disputed_facts(tests);
  bool const some_loads = std::ranges::any_of(tests, [](auto const& test) { return !test.record.load_kN.empty(); });
  TestRecord record = std::move(tests.front().record);
  auto const& first = tests.front().name;
  record.starts = {0};
  record.tests = {{.name = first, .file = record.file, .sha256 = record.sha256}};
  for (auto& fault : record.faults) fault.finding.words.push_back({"part", first});
  for (auto* findings : {&record.warnings, &record.corrections, &record.recognised})
    for (auto& finding : *findings) finding.words.push_back({"part", first});
  for (std::size_t t = 1; t < tests.size(); ++t) {
    auto& test = tests[t];
    auto const start = record.size();
    append_record(record, test.record, test.name);
    record.starts.push_back(start);
    record.tests.push_back({.name = test.name, .file = test.record.file, .sha256 = test.record.sha256});
    for (auto& line : test.record.recognised) {
      line.words.push_back({"part", test.name});
      record.recognised.push_back(std::move(line));
    }
  }
  record.warnings.insert(record.warnings.end(), about_facts.begin(), about_facts.end());
  std::vector<std::string> names;
  for (auto const& test : record.tests) names.push_back(test.name);
  record.recognised.push_back(decision(
      FindingKind::test_chosen,
      fmt::format(
          "{} tests of one device: {}; they share the parameters of each law, which starts at rest in each test",
          names.size(), joined(names))));
  if (some_loads && record.load_kN.empty())
    record.recognised.push_back(decision(FindingKind::columns_unused,
                                         "the vertical load is left out, because not every test has one", "--columns"));
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

}  // namespace isolaw::data
