// Combines the factors of all effects into one factor on a property, by the formula of a rule set, with its interval.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "isolaw/conditions/contrast.hpp"

namespace isolaw::conditions {

using rules::Form;
using rules::Group;

struct Part {
  Effect effect = Effect::temperature;
  Group group = Group::environment;
  Factor factor;
};

struct Combination {
  Form form = Form::product;
  double adjust = 1.0;  // the number f in the formula of the form (rules/effects.hpp)
  double margin = 1.0;  // the number `margin` in the formula of Form::sum
  double supply = 1.0;  // S, the factor for the scatter between devices, stated by the rule set or the contract
};

struct Combined {
  double factor = 1.0;
  std::optional<Interval> interval = {};
  double se = 0.0, df = 0.0;      // standard error and degrees of freedom of ln(factor); only tested factors contribute
  Status status = Status::shown;  // the weakest status among the combined factors
  double share_shown = 0.0;       // share of the sum of |ln lambda| that comes from factors shown or interpolated
  std::vector<Effect> assumed = {}, not_covered = {}, without_interval = {};
  bool complete() const { return not_covered.empty(); }  // if false, reports say "at least" or "at most" this factor
};

// If a factor is not covered, its known part is used, or 1 if nothing is known. An assumed factor is a constant without
// uncertainty. If a factor from tests has no interval, or if one is not covered, the combined factor has no interval.
// The degrees of freedom are those of Welch and Satterthwaite.
Combined combine(Combination const& how, std::span<Part const> parts);

}  // namespace isolaw::conditions
