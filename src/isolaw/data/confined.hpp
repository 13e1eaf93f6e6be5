// Runs a library on an untrusted file in a process of its own that opens no files, with limits on memory and time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

// Sanitizers need memory and files themselves, so with them neither is limited.
struct ConfinedLimits {
  std::uint64_t memory_bytes;  // in addition to what the process holds already
  unsigned seconds;
  std::size_t output_bytes;
};

struct ConfinedResult {
  std::string output;
  std::string failure;  // why there is no output; empty if the work ended well
};

// `work` passes its result to `write`; the text of an exception becomes the failure. Throws std::system_error.
ConfinedResult run_confined(std::function<void(std::function<void(std::string_view)> const& write)> const& work,
                            ConfinedLimits const& limits);

}  // namespace isolaw::data
