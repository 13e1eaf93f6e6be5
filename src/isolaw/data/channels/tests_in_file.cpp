#include "isolaw/data/channels/tests_in_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstddef>
#include <optional>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/dialect.hpp"
#include "isolaw/data/files/json_table.hpp"
#include "isolaw/data/files/mat_table.hpp"
#include "isolaw/data/files/sheet_choice.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/data/files/text_table.hpp"
#include "isolaw/data/files/workbook.hpp"

namespace isolaw::data {
namespace {

std::string typed(std::string const& name) {
  auto const plain = name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_.-");
  return plain == std::string::npos ? name : "\"" + printable(name) + "\"";
}

bool have_titles(Tests const& tests) {
  return !tests.tables.front()->title().empty();
}

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

}  // namespace

// Recognises the format by the first bytes and not by the file's name, because users rename files.
Tests open_tests(std::string_view bytes, std::string const& file, ReadOptions const& options, Wanted wanted) {
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

std::vector<std::string> idle_options(std::string_view bytes, ReadOptions const& options) {
  bool const numbers = is_mat(bytes) || is_json(bytes);
  if (!numbers && !is_zip(bytes)) return {};
  std::vector<std::string> found;
  if (options.thousands) found.push_back(fmt::format("--thousands {}", digit_group(*options.thousands).shell_text));
  if (numbers && options.skip_footer) found.emplace_back("--footer skip");
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

bool columns_are_told(ReadOptions const& options, Wanted wanted) {
  return options.columns.contains(Channel::disp) && (!wanted.force || options.columns.contains(Channel::force));
}

void require_one_sheet(Tests const& tests, std::string const& file, ReadOptions const& options, Wanted wanted) {
  bool const columns_told = columns_are_told(options, wanted);
  bool const by_name = tests.tables.front()->header().by_name;
  auto sheets = tests.sheets;
  if (columns_told)  // if the user names the columns, a sheet without column names may be the test too
    sheets.insert(sheets.end(), tests.sheets_passed_over.begin(), tests.sheets_passed_over.end());
  if (options.sheet || sheets.size() < 2 || (by_name && columns_told)) return;
  throw Error(Complaint{
      .where = file,
      .found = fmt::format("{} may each be the test", sheet_list(sheets, "tables")),
      .allowed = "one of them",
      .advice = fmt::format("--sheet {}, or isolaw init, which makes a device of each", typed(sheets.front()))});
}

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

}  // namespace isolaw::data
