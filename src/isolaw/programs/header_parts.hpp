// Makes the C++17 code of a law for exported files from the law's own file.
//
// Lines of a file of laws/ between `// [export]` and `// [end]` are exported. `// [export struct Bilinear]` encloses
// them in that struct. In these lines T is the number type of the parameters, X that of the motion and N that of the
// force. The export removes T, X and N from the template parameters and writes double for T and Dual for X and N. The
// marked lines of included files come before those of the law's own file. Functions that nothing calls are left out.
#pragma once

#include <string>
#include <string_view>

namespace isolaw::programs {

// Returns the whole C++ code of a law: number types, the law, its motion and the class Material. The parameters' values
// are not part of it. Empty if laws/ has no file of the law's name.
std::string law_in_cpp(std::string_view law);
// True if the law stores its turning points, so that its state grows with their number.
bool remembers_turning_points(std::string_view law);

}  // namespace isolaw::programs
