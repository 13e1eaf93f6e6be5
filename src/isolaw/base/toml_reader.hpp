// TOML files that others wrote: nesting bounded before the parser sees it, every mistake collected with its line, no
// conversions between kinds of values, text printable and of bounded length. What a file means is its reader's affair.
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

// What a message about the whole file says.
struct TomlMessages {
  std::string kind;  // "lot file"
  std::string advice;
};

// Throws one Error with the line: nested deeper than any such file needs, or no TOML.
toml::table parse_toml(std::string_view text, std::string const& file, TomlMessages const& messages);

// Throws what was collected, if anything; of very many complaints the first ones and a line that says so.
void throw_complaints(std::vector<Complaint> complaints, std::string const& file);

// Reads keys of one table, collects what is wrong with them, and remembers which keys are known.
class TomlTable {
 public:
  static constexpr std::size_t longest_text = 512;  // bytes, where a key does not say otherwise
  static constexpr std::size_t most_items = 1000;   // of a list
  static constexpr std::size_t most_complaints = 50;

  // `name` is the table in messages: "[calibrate]", or empty for the file itself.
  TomlTable(toml::table const& table, std::string file, std::string name, std::vector<Complaint>& complaints);

  std::string where(toml::node const& node) const;

  // Calls take(value) when the key is there and of type T; an Error of take() becomes complaints at the key's line.
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
  // A text or a list of texts, one take() each.
  void strings(std::string_view key, std::function<void(std::string const&)> const& take,
               std::size_t longest = longest_text);
  // Calls take() with the value of the key, when it is there: of a list once for each item, with those before it that
  // were taken; of a table once for each entry. What take() refuses is said at the line of the item.
  void json(std::string_view key, std::function<void(Json const&)> const& take, std::size_t longest = longest_text);
  // A sub-table; nullptr when there is none.
  toml::table const* table(std::string_view key);
  // The node of a key, which counts as known; nullptr when there is none.
  toml::node const* find(std::string_view key);
  // Every key that nobody asked for is a mistake.
  void refuse_unknown();
  void complain(toml::node const& node, std::string found, std::string allowed, std::string advice = {});
  // About the table as a whole.
  void complain(std::string found, std::string allowed, std::string advice = {}) {
    complain(table_, std::move(found), std::move(allowed), std::move(advice));
  }

 protected:
  // Names go to terminals, tables and pages.
  bool accept_text(toml::node const& node, std::string_view key, std::string const& text, std::size_t longest);
  // Whether the action refused nothing.
  bool guarded(toml::node const& node, std::string_view key, std::function<void()> const& action);

 private:
  // No conversions: true is no number, and 1 is not true.
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
  // Of text, a number, true and false, or a date, which is text; no value of what is none of these, or not accepted.
  std::optional<Json> scalar(toml::node const& node, std::string_view key, std::size_t longest);
  // Of another kind, or of that kind, but a whole number beyond those of its type.
  void complain_value(toml::node const& node, std::string_view key, std::string_view expected, bool of_kind);

  toml::table const& table_;
  std::string file_, name_;
  std::vector<Complaint>& complaints_;
  std::set<std::string> known_;
};

}  // namespace isolaw
