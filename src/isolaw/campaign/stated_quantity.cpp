#include "isolaw/campaign/stated_quantity.hpp"

#include <algorithm>

#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::campaign {
namespace {

struct Stated {
  double value;
  std::string_view unit;
};

// Splits "23.5 °C" or "120,5 cm2" into number and unit. "1 234 mm" gives the unit "234 mm". The callers do not know
// this unit and therefore take no value.
std::optional<Stated> number_and_unit(std::string_view text) {
  auto const end = std::min(text.find_first_not_of("0123456789.,+-eE"), text.size());
  std::string number(text.substr(0, end));
  if (std::ranges::count(number, ',') == 1 && number.find('.') == std::string::npos) {
    auto const fraction = number.substr(number.find(',') + 1);
    bool const may_group = fraction.size() == 3 && fraction.find_first_not_of("0123456789") == std::string::npos;
    if (may_group) return std::nullopt;
    std::ranges::replace(number, ',', '.');
  }
  auto const value = number_in<double>(number);
  if (!value) return std::nullopt;
  return Stated{*value, trimmed(text.substr(end))};
}

std::optional<double> celsius_of(Stated const& q) {
  auto const unit = lower(q.unit);
  for (auto const* c : {"\xC2\xB0"
                        "c",
                        "c", "\xE2\x84\x83", "deg c", "degc", "\xC2\xB0 c", "grad c"})
    if (unit == c) return q.value;
  if (unit == "k") return q.value - 273.15;
  if (unit ==
          "\xC2\xB0"
          "f" ||
      unit == "f" || unit == "deg f")
    return (q.value - 32.0) / 1.8;
  return std::nullopt;
}

std::optional<double> millimetres_of(Stated const& q) {
  auto const unit = parse_unit(q.unit);
  return unit && unit->dimension == Dimension::length ? std::optional(q.value * unit->in_record_units) : std::nullopt;
}

std::optional<double> square_millimetres_of(Stated const& q) {
  for (std::string_view const mark : {"^2", "\xC2\xB2", "2"}) {
    if (!q.unit.ends_with(mark)) continue;
    auto const side = millimetres_of({1.0, q.unit.substr(0, q.unit.size() - mark.size())});
    return side ? std::optional(q.value * *side * *side) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> stated(std::string_view text, Measure measure) {
  auto const found = number_and_unit(text);
  if (!found) return std::nullopt;
  switch (measure) {
    case Measure::temperature_C:
      return celsius_of(*found);
    case Measure::length_mm:
      return millimetres_of(*found);
    case Measure::area_mm2:
      return square_millimetres_of(*found);
    case Measure::text:
      break;
  }
  return std::nullopt;
}

}  // namespace isolaw::campaign
