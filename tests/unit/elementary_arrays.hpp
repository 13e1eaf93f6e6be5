// The functions of num/elementary.hpp, applied to arrays. elementary_arrays.cpp is compiled with the options of each
// instruction set and defines one table of these functions. The unit test and the benchmark use the tables.
#pragma once

#include <cstddef>

namespace isolaw::num {

struct ElementaryArrays {
  static constexpr std::size_t lanes = 32;  // elements per call

  // Only power and vector_power use p, the exponents.
  using Function = void (*)(double const* x, double const* p, double* y);
  // The functions without vector_ in their names are loops over doubles. The others work on the instruction set's
  // vectors.
  Function exp2, exp, log2, power, vector_exp2, vector_exp, vector_log2, vector_power;
};

extern ElementaryArrays const elementary_baseline, elementary_v3, elementary_v4;

// Returns whether this processor can run the functions compiled for x86-64-v3.
inline bool runs_v3() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
}
inline bool runs_v4() {
  return runs_v3() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
}

}  // namespace isolaw::num
