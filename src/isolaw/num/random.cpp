#include "isolaw/num/random.hpp"

#include <Random123/philox.h>

#include <bit>
#include <cassert>
#include <cmath>
#include <numbers>

namespace isolaw::num {
namespace {

constexpr std::uint32_t low_word(std::uint64_t value) {
  return static_cast<std::uint32_t>(value);
}
constexpr std::uint32_t high_word(std::uint64_t value) {
  return static_cast<std::uint32_t>(value >> 32);
}
constexpr std::uint64_t join(std::uint32_t low, std::uint32_t high) {
  return (std::uint64_t{high} << 32) | low;
}

}  // namespace

std::array<std::uint32_t, 4> philox_4x32_10(std::array<std::uint32_t, 4> const& counter, std::uint64_t key) {
  r123::Philox4x32::ctr_type const c = {{counter[0], counter[1], counter[2], counter[3]}};
  r123::Philox4x32::key_type const k = {{low_word(key), high_word(key)}};
  auto const words = r123::Philox4x32{}(c, k);
  return {words[0], words[1], words[2], words[3]};
}

// The key of the new stream is a random number of this stream at a = b = 0xffffffff, a place reserved for this purpose.
Stream Stream::split(std::uint64_t part) const {
  auto const words = philox_4x32_10({low_word(part), high_word(part), 0xffffffffu, 0xffffffffu}, key_);
  return Stream(join(words[0], words[1]));
}

Draws::Draws(Stream const& stream, std::uint32_t a, std::uint32_t b) : key_(stream.key()), a_(a), b_(b) {}

Draws::result_type Draws::operator()() {
  if (used_ == buffer_.size()) {
    buffer_ = philox_4x32_10({low_word(block_), high_word(block_), a_, b_}, key_);
    ++block_;
    used_ = 0;
  }
  return buffer_[used_++];
}

std::uint64_t Draws::bits64() {
  auto const low = (*this)();
  auto const high = (*this)();
  return join(low, high);
}

double Draws::uniform() {
  return static_cast<double>(bits64() >> 11) * 0x1p-53;
}

// Draws a number of as many random bits as n - 1 has, again and again until the number is below n. Every result is
// equally likely, and fewer than two tries are needed on average.
std::size_t Draws::below(std::size_t n) {
  assert(n > 0);
  auto const width = std::bit_width(n - 1);
  for (;;) {
    std::uint64_t const bits = width <= 32 ? (*this)() : bits64();
    std::uint64_t const candidate = width == 64 ? bits : bits & ((std::uint64_t{1} << width) - 1);
    if (candidate < n) return static_cast<std::size_t>(candidate);
  }
}

// The method of Box and Muller 1958 gives two numbers, one with a cosine and one with a sine. Only the first is used:
// each call then takes four words, and no second number has to be kept for the next call.
double Draws::normal() {
  double const radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));  // 1 - uniform() is never 0
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace isolaw::num
