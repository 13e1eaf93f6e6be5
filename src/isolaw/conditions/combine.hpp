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
  double adjust = 1.0;  // f
  double margin = 1.0;  // of Form::sum
  double supply = 1.0;  // S, the factor of the scatter between devices that the rule set or the contract states
};

struct Combined {
  double factor = 1.0;
  std::optional<Interval> interval = {};
  double se = 0.0, df = 0.0;      // of ln factor, from the factors that tests show
  Status status = Status::shown;  // the weakest of its parts
  double share_shown = 0.0;       // part of the sum of |ln lambda| that is shown or interpolated
  std::vector<Effect> assumed = {}, not_covered = {}, without_interval = {};
  bool complete() const { return not_covered.empty(); }  // otherwise the factor is "at least" or "at most" this
};

// Factors that are not covered count as far as they are known, else as 1. Those that are assumed are constants without
// an interval. If a factor from tests has no interval, the combined factor has none. The degrees of freedom are those
// of Welch and Satterthwaite.
Combined combine(Combination const& how, std::span<Part const> parts);

}  // namespace isolaw::conditions
