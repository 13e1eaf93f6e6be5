// Measures the time that threads spend in the laws' code, for a campaign's profile.
#pragma once

#include <chrono>

namespace isolaw::fit {

// Elapsed time of the calling thread in the laws' code [s]; the caller may reset it.
inline thread_local double kernel_time_s = 0.0;

// Adds the time for which the object lives to kernel_time_s. It reads the steady clock, which takes about 40 ns; the
// processor-time clock takes thirty times as long.
class KernelTimer {
 public:
  KernelTimer() = default;
  KernelTimer(KernelTimer const&) = delete;
  KernelTimer& operator=(KernelTimer const&) = delete;
  ~KernelTimer() { kernel_time_s += std::chrono::duration<double>(Clock::now() - start_).count(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace isolaw::fit
