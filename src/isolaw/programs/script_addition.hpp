// Text that a target adds to another target's script. Targets with a model add it to the script of the law.
#pragma once

#include <string>
#include <vector>

#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

struct ScriptAddition {
  std::vector<Fact> facts;
  std::string usage;       // comment lines
  std::string procedures;  // functions in the script's namespace or module
  std::string dispatch;    // reads the arguments of the script; in Tcl it follows the self-check
};

}  // namespace isolaw::programs
