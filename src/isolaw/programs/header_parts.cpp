#include "isolaw/programs/header_parts.hpp"

#include <algorithm>
#include <string>

#include "isolaw/base/embedded.hpp"

namespace isolaw::programs {

std::span<Embedded const> header_files();

namespace {

std::string_view part(std::string_view name) {
  return embedded_text(header_files(), name);
}

void add(std::vector<std::string_view>& parts, std::string_view text) {
  constexpr std::string_view include = "#include \"";
  while (text.starts_with(include)) {
    text.remove_prefix(include.size());
    add(parts, part(text.substr(0, text.find('"'))));
    text.remove_prefix(text.find('\n') + 1);
  }
  if (std::ranges::find(parts, text) == parts.end()) parts.push_back(text);
}

}  // namespace

std::string_view header_numbers() {
  return part("numbers.inc");
}
std::vector<std::string_view> header_material() {
  return {part("motion.inc"), part("material.inc")};
}

std::vector<std::string_view> header_parts(std::string_view law) {
  auto name = std::string(law) + ".inc";
  std::ranges::replace(name, '-', '_');
  std::vector<std::string_view> parts;
  if (std::ranges::find(header_files(), name, &Embedded::name) != header_files().end()) add(parts, part(name));
  return parts;
}

bool remembers_turning_points(std::string_view law) {
  auto const parts = header_parts(law);
  return std::ranges::any_of(parts,
                             [](std::string_view text) { return text.find("struct TurningPoints") != text.npos; });
}

}  // namespace isolaw::programs
