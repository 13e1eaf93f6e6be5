// Makes the bounds of a property from the factors of all effects. The rule set states the form in which the factors are
// combined, default factors, and limits on the bounds.
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

  CombinationMethod const& combination() const { return combination_; }

  // `shown` has a row for each effect that the tests or the design concern. Adds the effects that only the rule set
  // asks for. If no test covers an effect that [conditions] assumes, its row gets the rule set's default factors. If no
  // test covers any effect of the environment, one row with the default factors of the environment replaces the rows of
  // this group. `strength_share` is the share of Q_d / D in K_eff, with the amplitude D.
  std::vector<DesignRow> completed(std::vector<DesignRow> shown, rules::Quantity quantity, double strength_share) const;

  // nullopt without a verified rule that limits mean analyses, or if `bounds` has no row for K_eff or energy.
  std::optional<MeanProperties> mean_properties(std::vector<BoundRow> const& bounds) const;

  BoundRow bound(rules::Quantity quantity, std::vector<DesignRow> const& effects) const;

 private:
  std::optional<DesignRow> assumed(conditions::Effect effect, rules::Quantity quantity, double strength_share) const;
  conditions::Combined combined(rules::Quantity quantity, std::vector<DesignRow> const& effects, bool upper) const;

  rules::RuleSet const& rules_;
  campaign::StatedConditions const& stated_;
  CombinationMethod combination_;
};

}  // namespace isolaw::study
