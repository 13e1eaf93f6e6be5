#pragma once

// As an inline function of a header that the compiler did not inline: the linker keeps one copy for all objects.
[[gnu::noinline]] inline double breach(double const* values) {
  double sum = 0.0;
  for (int i = 0; i < 1024; ++i) sum += 0.5 * values[i] * values[i];
  return sum;
}
