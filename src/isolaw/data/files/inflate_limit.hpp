// Limits how large a file may become when it is unpacked: 30 times its size, or 64 MiB if that is more, but at most 1
// GiB. A file with measured channels grows at most tenfold, and one that is made to fill the memory grows a
// thousandfold. A channel of constant values also grows a thousandfold; the 64 MiB are for files with such channels.
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
