// All fuzz targets include this header. For every input isolaw must either succeed or throw an isolaw::Error. Any other
// exception ends the program, and libFuzzer or replay.cpp then reports the input.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

namespace isolaw::fuzz {

inline std::string_view as_text(std::uint8_t const* data, std::size_t size) {
  return {static_cast<char const*>(static_cast<void const*>(data)), size};
}

// Ends the program if the condition `holds` is false, in every build type. Fuzz targets call this to check what must be
// true for every input.
inline void require(bool holds, char const* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

inline void require_plain_message(Error const& error) {
  require(!error.complaints().empty(), "an Error has a complaint");
  for (auto const& complaint : error.complaints())
    require(printable(to_string(complaint), true) == to_string(complaint), "a message holds no control characters");
}

// Runs `action`, which may throw an isolaw::Error but nothing else.
template <class Action>
void attempt(Action&& action) {
  try {
    action();
  } catch (Error const& error) {
    require_plain_message(error);
  }
}

// Makes a temporary folder, in memory if the system has /dev/shm. The destructor removes it.
class Folder {
 public:
  Folder() {
    auto const memory = std::filesystem::path("/dev/shm");
    auto const base = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
    std::string name = (base / "isolaw-fuzz-XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr, "a temporary folder can be made");
    path_ = name;
  }
  Folder(Folder const&) = delete;
  Folder& operator=(Folder const&) = delete;
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path const& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace isolaw::fuzz
