#include "isolaw/data/files/json_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/number_table.hpp"
#include "isolaw/data/files/sheet_choice.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw::data {
namespace {

using namespace std::string_view_literals;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t most_odd_cells = 64;  // a column keeps the texts of this many cells that are no number
constexpr std::size_t most_words = 10000;   // number of single texts that are kept, because they may be units
constexpr std::size_t longest_text = 200;

struct Value {
  double number = missing;
  std::string text;  // only for a value that is no number
  bool is_text = false;
};

// One table of the document: an object whose arrays are columns, or an array whose elements are rows.
struct Branch {
  std::vector<NumberColumn> columns;
  std::map<std::string, std::size_t, std::less<>> index;  // position of a column by its name
  std::size_t rows = 0;                                   // number of rows, if elements are rows
  std::string element;                                    // path of the list element (a test) that holds the table
  bool of_rows = false;
  bool named = false;        // the columns have names
  std::string flaw;          // why the table cannot be read
  std::size_t flaw_row = 0;  // row of the flaw from 1; 0 if it concerns no single row
};

// A text and the list element (a test) that holds it. The units of one test do not apply to the next.
struct Word {
  std::string text;
  std::string element;
};
std::vector<std::string> texts_of(NumberColumn const& column) {
  std::vector<std::string> texts;
  if (column.odd_cells.size() != column.values.size()) return texts;
  for (auto const& [row, text] : column.odd_cells) texts.push_back(text);
  return texts;
}

// The texts of the columns called "units" or "unit".
std::vector<std::string> units_in(Branch const& part) {
  std::vector<std::string> units;
  for (auto const& column : part.columns)
    if (lower(column.name) == "units" || lower(column.name) == "unit") {
      auto texts = texts_of(column);
      units.insert(units.end(), texts.begin(), texts.end());
    }
  return units;
}

bool is_table(Branch const& part) {
  constexpr std::size_t fewest = 3;
  // A table with a flaw counts as a table, so that its flaw is reported.
  if (!part.flaw.empty()) return part.columns.size() >= 2 && part.rows >= fewest;
  auto const filled = std::ranges::count_if(
      part.columns, [](auto const& column) { return column.values.size() >= fewest && texts_of(column).empty(); });
  return filled >= 2;
}

void put(NumberColumn& column, Value const& value) {
  if (std::isnan(value.number) && column.odd_cells.size() < most_odd_cells && !value.text.empty())
    column.odd_cells.emplace(column.values.size(), value.text.substr(0, longest_text));
  if (value.is_text && column.stamps.size() == column.values.size())
    if (auto const stamp = parse_stamp(value.text)) column.stamps.push_back(*stamp);
  column.values.push_back(value.number);
}

// Receives the document from the JSON parser. Keeps only tables of numbers and a few texts.
class Handler {
 public:
  explicit Handler(std::size_t file_bytes) : left_(file_bytes + (std::size_t{1} << 20)) {}

  std::map<std::string, Branch> parts;                        // tables by path
  std::map<std::pair<std::string, std::string>, Word> words;  // single texts by their object's path and own key
  // For the path of each list: the paths of its elements with a table, and of those with columns but without a table.
  std::map<std::string, std::vector<std::string>> lists, passed_over;
  std::vector<std::string> units_dropped;  // units listed in elements without a table; their other contents are dropped
  std::string refusal;
  std::size_t failed_at = 0;  // position of the syntax error in bytes, from 1

  bool null() { return scalar({.number = missing, .text = "null", .is_text = false}); }
  bool boolean(bool value) { return scalar({.number = missing, .text = value ? "true" : "false", .is_text = false}); }
  bool number_integer(std::int64_t value) { return scalar({.number = static_cast<double>(value), .text = {}}); }
  bool number_unsigned(std::uint64_t value) { return scalar({.number = static_cast<double>(value), .text = {}}); }
  bool number_float(double value, std::string const&) { return scalar({.number = value, .text = {}}); }
  bool string(std::string& value) {
    return scalar({.number = missing, .text = value.empty() ? " " : value, .is_text = true});
  }
  bool binary(std::vector<std::uint8_t>&) { return false; }

