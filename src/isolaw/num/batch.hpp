// A batch of W doubles that behaves like one double. Its W places are called lanes. Each lane computes one candidate
// parameter set or, in building/, one random draw of a building's devices. No lane depends on another lane. A lane
// agrees with the computation on plain doubles within rounding.
// A batch consists of a few native vectors of GCC or Clang (vector_size), so a law's code uses the vector registers of
// the processor. The vectors do not depend on one another: the processor computes one while it waits for another.
// The code is compiled once for each instruction set, and the object files are linked into one program
// (fit/kernels.cpp). If several object files contain a function of the same mangled name, the linker keeps only one.
// The names of the types here therefore contain the instruction set, and every function that several object files may
// contain must have such a type in its mangled name.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

#include <bit>

#include "isolaw/num/elementary.hpp"
#include "isolaw/num/scalar.hpp"

// Every function here must be inlined: a separate copy could be linked into code for another processor.
#define ISOLAW_INLINE inline __attribute__((always_inline))
#define ISOLAW_LAMBDA __attribute__((always_inline))

namespace isolaw::num {

#if defined(__AVX512F__)
#define ISOLAW_INSTRUCTION_SET avx512
#elif defined(__AVX__)
#define ISOLAW_INSTRUCTION_SET avx2
#else
#define ISOLAW_INSTRUCTION_SET portable
#endif

inline namespace ISOLAW_INSTRUCTION_SET {

inline constexpr std::size_t vector_lanes =
#if defined(__AVX512F__)
    8;
#elif defined(__AVX__)
    4;
#else
    2;
#endif
typedef double Vector __attribute__((vector_size(vector_lanes * 8)));
typedef std::int64_t VectorMask __attribute__((vector_size(vector_lanes * 8)));
typedef std::uint64_t VectorBits __attribute__((vector_size(vector_lanes * 8)));

// An array of K vectors. each() passes every index to `f` as a constant, so that the values stay in registers.
template <class V, std::size_t K>
struct Pack {
  V part[K];

  template <class F>
  ISOLAW_INLINE static void each(F&& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) ISOLAW_LAMBDA {
      (f(I), ...);
    }
    (std::make_index_sequence<K>());
  }
  template <class F>
  ISOLAW_INLINE static Pack make(F&& f) {
    Pack pack;
    each([&](std::size_t i) ISOLAW_LAMBDA { pack.part[i] = f(i); });
    return pack;
  }
};

template <std::size_t W>
struct Mask : Pack<VectorMask, W / vector_lanes> {};
template <std::size_t W>
struct Bits : Pack<VectorBits, W / vector_lanes> {};
template <std::size_t W>
struct Indices : Pack<VectorMask, W / vector_lanes> {};

template <std::size_t W>
struct Batch : Pack<Vector, W / vector_lanes> {
  static_assert(W % vector_lanes == 0);
  using Base = Pack<Vector, W / vector_lanes>;

  Batch() = default;
  ISOLAW_INLINE Batch(Base const& base) : Base(base) {}
  ISOLAW_INLINE explicit Batch(double v) : Base(Base::make([&](std::size_t) ISOLAW_LAMBDA { return Vector{} + v; })) {}

  ISOLAW_INLINE static Batch load(double const* values) {
    return Base::make([&](std::size_t i) ISOLAW_LAMBDA {
      Vector v;
      std::memcpy(&v, values + i * vector_lanes, sizeof v);
      return v;
    });
  }
  ISOLAW_INLINE void store(double* values) const { std::memcpy(values, this->part, sizeof this->part); }

