#include "isolaw/programs/exports.hpp"
namespace isolaw::programs {
std::string value_sheet(Subject const&, Realisation const&, UnitSystem const&) {
  return {};
}
}  // namespace isolaw::programs
