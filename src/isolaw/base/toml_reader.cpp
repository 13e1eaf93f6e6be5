#include "isolaw/base/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sstream>

#include "isolaw/base/nearest_word.hpp"
#include "isolaw/base/option.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw {
namespace {

// Measures how deep each statement nests before toml++ parses it. Since toml++ parses by recursion, a name of a hundred
// thousand parts would overflow the stack. Each dot of a name counts as a level; quoted text and comments do not count.
class NestingCheck {
 public:
  explicit NestingCheck(std::string_view text) : text_(text) {}

  std::size_t deep_line() {  // returns the first line that nests too deep, or 0 if none does
    constexpr int deepest = 64;
    int depth = 0;
    std::vector<int> dots{0};  // for the document and each open bracket: the number of dots in the name being read
    auto const end_name = [&] {
      depth -= dots.back();
      dots.back() = 0;
    };
    for (; at_ < text_.size(); ++at_) {
      char const c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_quoted(c);
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size()) - 1;
      } else if (c == ',' || c == '\n') {
        end_name();
        line_ += c == '\n' ? 1 : 0;
      } else if (c == '.') {
        ++dots.back();
        ++depth;
      } else if (c == '[' || c == '{') {
        dots.push_back(0);
        ++depth;
      } else if ((c == ']' || c == '}') && dots.size() > 1) {
        end_name();
        dots.pop_back();
        --depth;
      }
      if (depth > deepest) return line_;
    }
    return 0;
  }

 private:
  void skip_quoted(char quote) {  // leaves at_ on the last character of the quoted text
    auto const run = [&](std::size_t at) {
      std::size_t length = 0;
      while (at + length < text_.size() && text_[at + length] == quote && length < 5) ++length;
      return length;
    };
    auto const opening = run(at_);
    if (opening == 2) {  // an empty text
      ++at_;
      return;
    }
    std::size_t const marks = opening >= 3 ? 3 : 1;
    for (at_ += marks; at_ < text_.size(); ++at_) {
      char const c = text_[at_];
      if (c == '\n') {
        if (marks == 1) {  // the quote is not closed: the parser will refuse it
          --at_;
          return;
        }
        ++line_;
      } else if (c == '\\' && quote == '"') {
        ++at_;
        if (at_ < text_.size() && text_[at_] == '\n') ++line_;
      } else if (c == quote && (marks == 1 || run(at_) >= 3)) {
        at_ += marks == 1 ? 0 : run(at_) - 1;  // up to two quotes before the closing three belong to the text
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

toml::table table_of(Json const& value, int depth);
toml::array array_of(Json const& value, int depth);

template <class Insert>
void insert_json(Json const& value, int depth, Insert const& insert) {
  constexpr int deepest = 8;
  if (depth > deepest)
    throw Error({.where = {}, .found = fmt::format("tables or lists nested more than {} levels deep", deepest)});
  if (value.is_object()) return insert(table_of(value, depth));
  if (value.is_array()) return insert(array_of(value, depth));
  if (value.is_boolean()) return insert(value.get<bool>());
  if (value.is_number_integer()) return insert(value.get<std::int64_t>());
  if (value.is_number()) return insert(value.get<double>());
  if (value.is_string()) return insert(value.get<std::string>());
}

toml::table table_of(Json const& value, int depth) {
  toml::table table;
  for (auto const& [key, item] : value.items())
    insert_json(item, depth + 1, [&, name = key](auto node) { table.insert(name, std::move(node)); });
  return table;
}

toml::array array_of(Json const& value, int depth) {
  toml::array array;
  for (auto const& item : value) insert_json(item, depth + 1, [&](auto node) { array.push_back(std::move(node)); });
  return array;
}

// Returns the place of a table for messages: the name of the file. If the table was not parsed from text, it has no
// line number, so the value of its key `name` or `file` is added.
std::string place_of(toml::table const& table, std::string file, std::string_view name) {
  if (name.empty() || table.source().begin.line != 0) return file;
  for (auto const* key : {"name", "file"})
    if (auto const text = table[key].value<std::string>()) return fmt::format("{}, {}", file, in_quotes(*text));
  return file;
}

}  // namespace

toml::table toml_of(Json const& tables, std::string const& file, TomlMessages const& messages) {
  if (!tables.is_object())
    throw Error({.where = file,
                 .found = shown(tables),
                 .allowed = fmt::format("tables as a {} has them", messages.kind),
                 .advice = std::string(messages.advice)});
  try {
    return table_of(tables, 0);
  } catch (Error const& error) {
    throw Error({.where = file,
                 .found = error.complaints().front().found,
                 .allowed = fmt::format("tables as a {} has them", messages.kind),
                 .advice = std::string(messages.advice)});
  }
}

toml::table parse_toml(std::string_view text, std::string const& file, TomlMessages const& messages) {
  auto const refuse = [&](std::size_t line, std::string found) {
    throw Error({.where = fmt::format("{}:{}", file, line),
                 .found = std::move(found),
                 .allowed = fmt::format("a {} in TOML", messages.kind),
                 .advice = std::string(messages.advice)});
  };
  if (auto const line = NestingCheck(text).deep_line())
    refuse(line, fmt::format("tables or lists nested deeper than any {} needs", messages.kind));
  try {
    return toml::parse(text, file);
  } catch (toml::parse_error const& error) {
    refuse(error.source().begin.line, std::string(error.description()));
  }
  return {};
}

void throw_complaints(std::vector<Complaint> complaints, std::string const& file) {
  if (complaints.empty()) return;
  // Sorts the complaints by line. A complaint about the whole file, or about another file, comes after those with a
  // line.
  std::ranges::stable_sort(complaints, {}, [&](Complaint const& complaint) {
    auto const& where = complaint.where;
    bool const has_line = where.starts_with(file + ":");
    return (has_line ? number_in<std::size_t>(std::string_view(where).substr(file.size() + 1)) : std::nullopt)
        .value_or(std::numeric_limits<std::size_t>::max());
  });
  if (complaints.size() > TomlTable::most_complaints) {
    complaints.resize(TomlTable::most_complaints);
    complaints.push_back({.where = file, .found = "and more of the kind"});
  }
  throw Error(std::move(complaints));
}

TomlTable::TomlTable(toml::table const& table, std::string file, std::string name, std::vector<Complaint>& complaints)
    : table_(table), file_(place_of(table, std::move(file), name)), name_(std::move(name)), complaints_(complaints) {}

std::string TomlTable::where(toml::node const& node) const {
  auto const line = node.source().begin.line;  // 0 for a table that was not parsed from text
  return line == 0 ? file_ : fmt::format("{}:{}", file_, line);
}

void TomlTable::strings(std::string_view key, std::function<void(std::string const&)> const& take,
                        std::size_t longest) {
  auto const last = [&](Json const& value) { take(text_in(value.is_array() ? value.back() : value)); };
  json(key, last, longest);
}

std::optional<Json> TomlTable::scalar(toml::node const& node, std::string_view key, std::size_t longest) {
  if (auto const* text = node.as_string()) {
    if (!accept_text(node, key, text->get(), longest)) return std::nullopt;
    return text->get();
  }
  if (auto const* whole = node.as_integer()) return whole->get();
  if (auto const* real = node.as_floating_point()) return real->get();
  if (auto const* truth = node.as_boolean()) return truth->get();
  if (auto const* date = node.as_date()) return (std::ostringstream() << *date).str();
  if (auto const* time = node.as_date_time()) return (std::ostringstream() << *time).str();
  complain(node, fmt::format("'{}' holds a time of day, or a list or table within another", key),
           "text, a number, true or false");
  return std::nullopt;
}

void TomlTable::json(std::string_view key, std::function<void(Json const&)> const& take, std::size_t longest) {
  auto const* node = find(key);
  if (node == nullptr) return;
  if (auto const* array = node->as_array()) {
    if (array->size() > most_items)
      return complain(*node, fmt::format("'{}' lists {} values", key, array->size()),
                      fmt::format("{} or fewer", most_items));
    Json taken = Json::array();
    for (auto const& item : *array) {
      auto const value = scalar(item, key, longest);
      if (!value) continue;
      taken.push_back(*value);
      if (!guarded(item, key, [&] { take(taken); })) taken.erase(taken.size() - 1);
    }
  } else if (auto const* table = node->as_table()) {
    Json taken = Json::object();
    for (auto const& [name, item] : *table) {
      auto const value = scalar(item, key, longest);
      if (!value) continue;
      auto const entry = printable(name.str());
      taken[entry] = *value;
      if (!guarded(item, key, [&] { take(taken); })) taken.erase(entry);
    }
  } else if (auto const value = scalar(*node, key, longest)) {
    guarded(*node, key, [&] { take(*value); });
  }
}

toml::table const* TomlTable::table(std::string_view key) {
  auto const* found = find(key);
  if (found == nullptr) return nullptr;
  if (!found->is_table()) complain(*found, fmt::format("'{}' is not a table", key), fmt::format("[{}]", key));
  return found->as_table();
}

toml::node const* TomlTable::find(std::string_view key) {
  known_.emplace(key);
  return table_.get(key);
}

void TomlTable::refuse_unknown() {
  for (auto const& [key, item] : table_) {
    if (known_.contains(std::string(key.str()))) continue;
    if (complaints_.size() > most_complaints) return;
    constexpr std::size_t longest = 100;
    auto const near = nearest_word(key.str().substr(0, longest), known_, key.str().size() < 4 ? 1 : 2);
    complain(item, fmt::format("unknown key {}{}", in_quotes(key.str()), name_.empty() ? "" : " in " + name_),
             joined(known_), near);
  }
}

void TomlTable::complain(toml::node const& node, std::string found, std::string allowed, std::string advice) {
  if (complaints_.size() > most_complaints) return;  // one extra complaint tells throw_complaints() that more follow
  complaints_.push_back(
      {.where = where(node), .found = std::move(found), .allowed = std::move(allowed), .advice = std::move(advice)});
}

void TomlTable::complain_value(toml::node const& node, std::string_view key, std::string_view expected, bool of_kind) {
  complain(node,
           of_kind ? fmt::format("'{}' is {}, out of range", key, node.value<std::int64_t>().value_or(0))
                   : fmt::format("'{}' is not {}", key, expected),
           std::string(expected));
}

bool TomlTable::accept_text(toml::node const& node, std::string_view key, std::string const& text,
                            std::size_t longest) {
  bool const fits = text.size() <= longest;
  if (fits && is_printable(text)) return true;
  complain(node,
           fits ? fmt::format("{}: {} holds control characters", key, in_quotes(text))
                : fmt::format("{}: {} is {} bytes long", key, in_quotes(text), text.size()),
           fits ? "printable text, of one line" : fmt::format("{} or fewer", longest));
  return false;
}

bool TomlTable::guarded(toml::node const& node, std::string_view key, std::function<void()> const& action) {
  try {
    action();
    return true;
  } catch (Error const& error) {
    for (auto complaint : error.complaints()) {
      if (complaints_.size() > most_complaints) break;
      bool const names_option = complaint.where.empty() || complaint.where.starts_with("--");
      complaint.found = names_option ? fmt::format("{}: {}", key, complaint.found)
                                     : fmt::format("{}: {}: {}", key, complaint.where, complaint.found);
      complaint.where = where(node);
      complaints_.push_back(std::move(complaint));
    }
    return false;
  }
}

}  // namespace isolaw
