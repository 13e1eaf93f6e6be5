#include "isolaw/data/files/workbook.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/inflate_limit.hpp"
#include "isolaw/data/files/sheet_choice.hpp"
#include "isolaw/data/files/text_table.hpp"
#include "isolaw/data/files/xml_reader.hpp"
#include "isolaw/data/files/zip_archive.hpp"

namespace isolaw::data {
namespace {

constexpr std::size_t most_rows = 1'048'576;  // Excel's limit for a sheet
constexpr std::size_t most_sheets = 1000;
// Long enough for a name. Longer texts are cut: if a million cells refer to one long text, its copies would fill the
// memory.
constexpr std::size_t longest_cell_text = 200;

struct Sheet {
  std::string name;
  std::string entry;
};

void parse(ZipArchive& archive, std::string const& file, std::string const& entry, XmlHandlers const& handlers) {
  read_xml(fmt::format("{}:{}", file, entry), handlers, [&](auto const& take) { archive.read(entry, take); });
}

// The path that `target` means in file `from`: "worksheets/a.xml" in "xl/workbook.xml" means "xl/worksheets/a.xml".
std::string resolved(std::string_view from, std::string_view target) {
  if (target.starts_with('/')) return std::string(target.substr(1));
  std::string folder(from.substr(0, from.rfind('/') + 1));
  while (target.starts_with("../")) {
    target.remove_prefix(3);
    if (!folder.empty()) folder.pop_back();
    folder.resize(folder.rfind('/') == std::string::npos ? 0 : folder.rfind('/') + 1);
  }
  return folder + std::string(target);
}

// The files that a part of the workbook refers to. Each has two keys: its id and the last word of its type ("/styles").
std::map<std::string, std::string> relations(ZipArchive& archive, std::string const& file, std::string const& part) {
  auto const slash = part.rfind('/') + 1;
  auto const entry = part.substr(0, slash) + "_rels/" + part.substr(slash) + ".rels";
  std::map<std::string, std::string> targets;
  if (!archive.has(entry)) return targets;
  parse(archive, file, entry, {[&](std::string_view name, Attributes const& attributes) {
          if (name != "Relationship" || attributes["TargetMode"] == "External") return;
          auto const target = resolved(part, attributes["Target"]);
          auto const type = attributes["Type"];
          targets[std::string(attributes["Id"])] = target;
          targets["/" + std::string(type.substr(type.rfind('/') + 1))] = target;
        }});
  return targets;
}

std::string target_or(std::map<std::string, std::string> const& targets, std::string const& key, std::string fallback) {
  auto const found = targets.find(key);
  return found == targets.end() ? std::move(fallback) : found->second;
}

class SharedTexts {
 public:
  void read(ZipArchive& archive, std::string const& file, std::string const& entry) {
    if (!archive.has(entry)) return;
    bool in_text = false;
    int phonetic = 0;  // number of open elements that state the pronunciation of a Japanese text
    parse(archive, file, entry,
          {.start =
               [&](std::string_view name, Attributes const&) {
                 if (name == "si") ends_.push_back(ends_.empty() ? 0 : ends_.back());
                 if (name == "rPh") ++phonetic;
                 in_text = name == "t" && phonetic == 0 && !ends_.empty();
               },
           .end =
               [&](std::string_view name) {
                 if (name == "rPh") --phonetic;
                 in_text = false;
               },
           .text =
               [&](std::string_view text) {
                 if (!in_text) return;
                 auto const begin = ends_.size() > 1 ? ends_[ends_.size() - 2] : 0;
                 auto const room = longest_cell_text - std::min(longest_cell_text, ends_.back() - begin);
                 texts_ += text.substr(0, room);
                 ends_.back() = texts_.size();
               }});
  }
  std::optional<std::string_view> operator[](std::size_t index) const {
    if (index >= ends_.size()) return std::nullopt;
    auto const begin = index == 0 ? 0 : ends_[index - 1];
    return std::string_view(texts_).substr(begin, ends_[index] - begin);
  }

