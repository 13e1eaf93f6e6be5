// Limits how much a file may grow when it is unpacked. A laboratory's file grows tenfold at most; a file made to fill
// the memory grows a thousandfold. A constant channel grows a thousandfold too, so every file may grow to 64 MiB.
#pragma once

#include <cstdint>

namespace isolaw::data {

inline constexpr std::uint64_t free_unpacked_bytes = std::uint64_t{64} << 20;
inline constexpr std::uint64_t most_unpacked_bytes = std::uint64_t{1} << 30;
inline constexpr std::uint64_t most_growth = 30;

constexpr std::uint64_t unpacked_limit(std::uint64_t file_bytes) {
  auto const grown = most_growth * file_bytes;  // cannot overflow: a file has 1 GiB at most
  if (grown <= free_unpacked_bytes) return free_unpacked_bytes;
  return grown < most_unpacked_bytes ? grown : most_unpacked_bytes;
}

}  // namespace isolaw::data
