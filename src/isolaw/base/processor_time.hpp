// Processor time in seconds. Unlike elapsed time, it hardly grows when other programs use the machine.
#pragma once

#include <ctime>

namespace isolaw {

inline double processor_time_s(clockid_t clock) {
  timespec time{};
  // A browser has no processor clock. There the function returns elapsed time.
  if (clock_gettime(clock, &time) != 0) clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
inline double thread_time_s() {
  return processor_time_s(CLOCK_THREAD_CPUTIME_ID);
}
inline double process_time_s() {
  return processor_time_s(CLOCK_PROCESS_CPUTIME_ID);
}

}  // namespace isolaw
