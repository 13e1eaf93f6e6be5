#include "isolaw/study/conditions_plan.hpp"

#include <algorithm>

#include "isolaw/study/conditions.hpp"

namespace isolaw::study {
namespace {

using conditions::Ageing;
using conditions::Condition;
using conditions::DesignEnd;
using conditions::Effect;
using conditions::Factor;
using conditions::History;
using conditions::Status;

class Planner {
 public:
  explicit Planner(ConditionsResult const& result) : result_(result), design_(result.stated.design) {}

  ConditionsPlan operator()(int devices) {
    ConditionsPlan all{.devices = devices};
    for (auto const effect : rules::effects())
      if (auto const why = add_ends(effect); why && is_asked(effect)) all.unplanned.push_back({effect, *why});
    std::vector<conditions::Candidate> candidates;
    for (auto const& device : result_.devices)
      // If a device was stretched too far, a new test of it cannot be compared with its earlier tests.
      if (device.is_compared && !device.is_scaled && history_of_next(device) != History::disturbed)
        candidates.push_back({.device = device.name,
                              .has_reference = has_reference(device),
                              .was_new = was_new(device),
                              .aged = device.aged});
    all.tests = conditions::plan(ends_, std::move(candidates), devices, result_.reference, least_cycles());
    return all;
  }

 private:
  bool is_asked(Effect effect) const {
    return std::ranges::any_of(result_.design, [&](DesignRow const& row) { return row.effect == effect; });
  }
  bool is_assumed(Effect effect) const {
    return std::ranges::any_of(result_.design, [&](DesignRow const& row) {
      return row.effect == effect && (row.max.status == Status::assumed || row.min.status == Status::assumed);
    });
  }

  int least_cycles() const { return result_.stated.reference.last_cycle; }

  // The history of the first reference cycle in a new test of the device, after a rest of an hour or more.
  History history_of_next(ConditionsDevice const& device) const {
    return conditions::history(result_.reference.strain_percent.value_or(0.0), device.largest_percent,
                               result_.stated.reference.first_cycle, std::nullopt, result_.tolerance);
  }
  bool has_reference(ConditionsDevice const& device) const {
    return std::ranges::any_of(result_.tests, [&](ConditionsTest const& test) {
      return test.device == device.name && test.role == TestRole::reference && test.history == history_of_next(device);
    });
  }
  static bool begins(ConditionsTest const& test, History history) {
    return test.role == TestRole::reference && !test.cycles.empty() && test.cycles.front().number == 1 &&
           test.cycles.front().history == history;
  }
  bool was_new(ConditionsDevice const& device) const {
    return std::ranges::any_of(result_.tests, [&](ConditionsTest const& test) {
      return test.device == device.name && begins(test, History::virgin);
    });
  }

  conditions::Response const& response_to(Effect effect) const {
    return std::ranges::find_if(result_.responses,
                                [&](EffectResponse const& each) {
                                  return each.quantity == rules::Quantity::K_eff && each.response.effect() == effect;
                                })
        ->response;
  }
  std::vector<std::string> devices_of_level(Effect effect) const {
    std::vector<std::string> names;
    for (auto const& row : result_.levels)
      if (row.quantity == rules::Quantity::K_eff && row.effect == effect)
        for (auto const& ratio : row.ratios) names.push_back(ratio.device);
    return names;
  }

  // Adds the ends of the design's range of this effect, or returns why there are none.
  std::optional<NoPlan> add_ends(Effect effect) {
    auto const& reference = result_.stated.reference;
    switch (effect) {
      case Effect::temperature:
        return add_range(effect, design_.temperature_C, true, &Condition::temperature_C);
      case Effect::rate:
        return add_range(effect, design_.frequency_Hz, reference.frequency_Hz.has_value(), &Condition::frequency_Hz);
      case Effect::load:
        return add_range(effect, design_.load_kN, reference.load_kN.has_value(), &Condition::load_kN);
      case Effect::ageing:
        return add_ageing();
      case Effect::scragging: {
        if (!design_.full_rest && !design_.rest_h) return NoPlan::no_condition;
        DesignEnd end{.effect = effect,
                      .condition = result_.reference,
                      .cycles = std::max(3, least_cycles()),
                      .rest_h = design_.rest_h};
        end.shown_on = devices_of_level(effect);
        if (design_.rest_h)
          std::erase_if(end.shown_on, [&](std::string const& device) { return !was_tested_after(device); });
        add(std::move(end), now(effect));
        return std::nullopt;
      }
      case Effect::cycles: {
        if (!design_.cycles) return NoPlan::no_condition;
        DesignEnd end{.effect = effect, .condition = result_.reference, .cycles = *design_.cycles};
        end.shown_on = devices_of_level(effect);
        add(std::move(end), now(effect));
        return std::nullopt;
      }
      case Effect::contamination:
      case Effect::environment:
        break;
    }
    return NoPlan::no_such_test;
  }

