// The input of rules: values of the counted cycles (data/cycles) of one block, and the design values to compare them
// with.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/data/properties/properties.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::rules {

double peak_to_peak(data::Cycle const& cycle, Quantity quantity);  // NaN for K_v

struct VerticalValue {  // the vertical stiffness that the device's compression test gives
  std::optional<double> K_v_kN_per_mm;
  std::string formula = "F_v/d_v";
  std::string reason = "no vertical test is given";  // why there is no value
};

struct BlockValues {
  int number = 0;  // number of the block in its record, from 1
  double amplitude_mm = 0.0;
  std::optional<double> frequency_Hz = {}, shear_strain_percent = {}, load_mean_kN = {};
  std::optional<std::pair<double, double>> sweep_Hz = {};  // first and last frequency of a sweep (data::Block)
  std::vector<data::Cycle> cycles = {};                    // the counted cycles, in order
  VerticalValue vertical = {};                             // K_v of the device, the same for every block

  data::Cycle const* find(int cycle) const;
};

struct Design {  // design values of the devices; all are positive
  std::optional<double> K_eff_kN_per_mm, damping_percent, energy_kN_mm, Q_d_kN, K_d_kN_per_mm, K_v_kN_per_mm;
  std::optional<double> disp_mm;       // displacement at which the design values hold
  std::optional<double> frequency_Hz;  // frequency at which the design values hold
  std::optional<double> load_kN;       // vertical load under which the design values hold

  std::optional<double> value(Quantity quantity) const;
};

struct DesignName {
  std::string_view name, unit;
  std::optional<double> Design::*member;
};
inline constexpr std::array<DesignName, 9> design_names{{{"K_eff", "kN/mm", &Design::K_eff_kN_per_mm},
                                                         {"damping", "%", &Design::damping_percent},
                                                         {"energy", "kN mm", &Design::energy_kN_mm},
                                                         {"Q_d", "kN", &Design::Q_d_kN},
                                                         {"K_d", "kN/mm", &Design::K_d_kN_per_mm},
                                                         {"K_v", "kN/mm", &Design::K_v_kN_per_mm},
                                                         {"disp", "mm", &Design::disp_mm},
                                                         {"frequency", "Hz", &Design::frequency_Hz},
                                                         {"load", "kN", &Design::load_kN}}};

// Parses "K_eff=1.2,damping=15,disp=150": K_eff, K_d, K_v in kN/mm, damping in percent, energy in kN mm, Q_d and load
// in kN, disp in mm, frequency in Hz. Throws Error for unknown or repeated names and for values that are not positive.
Design parse_design(std::string_view text);

enum class Side { both, positive, negative };  // both: peak to peak, or a quantity without sides
std::string_view name(Side side);              // "both", "positive", "negative"

// A value that a rule set asks for, computed from the cycles that the set names (RuleSet::cycles). Each side and each
// extreme over cycles has its own entry.
struct DerivedValue {
  std::string label;  // "K_eff, positive side"
  Side side = Side::both;
  std::string formula;               // "F+/d+, cycle 3"
  std::optional<double> value = {};  // nullopt if `reason` is not empty
  std::string reason;
};
std::vector<DerivedValue> derive(RuleSet const& rules, Quantity quantity, BlockValues const& block);
// A device's value for statistics over a lot: the mean over the cycles that the set names, and over both sides if the
// formula is per side. nullopt if one of these cycles is missing or the mean is not positive.
std::optional<double> device_value(RuleSet const& rules, Quantity quantity, BlockValues const& block);
// A sentence for each condition of the shear test that is unknown or is not as the set asks.
std::vector<std::string> unmet_conditions(RuleSet const& rules, BlockValues const& block, Design const& design);

}  // namespace isolaw::rules
