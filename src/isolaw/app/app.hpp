// Runs the command line program: it defines the commands, their options and the exit codes.
#pragma once

#include <string>

namespace isolaw::app {

// Runs a command. Never throws. Returns 0 if everything was done, 1 if an input was refused or a part of the work
// failed, 2 for wrong usage or if no device is usable, and 3 for an internal error.
int run(int argc, char** argv);

// Returns the text of `isolaw --version`, with the facts that a bug report needs: "isolaw 0.2.0 (commit 8394911)",
// "g++ 12.2.0, avx512", "build 0123456789ab". The hash after "build" is computed from the sources.
std::string version_text();

}  // namespace isolaw::app
