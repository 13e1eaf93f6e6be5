// The text of `isolaw --version`: it identifies the program, and holds the facts that a fault report needs.
#pragma once

#include <string>

namespace isolaw::app {

// "isolaw 0.2.0 (8394911)", "g++ 12.2.0, avx512", "build 0123456789ab". The last hash is of the sources.
std::string version_text();

}  // namespace isolaw::app
