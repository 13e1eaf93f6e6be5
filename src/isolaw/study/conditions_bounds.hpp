// How the factors of all effects make the bounds of a property: the form that the rule set states, its default factors,
// and the limits that it sets to the bounds.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/rules/rule_set.hpp"
#include "isolaw/study/conditions.hpp"

namespace isolaw::study {

class BoundMaker {
 public:
  // Throws Error if [conditions] assumes an effect for which the rule set has no default factors.
  BoundMaker(rules::RuleSet const& rules, campaign::StatedConditions const& stated);

  HowCombined const& how() const { return how_; }

  // `shown` has a row for each effect that the tests or the design concern. Adds the effects that only the rule set asks
  // for, and puts its default factors in place of effects that no test covers: those that [conditions] assumes, and the
  // factors of the environment if no test covers an effect of this group. `strength_share` is the part of K_eff that Q_d
  // gives.
  std::vector<DesignRow> completed(std::vector<DesignRow> shown, rules::Quantity quantity, double strength_share) const;

  // `bounds` has a row for K_eff and energy if the design has conditions.
  std::optional<MeanProperties> mean_properties(std::vector<BoundRow> const& bounds) const;

  BoundRow bound(rules::Quantity quantity, std::vector<DesignRow> const& effects) const;

 private:
  std::optional<DesignRow> assumed(conditions::Effect effect, rules::Quantity quantity, double strength_share) const;
  conditions::Combined combined(rules::Quantity quantity, std::vector<DesignRow> const& effects, bool upper) const;

  rules::RuleSet const& rules_;
  campaign::StatedConditions const& stated_;
  HowCombined how_;
};

}  // namespace isolaw::study
