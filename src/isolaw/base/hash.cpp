#include "isolaw/base/hash.hpp"

#include <fmt/ranges.h>
#include <openssl/evp.h>

#include <array>
#include <span>

#include "isolaw/base/error.hpp"

namespace isolaw {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw Error({.where = "SHA-256", .found = "the cryptographic library refused to compute a digest"});
  return fmt::format("{:02x}", fmt::join(std::span(digest).first(length), ""));
}

}  // namespace isolaw
