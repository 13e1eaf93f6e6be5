// The files of assets/ and the plotting script, embedded when the library is built.
#pragma once

#include <string_view>

namespace isolaw::render::assets {

std::string_view page_html();  // with the placeholders that html.cpp fills
std::string_view page_css();
std::string_view page_js();
std::string_view plotly_js();

}  // namespace isolaw::render::assets
