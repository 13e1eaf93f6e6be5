// Reads the block of JSON data in the HTML page of a report.
#pragma once

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

namespace isolaw {

inline constexpr std::string_view page_data_opening = R"(<script type="application/json" id="isolaw-data">)";

inline nlohmann::ordered_json page_data(std::string_view html) {
  auto const begin = html.find(page_data_opening);
  if (begin == std::string_view::npos) throw std::runtime_error("a page without data");
  auto const text = html.substr(begin + page_data_opening.size());
  return nlohmann::ordered_json::parse(text.substr(0, text.find("</script>")));
}

}  // namespace isolaw
