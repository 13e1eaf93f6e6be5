// The effects that change the properties of a device, as lot files, rule files and results name them, and the forms in
// which a standard combines their factors.
#pragma once

#include <span>
#include <string_view>

namespace isolaw::rules {

// An effect is a cause by which the properties of a device change. The first four are conditions of a test, scragging
// and cycles are its history. isolaw evaluates no test that shows contamination, so its factor can only be assumed. The
// environment stands for temperature, ageing and contamination together, as the factors of some standards do.
enum class Effect { temperature, rate, load, ageing, scragging, cycles, contamination, environment };
std::span<Effect const> effects();  // without the environment, which tests and lot files cannot name
std::string_view name(Effect effect);

enum class Group { environment, test, none };  // none: reports give the factor, but Form::asce does not use it
std::span<Group const> groups();
std::string_view name(Group group);
// The group of an effect if the rule set states no group for it: `environment` for temperature, ageing and
// contamination, `none` for load, `test` for the others.
Group usual_group(Effect effect);

// How the factors l of the effects make one factor. The formulas also use three numbers of the rule set:
// - S, the factor of the scatter between the devices of the supply: spec_min or spec_max, or 1 if the set states none.
// - f, the share of a factor's distance from 1 that counts. It is below 1 if the standard supposes that not all effects
//   are at their worst at the same time. It is the set's `adjust`, but for asce the `system_factor` of its factors.
// - margin, the number by which the sum of these distances is multiplied in the form sum: the set's `margin`.
enum class Form {
  asce,     // (1 + f (E - 1)) X S: E is the product of the environment's factors, X that of the tests' factors
  each,     // S times the product of (1 + f (l - 1))
  product,  // (1 + f (product of l - 1)) S
  sum,      // 1 + margin (sum of (l - 1)) + (S - 1)
};
std::span<Form const> forms();
std::string_view name(Form form);

}  // namespace isolaw::rules
