// Reads TOML files from outside safely: bounds the nesting before the parser sees it, collects every mistake with its
// line, converts no kind of value into another, and takes only printable text of bounded length.
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
  std::string kind;    // such as "lot file"
  std::string advice;  // for a file that is not TOML
};

// Throws one Error with the line if the text nests deeper than any such file needs or is not TOML.
toml::table parse_toml(std::string_view text, std::string const& file, TomlMessages const& messages);
// Throws one Error with all complaints, if there are any. If there are more than most_complaints, it only says so.
void throw_complaints(std::vector<Complaint> complaints, std::string const& file);

// Reads the keys of one table, collects complaints about them, and remembers which keys were asked for.
class TomlTable {
 public:
  static constexpr std::size_t longest_text = 512;  // bytes, unless the caller says otherwise
  static constexpr std::size_t most_items = 1000;   // in a list
  static constexpr std::size_t most_complaints = 50;
  // `name` is how messages call the table: "[calibrate]"; empty for the file itself.
  TomlTable(toml::table const& table, std::string file, std::string name, std::vector<Complaint>& complaints);

  std::string where(toml::node const& node) const;

  // Calls take(value) if the key is there with a value of type T. An Error of take() becomes complaints at its line.
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
  // Calls take() for a text, or for each text of a list.
  void strings(std::string_view key, std::function<void(std::string const&)> const& take,
               std::size_t longest = longest_text);
  // Passes the key's value to take(), if the key is there. A list is passed as it grows, so that an Error of take()
  // belongs to the item just added: for a, b, c first [a], then [a, b], then [a, b, c]. A table is passed entry by
  // entry, each as {name: value}. An Error becomes complaints at the item's line, and the list goes on without that
  // item.
  void json(std::string_view key, std::function<void(Json const&)> const& take, std::size_t longest = longest_text);
  toml::table const* table(std::string_view key);  // the sub-table, or nullptr
  toml::node const* find(std::string_view key);    // the node or nullptr; the key then counts as known
  void refuse_unknown();                           // complains about every key that was not asked for
  void complain(toml::node const& node, std::string found, std::string allowed, std::string advice = {});
  void complain(std::string found, std::string allowed, std::string advice = {}) {
    complain(table_, std::move(found), std::move(allowed), std::move(advice));
  }

 protected:
  // Whether the text is printable and short enough for terminals, tables and pages; complains if it is not.
  bool accept_text(toml::node const& node, std::string_view key, std::string const& text, std::size_t longest);
  // Calls action() and returns whether it threw no Error. Collects the complaints of an Error.
  bool guarded(toml::node const& node, std::string_view key, std::function<void()> const& action);

 private:
  // toml++ would convert 1 to true and true to a number.
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
  // The value of a text, number, bool or date (as text). Other nodes and refused texts give nullopt and a complaint.
  std::optional<Json> scalar(toml::node const& node, std::string_view key, std::size_t longest);
  // `of_kind` is true for a whole number that its type cannot hold, and false for a value of another kind.
  void complain_value(toml::node const& node, std::string_view key, std::string_view expected, bool of_kind);

  toml::table const& table_;
  std::string file_, name_;
  std::vector<Complaint>& complaints_;
  std::set<std::string> known_;
};

}  // namespace isolaw
