// The parts of exported C++ that OpenSees or Abaqus calls: the files in interface/, where values replace @marks@.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace isolaw::programs {

using Marks = std::span<std::pair<std::string_view, std::string> const>;
// Returns a file with its marks replaced. Throws std::logic_error for an unknown file or mark.
std::string interface_part(std::string_view file, Marks marks);

}  // namespace isolaw::programs
