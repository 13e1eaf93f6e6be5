#include "isolaw/study/conditions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/conditions/curves.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::study {
namespace {

using conditions::Effect;
using conditions::Factor;
using rules::Quantity;

constexpr Effect of_tests[]{Effect::temperature, Effect::rate, Effect::load, Effect::ageing};
// Damping follows from stiffness and energy, so it is shown and not combined.
constexpr Quantity combined[]{Quantity::K_eff, Quantity::energy, Quantity::Q_d, Quantity::K_d};

conditions::CycleValues values_of(campaign::ObservedCycle const& cycle) {
  conditions::CycleValues values{.number = cycle.number};
  for (std::size_t i = 0; i < conditions::quantities; ++i) {
    auto const value = [&]() -> double {
      switch (rules::measured_quantities()[i]) {
        case Quantity::K_eff:
          return cycle.K_eff_kN_per_mm;
        case Quantity::damping:
          return cycle.damping_percent;
        case Quantity::energy:
          return cycle.energy_kN_mm;
        case Quantity::Q_d:
          return cycle.Q_d_kN;
        case Quantity::K_d:
          return cycle.K_d_kN_per_mm;
        case Quantity::K_v:
          break;
      }
      return 0.0;
    };
    values.values[i] = value();
  }
  return values;
}

struct Observed {  // a block with the history of its cycles
  conditions::Block block;
  double largest_before_percent = 0.0;
  std::optional<std::size_t> row =
      {};  // in ConditionsResult::tests; empty for a block that only belongs to the history
  std::vector<Effect> differs = {};
  bool usable = false;  // it has the reference strain and the reference cycles
  bool is_scaled = false;
};

class Builder {
 public:
  Builder(campaign::ObservedTests const& observed, std::string title, campaign::Acceptance const& acceptance)
      : observed_(observed), stated_(observed.stated) {
    if (!stated_.rules.empty())
      rules_ = rules::find_rule_set(stated_.rules);
    else if (!acceptance.rules.empty())
      rules_ = rules::read_rule_text(acceptance.rules, acceptance.rules_file);
    if (!acceptance.design.empty()) design_values_ = rules::parse_design(acceptance.design);
    out_.rules = rules_.id;
    take_combination();
    check_assumed();
    auto const& from = stated_.reference;
    reference_ = {.temperature_C = from.temperature_C,
                  .frequency_Hz = from.frequency_Hz,
                  .load_kN = from.load_kN,
                  .strain_percent = from.disp_mm ? from.disp_mm : from.strain_percent};
    auto const& within = stated_.tolerance;
    tolerance_ = {.temperature_C = within.temperature_C,
                  .frequency_percent = within.frequency_percent,
                  .load_percent = within.load_percent,
                  .strain_percent = within.strain_percent};
    out_.title = std::move(title);
    out_.stated = stated_;
    out_.installed = acceptance.lot_size;
  }

  ConditionsResult operator()() {
    auto const& tests = observed_.tests;
    for (auto first = tests.begin(); first != tests.end();) {
      auto const end = std::find_if(first, tests.end(), [&](auto const& test) { return test.device != first->device; });
      read({first, end});
      first = end;
    }
    if (out_.tests.empty())
      throw Error({.where = "conditions",
                   .found = "no test can be used" + (out_.refused.empty() ? "" : ": " + out_.refused.front().reason),
                   .allowed = "records of cyclic tests"});
    require_one_value();
    require_one_kind();
    auto const& first = out_.tests.front().condition;
    out_.reference = reference_, out_.tolerance = tolerance_;
    if (!reference_.frequency_Hz) out_.reference.frequency_Hz = first.frequency_Hz;
    if (!reference_.load_kN) out_.reference.load_kN = first.load_kN;
    if (!reference_.strain_percent) out_.reference.strain_percent = first.strain_percent;
    for (auto& seen : all_) judge(seen);
    if (std::ranges::none_of(all_, [](Observed const& seen) { return seen.usable && seen.differs.empty(); }))
      throw Error({.where = "conditions",
                   .found = "no test agrees with the reference in everything",
                   .allowed = "a reference under which some devices were tested",
                   .advice = "isolaw inspect FILE, which prints frequency, amplitude, load and cycles of a test"});
    for (auto const quantity : rules::measured_quantities()) examine(quantity);
    out_.dependence = judge_dependence(out_, rules_, design_values_);
    return std::move(out_);
  }

