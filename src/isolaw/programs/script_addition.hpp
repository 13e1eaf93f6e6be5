// Text that one target adds to the script of another: a model is added to the script of its law.
#pragma once

#include <string>
#include <vector>

#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

struct ScriptAddition {
  std::vector<Fact> facts;
  std::string usage;       // lines of comment
  std::string procedures;  // belong to the namespace or the module
  std::string dispatch;    // reads the program's arguments; in Tcl it follows the check
};

}  // namespace isolaw::programs
