#include "isolaw/base/printable.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <iterator>

namespace isolaw {
namespace {

std::uint32_t code_point(std::string_view sequence) {
  auto const byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(sequence[i])); };
  std::uint32_t code = sequence.size() == 1 ? byte(0) : byte(0) & (0x7Fu >> sequence.size());
  for (std::size_t i = 1; i < sequence.size(); ++i) code = code << 6 | (byte(i) & 0x3Fu);
  return code;
}

bool is_printable_code(std::uint32_t code) {
  bool const control = code < 0x20 || (code >= 0x7F && code < 0xA0);
  bool const separator = code == 0x2028 || code == 0x2029;
  bool const turns_direction = (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
  return !control && !separator && !turns_direction;
}

}  // namespace

std::size_t utf8_length(std::string_view bytes) {
  auto const lead = static_cast<unsigned char>(bytes.front());
  std::size_t const length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || length > bytes.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if (!continues_character(bytes[i])) return 0;
  return length;
}

bool is_printable(std::string_view text) {
  while (!text.empty()) {
    auto const length = utf8_length(text);
    if (length == 0 || !is_printable_code(code_point(text.substr(0, length)))) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text, bool keep_lines) {
  std::string clean;
  clean.reserve(text.size());
  auto const out = std::back_inserter(clean);
  while (!text.empty()) {
    auto const length = utf8_length(text);
    auto const sequence = text.substr(0, length == 0 ? 1 : length);
    auto const code = length == 0 ? static_cast<unsigned char>(text.front()) : code_point(sequence);
    if (length != 0 && (is_printable_code(code) || (keep_lines && code == '\n')))
      clean += sequence;
    else if (code == '\n' || code == '\r' || code == '\t')
      clean += code == '\n' ? "\\n" : code == '\r' ? "\\r" : "\\t";
    else if (code < 0x100)
      fmt::format_to(out, "\\x{:02x}", code);
    else
      fmt::format_to(out, "\\u{:04x}", code);
    text.remove_prefix(sequence.size());
  }
  return clean;
}

std::string on_one_line(std::string_view text) {
  std::string line;
  for (char const c : text) line += c == '\n' ? std::string("; ") : std::string(1, c);
  return printable(line);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t readable = 40;
  auto clean = printable(text);
  if (clean.size() > readable) {
    auto end = readable;
    while (end > 0 && continues_character(clean[end])) --end;
    clean = clean.substr(0, end) + "...";
  }
  return "'" + clean + "'";
}

}  // namespace isolaw
