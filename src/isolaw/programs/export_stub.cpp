#include "isolaw/programs/exports.hpp"
namespace isolaw::programs {
std::string cpp_header(Subject const&, UnitSystem const&) {
  return {};
}
std::string export_json(Subject const&, Realisation const&, UnitSystem const&) {
  return {};
}
std::string value_sheet(Subject const&, Realisation const&, UnitSystem const&) {
  return {};
}
}  // namespace isolaw::programs
