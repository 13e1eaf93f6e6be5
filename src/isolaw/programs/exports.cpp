#include "isolaw/programs/exports.hpp"

#include <array>
#include <ranges>

#include "isolaw/base/error.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::programs {
namespace {

// Where the program's materials can give the law, or one near to it.
Realisation realised(Subject const& subject) {
  auto made = realise(subject);
  if (made.forms.empty())
    throw Error({.where = "law " + std::string(subject.law->info.id),
                 .found = made.explanation,
                 .allowed = "a law that the program's materials can give",
                 .advice = "--to cpp, the law itself as a C++ header"});
  return made;
}

constexpr std::array all{
    Target{"opensees",
           [](Subject const& s, UnitSystem const& units) { return opensees_script(s, realised(s), units); }},
    Target{"openseespy",
           [](Subject const& s, UnitSystem const& units) { return openseespy_script(s, realised(s), units); }},
    Target{"cpp", cpp_header},
    Target{"json", [](Subject const& s, UnitSystem const& units) { return export_json(s, realise(s), units); }},
    Target{"sheet", value_sheet},
    Target{"csv", protocol_csv}};

}  // namespace

std::span<Target const> targets() {
  return all;
}

Target const& find_target(std::string_view name) {
  for (auto const& target : all)
    if (target.name == name) return target;
  throw Error(
      {.where = "--to", .found = std::string(name), .allowed = joined(all | std::views::transform(&Target::name))});
}

}  // namespace isolaw::programs
