// 2^x, e^x, e^x - 1, log2 x, |x|^p and x^(1/5) without branches, tables or library calls. They are made for code that
// computes many numbers at once: loops over doubles that a compiler vectorises, and the same code on vectors.
//   function           largest error (with / without fused multiply-add; tests/unit checks it) and where it holds
//   fast_exp2(x)       0.9 / 1.2 ULP in [-1022, 1023.5); +inf from 1023.5 on; gradual underflow to -1022.5, 0 below
//   fast_exp(x)        0.9 / 1.2 ULP in [-708.3, 709.4]; +inf from 709.44 on; 0 below -708.75
//   fast_expm1(x)      relative error 4e-16; x is clamped to [-700, 700] first
//   fast_fifth_root(x) relative error 6e-14 for x = 0 and normal x > 0; uses no division and no square root
//   fast_log2(x)       1.6 / 1.8 ULP for positive normal x; +inf for +inf; NaN for anything else
//   fast_power(x, p)   |x|^p: relative error (2 + |p|) 2^-53, and without fused multiply-add |p log2 x| 2^-53 more; not
//                      finite where x or p is not; same range as fast_exp2
// NaN gives NaN. Powers above 2^1023.5, within a factor of sqrt(2) of the largest double, become +inf, and those below
// 2^-1022.5 become 0 instead of subnormal numbers. A second scaling would give these results, but costs time.
// Source: Cody and Waite 1980 (the argument is reduced to a short interval), fdlibm (log through s = (m-1) / (m+1)),
// own coefficients (tools/elementary_coefficients.py). Departure: doubles are rounded to integers by adding 1.5 * 2^52,
// because SSE2 and AVX2 cannot convert between doubles and 64-bit integers.
// Polynomials use Horner's scheme, which has the fewest operations. Each operation waits for the one before, but
// meanwhile the processor computes other vectors. Rejected: sums of even and odd powers (faster for one or two vectors,
// slower from four on), log2 without a division (twice the terms).
// This code assumes round to nearest and IEEE NaN and infinity: never use -ffast-math or -ffinite-math-only.
// -fno-trapping-math, -fno-signed-zeros and -fno-math-errno do no harm. -ffp-contract=fast lets the compiler fuse the
// multiply-adds of vectors; all instruction sets that have fused multiply-add then give the same bits.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace isolaw::num {

// The operations on T that the functions need besides + - * / and comparisons. This template serves native vectors.
// Types that consist of several vectors specialise it.
template <class T>
struct Lanes {
  typedef std::uint64_t Bits __attribute__((vector_size(sizeof(T))));

