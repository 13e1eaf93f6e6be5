// How long commands end early: what is finished is kept, the exit code is that of a result with something missing, and
// the same command goes on.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace isolaw::app {

// Ctrl-C, a polite kill and a terminal that is closed ask for an end; a second signal ends the program at once. Where a
// closed terminal is to be ignored (nohup), it is.
class SignalGuard {
 public:
  SignalGuard();
  SignalGuard(SignalGuard const&) = delete;
  SignalGuard& operator=(SignalGuard const&) = delete;
  ~SignalGuard();

 private:
  std::array<void (*)(int), 3> previous_{};
};
// Whether one came since the last guard was made.
bool interrupted();

// The command line that goes on: without what starts over.
std::string to_continue(std::vector<std::string> words);

}  // namespace isolaw::app
