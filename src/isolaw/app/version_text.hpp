// The text of `isolaw --version`: which program this is, and the facts that a fault report needs.
#pragma once

#include <string>

namespace isolaw::app {

// "isolaw 0.2.0 (8394911)", "g++ 12.2.0, avx512", "build 0123456789ab" (the hash of the sources that decide numbers).
std::string version_text();

}  // namespace isolaw::app
