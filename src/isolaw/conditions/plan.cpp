#include "isolaw/conditions/plan.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace isolaw::conditions {
namespace {

bool contains(std::vector<std::string> const& names, std::string const& name) {
  return std::ranges::find(names, name) != names.end();
}

bool can_reach(Candidate const& candidate, std::optional<Ageing> const& wanted) {
  if (!candidate.aged) return true;
  if (!candidate.has_reference) return false;
  constexpr double same_oven_C = 2.0;
  return wanted && wanted->days > candidate.aged->days && std::abs(wanted->at_C - candidate.aged->at_C) <= same_oven_C;
}

}  // namespace

std::vector<PlannedTest> plan(std::span<DesignEnd const> ends, std::vector<Candidate> candidates, int devices,
                              Condition const& reference, int reference_cycles) {
  auto const in_lot = candidates.size();
  for (int i = 1; i <= devices; ++i) candidates.push_back({.device = "new " + std::to_string(i), .was_new = true});
  std::vector<PlannedTest> planned;
  for (auto const& end : ends) {
    auto shown_on = static_cast<int>(end.shown_on.size());
    bool const of_rest = end.effect == Effect::scragging && end.rest_h;
    // Only the first test of a new device shows scragging itself, without recovery at rest.
    bool const of_first_test = end.effect == Effect::scragging && !of_rest;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      auto const& each = candidates[i];
      bool const is_possible = of_first_test ? i >= in_lot : !of_rest || each.was_new;
      if (is_possible && !contains(end.shown_on, each.device) && can_reach(each, end.condition.ageing))
        order.push_back(i);
    }
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
      auto const& each = candidates[i];
      return std::tuple(i >= in_lot, !each.has_reference, !contains(end.tested, each.device));
    });
    for (auto const i : order) {
      if (shown_on >= devices) break;
      auto& candidate = candidates[i];
      auto const add = [&](bool is_reference, bool shows) {
        if (shows) ++shown_on;
        PlannedTest test{.device = candidate.device,
                         .is_new = i >= in_lot,
                         .is_reference = is_reference,
                         .effect = end.effect,
                         .condition = is_reference ? reference : end.condition,
                         .cycles = is_reference && !of_first_test ? reference_cycles : end.cycles,
                         .rest_h = is_reference ? std::nullopt : end.rest_h,
                         .before = end.status,
                         .devices_before = end.devices};
        // The end of the design range keeps its status until a device shows this end. A reference test that is only
        // the basis of a later test does not show it.
        test.after = shown_on > 0 ? Status::shown : end.status;
        test.devices_after = shown_on > 0 ? shown_on : end.devices;
        planned.push_back(std::move(test));
      };
      bool const was_tested = contains(end.without_reference, candidate.device);
      bool const is_its_own_reference = end.effect == Effect::cycles || (of_rest && i < in_lot);
      bool const needs_reference = !candidate.has_reference && !is_its_own_reference;
      bool const reference_shows = of_first_test || was_tested;
      if (needs_reference) add(true, reference_shows);
      if (!reference_shows)
        add(false, true);
      else if (!needs_reference)
        ++shown_on;  // only a reference test was missing, and it is planned already for another effect
      candidate.has_reference = true;
    }
  }
  return planned;
}

}  // namespace isolaw::conditions
