// What is said of records: signals, channels, sampling.
#include <fmt/format.h>

#include "isolaw/wording/sentences.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::wording {

std::string no_cyclic_properties(Group group) {
  return fmt::format("no cyclic properties: {}", group.front().word("reason"));
}

std::string stated_by_older_store(Group group) {
  return std::string(group.front().word("text"));
}

}  // namespace isolaw::wording
