#include "isolaw/data/files/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/data/files/sheet_choice.hpp"

namespace isolaw::data {
namespace {

using namespace std::string_view_literals;

struct Magic {
  std::string_view bytes;
  std::string_view what;
  std::string_view advice;
};
constexpr std::string_view save_as_xlsx = "save it as .xlsx without a password, or the sheet as CSV";
constexpr std::string_view export_text = "export the channels as CSV";
constexpr std::string_view unpack = "unpack it first";
constexpr std::array known_formats{
    Magic{"\xD0\xCF\x11\xE0"sv, "an .xls workbook, or one with a password", save_as_xlsx},
    Magic{"%PDF"sv, "a PDF document", export_text},
    Magic{"\x89HDF"sv, "an HDF5 file", export_text},
    Magic{"TDSm"sv, "a TDMS file of National Instruments", export_text},
    Magic{"TDAT"sv, "a data file of Instron Bluehill", export_text},
    Magic{"\x1F\x8B"sv, "a gzip archive", unpack},
    Magic{"\xFD"
          "7zXZ\0"sv,
          "an xz archive", unpack},
    Magic{"BZh"sv, "a bzip2 archive", unpack},
    Magic{"7z\xBC\xAF"sv, "a 7z archive", unpack},
    Magic{"{\\rtf"sv, "an RTF document", "save it as plain text"},
};

[[noreturn]] void refuse(std::string where, std::string found, std::string_view advice = {}) {
  throw Error(Complaint{.where = std::move(where),
                        .found = std::move(found),
                        .allowed = std::string(accepted_formats),
                        .advice = std::string(advice)});
}

void refuse_binary(std::string const& where, std::string_view bytes) {
  for (auto const& format : known_formats)
    if (bytes.starts_with(format.bytes)) refuse(where, "is " + std::string(format.what), format.advice);
  constexpr std::size_t head = 400;
  if (bytes.starts_with("<?xml") && bytes.substr(0, head).find("<usi:tdm") != std::string_view::npos)
    refuse(where, "is the header of a TDM file of National Instruments, whose values are in a file beside it",
           export_text);
  auto const null = bytes.find('\0');
  if (null != std::string_view::npos)
    refuse(where, fmt::format("is a binary file (byte {} is 0)", null + 1), export_text);
}

std::string_view take_line(std::string_view& bytes) {
  auto const ends_line = [](char c) { return c == '\n' || c == '\r'; };
  auto const line = bytes.substr(0, static_cast<std::size_t>(std::ranges::find_if(bytes, ends_line) - bytes.begin()));
  bytes.remove_prefix(line.size());
  bytes.remove_prefix(bytes.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, bytes.size()));
  return line;
}

bool is_utf8(std::string_view bytes) {
  while (!bytes.empty()) {
    auto const length = utf8_length(bytes);
    if (length == 0) return false;
    bytes.remove_prefix(length);
  }
  return true;
}

void append_utf8(std::string& text, std::uint32_t code) {
  auto const put = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | (code >> 6));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xE0 | (code >> 12));
    put(0x80 | ((code >> 6) & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

// The character of a Windows-1252 byte. 0x80 to 0x9F differ from Latin-1; five are unassigned and become U+FFFD.
std::uint32_t windows_1252(unsigned char byte) {
  constexpr std::array<std::uint16_t, 32> high{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                               0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD,
                                               0xFFFD, 0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                               0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD, 0x017E, 0x0178};
  return byte >= 0x80 && byte < 0xA0 ? high[byte - 0x80u] : byte;
}

// The letters U+00C0 to U+00FF without their accents; a blank stands for a sign or for a letter that ASCII lacks.
constexpr std::string_view latin_letters = "AAAAAAACEEEEIIIIDNOOOOO OUUUUY saaaaaaaceeeeiiiidnooooo ouuuuy y";
static_assert(latin_letters.size() == 64);

// A Turkish letter outside Latin-1 without its accent; a blank for any other character.
char turkish_letter(unsigned char lead, unsigned char second) {
  if (lead == 0xC4)
    return second == 0x9E ? 'G' : second == 0x9F ? 'g' : second == 0xB0 ? 'I' : second == 0xB1 ? 'i' : ' ';
  return second == 0x9E ? 'S' : second == 0x9F ? 's' : ' ';
}

bool is_turkish_lead(unsigned char byte) {
  return byte == 0xC4 || byte == 0xC5;
}

}  // namespace

std::optional<LegacyText> decode_legacy(std::string_view bytes, bool (*names_channels)(std::string_view)) {
  if (is_utf8(bytes)) return std::nullopt;
  struct Encoding {
    char const* name;
    std::string_view shown;
  };
  for (auto const& [name, shown] :
       {Encoding{"CP932", "Shift-JIS"}, Encoding{"GB18030", "GB 18030 (Chinese)"},
        Encoding{"CP949", "Windows-949 (Korean)"}, Encoding{"CP1251", "Windows-1251 (Russian)"},
        Encoding{"CP1254", "Windows-1254 (Turkish)"}}) {
    constexpr std::size_t head = 16384;  // at most this many bytes, in whole lines, are searched for names of channels
    auto const cut = bytes.size() <= head ? bytes.size() : bytes.find_last_of("\n\r", head);
    auto const top = converted_to_utf8(bytes.substr(0, cut == std::string_view::npos ? head : cut), name);
    if (!top || !names_channels(*top)) continue;
    if (auto text = converted_to_utf8(bytes, name)) return LegacyText{std::move(*text), shown};
  }
  return std::nullopt;
}

std::optional<LegacyText> decode_wide(std::string_view bytes) {
  struct Encoding {
    char const* name;
    std::string_view mark, comma;  // how the byte order mark and a comma are written
  };
  // UTF-32 is tried first, because its byte order mark (little-endian) begins with the mark of UTF-16.
  constexpr std::array encodings{
      Encoding{"UTF-32LE", "\xFF\xFE\0\0"sv, ",\0\0\0"sv}, Encoding{"UTF-32BE", "\0\0\xFE\xFF"sv, "\0\0\0,"sv},
      Encoding{"UTF-16LE", "\xFF\xFE"sv, ",\0"sv}, Encoding{"UTF-16BE", "\xFE\xFF"sv, "\0,"sv}};
  auto const decoded = [](std::string_view text, Encoding const& encoding) -> std::optional<LegacyText> {
    auto utf8 = converted_to_utf8(text, encoding.name);
    if (!utf8) return std::nullopt;
    return LegacyText{std::move(*utf8), encoding.name};
  };
  for (auto const& each : encodings)
    if (bytes.starts_with(each.mark)) return decoded(bytes.substr(each.mark.size()), each);
  // Without a byte order mark, the positions of zero bytes show the encoding of text that is mostly ASCII.
  constexpr std::size_t head = 400, least = 16;
  auto const top = bytes.substr(0, head);
  if (top.size() < least) return std::nullopt;
  for (auto const& each : encodings) {
    auto const width = each.comma.size();
    std::size_t like_ascii = 0;
    for (std::size_t i = 0; i + width <= top.size(); i += width) {
      bool same = true;
      for (std::size_t k = 0; k < width; ++k) same = same && (top[i + k] == '\0') == (each.comma[k] == '\0');
      like_ascii += same ? 1u : 0u;
    }
    if (10 * like_ascii * width >= 7 * top.size()) return decoded(bytes, each);
  }
  return std::nullopt;
}

std::string load_text(std::filesystem::path const& file) {
  return read_file(file, {.largest_bytes = largest_file_bytes,
                          .allowed = accepted_formats,
                          .when_too_large = "export one test per file, or fewer samples per second"});
}

void check_text(std::string const& where, std::string_view bytes) {
  if (bytes.empty()) refuse(where, "is empty");
  refuse_binary(where, bytes);
  std::size_t lines = 0, line_of_longest = 0, longest = 0;
  while (!bytes.empty()) {
    auto const length = take_line(bytes).size();
    ++lines;
    if (length > longest) {
      longest = length;
      line_of_longest = lines;
    }
  }
  std::vector<Complaint> complaints;
  if (lines > most_lines)
    complaints.push_back({where, fmt::format("{} rows", lines), fmt::format("{} or fewer", most_lines),
                          "thin the record, every tenth row for example, or export one test per file"});
  if (longest > longest_line)
    complaints.push_back({fmt::format("{}:{}", where, line_of_longest), fmt::format("a line of {} characters", longest),
                          fmt::format("{} or fewer", longest_line), "export the channels as CSV, one sample a line"});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

Lines split_lines(std::string_view bytes) {
  Lines text;
  text.byte_order_mark = bytes.starts_with("\xEF\xBB\xBF");
  if (text.byte_order_mark) bytes.remove_prefix(3);
  if (bytes.ends_with('\x1A')) bytes.remove_suffix(1);  // old acquisition programs end a file with this character
  text.windows_1252 = !is_utf8(bytes);
  while (!bytes.empty()) text.lines.push_back(take_line(bytes));
  return text;
}

std::string to_utf8(std::string_view bytes) {
  if (is_utf8(bytes)) return std::string(bytes);
  std::string text;
  for (char const byte : bytes) append_utf8(text, windows_1252(static_cast<unsigned char>(byte)));
  return text;
}

std::string without_accents(std::string_view utf8) {
  std::string text;
  while (!utf8.empty()) {
    auto const length = std::max<std::size_t>(1, utf8_length(utf8));
    auto const lead = static_cast<unsigned char>(utf8.front());
    if (lead < 0x80)
      text += utf8.front();
    else if (lead == 0xC3 && length == 2)
      text += latin_letters[static_cast<unsigned char>(utf8[1]) & 0x3Fu];
    else if (is_turkish_lead(lead) && length == 2)
      text += turkish_letter(lead, static_cast<unsigned char>(utf8[1]));
    else
      text += ' ';
    utf8.remove_prefix(length);
  }
  return text;
}

bool has_turkish_letters(std::string_view utf8) {
  for (std::size_t i = 0; i + 1 < utf8.size(); ++i) {
    auto const lead = static_cast<unsigned char>(utf8[i]);
    if (is_turkish_lead(lead) && turkish_letter(lead, static_cast<unsigned char>(utf8[i + 1])) != ' ') return true;
  }
  return false;
}

std::string in_quotes(std::string_view bytes) {
  return isolaw::in_quotes(to_utf8(bytes));
}

}  // namespace isolaw::data
