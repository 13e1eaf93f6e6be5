#include "isolaw/study/results.hpp"

namespace isolaw::study {

std::vector<std::string> headings(std::string_view heading, std::string_view unit, Value const& of_kind) {
  auto const name = std::string(heading);
  auto const in_unit = unit.empty() || unit == own_unit ? std::string() : " [" + std::string(unit) + "]";
  if (std::holds_alternative<Statistic>(of_kind))
    return {"mean " + name + in_unit, "std " + name + in_unit, "best " + name + in_unit};
  if (std::holds_alternative<Ends>(of_kind)) return {name + " lower" + in_unit, name + " upper" + in_unit};
  return {name + in_unit};
}

}  // namespace isolaw::study
