// Prints the progress lines of the browser version, about five times per second. page/engine/progress.js reads them:
//   run LAW OBJECTIVE DEVICE       once for each finished run, also of an earlier start; DEVICE counts from 0
//   progress SHARE SECONDS_LEFT DONE TOTAL runs|analyses
#include <fmt/format.h>

#include "isolaw/app/progress.hpp"
#include "isolaw/app/say.hpp"

namespace isolaw::app {

ProgressLine::ProgressLine() : terminal_(false) {}

ProgressLine::~ProgressLine() = default;

void ProgressLine::show(campaign::Progress const& progress) {
  auto const now = Clock::now();
  bool const is_end = progress.done == progress.total;
  if (progress.total == 0 || (drawn_ && !is_end && now - last_ < std::chrono::milliseconds(200))) return;
  drawn_ = true;
  last_ = now;
  for (; told_ < progress.runs.size(); ++told_) {
    auto const& run = progress.runs[told_];
    say("run {} {:.6g} {}\n", run.law, run.objective, run.device);
  }
  say("progress {:.4f} {:.1f} {} {} {}\n", progress.share, progress.left_s, progress.done, progress.total,
      progress.analysis ? "analyses" : "runs");
}

}  // namespace isolaw::app
