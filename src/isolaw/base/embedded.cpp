#include "isolaw/base/embedded.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace isolaw {

std::string_view embedded_text(std::span<Embedded const> files, std::string_view name) {
  auto const found = std::ranges::find(files, name, &Embedded::name);
  if (found == files.end()) throw std::logic_error("no embedded file " + std::string(name));
  return found->text;
}

}  // namespace isolaw
