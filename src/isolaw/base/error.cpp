#include "isolaw/base/error.hpp"

#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"

namespace isolaw {
namespace {

// Replaces control characters except line breaks by visible codes, because a complaint may quote a user's file.
std::string clean(std::string const& part) {
  return printable(part, true);
}

}  // namespace

std::string Error::join(std::vector<Complaint> const& complaints) {
  std::string text;
  for (auto const& complaint : complaints) {
    if (!text.empty()) text += '\n';
    text += to_string(complaint);
  }
  return text;
}

std::string to_string(Complaint const& complaint) {
  std::string text = printable(complaint.where);
  if (!text.empty() && !complaint.found.empty()) text += ": ";
  text += clean(complaint.found);
  if (!complaint.allowed.empty()) text += "; allowed: " + clean(complaint.allowed);
  if (!complaint.advice.empty()) text += "; try: " + clean(complaint.advice);
  return text;
}

void write_complaints(JsonWriter& out, std::vector<Complaint> const& complaints) {
  out.begin_array();
  for (auto const& complaint : complaints) {
    out.begin_object().member("where", printable(complaint.where)).member("found", clean(complaint.found));
    out.member("allowed", clean(complaint.allowed))
        .member("advice", clean(complaint.advice))
        .key("names")
        .begin_array();
    for (auto const& name : complaint.names)
      if (!name.empty()) out.value(printable(name));
    out.end_array().end_object();
  }
  out.end_array();
}

}  // namespace isolaw
