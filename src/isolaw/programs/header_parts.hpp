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
// How far a sound header may be from the law, of the peak force. The exact flow is a polynomial in the law and a table
// in the header, within 1e-7 of one another but where unloading comes close to a rest (kappa near -1), which magnifies.
double header_tolerance(std::string_view law);

}  // namespace isolaw::programs
