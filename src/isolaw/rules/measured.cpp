#include "isolaw/rules/measured.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "isolaw/base/error.hpp"
#include "isolaw/base/number_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::rules {
namespace {

double stiffness(data::Cycle const& cycle, Side side) {
  if (side == Side::positive) return cycle.F_plus_kN / cycle.d_plus_mm;
  if (side == Side::negative) return cycle.F_minus_kN / cycle.d_minus_mm;
  return cycle.K_eff_kN_per_mm;
}

// Damping in percent; for one side E/(2 pi F d), with the energy E of the whole cycle. F and d have the side's sign.
double damping(data::Cycle const& cycle, Side side) {
  if (side == Side::both) return cycle.damping_percent;
  double const work = side == Side::positive ? cycle.F_plus_kN * cycle.d_plus_mm : cycle.F_minus_kN * cycle.d_minus_mm;
  return 100.0 * cycle.energy_kN_mm / (2.0 * std::numbers::pi * work);
}

double value_of(data::Cycle const& cycle, Quantity quantity, Side side) {
  if (quantity == Quantity::K_eff) return stiffness(cycle, side);
  if (quantity == Quantity::damping) return damping(cycle, side);
  return peak_to_peak(cycle, quantity);
}

bool is_per_side(RuleSet const& rules, Quantity quantity) {
  return (quantity == Quantity::K_eff && rules.stiffness_formula == Formula::per_side) ||
         (quantity == Quantity::damping && rules.damping_formula == Formula::per_side);
}

std::string formula_of(Quantity quantity, Side side) {
  std::string_view const sign = side == Side::positive ? "+" : "-";
  switch (quantity) {
    case Quantity::K_eff:
      return side == Side::both ? "(F+ - F-)/(d+ - d-)" : fmt::format("F{0}/d{0}", sign);
    case Quantity::damping:
      return side == Side::both ? "E/(2 pi K_eff D^2)" : fmt::format("E/(2 pi F{0} d{0})", sign);
    case Quantity::energy:
      return "integral of F dd";
    case Quantity::Q_d:
      return "(F(0+) - F(0-))/2";
    case Quantity::K_d:
      return "K_eff - Q_d/D";
    case Quantity::K_v:
      break;
  }
  return "";
}

std::string label_of(Quantity quantity, Side side) {
  auto label = std::string(name(quantity));
  if (side == Side::both) return label;
  return label + (side == Side::positive ? ", positive side" : ", negative side");
}

std::string cycles_text(CountingCycles const& cycles) {
  if (cycles.first == cycles.last) return fmt::format("cycle {}", cycles.first);
  return fmt::format("cycles {} to {}", cycles.first, cycles.last);
}

std::string missing_cycles(CountingCycles const& counting, BlockValues const& block) {
  for (int number = counting.first; number <= counting.last; ++number)
    if (block.find(number) == nullptr)
      return fmt::format("{} needed; block {} holds {} counted", cycles_text(counting), block.number,
                         block.cycles.size());
  return {};
}

struct Reduced {
  double mean = 0.0, lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
};

Reduced reduce(RuleSet const& rules, Quantity quantity, Side side, BlockValues const& block) {
  Reduced reduced;
  for (int number = rules.cycles.first; number <= rules.cycles.last; ++number) {
    double const value = value_of(*block.find(number), quantity, side);
    reduced.mean += value / (rules.cycles.last - rules.cycles.first + 1);
    reduced.lowest = std::min(reduced.lowest, value);
    reduced.highest = std::max(reduced.highest, value);
  }
  return reduced;
}

// Stores a positive value. For any other value, which arises if the motion misses one side or is no complete cycle, it
// stores the reason why there is none.
void set_value(DerivedValue& derived, double value) {
  if (std::isfinite(value) && value > 0.0)
    derived.value = value;
  else
    derived.reason = fmt::format("{} is {:.6g}, which is no positive number", derived.formula, value);
}

bool is_near(double value, double wanted, double tolerance_percent) {
  return std::abs(value - wanted) <= tolerance_percent / 100.0 * std::abs(wanted) * (1.0 + 1e-12);
}

bool is_near_any(double value, std::vector<double> const& wanted, double tolerance_percent) {
  return std::ranges::any_of(wanted, [&](double w) { return is_near(value, w, tolerance_percent); });
}

void take_design_value(std::string_view part, Design& design, std::vector<Complaint>& complaints) {
  constexpr std::string_view form =
      "K_eff=..., K_d=..., K_v=... in kN/mm, damping=... in percent, energy=... in kN mm, Q_d=..., load=... in kN, disp=... in mm, frequency=... in Hz";
  auto const equals = part.find('=');
  auto const key = trimmed(part.substr(0, equals));
  auto const* known = std::ranges::find(design_names, key, &DesignName::name);
  auto const complain = [&](std::string found, std::string_view allowed) {
    complaints.push_back({.where = "--design", .found = std::move(found), .allowed = std::string(allowed)});
  };
  if (equals == std::string_view::npos) return complain(fmt::format("{} has no '='", in_quotes(part)), form);
  if (known == design_names.end()) return complain(fmt::format("unknown design value {}", in_quotes(key)), form);
  auto const text = trimmed(part.substr(equals + 1));
  auto const value = number_in<double>(text);
  if (!value || !std::isfinite(*value) || !(*value > 0.0))
    return complain(fmt::format("{}={}", key, in_quotes(text)), "a positive number");
  if (design.*(known->member)) return complain(fmt::format("{} is given twice", key), "each design value once");
  design.*(known->member) = *value;
}

std::string sweep_of(BlockValues const& block) {
  return fmt::format("test frequency changes from {:.3g} to {:.3g} Hz within the test", block.sweep_Hz->first,
                     block.sweep_Hz->second);
}

}  // namespace

