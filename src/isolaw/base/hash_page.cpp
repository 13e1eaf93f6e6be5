#include <fmt/ranges.h>
#include <nettle/sha2.h>

#include <array>
#include <cstdint>

#include "isolaw/base/hash.hpp"

namespace isolaw {

std::string sha256(std::string_view bytes) {
  sha256_ctx context{};
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
  sha256_init(&context);
  sha256_update(&context, bytes.size(), reinterpret_cast<std::uint8_t const*>(bytes.data()));
  sha256_digest(&context, digest.size(), digest.data());
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace isolaw
