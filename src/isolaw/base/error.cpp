#include "isolaw/base/error.hpp"

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
  std::string text = complaint.where;
  if (!text.empty() && !complaint.found.empty()) text += ": ";
  text += complaint.found;
  if (!complaint.allowed.empty()) text += "; allowed: " + complaint.allowed;
  if (!complaint.advice.empty()) text += "; try: " + complaint.advice;
  return text;
}

}  // namespace isolaw
