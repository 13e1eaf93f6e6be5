// instructions.sh must find this error: compiled for a wide set and for the baseline, both objects hold the function.
#include "kernels/breach.hpp"

double ISOLAW_BREACH(double const* values) {
  return breach(values);
}
