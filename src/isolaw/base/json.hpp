// Writes JSON straight into a string. A number takes the shortest text that reads back as the same number; one that is
// not finite becomes null. Invalid UTF-8 becomes U+FFFD. The writer does not build the document in memory first, since
// the report page of 160 devices holds a million numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw {

class JsonWriter {
 public:
  enum class Layout { compact, indented };  // indented: two spaces per level, like nlohmann's dump(2)

  explicit JsonWriter(Layout layout = Layout::compact) : indented_(layout == Layout::indented) {}

  JsonWriter& begin_object() { return open('{'); }
  JsonWriter& end_object() { return close('}'); }
  JsonWriter& begin_array() { return open('['); }
  JsonWriter& end_array() { return close(']'); }
  JsonWriter& key(std::string_view name);

  JsonWriter& value(std::string_view text);
  JsonWriter& value(char const* text) { return value(std::string_view(text)); }
  JsonWriter& value(std::string const& text) { return value(std::string_view(text)); }
  JsonWriter& value(bool flag) { return put(flag ? "true" : "false"); }
  JsonWriter& value(int number) { return put(std::to_string(number)); }
  JsonWriter& value(std::uint64_t number) { return put(std::to_string(number)); }
  JsonWriter& value(double number);  // null when not finite
  JsonWriter& value(std::optional<double> const& number);
  JsonWriter& rounded(std::optional<double> const& number, int digits);  // to `digits` significant digits; for plots
  JsonWriter& line(std::vector<double> const& numbers, int digits);  // rounded, on one line in any layout; for curves
  JsonWriter& null() { return put("null"); }
  // Inserts `text`, which should be JSON. Text that does not parse is written as a string instead.
  JsonWriter& json(std::string_view text);
  JsonWriter& value(std::vector<std::string> const& texts);

  template <class T>
  JsonWriter& member(std::string_view name, T const& content) {
    return key(name).value(content);
  }
  // object() writes an object whose members come from `write`. array() calls `write` to write a value for each item.
  // objects() writes an array with an object for each item.
  template <class Write>
  JsonWriter& object(Write const& write) {
    begin_object(), write();
    return end_object();
  }
  template <class Items, class Write>
  JsonWriter& array(Items const& items, Write const& write) {
    begin_array();
    for (auto const& item : items) write(item);
    return end_array();
  }
  template <class Items, class Write>
  JsonWriter& objects(Items const& items, Write const& write) {
    return array(items, [&](auto const& item) { object([&] { write(item); }); });
  }

  std::string take();  // returns the document and empties the writer

 private:
  JsonWriter& put(std::string_view json);
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  void start_value();
  void new_line();

  std::string text_;
  std::vector<bool> filled_;  // for each open bracket: whether it already holds a value
  bool indented_;
  bool after_key_ = false;
};

// The number with `digits` significant digits in its shortest form ("0.0791", "2.32e+05"); "" if empty or not finite.
std::string to_text(std::optional<double> const& number, int digits);
std::string to_text(std::optional<double> const& number);  // shortest text that reads back as the same number, or ""
// Escapes "<", U+2028 and U+2029, so that the text is safe inside <script> and parses to the same document.
std::string script_safe(std::string_view json);

}  // namespace isolaw
