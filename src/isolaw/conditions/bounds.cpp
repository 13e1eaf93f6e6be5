#include "isolaw/conditions/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "isolaw/data/properties/properties.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::conditions {
namespace {

constexpr double within = 0.005;  // allowed difference from a target, relative to the target

Loop operator-(Loop const& left, Loop const& right) {
  return {left.K_eff_kN_per_mm - right.K_eff_kN_per_mm, left.energy_kN_mm - right.energy_kN_mm};
}

std::vector<double> changed(laws::LawEntry const& law, std::span<double const> parameters, LoopFactors const& by) {
  std::vector<double> values(parameters.begin(), parameters.end());
  law.with_factors(values, by.a, by.b);
  return values;
}

bool keeps_limits(laws::LawEntry const& law, std::span<double const> parameters) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    auto const& limits = law.parameters[i].physical;
    if (!(limits.lower <= parameters[i] && parameters[i] <= limits.upper)) return false;
  }
  return !law.unmet(parameters);
}

constexpr int samples = 400;  // in one cycle of the simulated block

data::FitRecord motion_of(ReferenceBlock const& block) {
  constexpr double two_pi = 2.0 * std::numbers::pi;
  data::FitRecord motion;
  for (int i = 0; i <= samples * block.last_cycle; ++i) {
    double const phase = two_pi * i / samples;
    motion.time_s.push_back(i / (samples * block.frequency_Hz));
    motion.disp_mm.push_back(i % (samples / 2) == 0 ? 0.0 : block.amplitude_mm * std::sin(phase));
    motion.vel_mm_s.push_back(block.amplitude_mm * two_pi * block.frequency_Hz * std::cos(phase));
  }
  return motion;
}

bool near(double value, double target) {
  return std::abs(value - target) <= within * std::abs(target);
}

}  // namespace

std::string_view name(OneFactor why) {
  switch (why) {
    case OneFactor::inseparable:
      return "inseparable";
    case OneFactor::not_positive:
      return "not-positive";
    case OneFactor::limits:
      return "limits";
    case OneFactor::not_reached:
      return "not-reached";
  }
  return "";
}

Loop loop_of(laws::LawEntry const& law, std::span<double const> parameters, ReferenceBlock const& block) {
  auto const motion = motion_of(block);
  auto const force_kN = fit::LawOnMotion(law, motion, laws::Integration::converged).force_kN(parameters);
  Loop mean;
  double const share = 1.0 / (block.last_cycle - block.first_cycle + 1);
  for (int number = block.first_cycle; number <= block.last_cycle; ++number) {
    data::Cycle cycle;
    cycle.first = samples * (number - 1), cycle.last = samples * number;
    cycle = data::properties_on(cycle, motion.disp_mm, force_kN);
    mean.K_eff_kN_per_mm += share * cycle.K_eff_kN_per_mm;
    mean.energy_kN_mm += share * cycle.energy_kN_mm;
  }
  return mean;
}

CycleCurve cycle_of(laws::LawEntry const& law, std::span<double const> parameters, ReferenceBlock const& block) {
  auto const motion = motion_of(block);
  auto const force_kN = fit::LawOnMotion(law, motion, laws::Integration::converged).force_kN(parameters);
  CycleCurve curve;
  constexpr int every = 2;
  for (int i = samples * (block.first_cycle - 1); i <= samples * block.first_cycle; i += every) {
    curve.disp_mm.push_back(motion.disp_mm[static_cast<std::size_t>(i)]);
    curve.force_kN.push_back(force_kN[static_cast<std::size_t>(i)]);
  }
  return curve;
}

LoopParts parts_of(laws::LawEntry const& law, std::span<double const> parameters, ReferenceBlock const& block) {
  auto const with = [&](double a, double b) { return loop_of(law, changed(law, parameters, {a, b}), block); };
  auto const whole = with(1.0, 1.0);
  return {.elastic = with(2.0, 1.0) - whole, .hysteretic = with(1.0, 2.0) - whole};
}

LoopFactors factors_for(LoopParts const& parts, Loop const& target) {
  auto const& [el, hy] = parts;
  double const determinant = el.K_eff_kN_per_mm * hy.energy_kN_mm - hy.K_eff_kN_per_mm * el.energy_kN_mm;
  return {.a = (target.K_eff_kN_per_mm * hy.energy_kN_mm - hy.K_eff_kN_per_mm * target.energy_kN_mm) / determinant,
          .b = (el.K_eff_kN_per_mm * target.energy_kN_mm - target.K_eff_kN_per_mm * el.energy_kN_mm) / determinant};
}

std::optional<BoundLaw> bound_law(laws::LawEntry const& law, std::span<double const> parameters,
                                  ReferenceBlock const& block, double C_K, double C_E) {
  auto const at_reference = loop_of(law, parameters, block);
  auto const sound = [](double value) { return value > 0.0 && std::isfinite(value); };
  constexpr double rounding = 1e-9;  // rounding may give an elastic law's loop an energy up to this share of `square`
  double const square = at_reference.K_eff_kN_per_mm * block.amplitude_mm * block.amplitude_mm;
  if (!sound(square) || !sound(at_reference.energy_kN_mm - rounding * square)) return std::nullopt;
  BoundLaw bound{.target = {C_K * at_reference.K_eff_kN_per_mm, C_E * at_reference.energy_kN_mm}};
  auto const take = [&](LoopFactors const& factors) {
    bound.factors = factors;
    bound.parameters = changed(law, parameters, factors);
    bound.reached = loop_of(law, bound.parameters, block);
  };
  auto const objection = [&]() -> std::optional<OneFactor> {
    if (law.one_factor) return OneFactor::inseparable;
    auto const factors = factors_for(parts_of(law, parameters, block), bound.target);
    if (!(sound(factors.a) && sound(factors.b))) return OneFactor::not_positive;
    take(factors);
    if (!keeps_limits(law, bound.parameters)) return OneFactor::limits;
    bool const reached = near(bound.reached.K_eff_kN_per_mm, bound.target.K_eff_kN_per_mm) &&
                         near(bound.reached.energy_kN_mm, bound.target.energy_kN_mm);
    return reached ? std::nullopt : std::optional(OneFactor::not_reached);
  };
  bound.one_factor = objection();
  if (bound.one_factor) {
    take({C_K, C_K});
    bound.energy_off_percent = 100.0 * (C_K / C_E - 1.0);
  }
  return bound;
}

}  // namespace isolaw::conditions
