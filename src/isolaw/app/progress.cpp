#include "isolaw/app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <string>

#include "isolaw/app/say.hpp"

namespace isolaw::app {
namespace {

std::string duration(double seconds) {
  auto const s = static_cast<long>(seconds + 0.5);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{}:{:02} min", s / 60, s % 60);
  return fmt::format("{}:{:02} h", s / 3600, s % 3600 / 60);
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  if (drawn_) say("\r\033[K");
}

void ProgressLine::show(campaign::Progress const& progress) {
  if (progress.total == 0) return;
  auto const now = Clock::now();
  if (analysis_ != progress.analysis) {  // the analyses that follow the runs have a rate of their own
    analysis_ = progress.analysis;
    first_ = true;
    start_ = now;
  }
  auto const* what = progress.analysis ? "analyses" : "runs";
  if (first_) {
    done_at_start_ = progress.done - 1;  // runs finished before an interruption do not count for the rate
    first_ = false;
  }
  bool const last = progress.done == progress.total;
  // In a log file a line now and then, so that a long search is seen to be alive.
  auto const pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(30);
  if (terminal_ ? !last && now - last_ < pause : now - last_ < pause) return;
  last_ = now;
  double const elapsed = std::chrono::duration<double>(now - start_).count();
  double const rate = static_cast<double>(progress.done - done_at_start_) / std::max(elapsed, 1e-3);
  double const left = static_cast<double>(progress.total - progress.done) / rate;
  if (!terminal_) {
    say("{}/{} {}, {:.1f}/s, {} left\n", progress.done, progress.total, what, rate, duration(left));
    return;
  }
  drawn_ = true;
  constexpr std::size_t cells = 20;
  auto const filled = cells * progress.done / progress.total;
  std::string bar;
  for (std::size_t i = 0; i < cells; ++i) bar += i < filled ? "#" : "-";
  auto line =
      fmt::format("[{}] {}/{} {}  {:.1f}/s  {} left ", bar, progress.done, progress.total, what, rate, duration(left));
  for (auto const& [law, best] : progress.best) line += fmt::format(" {} {:.4f}", law, best);
  line.resize(std::min(line.size(), static_cast<std::size_t>(terminal_width(STDERR_FILENO) - 1)));
  say("\r{}\033[K", line);
}

}  // namespace isolaw::app
