#include "isolaw/programs/header_parts.hpp"

#include <cstddef>
#include <cstdint>

// Defined in the assembly file that CMake makes from header/parts.s.in.
#define ISOLAW_HEADER_PART(name)            \
  extern char const isolaw_header_##name[]; \
  extern std::uint64_t const isolaw_header_##name##_size;
extern "C" {
ISOLAW_HEADER_PART(numbers)
ISOLAW_HEADER_PART(flow)
ISOLAW_HEADER_PART(material)
ISOLAW_HEADER_PART(bilinear)
ISOLAW_HEADER_PART(jankowski)
ISOLAW_HEADER_PART(vaiana)
ISOLAW_HEADER_PART(bouc_wen)
ISOLAW_HEADER_PART(abe_parts)
ISOLAW_HEADER_PART(abe)
ISOLAW_HEADER_PART(abe_y0)
ISOLAW_HEADER_PART(hwang_wu)
}
#undef ISOLAW_HEADER_PART

namespace isolaw::programs {
namespace {

std::string_view text(char const* begin, std::uint64_t size) {
  return {begin, std::size_t{size}};
}

}  // namespace

std::string_view header_numbers() {
  return text(isolaw_header_numbers, isolaw_header_numbers_size);
}
std::string_view header_material() {
  return text(isolaw_header_material, isolaw_header_material_size);
}

std::vector<std::string_view> header_parts(std::string_view law) {
  auto const flow = text(isolaw_header_flow, isolaw_header_flow_size);
  auto const abe_parts = text(isolaw_header_abe_parts, isolaw_header_abe_parts_size);
  if (law == "bilinear") return {text(isolaw_header_bilinear, isolaw_header_bilinear_size)};
  if (law == "jankowski") return {text(isolaw_header_jankowski, isolaw_header_jankowski_size)};
  if (law == "vaiana") return {text(isolaw_header_vaiana, isolaw_header_vaiana_size)};
  if (law == "bouc-wen") return {flow, text(isolaw_header_bouc_wen, isolaw_header_bouc_wen_size)};
  if (law == "abe") return {flow, abe_parts, text(isolaw_header_abe, isolaw_header_abe_size)};
  if (law == "abe-y0") return {flow, abe_parts, text(isolaw_header_abe_y0, isolaw_header_abe_y0_size)};
  if (law == "hwang-wu") return {text(isolaw_header_hwang_wu, isolaw_header_hwang_wu_size)};
  return {};
}

}  // namespace isolaw::programs
