// Work on a file of others by a library that such a file may bring down: in a process of its own, with a limit on
// memory and time, that opens no file and leaves nothing behind. What ends it ends as an outcome here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

// Under sanitizers, which need both for themselves, neither memory nor files are limited.
struct ConfinedLimits {
  std::uint64_t memory_bytes;  // beyond what the process holds already
  unsigned seconds;
  std::size_t output_bytes;
};

struct ConfinedResult {
  std::string output;
  std::string failure;  // why there is none; empty when the work ended well
};

// Runs `work` in a copy of this process; it hands over its result through `write`, and an exception's text as a
// failure. Throws std::system_error where no process can be made.
ConfinedResult run_confined(std::function<void(std::function<void(std::string_view)> const& write)> const& work,
                            ConfinedLimits const& limits);

}  // namespace isolaw::data
