#include "isolaw/programs/header_parts.hpp"

#include "isolaw/base/embedded.hpp"

namespace isolaw::programs {

std::span<Embedded const> header_files();

namespace {

std::string_view part(std::string_view name) {
  return embedded_text(header_files(), name);
}

}  // namespace

std::string_view header_numbers() {
  return part("numbers.inc");
}
std::string_view header_material() {
  return part("material.inc");
}

std::vector<std::string_view> header_parts(std::string_view law) {
  if (law == "bilinear") return {part("bilinear.inc")};
  if (law == "jankowski") return {part("jankowski.inc")};
  if (law == "vaiana") return {part("vaiana.inc")};
  if (law == "bouc-wen") return {part("flow.inc"), part("bouc_wen.inc")};
  if (law == "abe") return {part("flow.inc"), part("abe_parts.inc"), part("abe.inc")};
  if (law == "abe-y0") return {part("flow.inc"), part("abe_parts.inc"), part("abe_y0.inc")};
  if (law == "hwang-wu") return {part("hwang_wu.inc")};
  return {};
}

}  // namespace isolaw::programs
