// Reads TOML files from other people safely. The reader limits the nesting before the parser runs, collects every
// mistake with its line, and accepts only values of the expected kind and printable text of limited length.
#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "isolaw/base/error.hpp"

namespace isolaw {

using Json = nlohmann::ordered_json;

struct TomlMessages {
  std::string_view kind;    // such as "lot file"
  std::string_view advice;  // the remedy for a file that is not TOML
};

// Throws one Error with the line if the text is not TOML, or if its tables and lists nest more than 64 levels deep.
toml::table parse_toml(std::string_view text, std::string const& file, TomlMessages const& messages);
// Converts a JSON object to a TOML table as if the parser had read it from a file, but without line numbers. A key with
// the value null is left out. Messages call the object `file`. Throws Error if the JSON value is no object or nests
// more than 8 levels deep.
toml::table toml_of(Json const& tables, std::string const& file, TomlMessages const& messages);
// Throws one Error with the complaints, if there are any. If there are more than most_complaints, the Error holds the
// first most_complaints of them and says that there are more.
void throw_complaints(std::vector<Complaint> complaints, std::string const& file);

// Reads the keys of one table, collects complaints about them, and remembers which keys were asked for.
class TomlTable {
 public:
  static constexpr std::size_t longest_text = 512;  // bytes, unless the caller says otherwise
  static constexpr std::size_t most_items = 1000;   // in a list
  static constexpr std::size_t most_complaints = 50;
  // Messages call the table `name`, such as "[calibrate]"; it is empty for the file itself. A table that was not parsed
  // from text has no line, so messages add its key `name` or `file` to the name of the file.
  TomlTable(toml::table const& table, std::string file, std::string name, std::vector<Complaint>& complaints);

  std::string where(toml::node const& node) const;
  std::string const& file() const { return file_; }

  // Calls take(value) if the key has a value of type T. An Error from take() becomes complaints at the value's line.
  template <class T, class Take>
  void value(std::string_view key, std::string_view expected, Take&& take, std::size_t longest = longest_text) {
    auto const* node = find(key);
    if (node == nullptr) return;
    auto const found = node->value<T>();
    if (!found || !is_kind<T>(*node)) return complain_value(*node, key, expected, is_kind<T>(*node));
    if constexpr (std::is_same_v<T, std::string>)
      if (!accept_text(*node, key, *found, longest)) return;
    guarded(*node, key, [&] { take(*found); });
  }
  // Calls take() for the key's text or, if it is a list, for each text of the list.
  void strings(std::string_view key, std::function<void(std::string const&)> const& take,
               std::size_t longest = longest_text);
  // Passes the key's value, if there is one, to take(). A list or table is passed as it grows, first [a], then [a, b],
  // so that an Error from take() is about the item added last. The Error becomes complaints at the line of this item,
  // and reading goes on without the item.
  void json(std::string_view key, std::function<void(Json const&)> const& take, std::size_t longest = longest_text);
  toml::table const* table(std::string_view key);  // the sub-table, or nullptr
  toml::node const* find(std::string_view key);    // returns the node or nullptr; the key then counts as known
  void refuse_unknown();                           // complains about every key that was not asked for
  void complain(toml::node const& node, std::string found, std::string allowed, std::string advice = {});
  void complain(std::string found, std::string allowed, std::string advice = {}) {
    complain(table_, std::move(found), std::move(allowed), std::move(advice));
  }

 protected:
  // True if the text is printable and short enough for terminals, tables and pages. Complains if it is not.
  bool accept_text(toml::node const& node, std::string_view key, std::string const& text, std::size_t longest);
  // Calls action() and returns true unless it threw an Error. Collects the complaints of the Error.
  bool guarded(toml::node const& node, std::string_view key, std::function<void()> const& action);

 private:
  // True if the value is of the kind T, where a whole number is also a real one. toml++ itself would convert 1 to true
  // and true to a number.
  template <class T>
  static bool is_kind(toml::node const& node) {
    if constexpr (std::is_same_v<T, bool>)
      return node.is_boolean();
    else if constexpr (std::is_integral_v<T>)
      return node.is_integer();
    else if constexpr (std::is_floating_point_v<T>)
      return node.is_number();
    else
      return node.is_string();
  }
  // The node's value if it is a text, a number, a bool or a date (as text). Complains about any other node.
  std::optional<Json> scalar(toml::node const& node, std::string_view key, std::size_t longest);
  // Complains that a value is not `expected`, or, if `of_kind` is true, that a whole number is too large for its type.
  void complain_value(toml::node const& node, std::string_view key, std::string_view expected, bool of_kind);

  toml::table const& table_;
  std::string file_, name_;
  std::vector<Complaint>& complaints_;
  std::set<std::string> known_;
};

}  // namespace isolaw
