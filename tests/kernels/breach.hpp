#pragma once

// It stands for an inline function of a header that was not inlined: the linker keeps one copy for all objects.
[[gnu::noinline]] inline double breach(double const* values) {
  double sum = 0.0;
  for (int i = 0; i < 1024; ++i) sum += 0.5 * values[i] * values[i];
  return sum;
}
