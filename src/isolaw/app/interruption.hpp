// Ending a long command early: finished work is kept, and the same command continues.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace isolaw::app {

// A second signal ends the program at once. Under nohup a closed terminal is ignored.
class SignalGuard {
 public:
  SignalGuard();
  SignalGuard(SignalGuard const&) = delete;
  SignalGuard& operator=(SignalGuard const&) = delete;
  ~SignalGuard();

 private:
  std::array<void (*)(int), 3> previous_{};
};
// Whether a signal came since the last guard was constructed.
bool interrupted();

// The command line that continues the work: the given words without --fresh.
std::string to_continue(std::vector<std::string> words);

}  // namespace isolaw::app
