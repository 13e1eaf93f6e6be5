#include "isolaw/data/files/exporter.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "isolaw/base/words.hpp"

namespace isolaw::data {
namespace {

using FileLines = std::span<std::string_view const>;

std::string_view unquoted(std::string_view line) {
  line = trimmed(line);
  while (!line.empty() && (line.front() == '"' || line.front() == ' ')) line.remove_prefix(1);
  return line;
}

bool opens(FileLines lines, std::string_view word) {
  return !lines.empty() && unquoted(lines.front()).starts_with(word);
}

bool is_lvm(FileLines lines) {
  return opens(lines, "LabVIEW Measurement");
}
// MTS Series 793 writes program, language and the signs for numbers and dates: "MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A".
bool is_mts_793(FileLines lines) {
  return opens(lines, "MTS793|");
}
bool is_dasylab(FileLines lines) {
  return opens(lines, "DASYLab - V");
}

// MTS TestSuite writes four lines about the origin of the file above the names of the columns.
bool is_mts_test_suite(FileLines lines) {
  constexpr std::array<std::string_view, 4> keys{"File Path:", "Test:", "Test Run:", "Date:"};
  if (lines.size() < keys.size()) return false;
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (!unquoted(lines[i]).starts_with(keys[i])) return false;
  return true;
}

// Bluehill Universal writes a line "Raw Data" and then names with units. Bluehill 3 writes names, and units below them.
bool is_bluehill(FileLines lines) {
  constexpr std::size_t longest_head = 200;
  lines = lines.first(std::min(lines.size(), longest_head));
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    if (unquoted(lines[i]).starts_with("Raw Data") && unquoted(lines[i + 1]).starts_with("Time")) return true;
    bool const names = unquoted(lines[i]).starts_with("Time") && lines[i].find("Extension") != std::string_view::npos;
    if (names && unquoted(lines[i + 1]).starts_with("(s)")) return true;
  }
  return false;
}

struct Sign {
  bool (*is)(FileLines);
  Exporter exporter;
};
constexpr std::array signs{
    Sign{is_lvm, {.name = "LabVIEW measurement file"}},
    Sign{is_mts_793,
         {.name = "data file of MTS Series 793 (Station Manager, MultiPurpose TestWare)", .own_axis = true}},
    Sign{is_mts_test_suite, {.name = "data export of MTS TestSuite", .own_axis = true}},
    Sign{is_bluehill, {.name = "raw data export of Instron Bluehill", .own_axis = true}},
    Sign{is_dasylab, {.name = "ASCII file of DASYLab"}},
};

}  // namespace

std::optional<Exporter> exporter_of(FileLines lines) {
  auto const found = std::ranges::find_if(signs, [&](Sign const& sign) { return sign.is(lines); });
  return found == signs.end() ? std::nullopt : std::optional(found->exporter);
}

}  // namespace isolaw::data
