// Runs a library on a stranger's file that may bring it down: in a process of its own, with limits on memory and time,
// that opens no file and leaves nothing behind. Whatever ends that process is a value in this one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

// Under sanitizers memory and files are not limited, since sanitizers need both themselves.
struct ConfinedLimits {
  std::uint64_t memory_bytes;  // in addition to what the process holds already
  unsigned seconds;
  std::size_t output_bytes;
};

struct ConfinedResult {
  std::string output;
  std::string failure;  // why there is none; empty when the work ended well
};

// Runs `work` in a copy of this process. It passes its result to `write`; the text of an exception becomes the failure.
// Throws std::system_error if no process can be made.
ConfinedResult run_confined(std::function<void(std::function<void(std::string_view)> const& write)> const& work,
                            ConfinedLimits const& limits);

}  // namespace isolaw::data
