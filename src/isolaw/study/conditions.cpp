#include "isolaw/study/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "isolaw/conditions/curves.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/rules/rule_set.hpp"
#include "isolaw/study/conditions_bounds.hpp"
#include "isolaw/study/conditions_tests.hpp"

namespace isolaw::study {
namespace {

using conditions::Effect;
using conditions::Factor;
using rules::Quantity;

constexpr Effect of_tests[]{Effect::temperature, Effect::rate, Effect::load, Effect::ageing};
// The quantities that get bounds. Damping gets none, since it follows from stiffness and energy.
constexpr Quantity combined[]{Quantity::K_eff, Quantity::energy, Quantity::Q_d, Quantity::K_d};

class Builder {
 public:
  Builder(campaign::ObservedTests const& observed, std::string title, campaign::Acceptance const& acceptance)
      : stated_(observed.stated), rules_(rules_of(stated_, acceptance)), bounds_(rules_, stated_) {
    if (!acceptance.design.empty()) design_values_ = rules::parse_design(acceptance.design);
    out_.rules = rules_.id;
    out_.combination = bounds_.combination();
    out_.title = std::move(title);
    out_.stated = stated_;
    out_.installed = acceptance.lot_size;
    all_ = read_tests(observed, out_);
  }

  ConditionsResult operator()() {
    for (auto const quantity : rules::measured_quantities()) examine(quantity);
    out_.mean_properties = bounds_.mean_properties(out_.bounds);
    out_.dependence = judge_dependence(out_, rules_, design_values_);
    return std::move(out_);
  }

 private:
  static rules::RuleSet rules_of(campaign::StatedConditions const& stated, campaign::Acceptance const& acceptance) {
    if (!stated.rules.empty()) return rules::find_rule_set(stated.rules);
    if (!acceptance.rules.empty()) return rules::read_rule_text(acceptance.rules, acceptance.rules_file);
    return {};
  }

  double strength_share() const {  // share of Q_d / D in K_eff, with the amplitude D; mean over the reference tests
    std::vector<double> shares;
    for (auto const& test : out_.tests)
      if (test.role == TestRole::reference && test.K_eff_kN_per_mm && test.K_d_kN_per_mm)
        shares.push_back(1.0 - *test.K_d_kN_per_mm / *test.K_eff_kN_per_mm);
    return shares.empty() ? 0.0 : num::moments(shares).mean;
  }

  // The tests that show an effect, and the reference tests with which they are compared. If a device has reference
  // tests, all of its tests that are taken have the same history in the reference cycle. If its reference tests have
  // several histories, the one that most of its tests of the effect have is taken. Scaled specimens are taken only if
  // no device of full size shows the effect.
  struct Compared {
    std::vector<conditions::Sample> reference, others;
    std::vector<Observed const*> without_reference;  // tests in `others` of devices without a reference test
    bool is_scaled = false;
  };
  Compared compared(Quantity quantity, Effect effect) {
    auto const history = [&](Observed const& seen) {
      return history_of(seen, stated_.reference.first_cycle, out_.tolerance);
    };
    auto const differs_in_it = [&](Observed const& seen) { return seen.usable && seen.differs == std::vector{effect}; };
    Compared found;
    found.is_scaled = only_scaled(differs_in_it);
    auto const shows = [&](Observed const& seen) { return differs_in_it(seen) && seen.is_scaled == found.is_scaled; };
    auto const is_reference = [&](Observed const& seen) {
      return seen.usable && seen.differs.empty() && seen.is_scaled == found.is_scaled;
    };
    std::map<std::string, std::map<conditions::History, int>> tests;
    for (auto const& seen : all_)
      if (is_reference(seen)) tests[seen.block.device][*history(seen)] += 0;
    for (auto const& seen : all_)
      if (shows(seen) && tests[seen.block.device].contains(*history(seen))) ++tests[seen.block.device][*history(seen)];
    std::set<conditions::History> of_reference;  // the histories of the reference tests that are taken
    auto const leave_out = [&](Observed const& seen, TestRole why) {
      auto& row = out_.tests[*seen.test_index];
      row.role = why, row.effect.reset();
    };
    for (auto const& seen : all_) {
      if (differs_in_it(seen) && !shows(seen)) leave_out(seen, TestRole::scaled);
      if (!shows(seen) && !is_reference(seen)) continue;
      auto const& of_device = tests[seen.block.device];
      auto const most = std::ranges::max_element(of_device, {}, [](auto const& each) { return each.second; });
      auto const ln = ln_at_reference(seen.block, quantity, stated_);
      if (most == of_device.end() || most->first != *history(seen)) {
        if (!shows(seen)) continue;
        leave_out(seen, most == of_device.end() ? TestRole::unpaired : TestRole::other_history);
        if (most == of_device.end() && ln) found.without_reference.push_back(&seen);
        continue;
      }
      if (!shows(seen)) of_reference.insert(*history(seen));
      if (ln)
        (shows(seen) ? found.others : found.reference)
            .push_back({.device = seen.block.device, .condition = seen.block.condition, .ln = *ln});
    }
    std::erase_if(found.without_reference,
                  [&](Observed const* seen) { return !of_reference.contains(*history(*seen)); });
    for (auto const* seen : found.without_reference)
      found.others.push_back({.device = seen->block.device,
                              .condition = seen->block.condition,
                              .ln = *ln_at_reference(seen->block, quantity, stated_)});
    return found;
  }

