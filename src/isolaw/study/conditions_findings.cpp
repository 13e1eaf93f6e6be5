#include "isolaw/study/conditions_findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "isolaw/base/words.hpp"
#include "isolaw/campaign/names_of_tests.hpp"
#include "isolaw/num/statistics.hpp"
#include "isolaw/study/conditions_results.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {
namespace {

using conditions::Effect;
using conditions::Status;

std::string names_of(std::vector<Effect> const& effects) {
  std::vector<std::string> names;
  for (auto const effect : effects) names.emplace_back(rules::name(effect));
  return joined(names);
}

// A finding about one test, with its place in the lot file.
Finding about_test(FindingKind kind, auto const& test) {
  Finding finding{.kind = kind, .devices = {test.device}, .words = {{"test", test.test}}};
  if (!test.place.empty()) finding.words.push_back({"place", test.place});
  return finding;
}

Finding bound(rules::Quantity quantity, std::string which, conditions::Combined const& all) {
  Finding finding{.kind = FindingKind::design_bound,
                  .numbers = {{"factor", all.factor}},
                  .words = {{"quantity", std::string(rules::name(quantity))}, {"which", which}}};
  if (all.interval) {
    finding.numbers.push_back({"low", all.interval->low});
    finding.numbers.push_back({"high", all.interval->high});
  }
  if (!all.assumed.empty()) finding.words.push_back({"assumed", names_of(all.assumed)});
  if (all.complete()) {
    finding.words.push_back({"status", std::string(name(all.status))});
    finding.numbers.push_back({"share_shown", all.share_shown});
  } else {
    finding.words.push_back({"partial", which});
    finding.words.push_back({"not_covered", names_of(all.not_covered)});
  }
  return finding;
}

// Adds doubts about tests with implausible values and about devices that respond differently to a condition.
void add_doubts(ConditionsResult const& result, std::vector<Finding>& findings) {
  std::vector<double> at_reference;
  for (auto const& test : result.tests)
    if (test.role == TestRole::reference && test.K_eff_kN_per_mm) at_reference.push_back(*test.K_eff_kN_per_mm);
  if (!at_reference.empty()) {
    double const median = num::median(at_reference);
    constexpr double most_times = 4.0;  // conditions change K_eff by less than this factor, a wrong unit by more
    for (auto const& test : result.tests) {
      bool const is_compared = test.role != TestRole::other_device && test.role != TestRole::scaled && !test.is_scaled;
      if (!is_compared || !test.K_eff_kN_per_mm) continue;
      double const times = *test.K_eff_kN_per_mm / median;
      if (times > most_times || times < 1.0 / most_times) {
        findings.push_back(about_test(FindingKind::condition_test_unlike, test));
        findings.back().numbers = {{"times", times}};
      }
    }
  }
  for (auto const& test : result.tests) {
    double const times = test.condition.load_kN.value_or(0.0) / result.reference.load_kN.value_or(1.0);
    constexpr double most_times = 5.0;  // tons in place of kN give 9.8 times the load, N give 1000 times
    if (!result.reference.load_kN || times <= 0.0 || (times < most_times && times > 1.0 / most_times)) continue;
    findings.push_back(about_test(FindingKind::condition_load_unlike, test));
    findings.back().numbers = {{"times", times}};
  }
  for (auto const& row : result.levels) {
    if (row.quantity != rules::Quantity::K_eff && row.quantity != rules::Quantity::energy) continue;
    if (row.ratios.size() < 2) continue;
    auto const [least, largest] = std::ranges::minmax_element(row.ratios, {}, &conditions::DeviceRatio::ln);
    constexpr double much = 1.25;  // nominally equal devices differ less in how a condition changes them
    if (largest->ln - least->ln > std::log(much))
      findings.push_back({.kind = FindingKind::devices_disagree,
                          .devices = {least->device, largest->device},
                          .numbers = {{"least", std::exp(least->ln)}, {"largest", std::exp(largest->ln)}},
                          .words = {{"effect", std::string(rules::name(row.effect))},
                                    {"level", row.level},
                                    {"quantity", std::string(rules::name(row.quantity))}}});
  }
  for (auto const& test : result.doubted) {
    findings.push_back(about_test(FindingKind::condition_test_doubt, test));
    findings.back().words.push_back({"doubt", wording::reasons({test.doubt})});
  }
}

// Adds a doubt about each test whose name or file name contradicts what the lot file states about the test.
void add_misnamed(ConditionsResult const& result, std::vector<Finding>& findings) {
  std::vector<std::string> tests, files;
  for (auto const& test : result.tests) {
    tests.push_back(test.test);
    files.push_back(std::filesystem::path(test.file).stem().string());
  }
  auto const by_test = campaign::propose_tests(tests), by_file = campaign::propose_tests(files);
  for (std::size_t i = 0; i < tests.size(); ++i) {
    auto const& test = result.tests[i];
    if (test.block > 1) continue;
    auto const& at = test.condition;
    std::vector<std::string> named, stated;
    auto const compare = [&](std::optional<double> in_name, std::optional<double> in_file, bool agree,
                             std::string_view unit) {
      if (!in_name || !in_file || agree) return;
      named.push_back(fmt::format("{:g} {}", *in_name, unit));
      stated.push_back(fmt::format("{:.4g} {}", *in_file, unit));
    };
    for (auto const* proposed : {&by_test[i], &by_file[i]}) {
      if (!named.empty()) break;
      auto const& temperature_C = proposed->temperature_C;
      auto const& load_kN = proposed->load_kN;
      compare(temperature_C, at.temperature_C,
              std::abs(temperature_C.value_or(0.0) - at.temperature_C.value_or(0.0)) <= result.tolerance.temperature_C,
              "C");
      compare(load_kN, at.load_kN, conditions::agrees(load_kN, at.load_kN, result.tolerance.load_percent), "kN");
      if (proposed->is_virgin && !test.cycles.empty() && test.cycles.front().history != conditions::History::virgin)
        named.emplace_back("virgin"), stated.emplace_back("tests before it");
      if (proposed->is_aged && !at.ageing) named.emplace_back("aged"), stated.emplace_back("no ageing");
    }
    if (named.empty()) continue;
    findings.push_back(about_test(FindingKind::condition_name_differs, test));
    findings.back().words.push_back({"named", joined(named)});
    findings.back().words.push_back({"stated", joined(stated)});
  }
}

// Temperatures may have been interchanged if devices are stiffer at a higher temperature.
void add_stiffer_when_warm(ConditionsResult const& result, std::vector<Finding>& findings) {
  std::vector<std::pair<double, double>> factors{{result.stated.reference.temperature_C, 1.0}};
  for (auto const& row : result.levels)
    if (row.effect == Effect::temperature && row.quantity == rules::Quantity::K_eff &&
        row.factor.status != Status::not_covered)
      factors.emplace_back(row.factor.at, row.factor.lambda());
  auto const [cold, warm] = std::ranges::minmax_element(factors);
  constexpr double much = 1.02;  // scatter alone may cause differences up to this factor
  if (warm->second > much * cold->second)
    findings.push_back(
        {.kind = FindingKind::stiffer_when_warm,
         .numbers = {
             {"cold", cold->second}, {"cold_C", cold->first}, {"warm", warm->second}, {"warm_C", warm->first}}});
}

void add_lacking_tests(ConditionsResult const& result, std::vector<Finding>& findings) {
  for (auto const& [device, tests, last_order] : result.devices_lacking_tests)
    findings.push_back(
        {.kind = FindingKind::order_lacks_tests,
         .devices = {device},
         .numbers = {{"last_order", static_cast<double>(last_order)}, {"tests", static_cast<double>(tests)}}});
}

// Names the effects that rest on a test which another finding doubts, and the reference if it rests on such a test.
void add_rests_on_doubts(ConditionsResult const& result, std::vector<Finding>& findings) {
  if (result.bounds.empty()) return;
  auto const is_doubt = [](Finding const& finding) {
    using enum FindingKind;
    return finding.kind == condition_test_unlike || finding.kind == condition_load_unlike ||
           finding.kind == condition_name_differs || finding.kind == condition_test_doubt;
  };
  std::map<std::string, std::vector<std::string>> tests;  // for each effect, the tests that are doubted
  for (auto const& test : result.tests) {
    bool const is_used = test.role == TestRole::reference ||
                         (test.role == TestRole::effect &&
                          std::ranges::find(result.design, *test.effect, &DesignRow::effect) != result.design.end());
    auto const of_test = about_test(FindingKind::condition_test_doubt, test);
    bool const is_doubted = std::ranges::any_of(findings, [&](Finding const& finding) {
      return is_doubt(finding) && finding.devices == of_test.devices && finding.words.front() == of_test.words.front();
    });
    if (!is_used || !is_doubted) continue;
    auto& named = tests[std::string(test.effect ? rules::name(*test.effect) : "reference")];
    auto text = test.device + " " + test.test;
    if (std::ranges::find(named, text) == named.end()) named.push_back(std::move(text));
  }
  std::vector<std::string> named;
  for (auto const& [effect, of_effect] : tests) named.push_back(fmt::format("{} ({})", effect, joined(of_effect)));
  if (!named.empty())
    findings.push_back({.kind = FindingKind::bounds_rest_on_doubts, .words = {{"named", joined(named)}}});
}

// Warns if the histories of the reference cycles differ between the devices' first reference tests.
void add_histories(ConditionsResult const& result, std::vector<Finding>& findings) {
  std::map<std::string, std::string> histories;  // for each device, the history in its first reference test
  for (auto const& test : result.tests)
    if (test.role == TestRole::reference && test.history)
      histories.try_emplace(test.device, std::string(name(*test.history)));
  std::map<std::string, std::vector<std::string>> devices;
  for (auto const& [device, history] : histories) devices[history].push_back(device);
  if (devices.size() < 2) return;
  std::vector<std::string> named;
  for (auto const& [history, of] : devices) named.push_back(fmt::format("{} on {}", history, joined(of)));
  findings.push_back({.kind = FindingKind::histories_differ, .words = {{"named", joined(named)}}});
}

// Names the effects that tests show but the design does not ask for.
void add_left_out(ConditionsResult const& result, std::vector<Finding>& findings) {
  if (result.bounds.empty()) return;
  std::map<Effect, LevelRow const*> largest;
  for (auto const& row : result.levels) {
    if (row.quantity != rules::Quantity::K_eff || row.factor.status == Status::not_covered) continue;
    auto& so_far = largest[row.effect];
    if (so_far == nullptr || std::abs(row.factor.ln) > std::abs(so_far->factor.ln)) so_far = &row;
  }
  for (auto const& [effect, row] : largest) {
    constexpr double small = 0.02;
    if (std::abs(row->factor.ln) < small ||
        std::ranges::find(result.design, effect, &DesignRow::effect) != result.design.end())
      continue;
    auto const key = effect == Effect::temperature ? "temperature-C"
                     : effect == Effect::rate      ? "frequency-Hz"
                     : effect == Effect::load      ? "load-kN"
                     : effect == Effect::ageing    ? "aged"
                                                   : "rest";
    findings.push_back({.kind = FindingKind::effect_left_out,
                        .numbers = {{"factor", row->factor.lambda()}},
                        .words = {{"effect", std::string(rules::name(effect))}, {"level", row->level}, {"key", key}}});
  }
}

// Adds one finding for each role of tests that show no effect.
void add_unused(ConditionsResult const& result, std::vector<Finding>& findings) {
  std::map<TestRole, std::vector<std::string>> unused;
  for (auto const& test : result.tests)
    if (test.role != TestRole::reference && test.role != TestRole::effect)
      unused[test.role].push_back(test.device + " " + test.test);
  for (auto& [role, tests] : unused) {
    constexpr std::size_t most_named = 6;
    auto const count = static_cast<double>(tests.size());
    if (tests.size() > most_named) tests.resize(most_named), tests.emplace_back("...");
    findings.push_back({.kind = FindingKind::tests_show_no_effect,
                        .numbers = {{"count", count}},
                        .words = {{"role", std::string(name(role))}, {"named", joined(tests)}}});
  }
}

Finding not_covered(ConditionsResult const& result, Effect effect, conditions::Factor const& factor) {
  Finding finding{.kind = FindingKind::effect_not_covered,
                  .words = {{"effect", std::string(rules::name(effect))},
                            {"lack", std::string(factor.lack ? name(*factor.lack) : "")}}};
  if (factor.lack == conditions::Lack::too_far) {
    finding.numbers.push_back({"at", factor.at});
    finding.words.push_back({"unit", std::string(unit_of(effect))});
  }
  if (factor.lack == conditions::Lack::no_level) {
    std::vector<std::string> tested;
    for (auto const& row : result.levels)
      if (row.effect == effect && row.quantity == rules::Quantity::K_eff) tested.push_back(row.level);
    if (!tested.empty()) finding.words.push_back({"tested", joined(tested)});
  }
  return finding;
}

// A finding that names the effects whose factors come from a single device. Their intervals hold for this device alone.
void add_intervals_of_one(ConditionsResult const& result, std::vector<Finding>& findings) {
  std::vector<Effect> alone;
  for (auto const& row : result.design)
    for (auto const* factor : {&row.max, &row.min})
      if (factor->devices == 1 && factor->se && factor->status != Status::assumed &&
          std::ranges::find(alone, row.effect) == alone.end())
        alone.push_back(row.effect);
  bool const is_used = std::ranges::any_of(
      result.bounds, [](BoundRow const& row) { return row.max.interval.has_value() || row.min.interval.has_value(); });
  if (is_used && !alone.empty())
    findings.push_back({.kind = FindingKind::interval_of_one_device, .words = {{"effects", names_of(alone)}}});
}

// Names each end of the design range that is not covered.
void add_not_covered(ConditionsResult const& result, DesignRow const& row, conditions::Factor const& factor,
                     std::vector<Finding>& findings) {
  bool has_ends = false;
  for (auto const& end : result.ends)
    if (end.quantity == row.quantity && end.effect == row.effect && end.factor.status == Status::not_covered) {
      auto at_end = end.factor;
      at_end.at = end.at;
      findings.push_back(not_covered(result, row.effect, at_end));
      has_ends = true;
    }
  if (!has_ends) findings.push_back(not_covered(result, row.effect, factor));
}

void add_tests(ConditionsResult const& result, std::vector<Finding>& findings) {
  int without_rest = 0;
  std::vector<std::string> stated{"temperature"};
  bool is_aged = false, has_rest = false;
  for (auto const& test : result.tests) {
    is_aged |= test.condition.ageing.has_value();
    has_rest |= test.rest_h.value_or(0.0) > 0.0;
    if (!test.rest_h && test.order > 1 && test.block == 1) ++without_rest;
    if (test.warming_h && !(test.conditioned_h.value_or(0.0) >= *test.warming_h)) {
      auto finding = about_test(FindingKind::chamber_too_short, test);
      finding.numbers = {{"needed_h", *test.warming_h}};
      if (test.conditioned_h)
        finding.numbers.push_back({"conditioned_h", *test.conditioned_h});
      else
        finding.words.push_back({"unknown", "yes"});
      findings.push_back(std::move(finding));
    }
  }
  if (is_aged) stated.emplace_back("ageing");
  if (has_rest) stated.emplace_back("rest");
  stated.emplace_back("order");
  if (without_rest > 0)
    findings.push_back(
        {.kind = FindingKind::rest_not_stated, .numbers = {{"tests", static_cast<double>(without_rest)}}});
  findings.push_back({.kind = FindingKind::conditions_stated, .words = {{"stated", joined(stated)}}});
}

Finding judged(DependenceRow const& row, std::string const& rules) {
  auto const& limit = row.limit;
  bool const fails = row.verdict() == rules::Verdict::fail;
  Finding finding{.kind = fails ? FindingKind::dependence_not_kept : FindingKind::dependence_judged,
                  .numbers = {{"within_percent", limit.within_percent}},
                  .words = {{"quantity", std::string(name(limit.quantity))},
                            {"effect", std::string(name(limit.effect))},
                            {"kept", std::string(name(row.verdict()))},
                            {"rules", rules},
                            {"changes", row.is_load_variation ? "loads" : "reference"}}};
  if (!limit.clause.empty()) finding.words.push_back({"clause", limit.clause});
  if (auto const* worst = row.worst()) {
    finding.devices = {worst->device};
    finding.numbers.push_back({"worst_percent", 100.0 * (worst->ratio->lambda() - 1.0)});
    if (worst->at) {
      finding.numbers.push_back({"at", *worst->at});
      finding.words.push_back({"unit", std::string(unit_of(limit.effect))});
    }
  }
  if (row.verdict() == rules::Verdict::not_assessed)
    for (auto const& device : row.devices)
      if (device.reason) {
        finding.words.push_back({"because", std::string(name(*device.reason))});
        break;
      }
  return finding;
}

Finding judged(MeanProperties const& mean, std::string const& rules) {
  auto const& [rule, permitted, quantity, farthest_percent] = mean;
  Finding finding{.kind = FindingKind::mean_properties_judged,
                  .numbers = {{"farthest_percent", farthest_percent}, {"within_percent", rule.within_percent}},
                  .words = {{"mean_properties", !permitted   ? "open"
                                                : *permitted ? "yes"
                                                             : "no"},
                            {"quantity", std::string(name(quantity))},
                            {"rules", rules}}};
  if (!rule.clause.empty()) finding.words.push_back({"clause", rule.clause});
  return finding;
}

}  // namespace