  bool start_object(std::size_t) {
    if (stack_.empty() || stack_.back().kind != Kind::array) return push(Kind::object);
    begin_element(Shape::records);
    auto const number = ++stack_.back().elements;
    if (!push(Kind::object)) return false;
    stack_.back().number = number;
    return true;
  }
  bool key(std::string& name) {
    stack_.back().key = name.substr(0, longest_text);
    return true;
  }
  bool end_object() {
    bool const row = stack_.size() > 1 && stack_[stack_.size() - 2].shape == Shape::records;
    auto const ended = std::move(stack_.back());
    stack_.pop_back();
    if (ended.has_path_of_own && is_test(ended))
      end_test(ended);
    else if (row)
      end_row();
    return refusal.empty();
  }
  bool start_array(std::size_t) {
    if (!stack_.empty() && stack_.back().kind == Kind::array) begin_element(Shape::rows);
    return push(Kind::array);
  }
  bool end_array() {
    auto const shape = stack_.back().shape;
    stack_.pop_back();
    if (stack_.empty()) return refusal.empty();
    if (stack_.back().shape == Shape::rows)
      end_row();
    else if (shape == Shape::values && stack_.back().kind == Kind::object)
      finish_column();
    return refusal.empty();
  }
  bool parse_error(std::size_t at, std::string const&, nlohmann::detail::exception const& error) {
    std::string_view text = error.what();
    for (auto const mark : {"]"sv, ": "sv})  // removes "[json.exception.parse_error.101] parse error ...: "
      if (auto const found = text.find(mark); found != std::string_view::npos) text.remove_prefix(found + mark.size());
    failed_at = at;
    refusal = "is no JSON: " + std::string(trimmed(text));
    return false;
  }

 private:
  enum class Kind { object, array };
  enum class Shape { none, values, rows, records, mixed };  // kind of the elements in an array
  struct Frame {
    Kind kind;
    Shape shape = Shape::none;
    std::string path = {};         // keys that lead here, joined by points
    std::string key = {};          // the last key that was read
    bool in_reach = true;          // false if it is nested too deep for a table
    std::size_t elements = 0;      // number of objects read so far in an array
    std::size_t number = 0;        // position of an object in its array, from 1; else 0
    bool has_path_of_own = false;  // the element holds arrays or objects; its number is in its path
  };

  bool push(Kind kind) {
    constexpr std::size_t deepest = 64;
    if (stack_.size() >= deepest) {
      refusal = fmt::format("lists or objects nested more than {} deep", deepest);
      return false;
    }
    Frame frame{.kind = kind};
    if (!stack_.empty()) {
      auto const& above = stack_.back();
      bool const in_list = stack_.size() == 4 && stack_[2].kind == Kind::object;  // as in {"tests": [{"data": [[...
      frame.in_reach = above.in_reach && (above.kind == Kind::object ? depth() <= 2 : stack_.size() <= 3 || in_list);
      if (frame.in_reach && above.kind == Kind::object) number_path();
      frame.path = above.kind == Kind::object ? joined(above.path, above.key) : above.path;
    }
    stack_.push_back(std::move(frame));
    return refusal.empty();
  }

