// Shows the progress line: the share of all work that is done, the time left, the number of finished runs or analyses,
// and the law and device of the latest one.
#pragma once

#include <chrono>
#include <cstddef>

#include "isolaw/campaign/campaign.hpp"

namespace isolaw::app {

class ProgressLine {
 public:
  ProgressLine();  // if stderr is not a terminal, it prints a line every half minute
  ~ProgressLine();
  ProgressLine(ProgressLine const&) = delete;
  ProgressLine& operator=(ProgressLine const&) = delete;

  void show(campaign::Progress const& progress);

 private:
  using Clock = std::chrono::steady_clock;
  [[maybe_unused]] bool terminal_;
  bool drawn_ = false;
  [[maybe_unused]] std::size_t told_ = 0;  // how many of the finished runs the browser version has printed
  Clock::time_point last_ = Clock::now();
};

}  // namespace isolaw::app