double peak_to_peak(data::Cycle const& cycle, Quantity quantity) {
  static constexpr std::array members{&data::Cycle::K_eff_kN_per_mm, &data::Cycle::damping_percent,
                                      &data::Cycle::energy_kN_mm, &data::Cycle::Q_d_kN, &data::Cycle::K_d_kN_per_mm};
  auto const place = static_cast<std::size_t>(quantity);
  return place < members.size() ? cycle.*members[place] : std::numeric_limits<double>::quiet_NaN();
}

data::Cycle const* BlockValues::find(int cycle) const {
  auto const found = std::ranges::find(cycles, cycle, &data::Cycle::number);
  return found == cycles.end() ? nullptr : &*found;
}

std::optional<double> Design::value(Quantity quantity) const {
  auto const* known = std::ranges::find(design_names, name(quantity), &DesignName::name);
  return known == design_names.end() ? std::nullopt : this->*(known->member);
}

Design parse_design(std::string_view text) {
  Design design;
  std::vector<Complaint> complaints;
  for (std::size_t at = 0; at <= text.size() && complaints.size() < design_names.size();) {
    auto const end = std::min(text.find(',', at), text.size());
    take_design_value(text.substr(at, end - at), design, complaints);
    at = end + 1;
  }
  if (!complaints.empty()) throw Error(complaints);
  return design;
}

std::string_view name(Side side) {
  return side == Side::both ? "both" : side == Side::positive ? "positive" : "negative";
}

std::vector<DerivedValue> derive(RuleSet const& rules, Quantity quantity, BlockValues const& block) {
  if (quantity == Quantity::K_v)
    return {{.label = "K_v",
             .formula = block.vertical.formula,
             .value = block.vertical.K_v_kN_per_mm,
             .reason = block.vertical.K_v_kN_per_mm ? "" : block.vertical.reason}};
  std::vector<Side> const sides =
      is_per_side(rules, quantity) ? std::vector{Side::positive, Side::negative} : std::vector{Side::both};
  auto const missing = missing_cycles(rules.cycles, block);
  std::vector<DerivedValue> values;
  for (auto const side : sides) {
    auto const label = label_of(quantity, side), formula = formula_of(quantity, side);
    auto const cycles = cycles_text(rules.cycles);
    auto const add = [&](std::string const& extreme, std::string const& how, double Reduced::*member) {
      values.push_back({.label = label + extreme,
                        .side = side,
                        .formula = fmt::format("{}, {}{}", formula, how, cycles),
                        .reason = missing});
      if (missing.empty()) set_value(values.back(), reduce(rules, quantity, side, block).*member);
    };
    if (rules.cycles.counting == Counting::each) {
      add(", lowest", "lowest of ", &Reduced::lowest);
      add(", highest", "highest of ", &Reduced::highest);
    } else {
      add("", rules.cycles.counting == Counting::mean ? "mean of " : "", &Reduced::mean);
    }
  }
  return values;
}