std::vector<Finding> conditions_findings(ConditionsResult const& result) {
  std::vector<Finding> findings;
  add_doubts(result, findings);
  add_misnamed(result, findings);
  add_stiffer_when_warm(result, findings);
  add_lacking_tests(result, findings);
  add_rests_on_doubts(result, findings);
  for (auto const& row : result.dependence) findings.push_back(judged(row, result.rules));
  if (result.mean_properties) findings.push_back(judged(*result.mean_properties, result.rules));
  for (auto const& row : result.bounds) {
    findings.push_back(bound(row.quantity, "upper", row.max));
    findings.push_back(bound(row.quantity, "lower", row.min));
  }
  for (auto const& row : result.design) {
    if (auto const* factor = row.max.status == Status::not_covered   ? &row.max
                             : row.min.status == Status::not_covered ? &row.min
                                                                     : nullptr) {
      // Default factors of a rule set do not cover damping. It needs none, because it has no bounds.
      bool const is_assumed = std::ranges::any_of(
          result.design, [&](DesignRow const& other) { return other.effect == row.effect && other.assumed; });
      if (!is_assumed) add_not_covered(result, row, *factor, findings);
    }
    if (auto const* of_rules = row.assumed ? &*row.assumed : nullptr) {
      Finding finding{.kind = FindingKind::effect_assumed,
                      .numbers = {{"max", row.max.lambda()}, {"min", row.min.lambda()}},
                      .words = {{"effect", std::string(rules::name(row.effect))},
                                {"quantity", std::string(rules::name(row.quantity))},
                                {"rules", of_rules->rules}}};
      if (!of_rules->clause.empty()) finding.words.push_back({"clause", of_rules->clause});
      if (!of_rules->verified) finding.words.push_back({"unverified", "yes"});
      findings.push_back(std::move(finding));
    }
  }
  // If an effect is not covered, most quantities give the same finding. It is kept once, after all other findings.
  auto const covered = std::ranges::stable_partition(
      findings, [](Finding const& finding) { return finding.kind != FindingKind::effect_not_covered; });
  std::vector<Finding> lacking;
  for (auto& finding : covered)
    if (std::ranges::find(lacking, finding) == lacking.end()) lacking.push_back(std::move(finding));
  findings.erase(covered.begin(), covered.end());
  findings.insert(findings.end(), lacking.begin(), lacking.end());
  for (auto const& test : result.refused) {
    findings.push_back(about_test(FindingKind::condition_test_refused, test));
    findings.back().words.push_back({"reason", test.reason});
  }
  add_intervals_of_one(result, findings);
  add_left_out(result, findings);
  add_histories(result, findings);
  add_unused(result, findings);
  if (!result.drift_not_checked.empty())
    findings.push_back(
        {.kind = FindingKind::drift_not_checked, .words = {{"effects", names_of(result.drift_not_checked)}}});
  if (!result.straightness_not_checked.empty())
    findings.push_back(
        {.kind = FindingKind::line_not_checked, .words = {{"effects", names_of(result.straightness_not_checked)}}});
  if (result.ageing_stands_for_years)
    findings.push_back({.kind = FindingKind::ageing_stands_for,
                        .numbers = {{"years", *result.ageing_stands_for_years},
                                    {"service_C", result.stated.design.service_temperature_C.value_or(0.0)}}});
  constexpr double heat_recovers_h = 6.0;
  if (std::ranges::any_of(result.recovery, [](RecoveryRow const& row) { return row.rest_h < heat_recovers_h; }))
    findings.push_back({.kind = FindingKind::short_rest, .numbers = {{"rest_h", heat_recovers_h}}});
  add_tests(result, findings);
  return findings;
}

}  // namespace isolaw::study
