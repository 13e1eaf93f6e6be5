// Replaces wording/fill.cpp in a test program. In isolaw, fill() puts words and numbers into the fields of a text, and
// remark() returns the sentence on a group of findings without the devices or the law at its start. Here fill() returns
// the unfilled text reversed, and remark() returns the reversed key of the kind of the first finding. A program that
// reads its own sentences then behaves differently.
#include <algorithm>
#include <string>

#include "isolaw/wording/fill.hpp"

namespace isolaw::wording {

std::string fill(std::string_view text, Group, UnitSystem const&) {
  return "¿" + std::string(text.rbegin(), text.rend());
}
std::string remark(Group group, UnitSystem const&) {
  auto const key = row(group.front().kind).key;
  return "¿" + std::string(key.rbegin(), key.rend());
}

}  // namespace isolaw::wording
