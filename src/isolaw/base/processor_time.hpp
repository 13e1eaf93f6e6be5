// Processor time, which other work on the machine does not lengthen much.
#pragma once

#include <ctime>

namespace isolaw {

inline double processor_time_s(clockid_t clock) {
  timespec time{};
  // Without a clock of the processor's, as in a browser: time that goes by.
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