  static std::string joined(std::string const& path, std::string const& key) {
    return path.empty() ? key : path + '.' + key;
  }
  // Number of enclosing objects. Objects in arrays do not count, so that a list of tests is no deeper than one test.
  std::size_t depth() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        stack_, [](auto const& frame) { return frame.kind == Kind::object && frame.number == 0; }));
  }

  // Adds an element's number to its path if the element holds arrays or objects. Plain rows, often millions, get no
  // number.
  void number_path() {
    auto& frame = stack_.back();
    if (frame.number == 0 || frame.has_path_of_own) return;
    frame.path += fmt::format("({})", frame.number);
    frame.has_path_of_own = true;
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (row_[i].is_text) keep_word(row_names_[i], row_[i].text);
  }
  void keep_word(std::string const& key, std::string const& text) {
    if (words.size() >= most_words) return;
    words.emplace(std::pair(stack_.back().path, key), Word{text.substr(0, longest_text), element()});
  }
  std::string element() const {
    for (auto frame = stack_.rbegin(); frame != stack_.rend(); ++frame)
      if (frame->has_path_of_own) return frame->path;
    return {};
  }
  Branch& part_at(std::string const& path) {
    auto const [found, fresh] = parts.try_emplace(path);
    if (fresh) found->second.element = element();
    return found->second;
  }

  // Whether the list element that has just ended holds a table. Drops the contents of an element without a table.
  bool is_test(Frame const& ended) {
    bool channels = false;
    for (auto it = parts.lower_bound(ended.path); it != parts.end() && it->first.starts_with(ended.path);) {
      if (it->second.element == ended.path && is_table(it->second)) return true;
      channels = channels || !it->second.columns.empty();
      ++it;
    }
    for (auto it = parts.lower_bound(ended.path); it != parts.end() && it->first.starts_with(ended.path);) {
      if (units_dropped.size() < most_words) std::ranges::move(units_in(it->second), std::back_inserter(units_dropped));
      it = it->second.element == ended.path ? parts.erase(it) : std::next(it);
    }
    for (auto it = words.lower_bound({ended.path, ""}); it != words.end() && it->first.first.starts_with(ended.path);)
      it = it->second.element == ended.path ? words.erase(it) : std::next(it);
    auto& list = passed_over[stack_.back().path];
    if (channels && list.size() <= most_tests) list.push_back(ended.path);
    return false;
  }

  void end_test(Frame const& ended) {
    auto& list = lists[stack_.back().path];
    if (++tests_ > most_tests) refusal = fmt::format("more than {} tests", most_tests);
    list.push_back(ended.path);
  }

  void begin_element(Shape shape) {
    auto& above = stack_.back();
    row_.clear();
    row_names_.clear();
    if (!above.in_reach) return;
    auto& part = part_at(above.path);
    part.of_rows = true;
    if (above.shape == Shape::none) above.shape = shape;
    if (above.shape != shape) flawed(part, "rows of several kinds");
  }

  bool scalar(Value value) {
    if (stack_.empty()) return true;
    auto& frame = stack_.back();
    if (!frame.in_reach) return true;
    if (stack_.size() > 1) {
      auto const& above = stack_[stack_.size() - 2];
      if (above.shape == Shape::rows && frame.kind == Kind::array) return cell({}, std::move(value));
      if (above.shape == Shape::records && frame.kind == Kind::object) {
        if (frame.has_path_of_own && value.is_text) keep_word(frame.key, value.text);
        return cell(frame.key, std::move(value));
      }
    }
    if (frame.kind == Kind::object) {
      if (value.is_text) keep_word(frame.key, value.text);
      return true;
    }
    if (frame.shape == Shape::none) frame.shape = Shape::values;
    if (frame.shape != Shape::values) {
      flawed(part_at(frame.path), "single values among the rows");
      return true;
    }
    if (!afford(1)) return false;
    put(values_, value);
    return true;
  }

  bool cell(std::string const& name, Value value) {
    if (row_.size() >= most_columns) {
      refusal = fmt::format("a row of more than {} values", most_columns);
      return false;
    }
    row_names_.push_back(name);
    row_.push_back(std::move(value));
    return true;
  }

  void end_row() {
    auto const& above = stack_.back();
    if (!above.in_reach) return;
    auto& part = part_at(above.path);
    if (above.shape == Shape::records)
      add_record(part);
    else
      add_row(part);
  }

  void add_row(Branch& part) {
    bool const first = part.columns.empty();
    if (first) part.columns.resize(row_.size());
    bool const words_alone = !row_.empty() && std::ranges::all_of(row_, &Value::is_text);
    if (first && words_alone) {
      for (std::size_t i = 0; i < row_.size(); ++i) part.columns[i].name = row_[i].text;
      part.named = true;
      return;
    }
    ++part.rows;
    if (row_.size() != part.columns.size())
      return flawed(part, fmt::format("{} values, not {} as in the first row", row_.size(), part.columns.size()));
    if (words_alone && part.named && part.rows == 1 && part.columns.front().unit.empty()) {
      for (std::size_t i = 0; i < row_.size(); ++i) part.columns[i].unit = trimmed(row_[i].text);
      part.rows = 0;
      return;
    }
    if (!afford(row_.size())) return;
    for (std::size_t i = 0; i < row_.size(); ++i) put(part.columns[i], row_[i]);
  }

  void add_record(Branch& part) {
    part.named = true;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      auto const [found, fresh] = part.index.emplace(row_names_[i], part.columns.size());
      if (fresh) part.columns.push_back({.name = row_names_[i]});
      if (part.columns.size() > most_columns) {
        refusal = fmt::format("rows with more than {} different keys", most_columns);
        return;
      }
      auto& column = part.columns[found->second];
      if (column.values.size() > part.rows) continue;  // the row has this key twice: the first value counts
      if (!afford(part.rows + 1 - column.values.size())) return;
      while (column.values.size() < part.rows) put(column, {.number = missing, .text = "a key that is not there"});
      put(column, row_[i]);
    }
    ++part.rows;
  }

  void finish_column() {
    auto& frame = stack_.back();
    auto& part = part_at(frame.path);
    if (part.columns.size() >= most_columns) {
      refusal = fmt::format("more than {} arrays", most_columns);
    } else if (part.index.emplace(frame.key, part.columns.size()).second) {
      part.named = true;
      values_.name = frame.key;
      values_.values.shrink_to_fit();
      part.columns.push_back(std::move(values_));
    }
    values_ = {};
  }

  static void flawed(Branch& part, std::string what) {
    if (!part.flaw.empty()) return;
    part.flaw = std::move(what);
    part.flaw_row = part.rows;
  }
  bool afford(std::size_t cells) {
    bool const affordable = cells <= left_;
    if (!affordable) refusal = "keys that most rows lack: the table would be far larger than the file";
    left_ -= affordable ? cells : 0;
    return affordable;
  }

  // Number of table cells that may still be kept; at first a little more than the file's size in bytes. A cell that the
  // file states takes at least two bytes in the file, so only empty cells, in rows that lack a key, can use up this
  // number. The file is then refused, because its table would take far more memory than the file.
  std::size_t left_;
  std::size_t tests_ = 0;
  std::vector<Frame> stack_;
  NumberColumn values_;  // the array of single values being read
  std::vector<Value> row_;
  std::vector<std::string> row_names_;
};

