#pragma once

// This function stands for any inline function of a header that the compiler did not inline. Every object that calls
// such a function defines it, and the linker keeps one copy for the whole program, perhaps the one for AVX-512.
[[gnu::noinline]] inline double breach(double const* values) {
  double sum = 0.0;
  for (int i = 0; i < 1024; ++i) sum += 0.5 * values[i] * values[i];
  return sum;
}
