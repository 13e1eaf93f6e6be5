// Counter-based random numbers (Philox 4x32-10, Salmon et al. 2011, through Random123). A draw depends only on the
// stream's key and the draw's coordinates, so threads, order and interruptions do not change it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace isolaw::num {

// A bijection of 128-bit counters for each key; counter[0] and the low half of `key` are Random123's first words.
std::array<std::uint32_t, 4> philox_4x32_10(std::array<std::uint32_t, 4> const& counter, std::uint64_t key);

// A family of independent generators. The key identifies the user of the numbers (campaign seed, device, law, run).
class Stream {
 public:
  Stream() = default;
  explicit Stream(std::uint64_t key) : key_(key) {}
  // A stream for one part of a name, in order: Stream(seed).split(hash of device).split(hash of law).split(run).
  Stream split(std::uint64_t part) const;
  std::uint64_t key() const { return key_; }

 private:
  std::uint64_t key_ = 0;
};

// Sequential draws at one place (a, b) of a stream, for instance (generation, individual). Satisfies
// UniformRandomBitGenerator. It makes doubles and indices itself, since distributions of standard libraries differ.
class Draws {
 public:
  using result_type = std::uint32_t;
  Draws(Stream const& stream, std::uint32_t a, std::uint32_t b);
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return 0xffffffffu; }
  result_type operator()();

  double uniform();                  // [0, 1), 53 bits
  std::size_t below(std::size_t n);  // 0 .. n-1, unbiased; n > 0
  double normal();                   // mean 0, standard deviation 1

 private:
  std::uint64_t bits64();

  std::uint64_t key_;
  std::uint32_t a_, b_;
  std::uint64_t block_ = 0;
  std::array<std::uint32_t, 4> buffer_{};
  std::size_t used_ = 4;
};

}  // namespace isolaw::num