  friend ISOLAW_INLINE Batch operator-(Batch const& a) {
    return Base::make([&](std::size_t i) ISOLAW_LAMBDA { return -a.part[i]; });
  }
#define ISOLAW_OPERATOR(op)                                                                 \
  friend ISOLAW_INLINE Batch operator op(Batch const& a, Batch const& b) {                  \
    return Base::make([&](std::size_t i) ISOLAW_LAMBDA { return a.part[i] op b.part[i]; }); \
  }
  ISOLAW_OPERATOR(+)
  ISOLAW_OPERATOR(-)
  ISOLAW_OPERATOR(*)
  ISOLAW_OPERATOR(/)
#undef ISOLAW_OPERATOR
  ISOLAW_INLINE Batch& operator+=(Batch const& b) {
    return *this = *this + b;
  }

#define ISOLAW_OPERATOR(op)                                                                                    \
  friend ISOLAW_INLINE Mask<W> operator op(Batch const& a, Batch const& b) {                                   \
    return {Mask<W>::make([&](std::size_t i) ISOLAW_LAMBDA -> VectorMask { return a.part[i] op b.part[i]; })}; \
  }
  ISOLAW_OPERATOR(<)
  ISOLAW_OPERATOR(<=)
  ISOLAW_OPERATOR(>)
  ISOLAW_OPERATOR(>=)
#undef ISOLAW_OPERATOR
};

#define ISOLAW_OPERATOR(op, Right)                                                                     \
  template <std::size_t W>                                                                             \
  ISOLAW_INLINE Bits<W> operator op(Bits<W> const& a, Right b) {                                       \
    return {Bits<W>::make([&](std::size_t i) ISOLAW_LAMBDA -> VectorBits { return a.part[i] op b; })}; \
  }
ISOLAW_OPERATOR(+, std::uint64_t)
ISOLAW_OPERATOR(&, std::uint64_t)
ISOLAW_OPERATOR(|, std::uint64_t)
ISOLAW_OPERATOR(<<, int)
ISOLAW_OPERATOR(>>, int)
#undef ISOLAW_OPERATOR

}  // namespace ISOLAW_INSTRUCTION_SET

template <std::size_t W>
struct Lanes<Batch<W>> {
  using L = Lanes<Vector>;
  using T = Batch<W>;
  using B = Bits<W>;

  ISOLAW_INLINE static T all(double x) { return T(x); }
  ISOLAW_INLINE static B bits(T const& x) {
    return {B::make([&](std::size_t i) ISOLAW_LAMBDA { return L::bits(x.part[i]); })};
  }
  ISOLAW_INLINE static T from_bits(B const& x) {
    return T::make([&](std::size_t i) ISOLAW_LAMBDA { return L::from_bits(x.part[i]); });
  }
  ISOLAW_INLINE static T abs(T const& x) {
    return T::make([&](std::size_t i) ISOLAW_LAMBDA { return L::abs(x.part[i]); });
  }
  ISOLAW_INLINE static T multiply_add(T const& a, T const& b, T const& c) {
    return T::make([&](std::size_t i) ISOLAW_LAMBDA { return L::multiply_add(a.part[i], b.part[i], c.part[i]); });
  }
  ISOLAW_INLINE static T multiply_add_apart(T const& a, T const& b, T const& c) {
    return T::make([&](std::size_t i) ISOLAW_LAMBDA { return L::multiply_add_apart(a.part[i], b.part[i], c.part[i]); });
  }
  ISOLAW_INLINE static T select(Mask<W> const& mask, T const& a, T const& b) {
    return T::make([&](std::size_t i) ISOLAW_LAMBDA { return L::select(mask.part[i], a.part[i], b.part[i]); });
  }
};

