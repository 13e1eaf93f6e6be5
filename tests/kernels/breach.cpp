// The deliberate error that instructions.sh must report. This file is compiled for AVX-512 and for the baseline, so two
// objects define the function breach().
#include "kernels/breach.hpp"

double ISOLAW_BREACH(double const* values) {
  return breach(values);
}
