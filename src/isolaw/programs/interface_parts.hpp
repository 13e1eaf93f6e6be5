// The program's side of exported C++ (OpenSees, Abaqus): the files of interface/, with their @marks@ replaced.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace isolaw::programs {

using Marks = std::span<std::pair<std::string_view, std::string> const>;
// Throws std::logic_error for an unknown file or mark.
std::string interface_part(std::string_view file, Marks marks);

}  // namespace isolaw::programs
