// What a target puts into the script of another: a model into that of the law it is made of.
#pragma once

#include <string>
#include <vector>

#include "isolaw/programs/text.hpp"

namespace isolaw::programs {

struct ScriptAddition {
  std::vector<Fact> facts;
  std::string usage;       // lines of comment
  std::string procedures;  // of the namespace or the module
  std::string dispatch;    // what the arguments of the program ask for, in Tcl after that of the check
};

}  // namespace isolaw::programs
