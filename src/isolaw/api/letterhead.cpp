#include "isolaw/api/letterhead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/files/text.hpp"

namespace isolaw {
namespace {

constexpr long most_lines = 12;
constexpr std::size_t largest_bytes = 1'000'000;

struct Picture {
  std::string_view ending, type, mark;  // a file begins with `mark`; an .svg file may have it anywhere
};
constexpr Picture pictures[]{{".svg", "image/svg+xml", "<svg"},
                             {".png", "image/png", "\x89PNG"},
                             {".jpg", "image/jpeg", "\xFF\xD8"},
                             {".jpeg", "image/jpeg", "\xFF\xD8"}};

std::string base64(std::string_view bytes) {  // RFC 4648, with padding
  constexpr std::string_view signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    auto const byte = [&](std::size_t k) { return k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U; };
    unsigned const three = byte(i) << 16U | byte(i + 1) << 8U | byte(i + 2);
    for (unsigned k = 0; k < 4; ++k) text += i + k <= bytes.size() ? signs[three >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

}  // namespace

std::string load_letterhead(std::string const& file) {
  auto const allowed = fmt::format("a picture (.svg, .png, .jpg, .jpeg), or text (.txt) of 1 to {} lines", most_lines);
  auto const refuse = [&](std::string found) {
    return Error({.where = "letterhead " + in_quotes(file), .found = std::move(found), .allowed = allowed});
  };
  auto const ending = lower(std::filesystem::path(file).extension().string());
  auto const picture = std::ranges::find(pictures, ending, &Picture::ending);
  bool const is_picture = picture != std::end(pictures);
  if (!is_picture && ending != ".txt") throw refuse("its name has no ending of a picture or a text");
  auto const bytes =
      read_file(file, {.largest_bytes = largest_bytes, .allowed = allowed, .when_too_large = "a smaller file"});
  if (is_picture) {
    auto const at = bytes.find(picture->mark);
    if (at != 0 && (at == bytes.npos || ending != ".svg")) throw refuse("the file holds no such picture");
    return fmt::format("data:{};base64,{}", picture->type, base64(bytes));
  }
  auto text = data::to_utf8(bytes);
  text.resize(text.find_last_not_of(" \t\r\n") + 1);  // npos + 1 is 0: a text of blanks only becomes empty
  auto const lines = 1 + std::ranges::count(text, '\n');
  if (text.empty()) throw refuse("the file is empty");
  if (lines > most_lines) throw refuse(fmt::format("the file has {} lines", lines));
  return text;
}

}  // namespace isolaw