 private:
  std::string texts_;
  std::vector<std::size_t> ends_;
};

bool is_date_format(std::string_view code) {
  for (std::size_t i = 0; i < code.size(); ++i) {
    char const c = code[i];
    if (c == '"' || c == '[') {  // quoted text, or brackets with a colour, a condition or hours above 24
      auto const close = code.find(c == '"' ? '"' : ']', i + 1);
      auto const inside = code.substr(i + 1, close == std::string_view::npos ? close : close - i - 1);
      if (c == '[' &&
          (inside == "h" || inside == "hh" || inside == "m" || inside == "mm" || inside == "s" || inside == "ss"))
        return true;
      if (close == std::string_view::npos) return false;
      i = close;
    } else if (c == '\\' || c == '_' || c == '*') {
      ++i;
    } else if (std::string_view("dmyhsDMYHS").find(c) != std::string_view::npos) {
      return true;
    }
  }
  return false;
}

bool is_built_in_date(std::size_t format) {
  return (format >= 14 && format <= 22) || (format >= 27 && format <= 36) || (format >= 45 && format <= 47) ||
         (format >= 50 && format <= 58);
}

std::vector<bool> date_styles(ZipArchive& archive, std::string const& file, std::string const& entry) {
  std::vector<bool> styles;
  if (!archive.has(entry)) return styles;
  std::set<std::size_t> dates;
  bool in_cell_styles = false;
  parse(archive, file, entry,
        {.start =
             [&](std::string_view name, Attributes const& attributes) {
               if (name == "cellXfs") in_cell_styles = true;
               auto const format = number_in<std::size_t>(attributes["numFmtId"]);
               if (name == "numFmt" && format && is_date_format(attributes["formatCode"])) dates.insert(*format);
               if (name == "xf" && in_cell_styles)
                 styles.push_back(format && (is_built_in_date(*format) || dates.contains(*format)));
             },
         .end =
             [&](std::string_view name) {
               if (name == "cellXfs") in_cell_styles = false;
             }});
  return styles;
}

// The cell that a reference such as "BC12" means, with indices from 0.
struct CellPlace {
  std::size_t column;
  std::size_t row;
};
std::optional<CellPlace> parse_reference(std::string_view text) {
  auto const letters = text.substr(0, text.find_first_of("0123456789"));
  auto const column = letters_column(letters);
  auto const row = number_in<std::size_t>(text.substr(letters.size()));
  if (!column || !row || *row == 0) return std::nullopt;
  return CellPlace{*column, *row - 1};
}

// Writes a sheet as text: a line for each row, with tabs between the cells.
class RowWriter {
 public:
  RowWriter(std::string place, SharedTexts const& texts, std::vector<bool> const& dates, std::uint64_t longest)
      : place_(std::move(place)), texts_(texts), dates_(dates), longest_(longest) {}

  XmlHandlers handlers() {
    return {.start = [this](std::string_view name, Attributes const& a) { start(name, a); },
            .end = [this](std::string_view name) { end(name); },
            .text =
                [this](std::string_view text) {
                  if (in_value_ && value_.size() < longest_cell_text)
                    value_ += text.substr(0, longest_cell_text - value_.size());
                }};
  }
  std::string take() { return std::move(rows_); }

 private:
  void start(std::string_view name, Attributes const& attributes) {
    if (name == "row") {
      begin_row(attributes["r"]);
    } else if (name == "c") {
      in_cell_ = true;
      begin_cell(attributes);
    } else if (name == "f") {
      formula_ = true;
    } else if (name == "rPh") {
      phonetic_ = true;
    } else if (in_cell_ && !phonetic_ && (name == "v" || name == "t")) {
      in_value_ = true;
      has_value_ = true;
    }
  }

  void end(std::string_view name) {
    if (name == "v" || name == "t") in_value_ = false;
    if (name == "rPh") phonetic_ = false;
    if (name != "c" || !in_cell_) return;
    write_cell();
    in_cell_ = false;
  }

  // A file may leave out empty rows. If a row states no number, it follows directly on the row before it.
  void begin_row(std::string_view number) {
    auto const row = number.empty() ? std::optional(next_row_ + 1) : number_in<std::size_t>(number);
    if (!row || *row == 0 || *row > most_rows)
      refuse(fmt::format("row {}", in_quotes(number)), fmt::format("1 to {}", most_rows));
    begin_row_at(*row - 1);
    next_row_ = *row;
  }

  void begin_row_at(std::size_t row) {
    if (row < row_) refuse(fmt::format("row {} below row {}", row + 1, row_ + 1), "rows in their order");
    rows_.append(row - row_, '\n');
    if (row > row_) column_ = next_column_ = 0;
    row_ = row;
  }

  void begin_cell(Attributes const& attributes) {
    value_.clear();
    formula_ = has_value_ = in_value_ = false;
    type_ = attributes["t"];
    auto const style = number_in<std::size_t>(attributes["s"]);
    date_ = style && *style < dates_.size() && dates_[*style];
    cell_column_ = next_column_;
    if (auto const reference = attributes["r"]; !reference.empty()) {
      auto const place = parse_reference(reference);
      if (!place || place->row != row_)
        refuse(fmt::format("cell {} in row {}", in_quotes(reference), row_ + 1), "cells in the row they name");
      cell_column_ = place->column;
    }
    if (cell_column_ < next_column_)
      refuse(fmt::format("cell {}{} twice, or behind another", column_letters(cell_column_), row_ + 1),
             "cells in their order");
    next_column_ = cell_column_ + 1;
  }

