// Measures how long threads compute laws, for the report on where a campaign's time went.
#pragma once

#include <chrono>

namespace isolaw::fit {

// Time that the calling thread has spent in the laws' kernels [s]. The caller may reset it to zero.
inline thread_local double kernel_time_s = 0.0;

// Adds the lifetime of the object to kernel_time_s. It reads the steady clock, which takes about 40 ns, because reading
// the clock of processor time takes thirty times as long.
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
