#include "isolaw/base/version.hpp"

namespace isolaw {

std::string_view version() {
  return ISOLAW_VERSION;
}

}  // namespace isolaw
