#include "isolaw/programs/exports.hpp"

#include <array>
#include <utility>

#include "isolaw/base/error.hpp"

namespace isolaw::programs {
namespace {

constexpr std::array<std::pair<std::string_view, Target>, 5> targets{{{"opensees", Target::opensees},
                                                                      {"openseespy", Target::openseespy},
                                                                      {"cpp", Target::cpp},
                                                                      {"json", Target::json},
                                                                      {"sheet", Target::sheet}}};

}  // namespace

Target parse_target(std::string_view text) {
  for (auto const& [name, target] : targets)
    if (name == text) return target;
  throw Error({.where = "--to", .found = std::string(text), .allowed = "opensees, openseespy, cpp, json, sheet"});
}

std::string exported(Subject const& subject, Target target, UnitSystem const& units) {
  if (target == Target::cpp) return cpp_header(subject, units);
  if (target == Target::sheet) return value_sheet(subject, units);
  auto const realisation = realise(subject);
  if (target == Target::json) return export_json(subject, realisation, units);
  if (realisation.forms.empty())
    throw Error({.where = "law " + std::string(subject.law->info.id),
                 .found = realisation.explanation,
                 .allowed = "a law that the program's materials can give",
                 .advice = "--to cpp, the law itself as a C++ header"});
  return target == Target::opensees ? opensees_script(subject, realisation, units)
                                    : openseespy_script(subject, realisation, units);
}

}  // namespace isolaw::programs