  void write_cell() {
    auto const text = cell_text();
    if (text.empty()) return;
    if (cell_column_ >= most_columns)
      refuse(fmt::format("a cell in column {}", column_letters(cell_column_)),
             fmt::format("{} columns, to {}", most_columns, column_letters(most_columns - 1)));
    rows_.append(cell_column_ - column_, '\t');
    column_ = cell_column_;
    rows_ += text;
    if (rows_.size() > longest_)
      refuse("the cells refer to more text than the file holds", "a sheet with the test alone");
  }

  std::string cell_text() const {
    if (type_ == "s") {
      auto const index = number_in<std::size_t>(value_);
      auto const text = index ? texts_[*index] : std::nullopt;
      return one_line(text ? *text : "a text that the file lacks");
    }
    if (type_ == "b") return value_ == "1" ? "TRUE" : "FALSE";
    if (type_ == "e") return "error " + one_line(value_);  // without the word, "#DIV/0!" would look like a comment
    if (formula_ && !has_value_) return "a formula saved without its value";
    auto text = one_line(value_);
    bool const number = type_.empty() || type_ == "n";
    if (number && date_ && !text.empty()) text += " (a date or time of day)";
    return text;
  }

  static std::string one_line(std::string_view text) {
    std::string line(text);
    for (char& c : line) {
      if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
      if (c == '"') c = '\'';
    }
    while (!line.empty() && utf8_length(std::string_view(line).substr(last_character(line))) == 0)
      line.resize(last_character(line));  // longest_cell_text may have cut a character in two
    return std::string(trimmed(line));
  }
  static std::size_t last_character(std::string_view line) {
    auto at = line.size() - 1;
    while (at > 0 && continues_character(line[at])) --at;
    return at;
  }

  [[noreturn]] void refuse(std::string found, std::string allowed) const {
    throw Error(Complaint{.where = place_,
                          .found = std::move(found),
                          .allowed = std::move(allowed),
                          .advice = "open it in a spreadsheet program and save it again as .xlsx"});
  }

  std::string place_;
  SharedTexts const& texts_;
  std::vector<bool> const& dates_;
  std::uint64_t longest_;
  std::string rows_;
  std::size_t row_ = 0, next_row_ = 0;        // current row; next row if the file gives no number (from 0)
  std::size_t column_ = 0, next_column_ = 0;  // last column written; column of the next cell if the file gives none
  std::size_t cell_column_ = 0;
  bool in_cell_ = false, in_value_ = false, phonetic_ = false, formula_ = false, has_value_ = false, date_ = false;
  std::string type_, value_;
};

class Workbook {
 public:
  Workbook(std::string_view bytes, std::string const& file) : file_(file), archive_(bytes, file), size_(bytes.size()) {
    auto const main = target_or(relations(archive_, file, ""), "/officeDocument", "xl/workbook.xml");
    if (!archive_.has(main) || main.ends_with(".bin")) refuse_other_archive(main);
    auto const targets = relations(archive_, file, main);
    list_sheets(main, targets);
    texts_.read(archive_, file, target_or(targets, "/sharedStrings", "xl/sharedStrings.xml"));
    dates_ = date_styles(archive_, file, target_or(targets, "/styles", "xl/styles.xml"));
  }

  std::vector<Sheet> const& sheets() const { return sheets_; }

  Tests tests(Sheet const& sheet) {
    auto const place = fmt::format("{}:{}", file_, printable(sheet.name));
    RowWriter writer(place, texts_, dates_, unpacked_limit(size_));
    parse(archive_, file_, sheet.entry, writer.handlers());
    return sheet_tests(writer.take(), place);
  }

  // Facts about the device in a sheet of notes. Empty for a sheet that holds a table or a long text.
  DeviceFacts device_facts(Sheet const& sheet) {
    constexpr std::uint64_t longest = 1u << 16;
    try {
      RowWriter writer(sheet.name, texts_, dates_, longest);
      parse(archive_, file_, sheet.entry, writer.handlers());
      auto notes = sheet_tests(writer.take(), sheet.name);
      return notes.tables.empty() ? std::move(notes.device_facts) : DeviceFacts{};
    } catch (Error const&) {  // an error is ignored: a sheet that is not the test may hold anything
      return {};
    }
  }

 private:
  void list_sheets(std::string const& main, std::map<std::string, std::string> const& targets) {
    parse(archive_, file_, main, {[&](std::string_view name, Attributes const& attributes) {
            if (name != "sheet") return;
            auto const target = targets.find(std::string(attributes["id"]));
            if (target == targets.end() || !archive_.has(target->second)) return;
            if (target->second.find("worksheets/") == std::string::npos) return;  // the sheet is a chart
            if (sheets_.size() >= most_sheets)
              throw Error(Complaint{.where = file_,
                                    .found = fmt::format("more than {} sheets", most_sheets),
                                    .allowed = "a workbook with the tests alone"});
            sheets_.push_back({.name = std::string(attributes["name"]), .entry = target->second});
          }});
  }

