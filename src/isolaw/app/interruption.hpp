// Lets a signal end a long command early. Finished work is kept, and the user continues it with the same command.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace isolaw::app {

// Catches SIGINT, SIGTERM and SIGHUP: the first signal sets interrupted(), a second one of the same kind ends the
// program. SIGHUP stays ignored under nohup.
class SignalGuard {
 public:
  SignalGuard();
  SignalGuard(SignalGuard const&) = delete;
  SignalGuard& operator=(SignalGuard const&) = delete;
  ~SignalGuard();

 private:
  std::array<void (*)(int), 3> previous_{};
};
// Returns whether a signal came after the last SignalGuard was constructed.
bool interrupted();

// Returns the command line that continues the interrupted work: `words` without --fresh.
std::string to_continue(std::vector<std::string> words);

}  // namespace isolaw::app
