#include "isolaw/base/error.hpp"

#include "isolaw/base/printable.hpp"

namespace isolaw {

std::string Error::join(std::vector<Complaint> const& complaints) {
  std::string text;
  for (auto const& complaint : complaints) {
    if (!text.empty()) text += '\n';
    text += to_string(complaint);
  }
  return text;
}

std::string to_string(Complaint const& complaint) {
  // The parts may quote files from outside and hold several lines: line breaks stay, other control characters do not.
  auto const clean = [](std::string const& part) { return printable(part, true); };
  std::string text = printable(complaint.where);
  if (!text.empty() && !complaint.found.empty()) text += ": ";
  text += clean(complaint.found);
  if (!complaint.allowed.empty()) text += "; allowed: " + clean(complaint.allowed);
  if (!complaint.advice.empty()) text += "; try: " + clean(complaint.advice);
  return text;
}

}  // namespace isolaw