 private:
  // The form that the rule set states, that of its factors, or the product of all effects.
  void take_combination() {
    auto& how = out_.combined;
    if (auto const& stated = rules_.combination)
      how = {.form = stated->form, .adjust = stated->adjust, .margin = stated->margin, .clause = stated->clause};
    else if (!rules_.factors.properties.empty())
      how = {.form = conditions::Form::asce, .clause = rules_.factors.clause};
    else
      return;
    if (how.form == conditions::Form::asce) how.adjust = rules_.factors.system_factor;
    how.rules = rules_.id, how.verified = rules_.verified();
  }

  void check_assumed() const {
    std::vector<std::string> known;
    for (auto const effect : rules::effects())
      if (std::ranges::any_of(rules_.effects,
                              [&](rules::EffectRule const& rule) { return rule.effect == effect && rule.quantity; }))
        known.emplace_back(rules::name(effect));
    for (auto const& effect : stated_.assume)
      if (std::ranges::find(known, effect) == known.end())
        throw Error(
            {.where = "assume in [conditions]",
             .found = in_quotes(printable(effect)),
             .allowed = rules_.id.empty() ? "no effect, because no rule set is named"
                        : known.empty()
                            ? fmt::format("no effect, because the rule set {} has no default factors", rules_.id)
                            : fmt::format("an effect with default factors in {}: {}", rules_.id, joined(known))});
  }

  // The default factors of the rule set for an effect, if [conditions] assumes it. K_eff and energy follow from the
  // defaults of K_d and Q_d: K_eff is K_d + Q_d/D, and the energy is proportional to Q_d.
  std::optional<DesignRow> assumed(Effect effect, Quantity quantity) const {
    if (std::ranges::find(stated_.assume, rules::name(effect)) == stated_.assume.end()) return std::nullopt;
    auto const make = [&](double max, double min, std::string const& clause) {
      auto const factor = [](double value) {
        return Factor{.ln = std::log(value), .status = conditions::Status::assumed};
      };
      return DesignRow{.quantity = quantity,
                       .effect = effect,
                       .max = factor(max),
                       .min = factor(min),
                       .assumed = AssumedFrom{.rules = rules_.id, .clause = clause, .verified = rules_.verified()}};
    };
    if (auto const* own = rules_.default_of(effect, quantity))
      return make(own->default_max, own->default_min, own->clause);
    auto const *stiffness = rules_.default_of(effect, Quantity::K_d),
               *strength = rules_.default_of(effect, Quantity::Q_d);
    if (stiffness == nullptr || strength == nullptr) return std::nullopt;
    if (quantity == Quantity::energy) return make(strength->default_max, strength->default_min, strength->clause);
    if (quantity != Quantity::K_eff) return std::nullopt;
    auto const share = strength_share();
    return make(std::lerp(stiffness->default_max, strength->default_max, share),
                std::lerp(stiffness->default_min, strength->default_min, share), stiffness->clause);
  }

  double strength_share() const {  // the part of K_eff that Q_d gives, as a mean over the reference tests
    std::vector<double> shares;
    for (auto const& test : out_.tests)
      if (test.role == TestRole::reference && test.K_eff_kN_per_mm && test.K_d_kN_per_mm)
        shares.push_back(1.0 - *test.K_d_kN_per_mm / *test.K_eff_kN_per_mm);
    return shares.empty() ? 0.0 : num::moments(shares).mean;
  }

  void refuse(campaign::ObservedTest const& test, std::string why) {
    out_.refused.push_back({.device = test.device, .test = test.test, .reason = std::move(why)});
  }

