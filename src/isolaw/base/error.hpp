// The one exception of the library: wrong input or environment, said once and completely.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace isolaw {

// What is wrong with an input. Empty parts are left out of the message.
struct Complaint {
  std::string where;    // "file:line", a key, an option
  std::string found;    // what was found there
  std::string allowed;  // what would have been accepted
  std::string advice;   // what to try
};

// "where: found; allowed: ...; try: ..."
std::string to_string(Complaint const& complaint);

class Error : public std::runtime_error {
 public:
  explicit Error(Complaint complaint);
  // Several problems of one input, found in one pass; never empty.
  explicit Error(std::vector<Complaint> complaints);

  std::vector<Complaint> const& complaints() const noexcept { return complaints_; }

 private:
  std::vector<Complaint> complaints_;
};

}  // namespace isolaw
