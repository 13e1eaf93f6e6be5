#include "isolaw/study/results.hpp"

namespace isolaw::study {

std::string Heading::text() const {
  return unit.empty() ? title : title + " [" + unit + "]";
}

std::vector<Heading> headings(std::string_view heading, std::string_view unit, Value const& example) {
  auto const own = std::string(unit == own_unit ? "" : unit);
  auto const cell = [&](std::string const& before, std::string const& after) {
    return Heading{before + std::string(heading) + after, own};
  };
  if (std::holds_alternative<Statistic>(example)) return {cell("mean ", ""), cell("std ", ""), cell("best ", "")};
  if (std::holds_alternative<Ends>(example)) return {cell("", " lower"), cell("", " upper")};
  return {cell("", "")};
}

}  // namespace isolaw::study
