#include "isolaw/app/interruption.hpp"

#include <atomic>
#include <csignal>

#include "isolaw/base/shell.hpp"

namespace isolaw::app {
namespace {

std::atomic<bool> asked_to_end = false;
static_assert(std::atomic<bool>::is_always_lock_free);

#ifdef SIGHUP
constexpr int hang_up = SIGHUP;
#else
constexpr int hang_up = SIGBREAK;  // Windows sends it when the window of the terminal is closed
#endif
constexpr std::array signals{SIGINT, SIGTERM, hang_up};

void on_signal(int number) {
  asked_to_end = true;
  std::signal(number, SIG_DFL);
}

}  // namespace

SignalGuard::SignalGuard() {
  asked_to_end = false;
  for (std::size_t i = 0; i < signals.size(); ++i) previous_[i] = std::signal(signals[i], on_signal);
  if (previous_.back() == SIG_IGN) std::signal(hang_up, SIG_IGN);
}

SignalGuard::~SignalGuard() {
  for (std::size_t i = 0; i < signals.size(); ++i) std::signal(signals[i], previous_[i]);
}

bool interrupted() {
  return asked_to_end;
}

std::string to_continue(std::vector<std::string> words) {
  std::erase(words, "--fresh");
  return shell_quoted(words);
}

}  // namespace isolaw::app
