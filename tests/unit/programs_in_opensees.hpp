// A folder in which scripts run in the real OpenSees (Tcl, and as a module of Python), where that lies beside the
// checkout.
#pragma once

#include "unit/programs_folder.hpp"

namespace isolaw::programs_test {

inline fs::path const opensees = fs::path(ISOLAW_DATA_DIR).parent_path() / "opensees";

class OpenSees : public Folder {
 protected:
  void SetUp() override {
    Folder::SetUp();
    if (!fs::exists(opensees / "OpenSees")) GTEST_SKIP() << "OpenSees is not here: " << opensees;
    write("starts.tcl", "puts ready\n");
    if (run(fmt::format("'{}' starts.tcl", (opensees / "OpenSees").string())) != 0 ||
        read("printed").find("ready") == std::string::npos)
      GTEST_SKIP() << "OpenSees does not start (needs Debian's tcl, liblapack3, libgfortran5): " << read("printed");
    fs::create_directories(folder_ / "openseespy");
    write("openseespy/__init__.py", "");
    fs::create_symlink(opensees / "opensees.so", folder_ / "openseespy/opensees.so");
  }
  int run_tcl(std::string const& arguments) const {
    return run(fmt::format("'{}' {}", (opensees / "OpenSees").string(), arguments));
  }
};

}  // namespace isolaw::programs_test
