// Tells where OpenSees is installed; the tests run exported scripts in it. tools/opensees.sh installs OpenSees from
// PyPI as a Python module, in build/opensees. The environment variable ISOLAW_OPENSEES may name another folder. The
// module also runs Tcl scripts, through opensees/tcl_script.py. `xara` is a fork of OpenSees with its own Tcl
// interpreter.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace isolaw {

struct OpenSeesHere {
  std::filesystem::path folder =
      std::getenv("ISOLAW_OPENSEES") != nullptr ? std::getenv("ISOLAW_OPENSEES") : ISOLAW_OPENSEES_DIR;
  std::string python = (folder / "openseespy/bin/python").string();
  std::string xara = (folder / "xara/bin/python").string();
  std::string tcl_script = ISOLAW_SOURCE_DIR "/tests/opensees/tcl_script.py";

  bool is_there() const { return std::filesystem::exists(folder / "openseespy/installed"); }
  bool has_xara() const { return std::filesystem::exists(folder / "xara/installed"); }
  std::string lacking() const { return "OpenSees is not in " + folder.string() + "; tools/opensees.sh installs it"; }
};

}  // namespace isolaw
