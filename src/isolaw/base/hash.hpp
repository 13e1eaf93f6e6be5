// Fingerprints: SHA-256 of inputs for the record of what was computed from what, FNV-1a for stable stream numbers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace isolaw {

// Lower-case hexadecimal SHA-256 of the bytes.
std::string sha256(std::string_view bytes);

// 64-bit FNV-1a: the same on every machine and in every version.
constexpr std::uint64_t stable_hash(std::string_view bytes) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (char const c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3u;
  }
  return hash;
}

}  // namespace isolaw
