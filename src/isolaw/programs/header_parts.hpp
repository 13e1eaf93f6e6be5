// Pieces of exported C++ headers: the embedded files of laws/online/.
#pragma once

#include <string_view>
#include <vector>

namespace isolaw::programs {

// A law's pieces in order, to be written before header_material(); empty for a law without an online form.
std::vector<std::string_view> header_parts(std::string_view law);
std::string_view header_numbers();
std::vector<std::string_view> header_material();
// True if the law's state grows with the number of turning points that are still open.
bool remembers_turning_points(std::string_view law);

}  // namespace isolaw::programs
