// A folder in which exported scripts run in the real OpenSees.
#pragma once

#include "opensees.hpp"
#include "unit/programs_folder.hpp"

namespace isolaw::programs_test {

class OpenSees : public Folder {
 protected:
  void SetUp() override {
    Folder::SetUp();
    if (!here_.is_there()) GTEST_SKIP() << here_.lacking();
  }
  int run_tcl(std::string const& arguments) const {
    return run(fmt::format("'{}' '{}' {}", here_.python, here_.tcl_script, arguments));
  }
  int run_python(std::string const& arguments) const { return run(fmt::format("'{}' {}", here_.python, arguments)); }

  OpenSeesHere const here_;
};

}  // namespace isolaw::programs_test