inline namespace ISOLAW_INSTRUCTION_SET {

template <std::size_t W>
ISOLAW_INLINE Batch<W> abs(Batch<W> const& a) {
  return Lanes<Batch<W>>::abs(a);
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> exp(Batch<W> const& a) {
  return fast_exp(a);
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> expm1(Batch<W> const& a) {
  return fast_expm1(a);
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> fifth_root(Batch<W> const& a) {
  return fast_fifth_root(a);
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> exp2(Batch<W> const& a) {
  return fast_exp2(a);
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> log2(Batch<W> const& a) {
  return fast_log2(a);
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> power(Batch<W> const& x, Batch<W> const& p) {
  return fast_power(x, p);
}
ISOLAW_INLINE Vector sqrt_of(Vector const& a) {
#if defined(__AVX512F__)
  return _mm512_maskz_sqrt_pd(0xff, a);  // GCC 12 warns that _mm512_sqrt_pd uses an uninitialised value
#elif defined(__AVX__)
  return _mm256_sqrt_pd(a);
#elif defined(__SSE2__)
  return _mm_sqrt_pd(a);
#elif defined(__wasm_simd128__)
  return std::bit_cast<Vector>(wasm_f64x2_sqrt(std::bit_cast<v128_t>(a)));
#else
  Vector root;
  for (std::size_t i = 0; i < vector_lanes; ++i) root[i] = __builtin_sqrt(a[i]);
  return root;
#endif
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> sqrt(Batch<W> const& a) {
  return Batch<W>::make([&](std::size_t i) ISOLAW_LAMBDA { return sqrt_of(a.part[i]); });
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> select(Mask<W> const& condition, Batch<W> const& a, Batch<W> const& b) {
  return Lanes<Batch<W>>::select(condition, a, b);
}
template <std::size_t W>
ISOLAW_INLINE bool any(Mask<W> const& mask) {
  VectorMask all = mask.part[0];
  for (std::size_t i = 1; i < W / vector_lanes; ++i) all |= mask.part[i];
#if defined(__AVX512F__)
  return _mm512_test_epi64_mask(std::bit_cast<__m512i>(all), std::bit_cast<__m512i>(all)) != 0;
#elif defined(__AVX__)
  return _mm256_movemask_pd(std::bit_cast<__m256d>(all)) != 0;
#elif defined(__SSE2__)
  return _mm_movemask_pd(std::bit_cast<__m128d>(all)) != 0;
#elif defined(__wasm_simd128__)
  return wasm_v128_any_true(std::bit_cast<v128_t>(all));
#else
  std::int64_t bits = 0;
  for (std::size_t i = 0; i < vector_lanes; ++i) bits |= all[i];
  return bits != 0;
#endif
}
// select() for a condition that holds for all lanes or for none, because it does not depend on the parameters.
template <std::size_t W>
ISOLAW_INLINE Batch<W> select(bool condition, Batch<W> const& a, Batch<W> const& b) {
  return condition ? a : b;
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> min(Batch<W> const& a, Batch<W> const& b) {
  return select(b < a, b, a);
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> max(Batch<W> const& a, Batch<W> const& b) {
  return select(a < b, b, a);
}

// Returns the product `a` and keeps the compiler from fusing it with an addition, at no cost. In a sum of two products
// the compiler may fuse either product with the addition. Which one it fuses could depend on the width of the batch,
// and so could the last bits of a lane.
template <std::size_t W>
ISOLAW_INLINE Batch<W> rounded(Batch<W> a) {
  a.each([&]([[maybe_unused]] std::size_t i) ISOLAW_LAMBDA {
#if defined(__x86_64__)
    asm("" : "+v"(a.part[i]));
#elif defined(__aarch64__)
    asm("" : "+w"(a.part[i]));
#endif
  });
  return a;
}

ISOLAW_INLINE Vector gather(double const* base, VectorMask const& index) {
#if defined(__AVX512F__)
  return _mm512_mask_i64gather_pd(_mm512_setzero_pd(), 0xff, std::bit_cast<__m512i>(index), base, 8);
#elif defined(__AVX2__)
  return _mm256_i64gather_pd(base, std::bit_cast<__m256i>(index), 8);
#else
  Vector out;
  for (std::size_t i = 0; i < vector_lanes; ++i) out[i] = base[index[i]];
  return out;
#endif
}
// Returns the lane numbers of vector number `part`; they count from 0 through the whole batch.
ISOLAW_INLINE VectorMask lane_numbers(std::size_t part) {
  VectorMask numbers;
  for (std::size_t i = 0; i < vector_lanes; ++i) numbers[i] = static_cast<std::int64_t>(part * vector_lanes + i);
  return numbers;
}
ISOLAW_INLINE double const* doubles(void const* values) {
  return static_cast<double const*>(values);
}

template <std::size_t W, std::size_t Count>
ISOLAW_INLINE Batch<W> at(std::array<Batch<W>, Count> const& values, Indices<W> const& index) {
  return Batch<W>::make([&](std::size_t i) ISOLAW_LAMBDA {
    return gather(doubles(values.data()), index.part[i] * static_cast<std::int64_t>(W) + lane_numbers(i));
  });
}
template <std::size_t W, std::size_t Count>
ISOLAW_INLINE Batch<W> at(std::array<double, Count> const& values, Indices<W> const& index) {
  return Batch<W>::make([&](std::size_t i) ISOLAW_LAMBDA { return gather(values.data(), index.part[i]); });
}

template <std::size_t W>
ISOLAW_INLINE Batch<W> as_batch(Batch<W> const& node) {
  return node;
}
template <std::size_t W>
ISOLAW_INLINE Batch<W> as_batch(double node) {
  return Batch<W>(node);
}

// Finds for each lane the cell, between two neighbouring nodes, in which x lies. There are `cells` + 1 nodes. Bisection
// fetches a different node for each lane, and such a gather costs more than several comparisons. Comparisons with seven
// nodes, the same for all lanes, therefore replace the first three halvings.
template <class Values, std::size_t W>
ISOLAW_INLINE Indices<W> bisect(Values const& nodes, std::size_t cells, Batch<W> const& x) {
  Indices<W> first{Indices<W>::make([](std::size_t) ISOLAW_LAMBDA { return VectorMask{}; })};
  std::size_t const block = cells / 8;
  if (block > 0)
    for (std::size_t k = 1; k < 8; ++k) {
      Batch<W> const node = as_batch<W>(nodes[k * block]);
      auto const skip = static_cast<std::int64_t>(block);
      first = {Indices<W>::make([&](std::size_t i) ISOLAW_LAMBDA -> VectorMask {
        return first.part[i] + ((node.part[i] <= x.part[i]) & skip);
      })};
    }
  // The seven nodes divide the cells into eight blocks, of which the last may be longer. Every lane searches as many
  // cells as the last block has: nodes beyond the end of a shorter block exceed x and do not change the result.
  for (std::size_t length = cells - 7 * block; length > 1;) {
    std::size_t const half = length / 2;
    auto const step = static_cast<std::int64_t>(half);
    Indices<W> const middle{
        Indices<W>::make([&](std::size_t i) ISOLAW_LAMBDA -> VectorMask { return first.part[i] + step; })};
    Batch<W> const node = at(nodes, middle);
    first = {Indices<W>::make([&](std::size_t i) ISOLAW_LAMBDA -> VectorMask {
      return node.part[i] <= x.part[i] ? middle.part[i] : first.part[i];
    })};
    length -= half;
  }
  return first;
}
template <std::size_t W, std::size_t Count>
ISOLAW_INLINE Indices<W> cell_of(std::array<Batch<W>, Count> const& nodes, Batch<W> const& x) {
  return bisect(nodes, Count - 1, x);
}
template <std::size_t W, std::size_t Count>
ISOLAW_INLINE Indices<W> cell_of(std::array<double, Count> const& nodes, Batch<W> const& x) {
  return bisect(nodes, Count - 1, x);
}

// One round of the transposition of a square matrix. Moves each number to the place that results if bit `Bit` of its
// row index and bit `Bit` of its lane index change places.
template <std::size_t Bit, std::size_t... Lane>
ISOLAW_INLINE void exchange(std::array<Vector, vector_lanes>& rows, std::index_sequence<Lane...>) {
  for (std::size_t i = 0; i < vector_lanes; ++i) {
    if ((i & Bit) != 0) continue;
    Vector const a = rows[i], b = rows[i + Bit];
    rows[i] = __builtin_shufflevector(a, b, static_cast<int>(Lane & Bit ? vector_lanes + Lane - Bit : Lane)...);
    rows[i + Bit] = __builtin_shufflevector(a, b, static_cast<int>(Lane & Bit ? vector_lanes + Lane : Lane + Bit)...);
  }
}
ISOLAW_INLINE void transpose(std::array<Vector, vector_lanes>& rows) {
  constexpr std::make_index_sequence<vector_lanes> lanes;
  exchange<1>(rows, lanes);
  if constexpr (vector_lanes >= 4) exchange<2>(rows, lanes);
  if constexpr (vector_lanes >= 8) exchange<4>(rows, lanes);
}

}  // namespace ISOLAW_INSTRUCTION_SET

template <std::size_t W, std::size_t Count>
class Rows8<Batch<W>, Count> {
  static constexpr std::size_t n = vector_lanes;

 public:
  ISOLAW_INLINE void set(std::size_t row, std::array<Batch<W>, 8> const& values) {
    for (std::size_t part = 0; part < W / n; ++part)
      for (std::size_t first = 0; first < 8; first += n) {
        std::array<Vector, n> square;
        for (std::size_t k = 0; k < n; ++k) square[k] = values[first + k].part[part];
        transpose(square);
        for (std::size_t lane = 0; lane < n; ++lane)
          std::memcpy(rows_[row][part * n + lane] + first, &square[lane], sizeof(Vector));
      }
  }
  ISOLAW_INLINE std::array<Batch<W>, 8> get(Indices<W> const& index) const {
    std::array<Batch<W>, 8> values;
    for (std::size_t part = 0; part < W / n; ++part)
      for (std::size_t first = 0; first < 8; first += n) {
        std::array<Vector, n> square;
        for (std::size_t lane = 0; lane < n; ++lane)
          std::memcpy(&square[lane], rows_[static_cast<std::size_t>(index.part[part][lane])][part * n + lane] + first,
                      sizeof(Vector));
        transpose(square);
        for (std::size_t k = 0; k < n; ++k) values[first + k].part[part] = square[k];
      }
    return values;
  }

 private:
  alignas(64) double rows_[Count][W][8];
};

}  // namespace isolaw::num