  [[noreturn]] void refuse_other_archive(std::string const& main) {
    bool const binary = main.ends_with(".bin") || archive_.has("xl/workbook.bin");
    bool const open_document = archive_.has("content.xml") && archive_.has("mimetype");
    throw Error(
        Complaint{.where = file_,
                  .found = binary          ? "is an .xlsb workbook"
                           : open_document ? "is an OpenDocument file"
                                           : "is a zip archive",
                  .allowed = std::string(accepted_formats),
                  .advice = binary || open_document ? "save it as .xlsx, or the sheet as CSV" : "unpack it first"});
  }

  std::string file_;
  ZipArchive archive_;
  std::uint64_t size_;
  std::vector<Sheet> sheets_;
  SharedTexts texts_;
  std::vector<bool> dates_;
};

void append(DeviceFacts& list, DeviceFacts const& more) {
  list.insert(list.end(), more.begin(), more.end());
}
std::size_t channels_named(Tests const& tests) {
  std::size_t most = 0;
  for (auto const& table : tests.tables) {
    auto const named =
        std::ranges::count_if(table->header().names, [](auto const& name) { return names_a_channel(name); });
    most = std::max(most, static_cast<std::size_t>(named));
  }
  return most;
}

}  // namespace

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

Tests workbook_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& sheet) {
  Workbook workbook(bytes, file);
  std::vector<std::string> names;
  for (auto const& each : workbook.sheets()) names.push_back(each.name);
  if (sheet) {
    auto const index = choose_sheet(*sheet, names, file, "sheet");
    auto tests = workbook.tests(workbook.sheets()[index]);
    if (tests.tables.empty())
      throw Error(Complaint{.where = fmt::format("{}:{}", file, printable(names[index])),
                            .found = "no rows of numbers",
                            .allowed = sheet_list(names, "sheets")});
    if (names.size() > 1) tests.sheet = sheet_key(names, index);
    tests.recognised.push_back(
        decision(FindingKind::file_format, fmt::format("an Excel workbook, sheet {}", in_quotes(names[index]))));
    constexpr std::size_t most_beside = 30;  // only this many sheets are searched for notes
    for (std::size_t i = 0; i < std::min(names.size(), most_beside); ++i)
      if (i != index) append(tests.device_facts, workbook.device_facts(workbook.sheets()[i]));
    return tests;
  }
  Tests first, named;  // the first sheet with rows of numbers, and the first of these that names a channel
  std::vector<std::string> found, without_names;
  std::size_t most = 0;
  DeviceFacts device_facts;
  // For each sheet with rows of numbers: its index and the number of channels that it names.
  std::vector<std::pair<std::size_t, std::size_t>> filled;
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto tests = workbook.tests(workbook.sheets()[i]);
    if (tests.tables.empty()) {
      append(device_facts, tests.device_facts);
      continue;
    }
    auto const channels = channels_named(tests);
    filled.emplace_back(i, channels);
    most = std::max(most, channels);
    if (filled.size() == 1)
      first = std::move(tests);
    else if (filled.front().second == 0 && channels > 0 && named.tables.empty())
      named = std::move(tests);
  }
  if (most >= 2 && filled.front().second == 0) first = std::move(named);
  for (auto const& [i, channels] : filled)
    (most >= 2 && channels == 0 ? without_names : found).push_back(sheet_key(names, i));
  if (first.tables.empty())
    throw Error(Complaint{.where = file,
                          .found = fmt::format("no rows of numbers in {}", sheet_list(names, "sheets")),
                          .allowed = "two or more columns of numbers",
                          .advice = "a sheet with displacement and force"});
  if (names.size() > 1) first.sheet = found.front();
  first.recognised.push_back(
      decision(FindingKind::file_format, fmt::format("an Excel workbook, sheet {}{}", in_quotes(found.front()),
                                                     names.size() == 1       ? ""
                                                     : without_names.empty() ? ", the only one with rows of numbers"
                                                                             : ", the only test")));
  if (!without_names.empty())
    first.recognised.push_back(decision(
        FindingKind::test_chosen, fmt::format("{} {} no time, displacement or force, passed over",
                                              sheet_list(without_names, without_names.size() == 1 ? "sheet" : "sheets"),
                                              without_names.size() == 1 ? "names" : "name")));
  first.device_facts = std::move(device_facts);
  first.sheets_passed_over = std::move(without_names);
  first.sheets = std::move(found);
  return first;
}

}  // namespace isolaw::data