  bool only_scaled(auto const& is_meant) const {
    auto const is_scaled = [&](bool scaled) {
      return std::ranges::any_of(all_,
                                 [&](Observed const& seen) { return is_meant(seen) && seen.is_scaled == scaled; });
    };
    return is_scaled(true) && !is_scaled(false);
  }

  // If no device with a reference test was tested at a level, the effect at this level is taken from the other devices.
  // Gives their tests at this level the role TestRole::effect.
  void mark_unpaired(Compared const& tests, conditions::Response const& response) {
    for (auto const* seen : tests.without_reference)
      for (auto const& level : response.levels())
        if (level.unpaired_factor && response.is_at(level, seen->block.condition)) {
          auto& row = out_.tests[*seen->test_index];
          row.role = TestRole::effect, row.effect = response.effect();
        }
  }

  static std::string level_text(Effect effect, conditions::Level const& level) {
    if (level.ageing) return fmt::format("{:.6g} days at {:.6g} C", level.ageing->days, level.ageing->at_C);
    char const* unit = effect == Effect::temperature ? "C" : effect == Effect::rate ? "Hz" : "kN";
    return fmt::format("{:.4g} {}", level.at, unit);
  }

  void examine(Quantity quantity) {
    std::vector<DesignRow> asked;
    auto const add = [&](Effect effect, Factor const& largest, Factor const& smallest) {
      asked.push_back({.quantity = quantity, .effect = effect, .max = largest, .min = smallest});
    };
    auto const& design = stated_.design;
    for (auto const effect : of_tests) {
      auto const tests = compared(quantity, effect);
      conditions::Response const response(effect, tests.reference, tests.others, stated_reference(stated_),
                                          out_.tolerance,
                                          tests.is_scaled ? conditions::Status::scaled : conditions::Status::shown);
      mark_unpaired(tests, response);
      for (auto const& level : response.levels()) {
        if (level.reference) continue;
        out_.levels.push_back({.quantity = quantity,
                               .effect = effect,
                               .level = level_text(effect, level),
                               .factor = response.factor_of(level),
                               .ratios = level.ratios,
                               .ageing = level.ageing});
      }
      add_curves(quantity, response);
      out_.responses.push_back({.quantity = quantity, .response = response});
      if (quantity == Quantity::K_eff && response.levels().size() > 1) {
        if (!response.drift()) out_.drift_not_checked.push_back(effect);
        if (!response.line_error() && effect != Effect::ageing) out_.straightness_not_checked.push_back(effect);
      }
      if (effect == Effect::ageing) {
        if (auto const factor = aged(response)) {
          Factor const none = as_reference();
          bool const larger = factor->ln > 0.0;
          bool const covered = factor->status != conditions::Status::not_covered;
          add(effect, larger || !covered ? *factor : none, larger && covered ? none : *factor);
        }
        continue;
      }
      auto const& range = effect == Effect::temperature ? design.temperature_C
                          : effect == Effect::rate      ? design.frequency_Hz
                                                        : design.load_kN;
      if (!range) continue;
      for (double const at : {range->low, range->high})
        out_.ends.push_back({.quantity = quantity, .effect = effect, .at = at, .factor = response.at(at)});
      auto const [largest, smallest] = response.over(range->low, range->high);
      add(effect, largest, smallest);
    }
    add_history(quantity, add);
    asked = bounds_.completed(std::move(asked), quantity, strength_share());
    out_.design.insert(out_.design.end(), asked.begin(), asked.end());
    if (!asked.empty() && std::ranges::find(combined, quantity) != std::end(combined))
      out_.bounds.push_back(bounds_.bound(quantity, asked)), add_value_at_reference(out_.bounds.back());
  }

