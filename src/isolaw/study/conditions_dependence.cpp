#include "isolaw/study/conditions_dependence.hpp"

#include <algorithm>
#include <cmath>

#include "isolaw/rules/measured.hpp"
#include "isolaw/study/conditions.hpp"

namespace isolaw::study {
namespace {

using conditions::DeviceDependence;
using conditions::Effect;
using rules::Verdict;

// Whether the reference tests are those that the set asks for: its cycles, strain, frequency, displacement and load.
// A design value that is not stated is taken from the reference.
bool are_as_asked(ConditionsResult const& result, rules::RuleSet const& rules, rules::Design design) {
  auto const& from = result.stated.reference;
  if (from.first_cycle != rules.cycles.first || from.last_cycle != rules.cycles.last) return false;
  auto const test = std::ranges::find(result.tests, TestRole::reference, &ConditionsTest::role);
  if (test == result.tests.end()) return false;
  auto const& at = test->condition;
  if (!design.disp_mm) design.disp_mm = test->amplitude_mm;
  if (!design.load_kN) design.load_kN = at.load_kN;
  return rules::unmet_conditions(rules,
                                 {.amplitude_mm = test->amplitude_mm,
                                  .frequency_Hz = at.frequency_Hz,
                                  .shear_strain_percent = from.disp_mm ? std::nullopt : at.strain_percent,
                                  .load_mean_kN = at.load_kN},
                                 design)
      .empty();
}

conditions::DesignConditions asked(ConditionsResult const& result, Effect effect) {
  auto const& design = result.stated.design;
  auto const& range = effect == Effect::temperature ? design.temperature_C
                      : effect == Effect::rate      ? design.frequency_Hz
                                                    : design.load_kN;
  conditions::DesignConditions conditions;
  if (effect != Effect::ageing) {
    if (range) conditions.ends = {range->low, range->high};
  } else if (design.aged) {
    conditions.ageing = conditions::AskedAgeing{.test = {.days = design.aged->days, .at_C = design.aged->at_C}};
  } else if (design.years && result.ageing_test) {
    conditions.ageing = conditions::AskedAgeing{.test = *result.ageing_test,
                                                .years = *design.years,
                                                .test_stands_for_years = result.ageing_stands_for_years.value_or(0.0)};
  }
  return conditions;
}

conditions::Response const* response_of(ConditionsResult const& result, Effect effect, rules::Quantity quantity) {
  auto const found = std::ranges::find_if(result.responses, [&](EffectResponse const& each) {
    return each.quantity == quantity && each.response.effect() == effect;
  });
  return found == result.responses.end() ? nullptr : &found->response;
}

// Judges the difference between the values of each device at the two ends of the design's range of loads.
DependenceRow load_variation(ConditionsResult const& result, rules::LoadVariation const& rule, bool verified,
                             bool as_asked) {
  DependenceRow row{.limit = {.effect = Effect::load,
                              .quantity = rules::Quantity::K_eff,
                              .within_percent = rule.largest_percent,
                              .clause = rule.clause},
                    .is_load_variation = true};
  auto const* response = response_of(result, Effect::load, rules::Quantity::K_eff);
  auto const& loads = result.stated.design.load_kN;
  if (response == nullptr || !loads) {
    row.devices.push_back({.reason = conditions::NotAssessed::no_condition});
    return row;
  }
  auto const at = [&](double load_kN) {
    auto limit = row.limit;
    limit.levels = {load_kN};
    return judge_dependence(limit, verified, *response, {}, as_asked);
  };
  // judge_dependence() leaves out an end that is the reference itself. The ratio at this end is 1.
  auto const low = at(loads->low), high = at(loads->high);
  for (auto const& device : high.empty() ? low : high) {
    DeviceDependence both{.device = device.device};
    double difference = 0.0;
    bool known = true;
    for (auto const* end : {&low, &high}) {
      auto const own = std::ranges::find(*end, device.device, &DeviceDependence::device);
      bool const is_reference = own == end->end();
      if (!is_reference && own->reason) both.reason = own->reason;
      if (!is_reference && own->ratio) both.ratio = own->ratio;
      known = known && (is_reference || own->ratio);
      difference = (is_reference ? 1.0 : own->ratio ? own->ratio->lambda() : 0.0) - difference;
    }
    if (!known) both.ratio.reset();
    if (both.ratio) {
      both.ratio->ln = std::log(1.0 + std::abs(difference));
      if (!both.reason)
        both.verdict = !verified ? Verdict::information
                       : rules::is_within(both.ratio->lambda(), 1.0, std::nullopt, rule.largest_percent)
                           ? Verdict::pass
                           : Verdict::fail;
    }
    row.devices.push_back(std::move(both));
  }
  return row;
}

}  // namespace

Verdict DependenceRow::verdict() const {
  for (auto const verdict : {Verdict::fail, Verdict::not_assessed, Verdict::information})
    if (std::ranges::any_of(devices, [&](DeviceDependence const& each) { return each.verdict == verdict; }))
      return verdict;
  return devices.empty() ? Verdict::not_assessed : Verdict::pass;
}

DeviceDependence const* DependenceRow::worst() const {
  DeviceDependence const* found = nullptr;
  for (auto const& each : devices)
    if (each.ratio && each.verdict != Verdict::not_assessed &&
        (found == nullptr || std::abs(each.ratio->ln) > std::abs(found->ratio->ln)))
      found = &each;
  return found;
}

std::vector<DependenceRow> judge_dependence(ConditionsResult const& result, rules::RuleSet const& rules,
                                            rules::Design const& design) {
  bool const as_asked = are_as_asked(result, rules, design);
  std::vector<DependenceRow> rows;
  for (auto const& limit : rules.dependence)
    if (auto const* response = response_of(result, limit.effect, limit.quantity))
      rows.push_back(
          {.limit = limit,
           .devices = judge_dependence(limit, rules.verified(), *response, asked(result, limit.effect), as_asked)});
  if (rules.load_variation) rows.push_back(load_variation(result, *rules.load_variation, rules.verified(), as_asked));
  // A limit that concerns only the reference condition is always met, so it gets no row.
  std::erase_if(rows, [](DependenceRow const& row) { return row.devices.empty(); });
  return rows;
}

bool dependence_failed(ConditionsResult const& result) {
  return std::ranges::any_of(result.dependence, [](auto const& row) { return row.verdict() == Verdict::fail; });
}

}  // namespace isolaw::study
