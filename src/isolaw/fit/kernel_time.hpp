// Measures the time that threads spend in the laws' code, for a campaign's profile.
#pragma once

#include <chrono>

namespace isolaw::fit {

// Elapsed time of the calling thread in the laws' code [s]; the caller may reset it.
inline thread_local double kernel_time_s = 0.0;

// Adds its lifetime to kernel_time_s. Reading this clock takes some 40 ns, a processor clock thirty times longer.
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
