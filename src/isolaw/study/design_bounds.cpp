#include "isolaw/study/design_bounds.hpp"

#include <algorithm>
#include <ranges>
#include <string>
#include <vector>

#include "isolaw/base/words.hpp"
#include "isolaw/study/typical_device.hpp"

namespace isolaw::study {
namespace {

Finding none_because(std::string why) {
  return {.kind = FindingKind::no_bound_laws, .words = {{"because", std::move(why)}}};
}

BoundRow const* row_of(ConditionsResult const& conditions, rules::Quantity quantity) {
  auto const row = std::ranges::find(conditions.bounds, quantity, &BoundRow::quantity);
  return row == conditions.bounds.end() ? nullptr : &*row;
}

// Names of the effects (such as ageing) that no test and no stated value covers in at least one of the factors, each
// name once.
std::vector<std::string> not_covered(BoundRow const& K_eff, BoundRow const& energy) {
  std::vector<std::string> effects;
  for (auto const* combined : {&K_eff.max, &K_eff.min, &energy.max, &energy.min})
    for (auto const effect : combined->not_covered)
      if (std::string const name(rules::name(effect)); std::ranges::find(effects, name) == effects.end())
        effects.push_back(name);
  return effects;
}

std::optional<conditions::ReferenceBlock> reference_block(ConditionsResult const& conditions,
                                                          laws::LawEntry const& law) {
  conditions::ReferenceBlock block{.first_cycle = conditions.stated.reference.first_cycle,
                                   .last_cycle = conditions.stated.reference.last_cycle};
  int tests = 0, timed = 0;
  for (auto const& test : conditions.tests) {
    if (test.role != TestRole::reference) continue;
    block.amplitude_mm += test.amplitude_mm, ++tests;
    if (test.condition.frequency_Hz) block.frequency_Hz += *test.condition.frequency_Hz, ++timed;
  }
  if (tests == 0 || (timed == 0 && !law.info.traits.rate_independent)) return std::nullopt;
  block.amplitude_mm /= tests;
  block.frequency_Hz = timed == 0 ? 1.0 : block.frequency_Hz / timed;
  return block;
}

}  // namespace

DesignBounds design_bounds(Summary const& summary, laws::LawEntry const& law, std::span<double const> parameters) {
  if (!summary.conditions)
    return {.obstacle = none_because(summary.no_conditions.empty() ? "no-table" : summary.no_conditions)};
  auto const& conditions = *summary.conditions;
  auto const *K_eff = row_of(conditions, rules::Quantity::K_eff), *energy = row_of(conditions, rules::Quantity::energy);
  if (K_eff == nullptr || energy == nullptr) return {.obstacle = none_because("no-design")};
  if (auto const effects = not_covered(*K_eff, *energy); !effects.empty()) {
    auto none = none_because("not-covered");
    none.words.push_back({"effects", joined(effects)});
    return {.obstacle = std::move(none)};
  }
  auto const block = reference_block(conditions, law);
  if (!block) return {.obstacle = none_because("no-frequency")};
  auto const bound = [&](conditions::Combined const& stiffness,
                         conditions::Combined const& work) -> std::optional<DesignBound> {
    auto found = conditions::bound_law(law, parameters, *block, stiffness.factor, work.factor);
    if (!found) return std::nullopt;
    return DesignBound{.C_K = stiffness.factor,
                       .C_E = work.factor,
                       .status = std::max(stiffness.status, work.status),
                       .share_shown = std::min(stiffness.share_shown, work.share_shown),
                       .law = std::move(*found)};
  };
  DesignBounds bounds{.lower = bound(K_eff->min, energy->min), .upper = bound(K_eff->max, energy->max)};
  if (bounds.lower && bounds.upper) return bounds;
  auto none = none_because("no-loop");
  none.numbers.push_back({"amplitude_mm", block->amplitude_mm});
  return {.obstacle = std::move(none)};
}

Finding about_bound(std::string_view which, DesignBound const& bound) {
  auto const& law = bound.law;
  Finding finding{.kind = FindingKind::bound_law,
                  .numbers = {{"K_eff_factor", bound.C_K},
                              {"energy_factor", bound.C_E},
                              {"share_shown", bound.share_shown},
                              {"elastic_factor", law.factors.a},
                              {"hysteretic_factor", law.factors.b}},
                  .words = {{"which", std::string(which)}, {"status", std::string(conditions::name(bound.status))}}};
  finding.words.push_back({"made", law.one_factor ? "whole" : "parts"});
  if (!law.one_factor) return finding;
  finding.words.push_back({"since", std::string(name(*law.one_factor))});
  finding.numbers.push_back({"energy_off_percent", law.energy_off_percent});
  return finding;
}

std::vector<LawBounds> law_bounds(Summary const& summary) {
  std::vector<LawBounds> all;
  auto const typical = typical_device(summary);
  for (auto const& law : summary.laws) {
    LawBounds of{.law = law.id};
    std::vector<double> parameters;
    if (law.lot) {
      parameters = law.lot->parameters;
    } else if (typical) {
      of.device = summary.devices[*typical].name;
      auto const fit = std::ranges::find(law.devices, of.device, &DeviceFit::device);
      if (fit == law.devices.end() || !fit->objective.best) continue;
      for (auto const& parameter : fit->parameters) parameters.push_back(parameter.value.best.value_or(0.0));
    } else {
      continue;
    }
    auto const& entry = laws::find_law(law.id);
    of.bounds = design_bounds(summary, entry, parameters);
    if (!of.bounds.obstacle) {
      auto const block = *reference_block(*summary.conditions, entry);
      of.reference = conditions::cycle_of(entry, parameters, block);
      of.lower_kN = conditions::cycle_of(entry, of.bounds.lower->law.parameters, block).force_kN;
      of.upper_kN = conditions::cycle_of(entry, of.bounds.upper->law.parameters, block).force_kN;
    }
    all.push_back(std::move(of));
  }
  return all;
}

}  // namespace isolaw::study
