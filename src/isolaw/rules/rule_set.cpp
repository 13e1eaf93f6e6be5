#include "isolaw/rules/rule_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace isolaw::rules {

namespace {

struct Names {
  std::string_view name, unit;
};
constexpr std::array<Names, 6> names{
    {{"K_eff", "kN/mm"}, {"damping", "%"}, {"energy", "kN mm"}, {"Q_d", "kN"}, {"K_d", "kN/mm"}, {"K_v", "kN/mm"}}};

}  // namespace

std::string_view name(Quantity quantity) {
  return names.at(static_cast<std::size_t>(quantity)).name;
}

std::string_view unit(Quantity quantity) {
  return names.at(static_cast<std::size_t>(quantity)).unit;
}

std::vector<Quantity> const& measured_quantities() {
  static std::vector<Quantity> const all{Quantity::K_eff, Quantity::damping, Quantity::energy, Quantity::Q_d,
                                         Quantity::K_d};
  return all;
}

PropertyFactors const* RuleSet::factors_of(Quantity quantity) const {
  auto const found = std::ranges::find(factors.properties, quantity, &PropertyFactors::quantity);
  return found == factors.properties.end() ? nullptr : &*found;
}

Group RuleSet::group_of(Effect effect) const {
  for (auto const& rule : effects)
    if (rule.effect == effect && rule.group) return *rule.group;
  return usual_group(effect);
}

EffectRule const* RuleSet::default_of(Effect effect, Quantity quantity) const {
  auto const found = std::ranges::find_if(
      effects, [&](EffectRule const& rule) { return rule.effect == effect && rule.quantity == quantity; });
  return found == effects.end() ? nullptr : &*found;
}

int required_sample(SampleRule const& rule, int lot_size) {
  if (lot_size <= 0) return 0;
  // The 1e-9 keeps rounding from adding a device: 2.2 % of 1500 are 33 devices, not 34.
  double const tested = rule.share_percent * lot_size / 100.0;
  int const rounded_up = static_cast<int>(std::ceil(tested - 1e-9));
  return std::min(lot_size, std::max(rule.least, rounded_up));
}

}  // namespace isolaw::rules
