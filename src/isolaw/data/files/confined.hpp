// Runs a library on an untrusted file in a separate process that opens no files and has limited memory and time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace isolaw::data {

// Limits of the separate process. A build with sanitizers limits neither its memory nor its files.
struct ConfinedLimits {
  std::uint64_t memory_bytes;  // beyond the address space that the process has at its start
  unsigned seconds;
  std::size_t output_bytes;
};

struct ConfinedResult {
  std::string output;
  std::string failure;  // why there is no output; empty if the work succeeded
};

// `work` passes its result to `write`. If `work` throws, the text of the exception becomes the result's `failure`.
// Throws std::system_error if fork() fails.
ConfinedResult run_confined(std::function<void(std::function<void(std::string_view)> const& write)> const& work,
                            ConfinedLimits const& limits);

}  // namespace isolaw::data
