// The library's only exception. It reports all problems of one input, or a fault of the system such as a full disk.
#pragma once

#include <concepts>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace isolaw {

class JsonWriter;

struct Complaint {                      // one problem of an input; the message omits empty members
  std::string where = {};               // "file:line", a key, an option
  std::string found = {};               // the wrong value or the fault
  std::string allowed = {};             // the values that are accepted
  std::string advice = {};              // a remedy to try
  std::vector<std::string> names = {};  // the record's columns, if a column was not found; not in the message
};

// Writes a complaint as "where: found; allowed: ...; try: ...", with visible codes in place of control characters.
std::string to_string(Complaint const& complaint);
// Writes complaints as a JSON array of objects. Each has all members of Complaint, with visible codes in place of
// control characters.
void write_complaints(JsonWriter& out, std::vector<Complaint> const& complaints);

class Error : public std::runtime_error {
 public:
  explicit Error(Complaint complaint) : Error(std::vector{std::move(complaint)}) {}
  // Reports several problems of one input. It is a template so that Error({...}) always means a single complaint.
  template <std::same_as<std::vector<Complaint>> Complaints>
  explicit Error(Complaints complaints) : std::runtime_error(join(complaints)), complaints_(std::move(complaints)) {}

  std::vector<Complaint> const& complaints() const noexcept { return complaints_; }

 private:
  static std::string join(std::vector<Complaint> const& complaints);
  std::vector<Complaint> complaints_;
};

}  // namespace isolaw
