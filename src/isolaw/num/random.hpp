// Counter-based random numbers (Philox 4x32-10, Salmon et al. 2011, through Random123). A number depends only on the
// key of its stream and on its place in the stream, not on threads, order of computation or interruptions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace isolaw::num {

// Returns the four random words that belong to a 128-bit counter. For each key the mapping is one-to-one. The low words
// come first, as in Random123's counter and key.
std::array<std::uint32_t, 4> philox_4x32_10(std::array<std::uint32_t, 4> const& counter, std::uint64_t key);

// A family of independent generators. The key says what the numbers are for: campaign seed, device, law, run.
class Stream {
 public:
  Stream() = default;
  explicit Stream(std::uint64_t key) : key_(key) {}
  // Derives an independent stream that `part` selects, as in Stream(seed).split(hash of device).split(hash of
  // law).split(run).
  Stream split(std::uint64_t part) const;
  std::uint64_t key() const { return key_; }

 private:
  std::uint64_t key_ = 0;
};

// A sequence of random numbers at the place (a, b) of a stream, for instance (generation, individual). Satisfies
// UniformRandomBitGenerator. uniform(), below() and normal() give the same numbers with every standard library.
class Draws {
 public:
  using result_type = std::uint32_t;
  Draws(Stream const& stream, std::uint32_t a, std::uint32_t b);
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return 0xffffffffu; }
  result_type operator()();

  double uniform();                  // uniformly distributed in [0, 1), with 53 random bits
  std::size_t below(std::size_t n);  // an index from 0 to n - 1, unbiased; n > 0
  double normal();                   // normal with mean 0 and standard deviation 1

 private:
  std::uint64_t bits64();

  std::uint64_t key_;
  std::uint32_t a_, b_;
  std::uint64_t block_ = 0;
  std::array<std::uint32_t, 4> buffer_{};
  std::size_t used_ = 4;
};

}  // namespace isolaw::num
