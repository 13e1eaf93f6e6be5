#include "isolaw/render/page/assets.hpp"

#include <cstddef>
#include <cstdint>

// Defined in the assembly file that CMake makes from assets.s.in.
extern "C" {
extern char const isolaw_asset_page_html[];
extern std::uint64_t const isolaw_asset_page_html_size;
extern char const isolaw_asset_page_css[];
extern std::uint64_t const isolaw_asset_page_css_size;
extern char const isolaw_asset_page_js[];
extern std::uint64_t const isolaw_asset_page_js_size;
extern char const isolaw_asset_plotly_js[];
extern std::uint64_t const isolaw_asset_plotly_js_size;
}

namespace isolaw::render::assets {

std::string_view page_html() {
  return {isolaw_asset_page_html, std::size_t{isolaw_asset_page_html_size}};
}
std::string_view page_css() {
  return {isolaw_asset_page_css, std::size_t{isolaw_asset_page_css_size}};
}
std::string_view page_js() {
  return {isolaw_asset_page_js, std::size_t{isolaw_asset_page_js_size}};
}
std::string_view plotly_js() {
  return {isolaw_asset_plotly_js, std::size_t{isolaw_asset_plotly_js_size}};
}

}  // namespace isolaw::render::assets
