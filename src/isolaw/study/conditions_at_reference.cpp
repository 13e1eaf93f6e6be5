#include "isolaw/study/conditions_at_reference.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "isolaw/study/conditions.hpp"

namespace isolaw::study {
namespace {

using conditions::Effect;

// The records behind a factor: the tests at the levels that show it, and the reference tests that these were compared
// with.
std::vector<std::string> records_behind(ConditionsResult const& result, conditions::Response const& response,
                                        conditions::Condition const& condition) {
  std::set<std::string> records;
  std::set<std::pair<std::string, conditions::History>> compared;  // devices with the history of the reference cycle
  for (auto const& test : result.tests) {
    if (test.role != TestRole::effect || test.effect != response.effect()) continue;
    auto const levels = response.behind(test.device, condition);
    if (std::ranges::none_of(levels, [&](auto const* level) { return response.is_at(*level, test.condition); }))
      continue;
    records.insert(test.sha256);
    compared.emplace(test.device, *test.history);
  }
  for (auto const& test : result.tests)
    if (test.role == TestRole::reference && test.history && compared.contains({test.device, *test.history}))
      records.insert(test.sha256);
  return {records.begin(), records.end()};
}

// Why a test cannot be compared with reference tests at all; empty if it can.
std::string not_comparable(ConditionsResult const& result, ConditionsTest const& test) {
  switch (test.role) {
    case TestRole::other_strain:
    case TestRole::cycle_missing:
    case TestRole::other_history:
    case TestRole::other_device:
    case TestRole::scaled:
      return std::string(name(test.role));
    case TestRole::reference:
    case TestRole::effect:
    case TestRole::combined:
    case TestRole::unpaired:
      break;
  }
  bool const has_like = std::ranges::any_of(result.tests, [&](ConditionsTest const& other) {
    return other.role == TestRole::reference && other.history == test.history;
  });
  return has_like ? std::string() : std::string(name(TestRole::other_history));
}

AtReferenceRow row_of(ConditionsResult const& result, ConditionsTest const& test, rules::Quantity quantity,
                      std::optional<double> measured) {
  AtReferenceRow row{.device = test.device,
                     .test = test.test,
                     .block = test.block,
                     .condition = test.condition,
                     .quantity = quantity,
                     .measured = measured,
                     .not_comparable = not_comparable(result, test)};
  if (!row.not_comparable.empty() || !measured) return row;
  std::vector<conditions::Part> parts;
  auto const differs = conditions::differences(test.condition, result.reference, result.tolerance);
  for (auto const& [of, response] : result.responses) {
    if (of != quantity || std::ranges::find(differs, response.effect()) == differs.end()) continue;
    parts.push_back({.effect = response.effect(), .factor = response.paired_at(test.condition)});
    row.factors.push_back({.effect = response.effect(),
                           .factor = parts.back().factor,
                           .records = records_behind(result, response, test.condition)});
  }
  auto const converted = conditions::at_reference(std::log(*measured), parts);
  row.obstacle = converted.obstacle;
  if (!converted.ln) return row;
  row.at_reference = std::exp(*converted.ln);
  if (auto const half = converted.half_width)
    row.interval = {.low = std::exp(*converted.ln - *half), .high = std::exp(*converted.ln + *half)};
  return row;
}

}  // namespace

std::vector<AtReferenceRow> values_at_reference(ConditionsResult const& result) {
  std::vector<AtReferenceRow> rows;
  std::set<std::string> done;
  for (auto const& device : result.tests) {
    if (!device.is_acceptance || !done.insert(device.device).second) continue;
    std::vector<ConditionsTest const*> blocks;
    for (auto const& test : result.tests)
      if (test.is_acceptance && test.device == device.device) blocks.push_back(&test);
    auto const has_role = [](TestRole role) { return [role](auto const* block) { return block->role == role; }; };
    if (std::ranges::any_of(blocks, has_role(TestRole::reference))) continue;
    // Blocks of another strain get rows only if the test has no block of the reference strain.
    if (!std::ranges::all_of(blocks, has_role(TestRole::other_strain)))
      std::erase_if(blocks, has_role(TestRole::other_strain));
    for (auto const* block : blocks) {
      rows.push_back(row_of(result, *block, rules::Quantity::K_eff, block->K_eff_kN_per_mm));
      rows.push_back(row_of(result, *block, rules::Quantity::energy, block->energy_kN_mm));
      rows.push_back(row_of(result, *block, rules::Quantity::damping, block->damping_percent));
    }
  }
  return rows;
}

}  // namespace isolaw::study
