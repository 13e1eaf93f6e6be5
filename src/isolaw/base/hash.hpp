// Hashes. SHA-256 identifies the inputs of a result; FNV-1a turns a name into the number that selects its stream of
// random numbers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace isolaw {

std::string sha256(std::string_view bytes);  // in lower-case hexadecimal digits
// 64-bit FNV-1a. It must give the same hash on every machine and in every version, because the random numbers of a
// search, and with them its result, depend on it.
constexpr std::uint64_t stable_hash(std::string_view bytes) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (char const c : bytes) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3u;
  }
  return hash;
}

}  // namespace isolaw