std::optional<double> device_value(RuleSet const& rules, Quantity quantity, BlockValues const& block) {
  if (quantity == Quantity::K_v) return block.vertical.K_v_kN_per_mm;
  if (!missing_cycles(rules.cycles, block).empty()) return std::nullopt;
  double const value = is_per_side(rules, quantity) ? 0.5 * (reduce(rules, quantity, Side::positive, block).mean +
                                                             reduce(rules, quantity, Side::negative, block).mean)
                                                    : reduce(rules, quantity, Side::both, block).mean;
  if (!std::isfinite(value) || value <= 0.0) return std::nullopt;
  return value;
}

std::vector<std::string> unmet_conditions(RuleSet const& rules, BlockValues const& block, Design const& design) {
  auto const& test = rules.test;
  std::vector<std::string> unmet;
  auto const note = [&](std::string text) { unmet.push_back(std::move(text)); };
  if (!test.frequencies_Hz.empty()) {
    double const tolerance = test.frequency_tolerance_percent.value_or(0.0);
    auto const asked = fmt::format("{:g} Hz within {:g} %", fmt::join(test.frequencies_Hz, " or "), tolerance);
    if (block.sweep_Hz)
      note(fmt::format("{}, {} asked for", sweep_of(block), asked));
    else if (!block.frequency_Hz)
      note(fmt::format("test frequency not known, {} asked for: give the time or the sampling interval", asked));
    else if (!is_near_any(*block.frequency_Hz, test.frequencies_Hz, tolerance))
      note(fmt::format("test frequency {:.4g} Hz, {} asked for", *block.frequency_Hz, asked));
  }
  if (design.frequency_Hz && block.sweep_Hz)
    note(fmt::format("{}, design values hold at {:.4g} Hz", sweep_of(block), *design.frequency_Hz));
  if (design.frequency_Hz && block.frequency_Hz && test.frequency_tolerance_percent &&
      !is_near(*block.frequency_Hz, *design.frequency_Hz, *test.frequency_tolerance_percent))
    note(fmt::format("test frequency {:.4g} Hz, design values hold at {:.4g} Hz", *block.frequency_Hz,
                     *design.frequency_Hz));
  if (!test.strains_percent.empty()) {
    double const tolerance = *test.strain_tolerance_percent;
    auto const asked = fmt::format("{:g} % within {:g} %", fmt::join(test.strains_percent, " or "), tolerance);
    if (!block.shear_strain_percent)
      note(fmt::format("shear strain not known, {} asked for: give the rubber thickness", asked));
    else if (!is_near_any(*block.shear_strain_percent, test.strains_percent, tolerance))
      note(fmt::format("shear strain {:.4g} %, {} asked for", *block.shear_strain_percent, asked));
  }
  if (test.displacement_tolerance_percent) {
    if (!design.disp_mm)
      note("displacement at which the design values hold not known: give disp=MM among the design values");
    else if (!is_near(block.amplitude_mm, *design.disp_mm, *test.displacement_tolerance_percent))
      note(fmt::format("amplitude {:.4g} mm, design values hold at {:.4g} mm within {:g} %", block.amplitude_mm,
                       *design.disp_mm, *test.displacement_tolerance_percent));
  }
  if (test.load_tolerance_percent) {
    if (!design.load_kN || !block.load_mean_kN)
      note(design.load_kN
               ? "vertical load of the test not known: its record needs a load channel"
               : "vertical load at which the design values hold not known: give load=KN among the design values");
    else if (!is_near(*block.load_mean_kN, *design.load_kN, *test.load_tolerance_percent))
      note(fmt::format("mean vertical load {} kN, design values hold under {} kN within {:g} %",
                       number_text(*block.load_mean_kN), number_text(*design.load_kN), *test.load_tolerance_percent));
  }
  return unmet;
}

}  // namespace isolaw::rules
