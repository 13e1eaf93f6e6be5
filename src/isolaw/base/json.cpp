#include "isolaw/base/json.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace isolaw {
namespace {

template <class... Format>
std::string number_text(double number, Format... format) {
  std::array<char, 32> buffer;
  auto const result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number, format...);
  return {buffer.data(), result.ptr};
}

std::string quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

JsonWriter& JsonWriter::key(std::string_view name) {
  start_value();
  text_ += quoted(name);
  text_ += indented_ ? ": " : ":";
  after_key_ = true;
  return *this;
}

JsonWriter& JsonWriter::value(std::string_view text) {
  return put(quoted(text));
}

JsonWriter& JsonWriter::value(double number) {
  return std::isfinite(number) ? put(number_text(number)) : null();
}

JsonWriter& JsonWriter::value(std::optional<double> const& number) {
  return number ? value(*number) : null();
}

JsonWriter& JsonWriter::rounded(std::optional<double> const& number, int digits) {
  auto const text = to_text(number, digits);
  return text.empty() ? null() : put(text);
}

JsonWriter& JsonWriter::line(std::vector<double> const& numbers, int digits) {
  std::string all = "[";
  for (double const number : numbers) {
    auto const text = to_text(number, digits);
    all += text.empty() ? "null" : text;
    all += ',';
  }
  if (all.back() == ',') all.pop_back();
  return put(all + ']');
}

JsonWriter& JsonWriter::json(std::string_view text) {
  auto const document = nlohmann::ordered_json::parse(text, nullptr, false);
  if (document.is_discarded()) return value(text);
  auto const replace = nlohmann::json::error_handler_t::replace;
  if (!indented_) return put(document.dump(-1, ' ', false, replace));
  start_value();
  std::string const indent(2 * filled_.size(), ' ');
  for (char const c : document.dump(2, ' ', false, replace)) {
    text_ += c;
    // this break belongs to the layout, because dump() escapes line breaks within texts
    if (c == '\n') text_ += indent;
  }
  return *this;
}

JsonWriter& JsonWriter::value(std::vector<std::string> const& texts) {
  begin_array();
  for (auto const& text : texts) value(text);
  return end_array();
}

std::string JsonWriter::take() {
  filled_.clear();
  after_key_ = false;
  return std::exchange(text_, {});
}

JsonWriter& JsonWriter::put(std::string_view json) {
  start_value();
  text_ += json;
  return *this;
}

JsonWriter& JsonWriter::open(char bracket) {
  put({&bracket, 1});
  filled_.push_back(false);
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  bool const filled = filled_.back();
  filled_.pop_back();
  if (filled) new_line();
  text_ += bracket;
  return *this;
}

void JsonWriter::start_value() {
  if (std::exchange(after_key_, false) || filled_.empty()) return;
  if (filled_.back()) text_ += ',';
  filled_.back() = true;
  new_line();
}

void JsonWriter::new_line() {
  if (!indented_) return;
  text_ += '\n';
  text_.append(2 * filled_.size(), ' ');
}

std::string to_text(std::optional<double> const& number, int digits) {
  if (!number || !std::isfinite(*number)) return {};
  return number_text(*number == 0.0 ? 0.0 : *number, std::chars_format::general, digits);
}

std::string to_text(std::optional<double> const& number) {
  return number && std::isfinite(*number) ? number_text(*number) : std::string();
}

std::string script_safe(std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    if (json[i] == '<') {
      safe += "\\u003c";
    } else if (json.substr(i, 3) == "\xe2\x80\xa8" || json.substr(i, 3) == "\xe2\x80\xa9") {
      safe += json[i + 2] == '\xa8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      safe += json[i];
    }
  }
  return safe;
}

}  // namespace isolaw
