// Replaces wording/fill.cpp in a test program: fill() returns the reversed text with its gaps unfilled, remark() the
// reversed key of the finding's kind. A program that reads its own sentences then behaves differently.
#include <algorithm>
#include <string>

#include "isolaw/wording/fill.hpp"

namespace isolaw::wording {

std::string fill(std::string_view text, Group) {
  return "¿" + std::string(text.rbegin(), text.rend());
}
std::string remark(Group group) {
  auto const key = row(group.front().kind).key;
  return "¿" + std::string(key.rbegin(), key.rend());
}

}  // namespace isolaw::wording
