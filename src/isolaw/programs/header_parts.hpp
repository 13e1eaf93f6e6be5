// The C++17 code of a law for exported files, made from the law's own file.
//
// Lines of a file of laws/ between `// [export]` and `// [end]` are exported. `// [export struct Bilinear]` encloses
// them in that struct. In these lines T is the number of a parameter, X that of the motion and N that of a force. The
// export drops these three from the heads of templates and writes double, Dual and Dual for them. The marked lines of
// the files that a law's file includes come before its own, and functions that nothing calls are left out.
#pragma once

#include <string>
#include <string_view>

namespace isolaw::programs {

// Everything that follows the parameters: numbers, the law, its motion and the material. Empty if no file of laws/ has
// the law's id as its name.
std::string law_in_cpp(std::string_view law);
// True if the law stores its turning points, so that its state grows with their number.
bool remembers_turning_points(std::string_view law);

}  // namespace isolaw::programs
