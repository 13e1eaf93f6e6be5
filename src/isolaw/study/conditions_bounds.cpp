#include "isolaw/study/conditions_bounds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"

namespace isolaw::study {
namespace {

using conditions::Effect;
using conditions::Factor;
using conditions::Status;
using rules::Quantity;

bool is_covered(DesignRow const& row) {
  return row.max.status != Status::not_covered && row.min.status != Status::not_covered;
}

// Returns the form that the rule set states. A set that states only property modification factors gets Form::asce, and
// any other set the product of all effects.
CombinationMethod how_combined(rules::RuleSet const& rules) {
  CombinationMethod how;
  if (auto const& stated = rules.combination)
    how = {.form = stated->form, .adjust = stated->adjust, .margin = stated->margin, .clause = stated->clause};
  else if (!rules.factors.properties.empty())
    how = {.form = conditions::Form::asce, .clause = rules.factors.clause};
  else
    return how;
  if (how.form == conditions::Form::asce) how.adjust = rules.factors.system_factor;
  how.rules = rules.id, how.verified = rules.verified();
  return how;
}

struct Defaults {
  double max = 1.0, min = 1.0;
  std::string clause = {};
};

std::optional<Defaults> stated_defaults(rules::RuleSet const& rules, Effect effect, Quantity quantity) {
  if (effect == Effect::environment) {
    auto const* of_set = rules.factors_of(quantity);
    if (of_set == nullptr || (of_set->environment_max == 1.0 && of_set->environment_min == 1.0)) return std::nullopt;
    return Defaults{.max = of_set->environment_max, .min = of_set->environment_min, .clause = rules.factors.clause};
  }
  auto const* rule = rules.default_of(effect, quantity);
  if (rule == nullptr) return std::nullopt;
  return Defaults{.max = rule->default_max, .min = rule->default_min, .clause = rule->clause};
}

// Returns the default factors of a quantity. If the set states none for K_eff or energy, they follow from those of K_d
// and Q_d: K_eff is K_d + Q_d/D, and the energy is proportional to Q_d.
std::optional<Defaults> defaults(rules::RuleSet const& rules, Effect effect, Quantity quantity, double strength_share) {
  if (auto own = stated_defaults(rules, effect, quantity)) return own;
  auto const stiffness = stated_defaults(rules, effect, Quantity::K_d),
             strength = stated_defaults(rules, effect, Quantity::Q_d);
  if (!stiffness || !strength) return std::nullopt;
  if (quantity == Quantity::energy) return strength;
  if (quantity != Quantity::K_eff) return std::nullopt;
  return Defaults{.max = std::lerp(stiffness->max, strength->max, strength_share),
                  .min = std::lerp(stiffness->min, strength->min, strength_share),
                  .clause = stiffness->clause};
}

}  // namespace

BoundMaker::BoundMaker(rules::RuleSet const& rules, campaign::StatedConditions const& stated)
    : rules_(rules), stated_(stated), combination_(how_combined(rules)) {
  std::vector<std::string> known;
  for (auto const effect : rules::effects())
    if (std::ranges::any_of(rules_.effects,
                            [&](rules::EffectRule const& rule) { return rule.effect == effect && rule.quantity; }))
      known.emplace_back(rules::name(effect));
  for (auto const& effect : stated_.assume)
    if (std::ranges::find(known, effect) == known.end())
      throw Error({.where = "assume in [conditions]",
                   .found = in_quotes(printable(effect)),
                   .allowed = rules_.id.empty() ? "no effect, because no rule set is named"
                              : known.empty()
                                  ? fmt::format("no effect, because the rule set {} has no default factors", rules_.id)
                                  : fmt::format("an effect with default factors in {}: {}", rules_.id, joined(known))});
}

std::optional<DesignRow> BoundMaker::assumed(Effect effect, Quantity quantity, double strength_share) const {
  auto const found = defaults(rules_, effect, quantity, strength_share);
  if (!found) return std::nullopt;
  auto const factor = [](double value) { return Factor{.ln = std::log(value), .status = Status::assumed}; };
  return DesignRow{.quantity = quantity,
                   .effect = effect,
                   .max = factor(found->max),
                   .min = factor(found->min),
                   .assumed = AssumedFrom{.rules = rules_.id, .clause = found->clause, .verified = rules_.verified()}};
}

std::vector<DesignRow> BoundMaker::completed(std::vector<DesignRow> rows, Quantity quantity,
                                             double strength_share) const {
  for (auto const effect : rules::effects()) {
    bool const is_asked = std::ranges::find(rules_.effects, effect, &rules::EffectRule::effect) != rules_.effects.end();
    if (!is_asked || std::ranges::find(rows, effect, &DesignRow::effect) != rows.end()) continue;
    auto const none =
        Factor::not_covered(effect == Effect::contamination ? conditions::Lack::no_test : conditions::Lack::no_design);
    rows.push_back({.quantity = quantity, .effect = effect, .max = none, .min = none});
  }
  for (auto& row : rows)
    if (!is_covered(row) && std::ranges::find(stated_.assume, rules::name(row.effect)) != stated_.assume.end())
      if (auto from_rules = assumed(row.effect, quantity, strength_share)) row = *from_rules;
  auto const is_of_environment = [&](DesignRow const& row) {
    return rules_.group_of(row.effect) == rules::Group::environment;
  };
  if (std::ranges::any_of(rows, [&](DesignRow const& row) { return is_of_environment(row) && is_covered(row); }))
    return rows;
  if (auto environment = assumed(Effect::environment, quantity, strength_share)) {
    std::erase_if(rows, is_of_environment);
    rows.push_back(std::move(*environment));
  }
  return rows;
}

conditions::Combined BoundMaker::combined(Quantity quantity, std::vector<DesignRow> const& effects, bool upper) const {
  conditions::Combination how{.form = combination_.form, .adjust = combination_.adjust, .margin = combination_.margin};
  if (auto const* supply = rules_.factors_of(quantity))
    how.supply = (upper ? supply->spec_max : supply->spec_min).value_or(1.0);
  std::vector<conditions::Part> parts;
  for (auto const& row : effects)
    parts.push_back({.effect = row.effect, .group = rules_.group_of(row.effect), .factor = upper ? row.max : row.min});
  auto all = combine(how, parts);
  if (how.form != conditions::Form::asce) return all;
  auto const& limits = rules_.factors;
  if (upper && limits.max_not_below) all.factor = std::max(all.factor, *limits.max_not_below);
  if (!upper && limits.min_not_above) all.factor = std::min(all.factor, *limits.min_not_above);
  return all;
}

BoundRow BoundMaker::bound(Quantity quantity, std::vector<DesignRow> const& effects) const {
  return {.quantity = quantity, .max = combined(quantity, effects, true), .min = combined(quantity, effects, false)};
}

std::optional<MeanProperties> BoundMaker::mean_properties(std::vector<BoundRow> const& bounds) const {
  if (!rules_.verified() || !rules_.mean_analysis) return std::nullopt;
  MeanProperties found{.rule = *rules_.mean_analysis};
  bool any = false, exceeds = false, is_open = false;
  for (auto const& row : bounds) {
    if (row.quantity != Quantity::K_eff && row.quantity != Quantity::energy) continue;
    any = true;
    for (auto const* side : {&row.max, &row.min}) {
      double const change_percent = 100.0 * (side->factor - 1.0);
      if (std::abs(change_percent) > std::abs(found.farthest_percent))
        found.quantity = row.quantity, found.farthest_percent = change_percent;
      // An effect that is not covered yet can only move a bound farther from 1, so it cannot undo an excess. Assumed
      // factors prove nothing: with them, the question stays open.
      if (side->assumed.empty() && std::abs(change_percent) > found.rule.within_percent) exceeds = true;
      if (!side->assumed.empty() || !side->complete()) is_open = true;
    }
  }
  if (!any) return std::nullopt;
  if (exceeds)
    found.permitted = false;
  else if (!is_open)
    found.permitted = true;
  return found;
}

}  // namespace isolaw::study
