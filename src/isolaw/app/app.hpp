// The command line program: commands, options, exit codes.
#pragma once

namespace isolaw::app {

// Exit codes: 0 done; 1 done with refusals or failures; 2 wrong usage or no usable device; 3 internal error. Never
// throws.
int run(int argc, char** argv);

}  // namespace isolaw::app
