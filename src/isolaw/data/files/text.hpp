// Splits a file's bytes into lines. Bytes that are not UTF-8 are read as Windows-1252, the usual encoding on Windows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/words.hpp"

namespace isolaw::data {

inline constexpr std::uintmax_t largest_file_bytes = std::uintmax_t{1} << 30;

inline constexpr std::size_t most_lines = 10'000'000;
inline constexpr std::size_t longest_line = 32'768;  // bytes

// Throws Error if the file does not exist, is no plain file, cannot be read, or exceeds largest_file_bytes.
std::string load_text(std::filesystem::path const& file);
// Throws Error if the bytes are empty, are binary, or exceed most_lines or longest_line.
void check_text(std::string const& where, std::string_view bytes);

struct Lines {
  std::vector<std::string_view> lines;  // views into the bytes, without line ends; line number = index + 1
  bool byte_order_mark = false;
  bool windows_1252 = false;  // some bytes are not UTF-8
};
// Lines may end with LF, CRLF or CR in the same file.
Lines split_lines(std::string_view bytes);

// Text converted to UTF-8. decode_legacy() tries Japanese, Chinese, Korean, Russian and Turkish encodings. It takes the
// first encoding in which `names_channels` finds a channel's name, because a wrong encoding would hardly give such a
// name.
struct LegacyText {
  std::string utf8;
  std::string_view encoding;
};
std::optional<LegacyText> decode_legacy(std::string_view bytes, bool (*names_channels)(std::string_view));

// Converts UTF-16 or UTF-32, with or without a byte order mark, to UTF-8. Returns nullopt if the bytes are no such
// text.
std::optional<LegacyText> decode_wide(std::string_view bytes);
std::string to_utf8(std::string_view bytes);

// Turns text into ASCII: "Déplacement" -> "Deplacement". Other characters become blanks. Keeps upper and lower case.
std::string without_accents(std::string_view utf8);
// Whether the text has Turkish letters that Windows-1252 lacks.
bool has_turkish_letters(std::string_view utf8);
// The text in quotes for messages, cut to a readable length, with control characters spelled out.
std::string in_quotes(std::string_view bytes);

}  // namespace isolaw::data
