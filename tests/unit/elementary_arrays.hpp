// The functions of num/elementary.hpp over arrays, once per instruction set: elementary_arrays.cpp is compiled with the
// options of each set and gives one table. The unit test and the benchmark use them.
#pragma once

#include <cstddef>

namespace isolaw::num {

struct ElementaryArrays {
  static constexpr std::size_t lanes = 32;  // elements per call

  using Function = void (*)(double const* x, double const* p, double* y);  // p: exponents, for power alone
  // First as loops over doubles, then on vectors of the instruction set's width.
  Function exp2, exp, log2, power, vector_exp2, vector_exp, vector_log2, vector_power;
};

extern ElementaryArrays const elementary_baseline, elementary_v3, elementary_v4;

// Whether this machine can run the functions of v3 and v4.
inline bool runs_v3() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
}
inline bool runs_v4() {
  return runs_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
}

}  // namespace isolaw::num
