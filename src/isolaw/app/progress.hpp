// A progress line on a terminal: share done, rate, time left, best objective per law.
#pragma once

#include <chrono>

#include "isolaw/campaign/campaign.hpp"

namespace isolaw::app {

class ProgressLine {
 public:
  ProgressLine();  // a line every half minute when stderr is not a terminal
  ~ProgressLine();
  ProgressLine(ProgressLine const&) = delete;
  ProgressLine& operator=(ProgressLine const&) = delete;

  void show(campaign::Progress const& progress);

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
  std::size_t done_at_start_ = 0;
  bool first_ = true;
  bool analysis_ = false;
};

}  // namespace isolaw::app
