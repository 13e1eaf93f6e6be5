// An error that instructions.sh must find: compiled for a wide set and for the baseline, both objects hold this
// function.
#include "kernels/breach.hpp"

double ISOLAW_BREACH(double const* values) {
  return breach(values);
}