  void read(std::span<campaign::ObservedTest const> of_device) {
    std::vector<Observed> own;
    for (auto const& test : of_device) {
      auto why = add_blocks(test, own);
      if (why.empty()) continue;
      refuse(test, std::move(why));
      // A test that cannot be read may have gone to any strain, so everything after it has an unknown history.
      auto const strain_percent = test.farthest_mm ? strain_of(test, *test.farthest_mm) : std::nullopt;
      own.push_back({.block = {.device = test.device,
                               .test = test.test,
                               .condition = {.strain_percent =
                                                 strain_percent.value_or(std::numeric_limits<double>::infinity())}}});
    }
    std::vector<conditions::Block> blocks;
    for (auto const& each : own) blocks.push_back(each.block);
    auto const before = conditions::largest_before(blocks);
    auto const& last = of_device.back();
    ConditionsDevice device{
        .name = last.device, .is_scaled = last.stated.is_scaled, .is_compared = is_compared(last.of_device)};
    if (auto const& aged = last.stated.aged) device.aged = conditions::Ageing{.days = aged->days, .at_C = aged->at_C};
    for (auto const& block : blocks)
      device.largest_percent = std::max(device.largest_percent, block.condition.strain_percent.value_or(0.0));
    out_.devices.push_back(std::move(device));
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i].largest_before_percent = before[i];
      if (own[i].row) add_history_words(own[i], out_.tests[*own[i].row]);
      all_.push_back(std::move(own[i]));
    }
  }

  // If the reference does not state a condition, all tests must agree in it.
  void require_one_value() const {
    auto const& reference = stated_.reference;
    auto const require = [&](bool is_stated, std::optional<double> conditions::Condition::*member, double percent,
                             std::string_view key) {
      if (is_stated) return;
      auto const& first = out_.tests.front();
      for (auto const& test : out_.tests)
        if (!conditions::agrees(test.condition.*member, first.condition.*member, percent))
          throw Error({.where = "reference in [conditions]",
                       .found = fmt::format("{} is not stated, and the tests differ in it: {:.4g} in {} of {}, {:.4g} "
                                            "in {} of {}",
                                            key, (first.condition.*member).value_or(0.0), printable(first.test),
                                            printable(first.device), (test.condition.*member).value_or(0.0),
                                            printable(test.test), printable(test.device)),
                       .allowed = fmt::format("{} in the reference, or tests that agree in it", key)});
    };
    auto const& within = stated_.tolerance;
    require(reference.frequency_Hz.has_value(), &conditions::Condition::frequency_Hz, within.frequency_percent,
            "frequency-Hz");
    require(reference.load_kN.has_value(), &conditions::Condition::load_kN, within.load_percent, "load-kN");
    require(reference.strain_percent || reference.disp_mm, &conditions::Condition::strain_percent,
            within.strain_percent, "strain-percent or disp-mm");
  }

  // Devices of several compounds or sizes are not compared, so the user says which ones are meant.
  void require_one_kind() const {
    for (auto const& option : campaign::compared_devices_table()) {
      if (!option.get(stated_.compared).is_null()) continue;
      std::vector<std::string> kinds;
      for (auto const& test : out_.tests) {
        auto const kind = option.get(test.of_device);
        auto text = kind.is_null() ? std::string("none") : kind.get<std::string>();
        if (std::ranges::find(kinds, text) == kinds.end()) kinds.push_back(std::move(text));
      }
      if (kinds.size() > 1)
        throw Error({.where = "[conditions]",
                     .found = fmt::format("devices with {} {}", option.option(), printable(joined(kinds))),
                     .allowed = fmt::format("devices of one {0}, or {0} in [conditions] to name those meant",
                                            option.option())});
    }
  }
  bool is_compared(campaign::StatedDevice const& device) const {
    return std::ranges::all_of(campaign::compared_devices_table(), [&](auto const& option) {
      auto const wanted = option.get(stated_.compared);
      return wanted.is_null() || wanted == option.get(device);
    });
  }

  // The strain in percent of the rubber's thickness, or the amplitude in mm if the reference is one. Empty if the
  // reference is a strain and the thickness is not known.
  std::optional<double> strain_of(campaign::ObservedTest const& test, double amplitude_mm) const {
    if (stated_.reference.disp_mm) return amplitude_mm;
    if (!test.rubber_thickness_mm) return stated_.reference.strain_percent ? std::nullopt : std::optional(amplitude_mm);
    return 100.0 * amplitude_mm / *test.rubber_thickness_mm;
  }

  // Adds the blocks of a test, or returns why the test cannot be used.
  std::string add_blocks(campaign::ObservedTest const& test, std::vector<Observed>& own) {
    if (!test.refusal.empty()) return test.refusal;
    if (!strain_of(test, 0.0))
      return "the reference is a strain, and the thickness of the rubber is not known: rubber-thickness-mm in the "
             "device's table, or disp-mm in the reference";
    if (!test.stated.temperature_C) return "no temperature is stated: temperature-C = 20";
    bool const is_of_one_condition = std::ranges::none_of(
        test.blocks, [](campaign::ObservedBlock const& block) { return !block.cycles.empty() && !block.frequency_Hz; });
    if (reference_.frequency_Hz && !is_of_one_condition)
      return "its frequency is not known, or it changes from cycle to cycle, and the reference states one";
    bool first = true, any = false;
    for (auto const& block : test.blocks) {
      auto const strain_percent = strain_of(test, block.amplitude_mm);
      if (block.cycles.empty()) {
        if (!block.fault.empty()) refuse(test, fmt::format("block {}: {}", block.number, block.fault));
        own.push_back(
            {.block = {.device = test.device, .test = test.test, .condition = {.strain_percent = strain_percent}}});
        first = false;
        continue;
      }
      std::vector<double> loads;
      for (auto const& cycle : block.cycles)
        if (cycle.load_kN) loads.push_back(*cycle.load_kN);
      auto const measured_load = loads.empty() ? std::nullopt : std::optional(num::moments(loads).mean);
      if (measured_load && test.stated.load_kN)
        return "load-kN is stated, and the record has a channel for the load; leave load-kN out";
      if (reference_.load_kN && !measured_load && !test.stated.load_kN)
        return "the vertical load is neither measured nor stated: load-kN = 2000";
      if (reference_.load_kN && measured_load && *measured_load < -0.05 * *reference_.load_kN)
        return fmt::format("the mean vertical load is {:.4g} kN: compression must be positive", *measured_load);
      auto const& aged = test.stated.aged;
      conditions::Condition const condition{
          .temperature_C = test.stated.temperature_C,
          .frequency_Hz = block.frequency_Hz,
          .load_kN = measured_load ? measured_load : test.stated.load_kN,
          .strain_percent = strain_percent,
          .ageing = aged ? std::optional(conditions::Ageing{.days = aged->days, .at_C = aged->at_C}) : std::nullopt};
      Observed seen{.block = {.device = test.device,
                              .test = test.test,
                              .order = *test.stated.order,
                              .number = block.number,
                              .condition = condition,
                              .rest_h = first ? test.stated.rest_h : 0.0},
                    .row = out_.tests.size(),
                    .is_scaled = test.stated.is_scaled};
      for (auto const& cycle : block.cycles) seen.block.cycles.push_back(values_of(cycle));
      out_.tests.push_back({.device = test.device,
                            .test = test.test,
                            .file = test.file,
                            .sha256 = test.sha256,
                            .of_device = test.of_device,
                            .temperature_of = test.stated.temperature_of,
                            .is_scaled = test.stated.is_scaled,
                            .is_acceptance = test.stated.is_acceptance,
                            .order = *test.stated.order,
                            .block = block.number,
                            .amplitude_mm = block.amplitude_mm,
                            .condition = condition,
                            .rest_h = seen.block.rest_h,
                            .loop_mm = block.loop_mm,
                            .loop_kN = block.loop_kN});
      add_values(test, seen.block, out_.tests.back());
      own.push_back(std::move(seen));
      first = false, any = true;
    }
    return any ? std::string() : "no cycle of it counts";
  }

  void add_values(campaign::ObservedTest const& test, conditions::Block const& block, ConditionsTest& row) const {
    auto const value = [&](Quantity quantity) -> std::optional<double> {
      auto const ln = ln_at_reference(block, quantity);
      return ln ? std::optional(std::exp(*ln)) : std::nullopt;
    };
    row.K_eff_kN_per_mm = value(Quantity::K_eff);
    row.damping_percent = value(Quantity::damping);
    row.energy_kN_mm = value(Quantity::energy);
    row.Q_d_kN = value(Quantity::Q_d);
    row.K_d_kN_per_mm = value(Quantity::K_d);
    row.conditioned_h = test.stated.conditioned_h;
    if (test.stated.temperature_of == "chamber" && test.rubber_thickness_mm &&
        !conditions::agree_in(Effect::temperature, block.condition, reference_, tolerance_))
      row.warming_h = conditions::warming_h(*test.rubber_thickness_mm);
    if (row.energy_kN_mm && test.rubber_area_mm2 && test.rubber_thickness_mm)
      row.heating_K = conditions::heating_K(*row.energy_kN_mm, stated_.heat_capacity_MJ_per_m3K, *test.rubber_area_mm2,
                                            *test.rubber_thickness_mm);
  }

  void add_history_words(Observed const& seen, ConditionsTest& row) const {
    row.history = history_of(seen, stated_.reference.first_cycle);
    for (auto const& cycle : seen.block.cycles) {
      auto const value = [&](Quantity quantity) -> std::optional<double> {
        auto const ln = cycle.ln(quantity);
        return ln ? std::optional(std::exp(*ln)) : std::nullopt;
      };
      row.cycles.push_back({.number = cycle.number,
                            .history = history_of(seen, cycle.number),
                            .K_eff_kN_per_mm = value(Quantity::K_eff),
                            .damping_percent = value(Quantity::damping),
                            .energy_kN_mm = value(Quantity::energy),
                            .Q_d_kN = value(Quantity::Q_d),
                            .K_d_kN_per_mm = value(Quantity::K_d)});
    }
  }

  // ln of the mean over the reference cycles; empty if one of them is missing or has no such value.
  std::optional<double> ln_at_reference(conditions::Block const& block, Quantity quantity) const {
    double sum = 0.0;
    auto const& [first, last] = std::pair(stated_.reference.first_cycle, stated_.reference.last_cycle);
    for (int number = first; number <= last; ++number) {
      auto const* cycle = block.find(number);
      auto const ln = cycle != nullptr ? cycle->ln(quantity) : std::nullopt;
      if (!ln) return std::nullopt;
      sum += std::exp(*ln);
    }
    return std::log(sum / (last - first + 1));
  }

  std::optional<conditions::History> history_of(Observed const& seen, int cycle) const {
    auto const& block = seen.block;
    if (block.find(cycle) == nullptr || !block.condition.strain_percent) return std::nullopt;
    return conditions::history(*block.condition.strain_percent, seen.largest_before_percent, cycle, block.rest_h,
                               tolerance_);
  }

  void judge(Observed& seen) {
    if (!seen.row) return;
    auto& row = out_.tests[*seen.row];
    auto const& condition = seen.block.condition;
    auto reference = reference_;
    // All tests agree in a condition that the reference does not state (require_one_value()).
    if (!reference.frequency_Hz) reference.frequency_Hz = condition.frequency_Hz;
    if (!reference.load_kN) reference.load_kN = condition.load_kN;
    if (!reference.strain_percent) reference.strain_percent = condition.strain_percent;
    seen.differs = conditions::differences(condition, reference, tolerance_);
    if (!is_compared(row.of_device)) {
      row.role = TestRole::other_device;
    } else if (!conditions::agrees(condition.strain_percent, reference.strain_percent, tolerance_.strain_percent)) {
      row.role = TestRole::other_strain;
    } else if (seen.block.find(stated_.reference.last_cycle) == nullptr) {
      row.role = TestRole::cycle_missing;
    } else if (seen.differs.size() > 1) {
      row.role = TestRole::combined;
    } else {
      seen.usable = true;
      if (seen.differs.empty()) return;
      row.role = TestRole::effect;
      row.effect = seen.differs.front();
    }
  }

  // The tests that show an effect, and the reference tests of the same devices. Of each device only tests are taken
  // whose reference cycle has one history: of the histories that a reference test has too, the one of most tests. Scaled
  // specimens are taken only if no device of full size shows the effect.
  struct Compared {
    std::vector<conditions::Sample> reference, others;
    std::vector<Observed const*> without_reference;  // tests in `others` of devices without a reference test
    bool is_scaled = false;
  };
  Compared compared(Quantity quantity, Effect effect) {
    auto const history = [&](Observed const& seen) { return history_of(seen, stated_.reference.first_cycle); };
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
      auto& row = out_.tests[*seen.row];
      row.role = why, row.effect.reset();
    };
    for (auto const& seen : all_) {
      if (differs_in_it(seen) && !shows(seen)) leave_out(seen, TestRole::scaled);
      if (!shows(seen) && !is_reference(seen)) continue;
      auto const& of_device = tests[seen.block.device];
      auto const most = std::ranges::max_element(of_device, {}, [](auto const& each) { return each.second; });
      auto const ln = ln_at_reference(seen.block, quantity);
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
                              .ln = *ln_at_reference(seen->block, quantity)});
    return found;
  }

  bool only_scaled(auto const& is_meant) const {
    auto const is_scaled = [&](bool scaled) {
      return std::ranges::any_of(all_,
                                 [&](Observed const& seen) { return is_meant(seen) && seen.is_scaled == scaled; });
    };
    return is_scaled(true) && !is_scaled(false);
  }

  // Tests of devices without a reference test show an effect where no device with one was tested.
  void mark_unpaired(Compared const& tests, conditions::Response const& response) {
    for (auto const* seen : tests.without_reference)
      for (auto const& level : response.levels())
        if (level.unpaired && response.is_at(level, seen->block.condition)) {
          auto& row = out_.tests[*seen->row];
          row.role = TestRole::effect, row.effect = response.effect();
        }
  }

  static std::string level_text(Effect effect, conditions::Level const& level) {
    if (level.ageing) return fmt::format("{:.6g} days at {:.6g} C", level.ageing->days, level.ageing->at_C);
    char const* unit = effect == Effect::temperature ? "C" : effect == Effect::rate ? "Hz" : "kN";
    return fmt::format("{:.6g} {}", level.at, unit);
  }

  void examine(Quantity quantity) {
    std::vector<conditions::Part> max, min;
    auto const add = [&](Effect effect, Factor const& largest, Factor const& smallest) {
      DesignRow row{.quantity = quantity, .effect = effect, .max = largest, .min = smallest};
      using conditions::Status;
      if (largest.status == Status::not_covered || smallest.status == Status::not_covered)
        if (auto const from_rules = assumed(effect, quantity)) row = *from_rules;
      max.push_back({.effect = effect, .group = rules_.group_of(effect), .factor = row.max});
      min.push_back({.effect = effect, .group = rules_.group_of(effect), .factor = row.min});
      out_.design.push_back(std::move(row));
    };
    auto const& design = stated_.design;
    for (auto const effect : of_tests) {
      auto const tests = compared(quantity, effect);
      conditions::Response const response(effect, tests.reference, tests.others, reference_, tolerance_,
                                          tests.is_scaled ? conditions::Status::scaled : conditions::Status::shown);
      mark_unpaired(tests, response);
      for (auto const& level : response.levels()) {
        if (level.reference) continue;
        out_.levels.push_back({.quantity = quantity,
                               .effect = effect,
                               .level = level_text(effect, level),
                               .factor = response.of(level),
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
    for (auto const effect : rules::effects()) {
      bool const is_asked =
          std::ranges::find(rules_.effects, effect, &rules::EffectRule::effect) != rules_.effects.end();
      if (!is_asked || std::ranges::find(max, effect, &conditions::Part::effect) != max.end()) continue;
      auto const none =
          Factor::without(effect == Effect::contamination ? conditions::Lack::no_test : conditions::Lack::no_design);
      add(effect, none, none);
    }
    if (max.empty() || std::ranges::find(combined, quantity) == std::end(combined)) return;
    out_.bounds.push_back(
        {.quantity = quantity, .max = bound(quantity, max, true), .min = bound(quantity, min, false)});
  }

  conditions::Combined bound(Quantity quantity, std::vector<conditions::Part> const& parts, bool upper) const {
    auto const& from = out_.combined;
    conditions::Combination how{.form = from.form, .adjust = from.adjust, .margin = from.margin};
    if (auto const* supply = rules_.factors_of(quantity))
      how.supply = (upper ? supply->spec_max : supply->spec_min).value_or(1.0);
    auto all = combine(how, parts);
    if (how.form != conditions::Form::asce) return all;
    auto const& limits = rules_.factors;
    if (upper && limits.max_not_below) all.factor = std::max(all.factor, *limits.max_not_below);
    if (!upper && limits.min_not_above) all.factor = std::min(all.factor, *limits.min_not_above);
    return all;
  }

  void add_curves(Quantity quantity, conditions::Response const& response) {
    auto const effect = response.effect();
    if (auto const b = conditions::exponent(response))
      out_.curves.push_back({.quantity = quantity,
                             .effect = effect,
                             .parameter = "exponent",
                             .value = *b,
                             .unit = effect == Effect::temperature ? "1/K" : ""});
    if (effect != Effect::load || quantity != Quantity::K_d) return;
    if (auto const critical = conditions::critical_load_kN(response))
      out_.curves.push_back(
          {.quantity = quantity, .effect = effect, .parameter = "critical load", .value = *critical, .unit = "kN"});
  }

  // The factor of ageing that the design asks for; empty if it asks for none.
  std::optional<Factor> aged(conditions::Response const& response) {
    auto const& design = stated_.design;
    if (design.aged) return response.at(conditions::Ageing{.days = design.aged->days, .at_C = design.aged->at_C});
    if (!design.years) return std::nullopt;
    if (!stated_.activation_energy_kJ_per_mol) return Factor::without(conditions::Lack::no_energy);
    auto const* chosen = conditions::ageing_level_for(*design.years, response.levels(), *design.service_temperature_C,
                                                      *stated_.activation_energy_kJ_per_mol);
    if (chosen == nullptr) return Factor::without(conditions::Lack::no_test);
    double const life = conditions::stands_for_years(*chosen->ageing, *design.service_temperature_C,
                                                     *stated_.activation_energy_kJ_per_mol);
    out_.ageing_stands_for_years = life, out_.ageing_test = chosen->ageing;
    return conditions::aged_factor(response.of(*chosen), *design.years, life);
  }

  static Factor as_reference() { return {.se = 0.0, .df = 1.0}; }

  // Scragging, its recovery, and the softening over many cycles.
  void add_history(Quantity quantity, auto const& add) {
    std::vector<conditions::ReferenceTest> first, again;
    std::vector<conditions::DeviceRatio> first_ratios, after_ratios;  // in cycle 1, and in the design's cycle
    auto const is_reference = [](Observed const& seen) { return seen.usable && seen.differs.empty(); };
    bool const scaled = only_scaled(is_reference);
    for (auto const& seen : all_) {
      if (!is_reference(seen) || seen.is_scaled != scaled) continue;
      auto const reference = ln_at_reference(seen.block, quantity);
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
        auto const word = history_of(seen, 1);
        if (word == conditions::History::virgin) {
          first.push_back(test);
          std::vector<double> values;
          for (int n = 1; at(n); ++n) values.push_back(std::exp(*at(n)));
          if (auto const curve = conditions::softening(values))
            out_.curves.push_back({.quantity = quantity,
                                   .effect = Effect::cycles,
                                   .parameter = "p",
                                   .value = curve->p,
                                   .unit = "",
                                   .device = seen.block.device});
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
      auto factor = share ? conditions::scragging_factor(first, share) : Factor::without(conditions::Lack::no_rest);
      bool const is_tested =
          std::ranges::find(recovered_, *design.rest_h, &conditions::Recovered::rest_h) != recovered_.end();
      // The interval would have to contain that of the recovery, which few devices show.
      factor.se = factor.df = std::nullopt;
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

  campaign::ObservedTests const& observed_;
  campaign::StatedConditions const& stated_;
  rules::RuleSet rules_;
  rules::Design design_values_;
  conditions::Condition reference_;
  conditions::Tolerance tolerance_;
  std::vector<Observed> all_;
  std::vector<conditions::Recovered> recovered_;
  ConditionsResult out_;
};

}  // namespace

std::string_view name(TestRole role) {
  switch (role) {
    case TestRole::reference:
      return "reference";
    case TestRole::effect:
      return "effect";
    case TestRole::combined:
      return "combined";
    case TestRole::other_strain:
      return "another strain";
    case TestRole::cycle_missing:
      return "no reference cycle";
    case TestRole::other_history:
      return "another history";
    case TestRole::unpaired:
      return "no reference test";
    case TestRole::other_device:
      return "another compound or size";
    case TestRole::scaled:
      return "scaled specimen";
  }
  return "";
}

ConditionsResult build_conditions(campaign::ObservedTests const& observed, std::string title,
                                  campaign::Acceptance const& acceptance) {
  auto result = Builder(observed, std::move(title), acceptance)();
  result.at_reference = values_at_reference(result);
  result.plan = plan_tests(result, usual_planned_devices);
  return result;
}

}  // namespace isolaw::study
