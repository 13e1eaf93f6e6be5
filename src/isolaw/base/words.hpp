// Small functions for text that a person typed or a file holds: trimming, lower case, numbers, lists of words.
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace isolaw {

constexpr std::string_view trimmed(std::string_view text) {  // removes blanks and tabs at both ends
  auto const first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_letter(char c) {  // ASCII only
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

inline std::string lower(std::string_view text) {  // changes ASCII letters only
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

// Returns the part of `text` before the first separator, or all of it, and removes the part and the separator.
constexpr std::string_view take_part(std::string_view& text, char separator) {
  auto const part = text.substr(0, text.find(separator));
  text.remove_prefix(part.size() == text.size() ? part.size() : part.size() + 1);
  return part;
}

// Converts the text if all of it is a number that T can hold. The decimal sign is a point; a leading '+' is allowed.
template <class T>
std::optional<T> number_in(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  T value{};
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// Writes a count with its noun: "1 sample", "2 samples".
template <class Count>
std::string counted(Count count, std::string_view one) {
  return std::to_string(count) + " " + std::string(one) + (count == 1 ? "" : "s");
}

// Joins words by a separator: "a, b, c".
template <class Words>
std::string joined(Words const& words, std::string_view separator = ", ") {
  std::string text;
  for (auto const& word : words) {
    if (!text.empty()) text += separator;
    text += word;
  }
  return text;
}

// "a, b, and 3 more": lists only the first `shown` words.
inline std::string shortened(std::vector<std::string> words, std::size_t shown, std::string_view separator = ", ") {
  auto const left_out = words.size() > shown ? words.size() - shown : 0;
  words.resize(words.size() - left_out);
  if (left_out > 0) words.push_back("and " + std::to_string(left_out) + " more");
  return joined(words, separator);
}

}  // namespace isolaw
