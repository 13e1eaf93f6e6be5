// The command line program: commands, options, exit codes.
#pragma once

namespace isolaw::app {

// Never throws. Returns 0 if done, 1 with refusals or failures, 2 for wrong usage or no usable device, 3 for an
// internal error.
int run(int argc, char** argv);

}  // namespace isolaw::app
