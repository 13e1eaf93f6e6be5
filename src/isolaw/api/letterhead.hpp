// A laboratory's letterhead for certificates.
#pragma once

#include <string>

namespace isolaw {

// Returns a picture as a data: address (RFC 2397), or lines of text in UTF-8. Throws Error for a file that is neither a
// picture nor text of a few lines.
std::string load_letterhead(std::string const& file);

}  // namespace isolaw
