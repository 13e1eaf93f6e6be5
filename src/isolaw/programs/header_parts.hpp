// The pieces that exported C++ headers are put together from; the files of laws/online/.
#pragma once

#include <string_view>
#include <vector>

namespace isolaw::programs {

// Those of a law before its material, in order; empty for a law that has none.
std::vector<std::string_view> header_parts(std::string_view law);
std::string_view header_numbers();
std::vector<std::string_view> header_material();  // what stands around it
// Whether its state grows with what the motion left open.
bool remembers_turning_points(std::string_view law);

}  // namespace isolaw::programs
