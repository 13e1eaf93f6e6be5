// JSON text, written straight to a string: shortest round-trip numbers, invalid UTF-8 replaced by U+FFFD, and null for
// everything that is not a finite number. A page of 160 devices holds a million numbers: no document tree is built.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw {

class JsonWriter {
 public:
  enum class Layout { compact, indented };  // indented: two spaces per level, as nlohmann's dump(2)

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
  // Rounded to `digits` significant digits: for numbers that are drawn rather than computed with.
  JsonWriter& rounded(std::optional<double> const& number, int digits);
  // The same of many, on one line however the rest is laid out: curves.
  JsonWriter& line(std::vector<double> const& numbers, int digits);
  JsonWriter& null() { return put("null"); }
  // Text that is JSON already. What does not parse is written as a string: a setting is never lost.
  JsonWriter& json(std::string_view text);
  JsonWriter& value(std::vector<std::string> const& texts);

  template <class T>
  JsonWriter& member(std::string_view name, T const& of) {
    return key(name).value(of);
  }

  std::string take();  // the document; the writer is empty afterwards

 private:
  JsonWriter& put(std::string_view json);  // a value
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  void start_value();
  void new_line();

  std::string text_;
  std::vector<bool> filled_;  // per open bracket: it holds something already
  bool indented_;
  bool after_key_ = false;
};

// `number` to `digits` significant digits, shortest form ("0.0791", "2.32e+05"); "" when there is none.
std::string to_text(std::optional<double> const& number, int digits);
// Shortest text that reads back as the same double; "" when it is empty or not finite.
std::string to_text(std::optional<double> const& number);

// JSON that may stand inside <script>: no "<", U+2028 or U+2029 remains, and it parses to the same document.
std::string script_safe(std::string_view json);

}  // namespace isolaw
