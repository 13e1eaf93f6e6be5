#include "isolaw/base/hash.hpp"

#include <openssl/evp.h>

#include <array>

#include "isolaw/base/error.hpp"

namespace isolaw {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw Error({.where = "SHA-256", .found = "the cryptographic library refused to compute a digest"});
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

}  // namespace isolaw
