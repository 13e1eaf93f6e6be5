// Makes text from other people's files safe to show. Control characters could move the cursor, forge or reorder lines.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace isolaw {

// The length of the UTF-8 sequence at the start of `bytes`, which must not be empty; 0 if the sequence is invalid.
std::size_t utf8_length(std::string_view bytes);
constexpr bool continues_character(char byte) {  // true for the second and later bytes of a character
  return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
}
constexpr std::size_t character_count(std::string_view utf8) {
  return utf8.size() - static_cast<std::size_t>(std::ranges::count_if(utf8, continues_character));
}
// True if the text is UTF-8 without control characters, line or paragraph separators, and characters that embed or
// override a direction of writing.
bool is_printable(std::string_view text);
// Replaces unprintable characters by visible codes such as \n, \x1b and \u202e. With `keep_lines`, line breaks stay.
std::string printable(std::string_view text, bool keep_lines = false);
std::string on_one_line(std::string_view text);  // printable(), with lines joined: "a; b"
// For a message: replaces control characters by codes, cuts what is longer than 40 bytes and adds single quotes.
std::string in_quotes(std::string_view text);

}  // namespace isolaw