std::string plain(std::string_view name) {
  std::string text;
  for (char const c : lower(name))
    if ((c >= 'a' && c <= 'z') || is_digit(c) || static_cast<unsigned char>(c) >= 0x80) text += c;
  return text;
}

class Document {
 public:
  Document(Handler handler) : handler_(std::move(handler)) {
    for (auto& [path, part] : handler_.parts) settle(path, part);
  }

  std::vector<std::string> tables() const {
    std::vector<std::string> names;
    for (auto const& [path, part] : handler_.parts)
      if (part.element.empty() && is_table(part) && !handler_.lists.contains(path)) names.push_back(shown(path));
    for (auto const& [path, elements] : handler_.lists) names.push_back(shown(path));
    return names;
  }

  void add_tests(std::string const& name, std::string const& file, Tests& tests) {
    auto const path = name == top ? std::string() : name;
    auto const list = handler_.lists.find(path);
    if (list == handler_.lists.end()) {
      tests.tables.push_back(table(path, file, {}));
      return;
    }
    if (handler_.parts.contains(path) && is_table(handler_.parts.at(path)))
      throw Error(Complaint{.where = path.empty() ? file : fmt::format("{}:{}", file, printable(path)),
                            .found = "a list of rows of numbers and of tests",
                            .allowed = "elements of one kind",
                            .advice = "a list of the tests alone"});
    for (auto const& element : list->second)
      for (auto const& [at, part] : handler_.parts)
        if (part.element == element && is_table(part)) tests.tables.push_back(table(at, file, title_of(element)));
    if (auto const other = handler_.passed_over[path]; !other.empty())
      tests.recognised.push_back(
          decision(FindingKind::test_chosen,
                   fmt::format("{} of the list {} no table of numbers, {} passed over",
                               sheet_list(other, other.size() == 1 ? "element" : "elements"),
                               other.size() == 1 ? "holds" : "hold", other.size() == 1 ? "is" : "are")));
  }

 private:
  static inline std::string const top = "(top)";
  static std::string shown(std::string const& path) { return path.empty() ? top : path; }

  // The name of a test in messages: "tests(2) 'B'".
  std::string title_of(std::string const& element) const {
    for (auto const* key : {"name", "title", "id", "label", "test"})
      if (auto const word = handler_.words.find({element, key}); word != handler_.words.end())
        return fmt::format("{} {}", printable(element), in_quotes(word->second.text));
    return printable(element);
  }

  std::unique_ptr<Table> table(std::string const& path, std::string const& file, std::string title) {
    auto& part = handler_.parts.at(path);
    auto const place = path.empty() ? file : fmt::format("{}:{}", file, printable(path));
    if (!part.flaw.empty())
      throw Error(Complaint{.where = part.flaw_row == 0 ? place : fmt::format("{}:{}", place, part.flaw_row),
                            .found = part.flaw,
                            .allowed = "one number for each column in every row",
                            .advice = "correct the row, or export the test again"});
    auto layout =
        fmt::format("JSON: {}{}", part.of_rows ? "an array whose elements are rows" : "arrays that are columns",
                    path.empty() ? "" : fmt::format(", under {}", in_quotes(path)));
    auto result = std::make_unique<NumberTable>(place, std::move(part.columns), part.of_rows ? "row" : "element",
                                                std::move(layout), std::move(title));
    result->add_units_elsewhere(listed_units());
    return result;
  }

