#include "law.hpp"

#include <cmath>
#include <string_view>
#include <utility>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::opensees {

Law::Law(IsolawLaw const& given)
    : id(given.id),
      length_to_law(given.length_to_law),
      force_from_law(given.force_from_law),
      lower(given.lower),
      upper(given.upper),
      depends_on_velocity(!laws::find_law(given.id).info.traits.rate_independent) {}

double Law::factor_of(ParameterKind parameter, double value) const {
  if (parameter == ParameterKind::factor) return value;
  return 1.0 + value * ((parameter == ParameterKind::lower ? lower : upper) - 1.0);
}

double Law::value_of(ParameterKind parameter, double factor) const {
  if (parameter == ParameterKind::factor) return factor;
  double const of_bound = factor_of(parameter, 1.0) - 1.0;
  return of_bound != 0.0 && std::isfinite(of_bound) ? (factor - 1.0) / of_bound : 0.0;
}

int set_parameter(Program const& program, Law const& law, double factor, void* movable, char const** words, int count,
                  void* parameter) {
  constexpr std::pair<std::string_view, ParameterKind> names[]{
      {"factor", ParameterKind::factor}, {"lower", ParameterKind::lower}, {"upper", ParameterKind::upper}};
  for (auto const& [name, kind] : names)
    if (count > 0 && words[0] == name) {
      program.calls().set_parameter_value(parameter, law.value_of(kind, factor));
      return program.calls().add_to_parameter(parameter, static_cast<int>(kind), movable);
    }
  return -1;
}

}  // namespace isolaw::opensees
