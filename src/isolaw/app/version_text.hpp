// What `isolaw --version` prints: which program this is, and what a fault report needs.
#pragma once

#include <string>

namespace isolaw::app {

// Three lines: "isolaw 0.2.0 (8394911)", "g++ 12.2.0, avx512", "build 0123456789ab". The build is the hash of the
// sources that decide numbers, as stores keep it; the commit changes with every comment too.
std::string version_text();

}  // namespace isolaw::app
