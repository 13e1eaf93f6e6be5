// Turns the observed tests of a lot into rows of the results: each block with its condition, its values in the
// reference cycle, the history of its cycles and its role.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/conditions/observe.hpp"
#include "isolaw/study/conditions.hpp"

namespace isolaw::study {

struct Observed {  // a block with the history of its cycles
  conditions::Block block;
  double largest_before_percent = 0.0;
  // Index in ConditionsResult::tests; empty for a block that only belongs to the device's history.
  std::optional<std::size_t> test_index = {};
  std::vector<conditions::Effect> differs = {};  // the conditions in which the block differs from the reference
  bool usable = false;                           // the block has the reference strain and the reference cycles
  bool is_scaled = false;
};

// Fills the reference, the tolerance, the devices, the tests and the refused tests of `result`. Throws Error if no test
// agrees with the reference, or if the tests differ in a condition that the reference does not state.
std::vector<Observed> read_tests(campaign::ObservedTests const& observed, ConditionsResult& result);

// The reference as stated; a condition that is not stated is empty.
conditions::Condition stated_reference(campaign::StatedConditions const& stated);

// ln of the mean over the reference cycles; empty if one of them is missing or has no such value.
std::optional<double> ln_at_reference(conditions::Block const& block, rules::Quantity quantity,
                                      campaign::StatedConditions const& stated);

// The history of a cycle; nullopt if the block does not have this cycle, or if the block's strain is not known.
std::optional<conditions::History> history_of(Observed const& seen, int cycle, conditions::Tolerance const& tolerance);

}  // namespace isolaw::study
