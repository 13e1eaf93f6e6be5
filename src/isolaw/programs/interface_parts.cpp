#include "isolaw/programs/interface_parts.hpp"

#include <stdexcept>

#include "isolaw/base/embedded.hpp"

namespace isolaw::programs {

std::span<Embedded const> interface_files();

std::string interface_part(std::string_view file, Marks marks) {
  std::string text(embedded_text(interface_files(), file));
  for (auto const& [mark, value] : marks) {
    auto const written = "@" + std::string(mark) + "@";
    auto at = text.find(written);
    if (at == std::string::npos) throw std::logic_error(std::string(file) + " has no mark " + written);
    for (; at != std::string::npos; at = text.find(written, at + value.size())) text.replace(at, written.size(), value);
  }
  if (text.find('@') != std::string::npos) throw std::logic_error(std::string(file) + " has a mark without a value");
  return text;
}

}  // namespace isolaw::programs
