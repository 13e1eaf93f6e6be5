#include "isolaw/study/conditions_tests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/runs.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::study {
namespace {

using conditions::Effect;
using rules::Quantity;

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

class TestReader {
 public:
  TestReader(campaign::ObservedTests const& observed, ConditionsResult& out)
      : observed_(observed), stated_(observed.stated), reference_(stated_reference(stated_)), out_(out) {
    auto const& within = stated_.tolerance;
    tolerance_ = {.temperature_C = within.temperature_C,
                  .frequency_percent = within.frequency_percent,
                  .load_percent = within.load_percent,
                  .strain_percent = within.strain_percent};
  }

  std::vector<Observed> operator()() {
    each_run(std::span(std::as_const(observed_.tests)), &campaign::ObservedTest::device,
             [&](auto of_device) { read(of_device); });
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
      throw Error({.where = "reference in [conditions]",
                   .found = "no test agrees with the reference in everything" + nearest_text(),
                   .allowed = "a reference under which some devices were tested",
                   .advice = "isolaw inspect FILE, which prints frequency, amplitude, load and cycles of a test"});
    return std::move(all_);
  }

 private:
  void refuse(campaign::ObservedTest const& test, std::string why) {
    out_.refused.push_back({.device = test.device, .test = test.test, .place = test.place, .reason = std::move(why)});
  }

  void read(std::span<campaign::ObservedTest const> of_device) {
    std::vector<Observed> own;
    campaign::ObservedTest const* aged = nullptr;  // the last test so far that states an ageing; nullptr if none does
    if (*of_device.back().stated.order > static_cast<int>(of_device.size()))
      out_.devices_lacking_tests.push_back({.device = of_device.back().device,
                                            .tests = static_cast<int>(of_device.size()),
                                            .last_order = *of_device.back().stated.order});
    for (auto const& test : of_device) {
      for (auto const& doubt : test.doubts)
        out_.doubted.push_back({.device = test.device, .test = test.test, .place = test.place, .doubt = doubt});
      auto why = aged != nullptr ? younger_than(*aged, test) : std::string();
      if (why.empty()) why = add_blocks(test, own);
      if (test.stated.aged) aged = &test;
      if (why.empty()) continue;
      refuse(test, std::move(why));
      // A refused test of unknown strain may have had any strain, so all later tests have an unknown history.
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
    if (auto const& ageing = last.stated.aged)
      device.aged = conditions::Ageing{.days = ageing->days, .at_C = ageing->at_C};
    for (auto const& block : blocks)
      device.largest_percent = std::max(device.largest_percent, block.condition.strain_percent.value_or(0.0));
    out_.devices.push_back(std::move(device));
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i].largest_before_percent = before[i];
      if (own[i].test_index) add_history_words(own[i], out_.tests[*own[i].test_index]);
      all_.push_back(std::move(own[i]));
    }
  }

