#include "isolaw/conditions/condition.hpp"

#include <cmath>

namespace isolaw::conditions {

bool agrees(std::optional<double> value, std::optional<double> reference, double percent) {
  if (!value || !reference) return !value && !reference;
  return std::abs(*value - *reference) <= percent / 100.0 * std::abs(*reference);
}

bool agrees(Ageing const& ageing, Ageing const& reference) {
  constexpr double days_percent = 1.0, at_C = 2.0;
  return agrees(ageing.days, reference.days, days_percent) && std::abs(ageing.at_C - reference.at_C) <= at_C;
}

bool agree_in(Effect effect, Condition const& test, Condition const& reference, Tolerance const& tolerance) {
  switch (effect) {
    case Effect::temperature:
      if (!test.temperature_C || !reference.temperature_C) return !test.temperature_C && !reference.temperature_C;
      return std::abs(*test.temperature_C - *reference.temperature_C) <= tolerance.temperature_C;
    case Effect::rate:
      return agrees(test.frequency_Hz, reference.frequency_Hz, tolerance.frequency_percent);
    case Effect::load:
      return agrees(test.load_kN, reference.load_kN, tolerance.load_percent);
    case Effect::ageing:
      if (!test.ageing || !reference.ageing) return !test.ageing && !reference.ageing;
      return agrees(*test.ageing, *reference.ageing);
    default:
      return true;
  }
}

std::vector<Effect> differences(Condition const& test, Condition const& reference, Tolerance const& tolerance) {
  std::vector<Effect> different;
  for (auto const effect : {Effect::temperature, Effect::rate, Effect::load, Effect::ageing})
    if (!agree_in(effect, test, reference, tolerance)) different.push_back(effect);
  return different;
}

}  // namespace isolaw::conditions