  void add_value_at_reference(BoundRow& row) const {
    std::map<std::string, std::vector<double>> lns;  // for each device, ln of the values in its reference tests
    auto const is_reference = [](Observed const& seen) { return seen.usable && seen.differs.empty(); };
    bool const scaled = only_scaled(is_reference);
    for (auto const& seen : all_)
      if (is_reference(seen) && seen.is_scaled == scaled)
        if (auto const ln = ln_at_reference(seen.block, row.quantity, stated_)) lns[seen.block.device].push_back(*ln);
    std::vector<double> of_devices;
    for (auto const& [device, values] : lns) of_devices.push_back(num::moments(values).mean);
    if (of_devices.empty()) return;
    row.value_at_reference = std::exp(num::moments(of_devices).mean), row.devices = static_cast<int>(of_devices.size());
  }

  void add_curves(Quantity quantity, conditions::Response const& response) {
    auto const effect = response.effect();
    // Adds a curve with its points from the first to the last of the levels to which it is fitted.
    auto const add = [&](std::string parameter, double value, std::string unit, auto const& lambda_at) {
      CurveRow row{.quantity = quantity,
                   .effect = effect,
                   .parameter = std::move(parameter),
                   .value = value,
                   .unit = std::move(unit)};
      auto const fitted = response.paired_levels();
      constexpr int steps = 24;
      for (int i = 0; i <= steps; ++i) {
        row.at.push_back(std::lerp(fitted.front()->at, fitted.back()->at, static_cast<double>(i) / steps));
        row.lambda.push_back(lambda_at(row.at.back()));
      }
      out_.curves.push_back(std::move(row));
    };
    if (auto const b = conditions::exponent(response)) {
      double const from = std::ranges::find_if(response.levels(), &conditions::Level::reference)->at;
      if (effect == Effect::temperature)
        add("exponent", *b, "1/K", [&](double at) { return std::exp(*b * (at - from)); });
      else
        add("exponent", *b, "", [&](double at) { return std::pow(at / from, *b); });
    }
    if (effect != Effect::load || quantity != Quantity::K_d) return;
    if (auto const curve = conditions::load_curve(response))
      add("critical load", curve->critical_kN, "kN", [&](double at) { return curve->at(at); });
  }

  // The factor of ageing that the design asks for; empty if it asks for none.
  std::optional<Factor> aged(conditions::Response const& response) {
    auto const& design = stated_.design;
    if (design.aged) return response.at(conditions::Ageing{.days = design.aged->days, .at_C = design.aged->at_C});
    if (!design.years) return std::nullopt;
    if (!stated_.activation_energy_kJ_per_mol) return Factor::not_covered(conditions::Lack::no_energy);
    auto const* chosen = conditions::ageing_level_for(*design.years, response.levels(), *design.service_temperature_C,
                                                      *stated_.activation_energy_kJ_per_mol);
    if (chosen == nullptr) return Factor::not_covered(conditions::Lack::no_test);
    double const life = conditions::stands_for_years(*chosen->ageing, *design.service_temperature_C,
                                                     *stated_.activation_energy_kJ_per_mol);
    out_.ageing_stands_for_years = life, out_.ageing_test = chosen->ageing;
    return conditions::aged_factor(response.factor_of(*chosen), *design.years, life);
  }

  static Factor as_reference() { return {.se = 0.0, .df = 1.0}; }