  // Returns how the ageing stated for a test contradicts that of an earlier test; empty if it does not.
  static std::string younger_than(campaign::ObservedTest const& before, campaign::ObservedTest const& test) {
    auto const& now = test.stated.aged;
    constexpr double rounding = 1e-9;
    if (now && now->days >= before.stated.aged->days * (1.0 - rounding)) return {};
    return fmt::format(
        "it states {}, and the device was aged {:g} days before the earlier test {}: aged = {{ days = {:g}, at-C = {:g} "
        "}}, or more days",
        now ? fmt::format("an ageing of {:g} days", now->days) : "no ageing", before.stated.aged->days,
        printable(before.test), before.stated.aged->days, before.stated.aged->at_C);
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

  // Devices of several compounds or sizes are not compared with one another, so the user must say which ones are meant.
  void require_one_kind() const {
    for (auto const& option : campaign::compared_devices_table()) {
      if (!option.get(stated_.compared).is_null()) continue;
      std::map<std::string, std::string> kinds;  // each compound or size, with the first device that has it
      for (auto const& test : out_.tests) {
        auto const kind = option.get(test.of_device);
        kinds.try_emplace(kind.is_null() ? "none" : kind.get<std::string>(), test.device);
      }
      std::vector<std::string> named;
      for (auto const& [kind, device] : kinds) named.push_back(fmt::format("{} (as {})", kind, device));
      if (kinds.size() > 1)
        throw Error({.where = "[conditions]",
                     .found = fmt::format("devices with {} {}", option.option(), printable(joined(named))),
                     .allowed = fmt::format("devices of one {0}, or {0} in [conditions] to name those meant",
                                            option.option())});
    }
    require_one("rubber-thickness-mm", &campaign::ObservedTest::rubber_thickness_mm);
    require_one("rubber-area-mm2", &campaign::ObservedTest::rubber_area_mm2);
  }
  void require_one(std::string_view key, std::optional<double> campaign::ObservedTest::*dimension) const {
    campaign::ObservedTest const* first = nullptr;
    for (auto const& test : observed_.tests) {
      auto const& value = test.*dimension;
      if (!value || test.stated.is_scaled || !is_compared(test.of_device)) continue;
      if (first == nullptr) first = &test;
      constexpr double tolerance_percent = 1.0;
      if (!conditions::agrees(value, first->*dimension, tolerance_percent))
        throw Error({.where = "[conditions]",
                     .found = fmt::format("devices of different size: {} {:g} of {} and {:g} of {}", key,
                                          (first->*dimension).value(), printable(first->device), *value,
                                          printable(test.device)),
                     .allowed = "devices of one size",
                     .advice = "size in each [[device]], and size in [conditions] to name those meant"});
    }
  }
  bool is_compared(campaign::StatedDevice const& device) const {
    return std::ranges::all_of(campaign::compared_devices_table(), [&](auto const& option) {
      auto const wanted = option.get(stated_.compared);
      return wanted.is_null() || wanted == option.get(device);
    });
  }

  // The strain in percent of the rubber's thickness. The amplitude in mm takes its place if the reference states a
  // displacement, or if it states no strain and the thickness is not known. nullopt if the reference states a strain
  // and the thickness is not known.
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
    if (!test.stated.temperature_C) return "no temperature is stated; the test needs a line such as temperature-C = 20";
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
        return "the vertical load is neither measured nor stated; the test needs a line such as load-kN = 2000";
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
                    .test_index = out_.tests.size(),
                    .is_scaled = test.stated.is_scaled};
      for (auto const& cycle : block.cycles) seen.block.cycles.push_back(values_of(cycle));
      out_.tests.push_back({.device = test.device,
                            .test = test.test,
                            .file = test.file,
                            .sha256 = test.sha256,
                            .place = test.place,
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
      auto const ln = ln_at_reference(block, quantity, stated_);
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
    row.history = history_of(seen, stated_.reference.first_cycle, tolerance_);
    for (auto const& cycle : seen.block.cycles) {
      auto const value = [&](Quantity quantity) -> std::optional<double> {
        auto const ln = cycle.ln(quantity);
        return ln ? std::optional(std::exp(*ln)) : std::nullopt;
      };
      row.cycles.push_back({.number = cycle.number,
                            .history = history_of(seen, cycle.number, tolerance_),
                            .K_eff_kN_per_mm = value(Quantity::K_eff),
                            .damping_percent = value(Quantity::damping),
                            .energy_kN_mm = value(Quantity::energy),
                            .Q_d_kN = value(Quantity::Q_d),
                            .K_d_kN_per_mm = value(Quantity::K_d)});
    }
  }

  void judge(Observed& seen) {
    if (!seen.test_index) return;
    auto& row = out_.tests[*seen.test_index];
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

  // Names the compared test that differs from the reference in the fewest conditions, and its condition.
  std::string nearest_text() const {
    Observed const* nearest = nullptr;
    for (auto const& seen : all_)
      if (seen.test_index && is_compared(out_.tests[*seen.test_index].of_device) &&
          (nearest == nullptr || seen.differs.size() < nearest->differs.size()))
        nearest = &seen;
    if (nearest == nullptr) return "; no device has the compound and the size that [conditions] names";
    auto const& row = out_.tests[*nearest->test_index];
    auto const& at = row.condition;
    auto text = fmt::format("; the nearest is {} of {}{}: {:g} C", printable(row.test), printable(row.device),
                            row.place.empty() ? "" : " (" + printable(row.place) + ")", at.temperature_C.value_or(0.0));
    if (at.frequency_Hz) text += fmt::format(", {:.4g} Hz", *at.frequency_Hz);
    if (at.load_kN) text += fmt::format(", {:.4g} kN", *at.load_kN);
    if (at.strain_percent)
      text += fmt::format(", {:.4g} {}", *at.strain_percent, stated_.reference.disp_mm ? "mm" : "%");
    if (at.ageing) text += fmt::format(", aged {:g} days", at.ageing->days);
    text += fmt::format(", {} cycles", nearest->block.cycles.size());
    std::vector<std::string> differs;
    for (auto const effect : nearest->differs) differs.emplace_back(rules::name(effect));
    if (row.role == TestRole::other_strain || row.role == TestRole::cycle_missing) differs.emplace_back(name(row.role));
    return text + fmt::format(" (it does not agree in: {})", joined(differs));
  }

  campaign::ObservedTests const& observed_;
  campaign::StatedConditions const& stated_;
  conditions::Condition reference_;
  conditions::Tolerance tolerance_;
  std::vector<Observed> all_;
  ConditionsResult& out_;
};

}  // namespace

std::vector<Observed> read_tests(campaign::ObservedTests const& observed, ConditionsResult& result) {
  return TestReader(observed, result)();
}

conditions::Condition stated_reference(campaign::StatedConditions const& stated) {
  auto const& from = stated.reference;
  return {.temperature_C = from.temperature_C,
          .frequency_Hz = from.frequency_Hz,
          .load_kN = from.load_kN,
          .strain_percent = from.disp_mm ? from.disp_mm : from.strain_percent};
}

std::optional<double> ln_at_reference(conditions::Block const& block, Quantity quantity,
                                      campaign::StatedConditions const& stated) {
  double sum = 0.0;
  auto const first = stated.reference.first_cycle, last = stated.reference.last_cycle;
  for (int number = first; number <= last; ++number) {
    auto const* cycle = block.find(number);
    auto const ln = cycle != nullptr ? cycle->ln(quantity) : std::nullopt;
    if (!ln) return std::nullopt;
    sum += std::exp(*ln);
  }
  return std::log(sum / (last - first + 1));
}

std::optional<conditions::History> history_of(Observed const& seen, int cycle, conditions::Tolerance const& tolerance) {
  auto const& block = seen.block;
  if (block.find(cycle) == nullptr || !block.condition.strain_percent) return std::nullopt;
  return conditions::history(*block.condition.strain_percent, seen.largest_before_percent, cycle, block.rest_h,
                             tolerance);
}

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

}  // namespace isolaw::study