  // Returns the texts of all lists called "units" in the document.
  std::vector<std::string> listed_units() const {
    auto units = handler_.units_dropped;
    for (auto const& [path, part] : handler_.parts) std::ranges::move(units_in(part), std::back_inserter(units));
    return units;
  }

  void settle(std::string const& path, Branch& part) {
    for (auto& column : part.columns) {
      if (part.of_rows)
        while (column.values.size() < part.rows && part.flaw.empty()) {
          if (column.odd_cells.size() < most_odd_cells)
            column.odd_cells.emplace(column.values.size(), "a key that is not there");
          column.values.push_back(missing);
        }
      column.length = column.values.size();
    }
    if (part.of_rows && !part.named) name_columns(path, part);
    for (auto& column : part.columns)
      if (column.unit.empty() && !column.name.empty()) column.unit = unit_of(path, part.element, column.name);
  }

  static std::string above(std::string const& path) {
    auto const point = path.rfind('.');
    return point == std::string::npos ? std::string() : path.substr(0, point);
  }

  std::vector<std::string> list_beside(std::string const& path, std::initializer_list<char const*> keys) const {
    auto const part = handler_.parts.find(above(path));
    if (part == handler_.parts.end()) return {};
    for (auto const& column : part->second.columns)
      if (std::ranges::find(keys, lower(column.name)) != keys.end()) return texts_of(column);
    return {};
  }

  void name_columns(std::string const& path, Branch& part) {
    auto const names = list_beside(path, {"columns", "names", "header", "headers", "channels", "fields"});
    auto const units = list_beside(path, {"units", "unit"});
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      if (names.size() == part.columns.size()) part.columns[i].name = names[i];
      if (units.size() == part.columns.size()) part.columns[i].unit = trimmed(units[i]);
    }
  }

  std::string unit_of(std::string const& path, std::string const& element, std::string const& name) const {
    auto const wanted = plain(name);
    for (auto const& [where, word] : handler_.words) {
      auto const& [words_path, key] = where;
      auto const& text = word.text;
      if (!word.element.empty() && word.element != element) continue;
      bool const near = words_path == path || words_path == above(path);
      if (near && (plain(key) == wanted + "unit" || plain(key) == wanted + "units")) return text;
      auto const last = words_path.substr(words_path.rfind('.') + 1);  // without a point, npos + 1 is 0
      if ((lower(last) == "units" || lower(last) == "unit") && key == name) return text;
    }
    return {};
  }

  Handler handler_;
};

}  // namespace

bool is_json(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  auto const skip = [&] {
    auto const first = bytes.find_first_not_of(" \t\r\n");
    bytes.remove_prefix(std::min(first, bytes.size()));
  };
  skip();
  if (bytes.empty()) return false;
  char const open = bytes.front();
  bytes.remove_prefix(1);
  skip();
  if (bytes.empty()) return false;
  if (open == '{') return bytes.front() == '"' || bytes.front() == '}';
  return open == '[' && "[{\"-0123456789"sv.find(bytes.front()) != std::string_view::npos;
}

Tests json_tests(std::string_view bytes, std::string const& file, std::optional<std::string> const& key) {
  Handler handler(bytes.size());
  bool const read = nlohmann::json::sax_parse(bytes.begin(), bytes.end(), &handler);
  if (!read) {
    auto const lines =
        1 + std::ranges::count(bytes.substr(0, handler.failed_at == 0 ? 0 : handler.failed_at - 1), '\n');
    throw Error(Complaint{.where = handler.failed_at == 0 ? file : fmt::format("{}:{}", file, lines),
                          .found = handler.refusal,
                          .allowed = "an object of arrays, an array of objects or an array of rows",
                          .advice = "export the channels as CSV"});
  }
  Document document(std::move(handler));
  auto const names = document.tables();
  if (names.empty())
    throw Error(Complaint{
        .where = file,
        .found = "JSON without a table of numbers",
        .allowed = "an object of arrays, an array of objects or an array of rows, at the top or under one key",
        .advice = "{\"time\": [...], \"disp\": [...], \"force\": [...]}"});
  auto const index = key ? choose_sheet(*key, names, file, "table") : 0;
  Tests tests;
  if (names.size() > 1) tests.sheet = sheet_key(names, index);
  for (std::size_t i = 0; i < names.size() && !key; ++i) tests.sheets.push_back(sheet_key(names, i));
  document.add_tests(names[index], file, tests);
  return tests;
}

}  // namespace isolaw::data
