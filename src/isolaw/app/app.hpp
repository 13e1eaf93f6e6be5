// The command line program: commands, options, exit codes.
#pragma once

#include <string>

namespace isolaw::app {

// Runs a command. Never throws. Returns 0 if all is done, 1 if a part was refused or failed, 2 for wrong usage or no
// usable device, 3 for an internal error.
int run(int argc, char** argv);

// The text of `isolaw --version`, with the facts that a fault report needs: "isolaw 0.2.0 (commit 8394911)",
// "g++ 12.2.0, avx512", "build 0123456789ab". The last hash is of the sources.
std::string version_text();

}  // namespace isolaw::app
