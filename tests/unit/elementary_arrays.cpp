// The build compiles this file once for each instruction set. Each time, ISOLAW_ELEMENTARY_TABLE names the table of
// functions that the file defines. All functions are inlined or private to this file; otherwise the linker could keep
// one copy of a function for all instruction sets.
#include "unit/elementary_arrays.hpp"

#include "isolaw/num/elementary.hpp"

namespace isolaw::num {
namespace {

#if defined(__AVX512F__)
constexpr std::size_t width = 8;
#elif defined(__AVX__)
constexpr std::size_t width = 4;
#else
constexpr std::size_t width = 2;
#endif
typedef double Vector __attribute__((vector_size(width * sizeof(double))));
typedef double Unaligned __attribute__((vector_size(width * sizeof(double)), aligned(sizeof(double)), may_alias));

template <class F>
[[gnu::always_inline]] inline void loop(double const* __restrict x, double const* __restrict p, double* __restrict y,
                                        F f) {
  for (std::size_t i = 0; i < ElementaryArrays::lanes; ++i) y[i] = f(x[i], p[i]);
}
template <class F>
[[gnu::always_inline]] inline void vectors(double const* x, double const* p, double* y, F f) {
  for (std::size_t i = 0; i < ElementaryArrays::lanes; i += width) {
    Vector const xs = *reinterpret_cast<Unaligned const*>(x + i), ps = *reinterpret_cast<Unaligned const*>(p + i);
    *reinterpret_cast<Unaligned*>(y + i) = f(xs, ps);
  }
}

constexpr auto exp2_of = [](auto const& x, auto const&) __attribute__((always_inline)) {
  return fast_exp2(x);
};
constexpr auto exp_of = [](auto const& x, auto const&) __attribute__((always_inline)) {
  return fast_exp(x);
};
constexpr auto log2_of = [](auto const& x, auto const&) __attribute__((always_inline)) {
  return fast_log2(x);
};
constexpr auto power_of = [](auto const& x, auto const& p) __attribute__((always_inline)) {
  return fast_power(x, p);
};

}  // namespace

extern ElementaryArrays const ISOLAW_ELEMENTARY_TABLE{
    .exp2 = [](double const* x, double const* p, double* y) { loop(x, p, y, exp2_of); },
    .exp = [](double const* x, double const* p, double* y) { loop(x, p, y, exp_of); },
    .log2 = [](double const* x, double const* p, double* y) { loop(x, p, y, log2_of); },
    .power = [](double const* x, double const* p, double* y) { loop(x, p, y, power_of); },
    .vector_exp2 = [](double const* x, double const* p, double* y) { vectors(x, p, y, exp2_of); },
    .vector_exp = [](double const* x, double const* p, double* y) { vectors(x, p, y, exp_of); },
    .vector_log2 = [](double const* x, double const* p, double* y) { vectors(x, p, y, log2_of); },
    .vector_power = [](double const* x, double const* p, double* y) { vectors(x, p, y, power_of); },
};

}  // namespace isolaw::num
