// Text that is inserted in the script of a law. The targets that write a building model use it.
#pragma once

#include <string>
#include <vector>

#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

struct ScriptAddition {
  std::vector<Fact> facts;
  std::string usage;       // comment lines
  std::string head;        // code at the head of the script, after its comments
  std::string procedures;  // functions to add to the script's namespace or module
  std::string dispatch;    // code that reads the script's arguments; in Tcl it follows the self-check
};

}  // namespace isolaw::programs