  [[gnu::always_inline]] static inline T all(double x) { return T{} + x; }
  [[gnu::always_inline]] static inline Bits bits(T const& x) { return std::bit_cast<Bits>(x); }
  [[gnu::always_inline]] static inline T from_bits(Bits const& x) { return std::bit_cast<T>(x); }
  [[gnu::always_inline]] static inline T abs(T const& x) { return from_bits(bits(x) & 0x7fff'ffff'ffff'ffffU); }
  [[gnu::always_inline]] static inline T multiply_add(T const& a, T const& b, T const& c) { return a * b + c; }
  // multiply_add() for a sum that is then passed to select(). For AVX-512, GCC 12 would merge the addition with this
  // selection and no longer fuse the product with the addition.
  [[gnu::always_inline]] static inline T multiply_add_apart(T const& a, T const& b, T const& c) {
    T sum = a * b + c;
#if defined(__AVX512F__)
    asm("" : "+v"(sum));
#endif
    return sum;
  }
  template <class Mask>
  [[gnu::always_inline]] static inline T select(Mask const& mask, T const& a, T const& b) {
    return mask ? a : b;
  }
};

template <>
struct Lanes<double> {
  using Bits = std::uint64_t;

  [[gnu::always_inline]] static inline double all(double x) { return x; }
  [[gnu::always_inline]] static inline Bits bits(double x) { return std::bit_cast<Bits>(x); }
  [[gnu::always_inline]] static inline double from_bits(Bits x) { return std::bit_cast<double>(x); }
  [[gnu::always_inline]] static inline double abs(double x) { return __builtin_fabs(x); }
  [[gnu::always_inline]] static inline double multiply_add(double a, double b, double c) {
#ifdef __FMA__
    return __builtin_fma(a, b, c);
#else
    return a * b + c;  // without a fused instruction, std::fma would call a slow library function
#endif
  }
  [[gnu::always_inline]] static inline double multiply_add_apart(double a, double b, double c) {
    return multiply_add(a, b, c);
  }
  [[gnu::always_inline]] static inline double select(bool condition, double a, double b) {
    return condition ? a : b;
  }
};

namespace elementary {

// Coefficients of polynomials, lowest power first. The first polynomial is 2^f for |f| <= 1/2, relative error 5.6e-18.
inline constexpr double exp2_terms[] = {0x1.0000000000000p+0,  0x1.62e42fefa39efp-1,  0x1.ebfbdff82c5a5p-3,
                                        0x1.c6b08d704a122p-5,  0x1.3b2ab6fb9ffb3p-7,  0x1.5d87fe78a111cp-10,
                                        0x1.4309130f139cbp-13, 0x1.ffcbfc595bcf6p-17, 0x1.62bfc71ea7788p-20,
                                        0x1.b5253f6036401p-24, 0x1.e61c1058a1947p-28, 0x1.e9471c875b804p-32};
// e^f for |f| <= ln(2) / 2, relative error 4.1e-18.
inline constexpr double exp_terms[] = {0x1.0000000000000p+0,  0x1.0000000000000p+0,  0x1.000000000000bp-1,
                                       0x1.555555555550fp-3,  0x1.55555555502a0p-5,  0x1.1111111122b4ap-7,
                                       0x1.6c16c1852c01cp-10, 0x1.a01a014498ae6p-13, 0x1.a01997c656a0fp-16,
                                       0x1.71deec62e8918p-19, 0x1.28af42a60c9fap-22, 0x1.add773f1864b3p-26};
// ln(1 + f) = 2 s + s^3 q(s^2) for 1 + f from sqrt(1/2) to sqrt(2), s = f / (2 + f); relative error of the sum 1.3e-18.
inline constexpr double ln_terms[] = {0x1.5555555555594p-1, 0x1.999999997f77cp-2, 0x1.2492494235b74p-2,
                                      0x1.c71c51dbbbd75p-3, 0x1.746646d7fcebcp-3, 0x1.39a108cae2047p-3,
                                      0x1.2f0b96857276dp-3};
// log2(1 + f) = s q(s^2), relative error 1.8e-16, which suffices inside an exponent.
inline constexpr double power_log2_terms[] = {0x1.71547652b82ffp+1, 0x1.ec709dc39cd37p-1, 0x1.2776c5166ea8bp-1,
                                              0x1.a61756ae0f569p-2, 0x1.484f9fb17a412p-2, 0x1.0bb91613aa66ap-2,
                                              0x1.f1683d117925fp-3};
// (e^f - 1) / f: the polynomial of e^f without its first term.
inline constexpr double expm1_terms[] = {0x1.0000000000000p+0,  0x1.000000000000bp-1,  0x1.555555555550fp-3,
                                         0x1.55555555502a0p-5,  0x1.1111111122b4ap-7,  0x1.6c16c1852c01cp-10,
                                         0x1.a01a014498ae6p-13, 0x1.a01997c656a0fp-16, 0x1.71deec62e8918p-19,
                                         0x1.28af42a60c9fap-22, 0x1.add773f1864b3p-26};
// (1 - r)^(-4/5) for |r| <= 0.1551, which corrects the guess of fast_fifth_root(); relative error 6.2e-14.
inline constexpr double fifth_root_terms[] = {0x1.ffffffffffe17p-1, 0x1.9999999998dcdp-1, 0x1.70a3d70b97f13p-1,
                                              0x1.58106251289e7p-1, 0x1.46dc5ad4239cfp-1, 0x1.39c94b1496699p-1,
                                              0x1.2f556f2eab700p-1, 0x1.26ab754546262p-1, 0x1.1ebe68daca01fp-1,
                                              0x1.184271bf2f816p-1, 0x1.2755d98415d35p-1, 0x1.23a77d79fff6cp-1};
// Read as whole numbers, the first 52 bits of x^(-1/5) are about this constant minus a fifth of the first 52 bits of x.
inline constexpr double fifth_root_guess = 0x1.7febced916873p+52;
inline constexpr double log2_e = 0x1.71547652b82fep+0;
// ln(2) is the sum of these two. The first has so few bits that its product with a double's exponent is exact.
inline constexpr double ln2_high = 0x1.62e42fee00000p-1;
inline constexpr double ln2_low = 0x1.a39ef35793c76p-33;
// x + shifter rounds x to an integer n if |x| < 2^51 - 1023. The last bits of the sum then hold n + 1023, where 1023 is
// the bias of a double's exponent.
inline constexpr double shifter = 0x1.8p52 + 1023.0;
inline constexpr double lowest_exponent = -1022.5, highest_exponent = 1023.5;

inline constexpr double least_normal = std::numeric_limits<double>::min();
inline constexpr double largest = std::numeric_limits<double>::max();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double power_floor = 1e-290;
inline constexpr std::uint64_t bits_of_one = 0x3ff0'0000'0000'0000U, bits_of_root_half = 0x3fe6'a09e'667f'3bcdU;

template <class T, std::size_t Count, std::size_t... I>
[[gnu::always_inline]] inline T horner(double const (&terms)[Count], T const& x, std::index_sequence<I...>) {
  using L = Lanes<T>;
  T sum = L::all(terms[Count - 1]);
  ((sum = L::multiply_add(sum, x, L::all(terms[Count - 2 - I]))), ...);
  return sum;
}
template <class T, std::size_t Count>
[[gnu::always_inline]] inline T polynomial(double const (&terms)[Count], T const& x) {
  return horner<T>(terms, x, std::make_index_sequence<Count - 1>());
}

// Returns mantissa * 2^n for the integer n that the last bits of `shifted` hold (see `shifter`). Returns +inf or 0 if
// `exponent`, the number that was rounded to n, is out of range. The callers could clamp the exponent to the range
// before they round it, but for single doubles GCC 12 would compile this with one more branch on AVX2 and AVX-512.
// fast_expm1() clamps its x nevertheless, because its result is no product of this kind, so it cannot use scale().
template <class T>
[[gnu::always_inline]] inline T scale(T const& mantissa, T const& shifted, T const& exponent) {
  using L = Lanes<T>;
  T y = mantissa * L::from_bits(L::bits(shifted) << 52);
  y = L::select(exponent < L::all(lowest_exponent), L::all(0.0), y);
  return L::select(exponent >= L::all(highest_exponent), L::all(infinity), y);
}

// Splits a positive normal x into 2^whole * m with m from sqrt(1/2) to sqrt(2). The result is an integer with the bits
// of whole and of m, which whole_of() and mantissa_of() extract. A struct of two numbers would be slower, because GCC
// 12 would copy it through memory.
template <class T>
[[gnu::always_inline]] inline auto split(T const& x) {
  return Lanes<T>::bits(x) + (bits_of_one - bits_of_root_half);
}
template <class T, class Bits>
[[gnu::always_inline]] inline T whole_of(Bits const& split) {
  using L = Lanes<T>;
  return L::from_bits((split >> 52) | 0x4330'0000'0000'0000U) - L::all(0x1p52 + 1023.0);
}
template <class T, class Bits>
[[gnu::always_inline]] inline T mantissa_of(Bits const& split) {
  return Lanes<T>::from_bits((split & 0x000f'ffff'ffff'ffffU) + bits_of_root_half);
}

}  // namespace elementary

template <class T>
[[gnu::always_inline]] inline T fast_exp2(T const& x) {
  using L = Lanes<T>;
  T const shifted = x + L::all(elementary::shifter);
  T const rest = x - (shifted - L::all(elementary::shifter));
  return elementary::scale<T>(elementary::polynomial<T>(elementary::exp2_terms, rest), shifted, x);
}

template <class T>
[[gnu::always_inline]] inline T fast_exp(T const& x) {
  using L = Lanes<T>;
  T const exponent = x * L::all(elementary::log2_e);
  T const shifted = exponent + L::all(elementary::shifter);
  T const whole = shifted - L::all(elementary::shifter);
  T const rest =
      L::multiply_add(whole, L::all(-elementary::ln2_low), L::multiply_add(whole, L::all(-elementary::ln2_high), x));
  return elementary::scale<T>(elementary::polynomial<T>(elementary::exp_terms, rest), shifted, exponent);
}

template <class T>
[[gnu::always_inline]] inline T fast_expm1(T const& any) {
  using L = Lanes<T>;
  T const above = L::select(any < L::all(-700.0), L::all(-700.0), any);
  T const x = L::select(above > L::all(700.0), L::all(700.0), above);
  T const shifted = x * L::all(elementary::log2_e) + L::all(elementary::shifter);
  T const whole = shifted - L::all(elementary::shifter);
  T const rest =
      L::multiply_add(whole, L::all(-elementary::ln2_low), L::multiply_add(whole, L::all(-elementary::ln2_high), x));
  T const power = L::from_bits(L::bits(shifted) << 52);
  return L::multiply_add(power, rest * elementary::polynomial<T>(elementary::expm1_terms, rest), power - L::all(1.0));
}

// Guesses y = x^(-1/5) from the bits of x. The guessed root x y^4 is corrected by a polynomial in 1 - x y^5.
template <class T>
[[gnu::always_inline]] inline T fast_fifth_root(T const& x) {
  using L = Lanes<T>;
  T const bits = L::from_bits((L::bits(x) >> 12) | 0x4330'0000'0000'0000U);
  T const y = L::from_bits(L::bits(L::multiply_add(bits, L::all(-0.2), L::all(elementary::fifth_root_guess))) << 12);
  T const square = y * y, root = x * (square * square), off = L::all(1.0) - root * y, off2 = off * off;
  // The even and the odd powers are summed separately, which halves the latency.
  constexpr auto const& c = elementary::fifth_root_terms;
  T even = L::all(c[10]), odd = L::all(c[11]);
  for (int i = 8; i >= 0; i -= 2) {
    even = L::multiply_add(even, off2, L::all(c[i]));
    odd = L::multiply_add(odd, off2, L::all(c[i + 1]));
  }
  return root * L::multiply_add(odd, off, even);
}

template <class T>
[[gnu::always_inline]] inline T fast_log2(T const& x) {
  using L = Lanes<T>;
  auto const split = elementary::split<T>(x);
  T const whole = elementary::whole_of<T>(split), m = elementary::mantissa_of<T>(split);
  T const f = m - L::all(1.0), s = f / (m + L::all(1.0));
  // Since 2 s = f - s f, the leading term can be f, which is exact, instead of s, which is rounded twice.
  T const square = s * s;
  T const correction = L::multiply_add(-square, elementary::polynomial<T>(elementary::ln_terms, square), f);
  T const y = L::multiply_add_apart(L::multiply_add(-s, correction, f), L::all(elementary::log2_e), whole);
  T const finite = L::select(x <= L::all(elementary::largest), y, x);
  return L::select(x < L::all(elementary::least_normal), L::all(elementary::not_a_number), finite);
}

// |x|^p as 2^(p log2 |x|) for |p| up to 1e20. log2 |x| is kept in two parts, so that a large exponent loses no digits.
// 1e-290 is added to |x|, which is cheaper than a maximum and gives the same result at 0 and from 1e-274 on.
template <class T>
[[gnu::always_inline]] inline T fast_power(T const& x, T const& p) {
  using L = Lanes<T>;
  T const base = L::abs(x) + L::all(elementary::power_floor);
  auto const split = elementary::split<T>(base);
  T const whole = elementary::whole_of<T>(split), m = elementary::mantissa_of<T>(split);
  T const s = (m - L::all(1.0)) / (m + L::all(1.0));
  // If base is not finite, base - base is NaN and makes the result NaN; else it is 0. GCC 12 with -fno-signed-zeros
  // would turn base * 0 into 0.
  T const fraction = s * elementary::polynomial<T>(elementary::power_log2_terms, s * s) + (base - base);
  // `exponent` has a rounding error. `rest` is computed from p, `whole` and `fraction`, so that it lacks this error.
  T const exponent = p * (whole + fraction);
  T const shifted = exponent + L::all(elementary::shifter);
  T const nearest = shifted - L::all(elementary::shifter);
  T const rest = L::multiply_add(p, fraction, L::multiply_add(p, whole, -nearest));
  return elementary::scale<T>(elementary::polynomial<T>(elementary::exp2_terms, rest), shifted, exponent);
}

}  // namespace isolaw::num
