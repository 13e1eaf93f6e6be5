// The source texts in laws/online/ that exported C++ headers consist of.
#pragma once

#include <string_view>
#include <vector>

namespace isolaw::programs {

// The texts of one law, in the order in which they precede header_material(). Empty for a law without an online form.
std::vector<std::string_view> header_parts(std::string_view law);
std::string_view header_numbers();
std::vector<std::string_view> header_material();
// True if the law stores its turning points, so that its state grows with their number.
bool remembers_turning_points(std::string_view law);

}  // namespace isolaw::programs
