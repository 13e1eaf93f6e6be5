// What instructions.sh must find: compiled for a wide set and for the baseline, both hold the same function.
#include "kernels/breach.hpp"

double ISOLAW_BREACH(double const* values) {
  return breach(values);
}
