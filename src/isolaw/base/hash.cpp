#include "isolaw/base/hash.hpp"

#include <bearssl.h>
#include <fmt/ranges.h>

#include <array>

namespace isolaw {

std::string sha256(std::string_view bytes) {
  br_sha256_context context{};
  std::array<unsigned char, br_sha256_SIZE> digest{};
  br_sha256_init(&context);
  br_sha256_update(&context, bytes.data(), bytes.size());
  br_sha256_out(&context, digest.data());
  return fmt::format("{:02x}", fmt::join(digest, ""));
}

}  // namespace isolaw
