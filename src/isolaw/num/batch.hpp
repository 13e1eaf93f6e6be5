// W doubles that behave like one: the population is the vector, a lane is a candidate. Plain loops that a compiler
// can turn into vector instructions; lanes never mix.
#pragma once

#include <array>
#include <cstddef>

#include "isolaw/num/scalar.hpp"

namespace isolaw::num {

template <std::size_t W>
struct Mask {
  std::array<bool, W> lane{};
};

template <std::size_t W>
struct Batch {
  std::array<double, W> lane{};

  Batch() = default;
  explicit Batch(double v) { lane.fill(v); }

  template <class F>
  static Batch map(Batch const& a, F f) {
    Batch out;
    for (std::size_t i = 0; i < W; ++i) out.lane[i] = f(a.lane[i]);
    return out;
  }
  template <class F>
  static Batch map(Batch const& a, Batch const& b, F f) {
    Batch out;
    for (std::size_t i = 0; i < W; ++i) out.lane[i] = f(a.lane[i], b.lane[i]);
    return out;
  }
  template <class F>
  static Mask<W> compare(Batch const& a, Batch const& b, F f) {
    Mask<W> out;
    for (std::size_t i = 0; i < W; ++i) out.lane[i] = f(a.lane[i], b.lane[i]);
    return out;
  }

  friend Batch operator-(Batch const& a) {
    return map(a, [](double x) { return -x; });
  }
  friend Batch operator+(Batch const& a, Batch const& b) {
    return map(a, b, [](double x, double y) { return x + y; });
  }
  friend Batch operator-(Batch const& a, Batch const& b) {
    return map(a, b, [](double x, double y) { return x - y; });
  }
  friend Batch operator*(Batch const& a, Batch const& b) {
    return map(a, b, [](double x, double y) { return x * y; });
  }
  friend Batch operator/(Batch const& a, Batch const& b) {
    return map(a, b, [](double x, double y) { return x / y; });
  }
  Batch& operator+=(Batch const& b) { return *this = *this + b; }

  friend Mask<W> operator<(Batch const& a, Batch const& b) {
    return compare(a, b, [](double x, double y) { return x < y; });
  }
  friend Mask<W> operator<=(Batch const& a, Batch const& b) {
    return compare(a, b, [](double x, double y) { return x <= y; });
  }
  friend Mask<W> operator>(Batch const& a, Batch const& b) {
    return compare(a, b, [](double x, double y) { return x > y; });
  }
  friend Mask<W> operator>=(Batch const& a, Batch const& b) {
    return compare(a, b, [](double x, double y) { return x >= y; });
  }
};

template <std::size_t W>
Batch<W> abs(Batch<W> const& a) {
  return Batch<W>::map(a, [](double x) { return num::abs(x); });
}
template <std::size_t W>
Batch<W> exp(Batch<W> const& a) {
  return Batch<W>::map(a, [](double x) { return num::exp(x); });
}
template <std::size_t W>
Batch<W> exp2(Batch<W> const& a) {
  return Batch<W>::map(a, [](double x) { return num::exp2(x); });
}
template <std::size_t W>
Batch<W> log2(Batch<W> const& a) {
  return Batch<W>::map(a, [](double x) { return num::log2(x); });
}
template <std::size_t W>
Batch<W> sqrt(Batch<W> const& a) {
  return Batch<W>::map(a, [](double x) { return num::sqrt(x); });
}
template <std::size_t W>
Batch<W> min(Batch<W> const& a, Batch<W> const& b) {
  return Batch<W>::map(a, b, [](double x, double y) { return num::min(x, y); });
}
template <std::size_t W>
Batch<W> max(Batch<W> const& a, Batch<W> const& b) {
  return Batch<W>::map(a, b, [](double x, double y) { return num::max(x, y); });
}
template <std::size_t W>
Batch<W> select(Mask<W> const& condition, Batch<W> const& a, Batch<W> const& b) {
  Batch<W> out;
  for (std::size_t i = 0; i < W; ++i) out.lane[i] = condition.lane[i] ? a.lane[i] : b.lane[i];
  return out;
}
// Branching on what the record determines is the same for all lanes.
template <std::size_t W>
Batch<W> select(bool condition, Batch<W> const& a, Batch<W> const& b) {
  return condition ? a : b;
}

template <std::size_t W>
struct Indices {
  std::array<std::size_t, W> lane{};
};

template <std::size_t W, std::size_t Count>
Indices<W> cell_of(std::array<Batch<W>, Count> const& nodes, Batch<W> const& x) {
  Indices<W> first{};
  for (std::size_t length = Count - 1; length > 1;) {
    std::size_t const half = length / 2;
    for (std::size_t i = 0; i < W; ++i) first.lane[i] += nodes[first.lane[i] + half].lane[i] <= x.lane[i] ? half : 0;
    length -= half;
  }
  return first;
}
template <std::size_t W, std::size_t Count>
Indices<W> cell_of(std::array<double, Count> const& nodes, Batch<W> const& x) {
  Indices<W> out{};
  for (std::size_t i = 0; i < W; ++i) out.lane[i] = num::cell_of(nodes, x.lane[i]);
  return out;
}
template <std::size_t W, std::size_t Count>
Batch<W> at(std::array<Batch<W>, Count> const& values, Indices<W> const& index) {
  Batch<W> out;
  for (std::size_t i = 0; i < W; ++i) out.lane[i] = values[index.lane[i]].lane[i];
  return out;
}
template <std::size_t W, std::size_t Count>
Batch<W> at(std::array<double, Count> const& values, Indices<W> const& index) {
  Batch<W> out;
  for (std::size_t i = 0; i < W; ++i) out.lane[i] = values[index.lane[i]];
  return out;
}

}  // namespace isolaw::num
