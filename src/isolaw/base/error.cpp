#include "isolaw/base/error.hpp"

#include <utility>

namespace isolaw {
namespace {

std::string join(std::vector<Complaint> const& complaints) {
  std::string text;
  for (auto const& complaint : complaints) {
    if (!text.empty()) text += '\n';
    text += to_string(complaint);
  }
  return text;
}

}  // namespace

std::string to_string(Complaint const& complaint) {
  std::string text = complaint.where;
  if (!text.empty() && !complaint.found.empty()) text += ": ";
  text += complaint.found;
  if (!complaint.allowed.empty()) text += "; allowed: " + complaint.allowed;
  if (!complaint.advice.empty()) text += "; try: " + complaint.advice;
  return text;
}

Error::Error(Complaint complaint) : Error(std::vector<Complaint>{std::move(complaint)}) {}

Error::Error(std::vector<Complaint> complaints)
    : std::runtime_error(join(complaints)), complaints_(std::move(complaints)) {}

}  // namespace isolaw
