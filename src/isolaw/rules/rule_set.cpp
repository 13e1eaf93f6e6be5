#include "isolaw/rules/rule_set.hpp"

#include <algorithm>
#include <cmath>

namespace isolaw::rules {

std::string_view name(Quantity quantity) {
  switch (quantity) {
    case Quantity::K_eff:
      return "K_eff";
    case Quantity::damping:
      return "damping";
    case Quantity::energy:
      return "energy";
    case Quantity::Q_d:
      return "Q_d";
    case Quantity::K_d:
      return "K_d";
    case Quantity::K_v:
      break;
  }
  return "K_v";
}

std::string_view unit(Quantity quantity) {
  switch (quantity) {
    case Quantity::damping:
      return "%";
    case Quantity::energy:
      return "kN mm";
    case Quantity::Q_d:
      return "kN";
    case Quantity::K_eff:
    case Quantity::K_d:
    case Quantity::K_v:
      break;
  }
  return "kN/mm";
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

int required_sample(SampleRule const& rule, int lot_size) {
  if (lot_size <= 0) return 0;
  // 2.2 % of 1500 are 33 and not 34, whatever the last bit of the product.
  double const share = rule.share_percent * lot_size / 100.0;
  int const rounded_up = static_cast<int>(std::ceil(share - 1e-9));
  return std::min(lot_size, std::max(rule.least, rounded_up));
}

}  // namespace isolaw::rules