  std::optional<NoPlan> add_range(Effect effect, std::optional<campaign::ConditionRange> const& range, bool is_stated,
                                  std::optional<double> Condition::*member) {
    if (!range) return NoPlan::no_condition;
    if (!is_stated) return NoPlan::no_reference;
    auto condition = result_.reference;
    condition.*member = range->low;
    add_condition(effect, condition, response_to(effect).at(range->low));
    if (range->high == range->low) return std::nullopt;
    condition.*member = range->high;
    add_condition(effect, condition, response_to(effect).at(range->high));
    return std::nullopt;
  }

  std::optional<NoPlan> add_ageing() {
    auto condition = result_.reference;
    if (design_.aged) {
      condition.ageing = Ageing{.days = design_.aged->days, .at_C = design_.aged->at_C};
    } else if (design_.years) {
      auto const energy = result_.stated.activation_energy_kJ_per_mol;
      if (!energy) return NoPlan::no_energy;
      double const years = *design_.years, service_C = *design_.service_temperature_C;
      auto const* level = conditions::ageing_level_for(years, response_to(Effect::ageing).levels(), service_C, *energy);
      if (level == nullptr) return NoPlan::no_oven;
      bool const is_long = conditions::stands_for_years(*level->ageing, service_C, *energy) >= years;
      condition.ageing =
          is_long ? *level->ageing : conditions::ageing_for(years, level->ageing->at_C, service_C, *energy);
    } else {
      return NoPlan::no_condition;
    }
    add_condition(Effect::ageing, condition, now(Effect::ageing));
    return std::nullopt;
  }

  void add_condition(Effect effect, Condition const& condition, Factor const& now) {
    if (conditions::agree_in(effect, condition, result_.reference, result_.tolerance)) return;
    auto const& response = response_to(effect);
    DesignEnd end{.effect = effect, .condition = condition, .cycles = least_cycles()};
    if (auto const* level = response.paired_level_at(condition);
        level != nullptr && response.factor_of(*level).status == Status::shown)
      for (auto const& ratio : level->ratios) end.shown_on.push_back(ratio.device);
    for (auto const& test : result_.tests) {
      if (test.effect == effect) end.tested.push_back(test.device);
      auto const& own = *std::ranges::find(result_.devices, test.device, &ConditionsDevice::name);
      bool const is_like = test.role == TestRole::effect || test.role == TestRole::unpaired;
      if (is_like && !has_reference(own) && test.history == history_of_next(own) &&
          conditions::differences(test.condition, condition, result_.tolerance).empty())
        end.without_reference.push_back(test.device);
    }
    add(std::move(end), now);
  }

  void add(DesignEnd end, Factor const& now) {
    end.status = is_assumed(end.effect) && end.shown_on.empty() ? Status::assumed : now.status;
    end.devices = end.status == Status::shown ? static_cast<int>(end.shown_on.size()) : now.devices;
    if (end.status == Status::assumed) end.devices = 0;
    ends_.push_back(std::move(end));
  }

  // The present factor of an effect on K_eff: the largest factor in the design range. If this is the factor 1 of the
  // reference itself, it is the smallest factor instead.
  Factor now(Effect effect) const {
    for (auto const& row : result_.design)
      if (row.quantity == rules::Quantity::K_eff && row.effect == effect)
        return row.max.devices == 0 && row.max.status == Status::shown ? row.min : row.max;
    return {.status = Status::not_covered};
  }

  bool was_tested_after(std::string const& device) const {
    return std::ranges::any_of(result_.tests, [&](ConditionsTest const& test) {
      return test.device == device && begins(test, History::first_after_rest) && test.rest_h == design_.rest_h;
    });
  }

  ConditionsResult const& result_;
  decltype(campaign::StatedConditions::design) const& design_;
  std::vector<DesignEnd> ends_;
};

}  // namespace

std::string_view name(NoPlan why) {
  switch (why) {
    case NoPlan::no_condition:
      return "not stated in the design";
    case NoPlan::no_reference:
      return "not stated in the reference";
    case NoPlan::no_energy:
      return "no activation energy";
    case NoPlan::no_oven:
      return "no ageing test";
    case NoPlan::no_such_test:
      return "no test shows it";
  }
  return "";
}

int ConditionsPlan::turn_assumed_into_shown() const {
  return static_cast<int>(std::ranges::count(tests, conditions::Status::assumed, &conditions::PlannedTest::before));
}

ConditionsPlan plan_tests(ConditionsResult const& result, int devices) {
  return Planner(result)(devices);
}

}  // namespace isolaw::study