  // Adds the effects of scragging, of the recovery at rest, and of the softening over many cycles.
  void add_history(Quantity quantity, auto const& add) {
    std::vector<conditions::ReferenceTest> first, again;
    // The value in cycle 1, and in the cycle that the design states, relative to the value in the reference cycle.
    std::vector<conditions::DeviceRatio> first_ratios, after_ratios;
    auto const is_reference = [](Observed const& seen) { return seen.usable && seen.differs.empty(); };
    bool const scaled = only_scaled(is_reference);
    for (auto const& seen : all_) {
      if (!is_reference(seen) || seen.is_scaled != scaled) continue;
      auto const reference = ln_at_reference(seen.block, quantity, stated_);
      auto const at = [&](int number) {
        auto const* cycle = seen.block.find(number);
        return cycle != nullptr ? cycle->ln(quantity) : std::nullopt;
      };
      if (!reference) continue;
      constexpr int settled = 3;
      if (auto const one = at(1), third = at(settled); one && third) {
        conditions::ReferenceTest const test{.device = seen.block.device,
                                             .ln_first = *one,
                                             .ln_third = *third,
                                             .ln_reference = *reference,
                                             .rest_h = seen.block.rest_h};
        auto const word = history_of(seen, 1, out_.tolerance);
        if (word == conditions::History::virgin) {
          first.push_back(test);
          std::vector<double> values;
          for (int n = 1; at(n); ++n) values.push_back(std::exp(*at(n)));
          if (auto const curve = conditions::softening(values)) {
            CurveRow row{.quantity = quantity,
                         .effect = Effect::cycles,
                         .parameter = "p",
                         .value = curve->p,
                         .unit = "",
                         .device = seen.block.device};
            constexpr double step = 0.25;
            for (double n = 1.0; n <= static_cast<double>(values.size()); n += step) {
              row.at.push_back(n);
              row.lambda.push_back(curve->at(n) / std::exp(*reference));
            }
            out_.curves.push_back(std::move(row));
          }
          first_ratios.push_back({.device = seen.block.device, .ln = *one - *reference});
        } else if (word == conditions::History::first_after_rest) {
          again.push_back(test);
        }
      }
      if (auto const many = stated_.design.cycles ? at(*stated_.design.cycles) : std::nullopt;
          many &&
          std::ranges::find(after_ratios, seen.block.device, &conditions::DeviceRatio::device) == after_ratios.end())
        after_ratios.push_back({.device = seen.block.device, .ln = *many - *reference});
    }
    if (!first.empty())
      out_.levels.push_back({.quantity = quantity,
                             .effect = Effect::scragging,
                             .level = "cycle 1, new",
                             .factor = conditions::scragging_factor(first),
                             .ratios = first_ratios});
    if (quantity == Quantity::K_eff)
      for (auto const& each : conditions::recovery(first, again))
        out_.recovery.push_back({.rest_h = each.rest_h, .share = each.share, .devices = each.devices}),
            recovered_.push_back(each);
    auto const add_one = [&](Effect effect, Factor factor) {
      if (scaled) factor.status = std::max(factor.status, conditions::Status::scaled);
      bool const covered = factor.status != conditions::Status::not_covered, larger = factor.ln > 0.0;
      add(effect, larger || !covered ? factor : as_reference(), larger && covered ? as_reference() : factor);
    };
    auto const& design = stated_.design;
    if (design.full_rest) add_one(Effect::scragging, conditions::scragging_factor(first));
    if (design.rest_h) {
      auto const share = conditions::recovery_after(recovered_, *design.rest_h);
      auto factor = share ? conditions::scragging_factor(first, share) : Factor::not_covered(conditions::Lack::no_rest);
      bool const is_tested =
          std::ranges::find(recovered_, *design.rest_h, &conditions::Recovered::rest_h) != recovered_.end();
      // No interval is given, because it would have to include the uncertainty of the recovery, which few devices show.
      factor.se = factor.df = std::nullopt;
      for (auto const& each : recovered_) factor.devices = std::min(factor.devices, each.devices);
      if (factor.status == conditions::Status::shown && !is_tested) factor.status = conditions::Status::interpolated;
      add_one(Effect::scragging, factor);
    }
    if (!design.cycles) return;
    std::vector<double> after;
    for (auto const& ratio : after_ratios) after.push_back(ratio.ln);
    auto const factor = conditions::mean_factor(after, conditions::Lack::no_cycle);
    if (!after.empty())
      out_.levels.push_back({.quantity = quantity,
                             .effect = Effect::cycles,
                             .level = fmt::format("cycle {}", *design.cycles),
                             .factor = factor,
                             .ratios = after_ratios});
    add_one(Effect::cycles, factor);
  }

  campaign::StatedConditions const& stated_;
  rules::RuleSet rules_;
  BoundMaker bounds_;
  rules::Design design_values_;
  std::vector<Observed> all_;
  std::vector<conditions::Recovered> recovered_;
  ConditionsResult out_;
};

}  // namespace

std::string_view status_word(Factor const& factor) {
  if (factor.status == conditions::Status::not_covered) return "NOT COVERED";
  if (factor.status == conditions::Status::assumed) return "ASSUMED";
  // No device was compared: this is the reference condition itself, with the factor 1.
  return factor.devices == 0 ? "reference" : name(factor.status);
}

ConditionsResult build_conditions(campaign::ObservedTests const& observed, std::string title,
                                  campaign::Acceptance const& acceptance) {
  auto result = Builder(observed, std::move(title), acceptance)();
  result.at_reference = values_at_reference(result);
  result.plan = plan_tests(result, usual_planned_devices);
  return result;
}

}  // namespace isolaw::study
