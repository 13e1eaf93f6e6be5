// Turns findings into their sentences, so that tests can compare the words.
#pragma once

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/wording/table.hpp"

namespace isolaw {

inline void PrintTo(Finding const& finding, std::ostream* out) {
  *out << wording::remark(finding);
}
inline std::string text_of(Finding const& finding) {
  return wording::remark(finding);
}
inline std::string text_of(std::optional<Finding> const& finding) {
  return finding ? wording::remark(*finding) : std::string();
}
inline std::string text_of(std::vector<Finding> const& findings) {
  return wording::reasons(findings);
}
// Returns a finding whose whole sentence is `text`.
inline Finding stated(std::string text) {
  return {.kind = FindingKind::file_format, .words = {{"text", std::move(text)}}};
}
// Returns whether `part` occurs in the sentence of a finding, or in the paragraph that the sentences of several
// findings make.
inline bool contains(Finding const& finding, std::string_view part) {
  return wording::sentence(finding).find(part) != std::string::npos;
}
inline bool contains(std::vector<Finding> const& findings, std::string_view part) {
  return wording::paragraph(findings).find(part) != std::string::npos;
}
inline bool contains(std::optional<Finding> const& finding, std::string_view part) {
  return finding && contains(*finding, part);
}
inline std::ostream& operator<<(std::ostream& out, std::vector<Finding> const& findings) {
  return out << wording::paragraph(findings, record_units, "\n");
}
inline bool says(std::vector<Finding> const& findings, std::string_view part) {
  for (auto const& text : wording::remarks(findings))
    if (text.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace isolaw
