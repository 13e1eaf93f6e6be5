#include "isolaw/app/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "isolaw/app/say.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::app {
namespace {

std::string duration(double seconds) {
  auto const s = static_cast<long>(seconds + 0.5);
  if (s < 60) return fmt::format("{} s", s);
  if (s < 3600) return fmt::format("{}:{:02} min", s / 60, s % 60);
  return fmt::format("{}:{:02} h", s / 3600, s % 3600 / 60);
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(is_terminal(StandardStream::error)) {}

ProgressLine::~ProgressLine() {
  if (drawn_) say("\r\033[K");
}

void ProgressLine::show(campaign::Progress const& progress) {
  if (progress.total == 0) return;
  auto const now = Clock::now();
  auto const* what = progress.analysis ? "analyses" : "runs";
  bool const last = progress.done == progress.total;
  // If standard error is a log file, it gets a line every 30 s, which shows that a long search is still running.
  auto const pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::seconds(30);
  if (terminal_ ? !last && now - last_ < pause : now - last_ < pause) return;
  last_ = now;
  // Rounds down, so that 100 % is shown only when all work is done.
  auto const percent = static_cast<int>(100.0 * progress.share);
  if (!terminal_) {
    say("{} % done, {} left, {}/{} {}\n", percent, duration(progress.left_s), progress.done, progress.total, what);
    return;
  }
  drawn_ = true;
  constexpr std::size_t cells = 16;
  auto const filled = static_cast<std::size_t>(static_cast<double>(cells) * progress.share);
  std::string bar;
  for (std::size_t i = 0; i < cells; ++i) bar += i < filled ? "#" : "-";
  auto line = fmt::format("[{}] {} %  {} left  {}/{} {} ", bar, percent, duration(progress.left_s), progress.done,
                          progress.total, what);
  if (!progress.law.empty()) line += " " + std::string(laws::display_name(progress.law));
  if (!progress.device.empty()) line += " on " + printable(progress.device);
  // The line is cut to the width of the terminal or 80 columns, so that it does not wrap. It is cut between characters,
  // even if this is within a name.
  auto const width = std::min(terminal_width(StandardStream::error), 80) - 1;
  std::size_t end = 0;
  for (int letters = 0; letters < width && end < line.size(); ++letters)
    end += utf8_length(std::string_view(line).substr(end));
  say("\r{}\033[K", line.substr(0, end));
}

}  // namespace isolaw::app
