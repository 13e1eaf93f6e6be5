#include "isolaw/study/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "isolaw/base/number_text.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"
#include "isolaw/study/value_doubts.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {
namespace {

using rules::Verdict;

void add_once(std::vector<std::string>& names, std::string const& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// The name under which an assessment is listed. The two sides of a device and the mean of the lot are listed under the
// property, such as "K_eff". A limit on how a property changes over cycles or loads is listed under its own name.
std::string property_of(rules::Assessment const& a) {
  bool const plain = a.subject == rules::Subject::device || a.subject == rules::Subject::lot;
  return a.property && plain ? std::string(name(*a.property)) : printable(a.quantity);
}

std::string failure(rules::Assessment const& a) {
  if (!a.deviation.empty()) return fmt::format("{} {}", property_of(a), a.deviation);
  if (!a.value) return property_of(a);
  return fmt::format("{} {}{}{}", property_of(a), number_text(*a.value), a.unit.empty() ? "" : " ", a.unit);
}

// Shortens "NTC 2018, elastomeric isolators: ..." to "NTC 2018", the name in common use.
std::string short_title(rules::RuleSet const& rules) {
  return printable(rules.title.substr(0, rules.title.find_first_of(",:")));
}

void add(std::vector<Requirement>& requirements, std::string const& name, Verdict verdict) {
  auto found = std::ranges::find(requirements, name, &Requirement::name);
  if (found == requirements.end()) {
    requirements.push_back({.name = name, .verdict = verdict});
    return;
  }
  if (found->verdict == Verdict::fail || verdict == Verdict::pass) return;
  found->verdict = verdict;
}

// Adds the requirements on the lot as a whole. If the conditions of the tests differ, the lot as a whole has no
// verdict.
void add_lot(OverallVerdict& overall, LotAcceptance const& acceptance, bool has_one_condition) {
  auto const& lot = acceptance.lot;
  if (!has_one_condition && !overall.requirements.empty())
    add(overall.requirements, "one condition for all tests", Verdict::not_assessed);
  auto const add_line = [&](std::string const& name, rules::Assessment const& a) {
    add(overall.requirements, name, a.verdict);
    if (a.verdict == Verdict::fail)
      overall.failing.push_back(
          {.device = {},
           .remark = fmt::format("{}, limit {}", a.deviation.empty() ? failure(a) : a.quantity + " " + a.deviation,
                                 printable(a.limit))});
  };
  if (acceptance.rules.sample) add_line(lot.sample.quantity, lot.sample);
  for (auto const& quantity : lot.quantities)
    for (auto const& limit : quantity.mean_limits) add_line(fmt::format("mean {}", name(quantity.quantity)), limit);
}

// Adds the limits on how properties change with conditions. The text names the rule set of the table [conditions] if it
// is not that of the acceptance.
void add_dependence(OverallVerdict& overall, Summary const& summary) {
  if (!summary.conditions) return;
  auto const& rules = summary.conditions->rules;
  auto const of_set = rules == summary.acceptance.rules.id ? std::string() : " of " + printable(rules);
  for (auto const& row : summary.conditions->dependence) {
    if (row.verdict() == Verdict::information) continue;
    auto const what = fmt::format("{} under {}{}", name(row.limit.quantity), name(row.limit.effect),
                                  row.is_load_variation ? ", from load to load" : "");
    add(overall.requirements, what, row.verdict());
    if (row.verdict() != Verdict::fail) continue;
    auto const* worst = row.worst();
    overall.failing.push_back(
        {.device = printable(worst->device),
         .remark = fmt::format("{} {:+.1f} %, limit {:g} %{}", what, 100.0 * (worst->ratio->lambda() - 1.0),
                               row.limit.within_percent, of_set)});
  }
}

void add_device(OverallVerdict& overall, DeviceResult const& device) {
  auto const& lines = device.acceptance.assessments;
  auto const name = printable(device.name);
  if (device.status != "ok" || lines.empty()) {
    auto const why = device.status != "ok" ? device.message : wording::reasons(device.properties.refusal);
    overall.not_assessed.push_back({.device = name, .remark = printable(on_one_line(why))});
    return;
  }
  // If two devices share a record, the assessment of it belongs to the first device, and the second one counts as not
  // assessed.
  auto const& copy_of = device.acceptance.copy_of;
  if (!copy_of.empty())
    overall.not_assessed.push_back({.device = name, .remark = rules::same_record_as(printable(copy_of))});
  for (auto const& a : lines)
    if (!a.limit.empty() && (copy_of.empty() || property_of(a) == rules::name(rules::Quantity::K_v)))
      add(overall.requirements, property_of(a), a.verdict);
  auto const own = device_verdict(device.acceptance);
  auto const& withheld = device.acceptance.withheld;
  if (copy_of.empty() && own.verdict != Verdict::fail && !withheld.empty())
    overall.not_assessed.push_back({.device = name, .remark = withheld});
  else if (own.verdict == Verdict::fail)
    overall.failing.push_back({.device = name, .remark = own.failures_text(" and ")});
  else if (copy_of.empty() && own.verdict != Verdict::pass && own.not_assessed.empty() && !own.passed.empty())
    overall.not_assessed.push_back({.device = name, .remark = "a compression test alone is no pass"});
}

// Adds "2 of 10 devices fail: D03 K_eff +23.0 %, D07 damping -16.2 %" and "the lot fails: sample size ...".
void say_failures(OverallVerdict const& overall, std::size_t devices, std::vector<std::string>& parts) {
  std::vector<std::string> device_failures, lot_failures;
  for (auto const& [device, remark] : overall.failing)
    device.empty() ? lot_failures.push_back(remark) : device_failures.push_back(device + " " + remark);
  if (auto const count = device_failures.size(); count > 0) {
    constexpr std::size_t shown = 10;
    device_failures.resize(std::min(count, shown));
    parts.push_back(fmt::format("{} of {} fail{}: {}{}", count, counted(devices, "device"), count == 1 ? "s" : "",
                                fmt::join(device_failures, ", "),
                                count > shown ? fmt::format(" and {} more", count - shown) : ""));
  }
  if (!lot_failures.empty()) parts.push_back(fmt::format("the lot fails: {}", fmt::join(lot_failures, "; ")));
}

std::string values_not_compared(LotAcceptance const& acceptance, std::vector<Requirement> const& requirements) {
  auto const& test = acceptance.rules.test;
  std::vector<std::string> names;
  for (auto const& [name, value, unit] : design_values(acceptance.design)) {
    bool const is_condition = (name == "disp" && test.displacement_tolerance_percent) ||
                              (name == "frequency" && test.frequency_tolerance_percent) ||
                              (name == "load" && test.load_tolerance_percent);
    bool const is_required = std::ranges::any_of(
        requirements, [&, &key = name](auto const& one) { return one.name == key || one.name == "mean " + key; });
    if (!is_condition && !is_required) names.push_back(name);
  }
  return names.empty() ? std::string() : "stated and not compared: " + joined(names);
}

std::string in_doubt(Summary const& summary) {
  struct Lost {
    std::string quantity, condition;
    int devices = 0;
  };
  std::vector<Lost> found;
  for (auto const& device : summary.devices)
    for (auto const& doubt : value_doubts(device)) {
      bool const lost = std::ranges::any_of(device.acceptance.assessments, [&](auto const& a) {
        if (a.verdict != Verdict::pass || property_of(a) != doubt.quantity || !a.nominal || *a.nominal == 0.0)
          return false;
        double const percent = 100.0 * (doubt.otherwise / *a.nominal - 1.0);
        return (a.lower_percent && percent < *a.lower_percent) || (a.upper_percent && percent > *a.upper_percent);
      });
      if (!lost) continue;
      auto const same = [&](auto const& one) {
        return one.quantity == doubt.quantity && one.condition == doubt.condition;
      };
      auto at = std::ranges::find_if(found, same);
      if (at == found.end()) at = found.insert(found.end(), {doubt.quantity, doubt.condition, 0});
      ++at->devices;
    }
  std::vector<std::string> parts;
  for (std::string_view previous; auto const& [quantity, condition, count] : found) {
    parts.push_back(fmt::format("{}of {}{} if {}", quantity == previous ? "" : quantity + " ", counted(count, "device"),
                                parts.empty() ? " would be outside its limit" : "", condition));
    previous = quantity;
  }
  return parts.empty() ? std::string() : "check the rig: " + joined(parts, ", and ");
}

std::string sentence_of(OverallVerdict const& overall, std::size_t devices) {
  std::vector<std::string> parts, open, without;
  say_failures(overall, devices, parts);
  std::size_t passed = 0;
  for (auto const& [name, verdict] : overall.requirements) {
    passed += verdict == Verdict::pass ? 1u : 0u;
    if (verdict == Verdict::not_assessed) open.push_back(name);
  }
  auto const all = overall.requirements.size();
  if (overall.word == "PASS")
    parts.push_back(fmt::format("{} {} {} requirement{}", counted(devices, "device"), devices == 1 ? "keeps" : "keep",
                                all == 1 ? std::string("the") : fmt::format("all {}", all), all == 1 ? "" : "s"));
  else if (all > 0)
    parts.push_back(fmt::format(
        "pass on {} of {}{}{}", passed, counted(all, "requirement"),
        overall.not_assessed.empty() || devices == 1
            ? std::string()
            : fmt::format(" with {} of {}", devices - overall.not_assessed.size(), counted(devices, "device")),
        open.empty() ? "" : fmt::format("; not assessed: {}", fmt::join(open, ", "))));
  for (auto const& [device, remark] : overall.not_assessed) without.push_back(device);
  if (!without.empty()) parts.push_back(fmt::format("without a verdict: {}", enumerate(without)));
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace

std::string DeviceVerdict::text() const {
  if (verdict == Verdict::fail) return "fail: " + failures_text();
  if (!copy_of.empty()) return fmt::format("{}: {}", rules::name(verdict), rules::same_record_as(copy_of));
  if (verdict != Verdict::pass || not_assessed.empty()) return brief();
  return fmt::format("{} ({}; not assessed: {})", brief(), fmt::join(passed, ", "), fmt::join(not_assessed, ", "));
}

std::string DeviceVerdict::brief() const {
  std::string text(rules::name(verdict));
  if (as_corrected) text += " as corrected";
  if (verdict != Verdict::pass || not_assessed.empty()) return text;
  return fmt::format("{} on {} of {}", text, passed.size(), passed.size() + not_assessed.size());
}

std::string DeviceVerdict::failures_text(std::string_view between) const {
  constexpr std::size_t shown = 3;
  auto const count = std::min(shown, failures.size());
  auto const text =
      fmt::format("{}", fmt::join(failures.begin(), failures.begin() + static_cast<std::ptrdiff_t>(count), between));
  return failures.size() > count ? fmt::format("{} and {} more", text, failures.size() - count) : text;
}

DeviceVerdict device_verdict(DeviceAcceptance const& acceptance) {
  auto const& assessments = acceptance.assessments;
  DeviceVerdict result;
  result.copy_of = printable(acceptance.copy_of);
  struct Farthest {
    double off = 0.0;
    std::string name, text;
  };
  std::vector<Farthest> off;  // one for each quantity
  bool limits = false, information = false;
  for (auto const& a : assessments) {
    // A rule set requires nothing of a quantity without a limit.
    if (a.limit.empty()) continue;
    limits = true;
    information = information || a.verdict == Verdict::information;
    if (a.verdict == Verdict::pass) add_once(result.passed, property_of(a));
    if (a.verdict == Verdict::not_assessed) add_once(result.not_assessed, property_of(a));
    if (a.verdict != Verdict::fail) continue;
    add_once(result.failed, property_of(a));
    Farthest const line{.off = std::abs(a.deviation_percent.value_or(0.0)), .name = property_of(a), .text = failure(a)};
    auto const same = std::ranges::find(off, line.name, &Farthest::name);
    if (same == off.end())
      off.push_back(line);
    else if (line.off > same->off)
      *same = line;
  }
  std::ranges::stable_sort(off, std::ranges::greater(), &Farthest::off);
  for (auto& line : off) result.failures.push_back(std::move(line.text));
  if (!limits)
    information = std::ranges::any_of(assessments, [](auto const& a) { return a.verdict == Verdict::information; });
  // A quantity does not pass if one of its two sides could not be compared.
  std::erase_if(result.passed, [&](auto const& name) {
    return std::ranges::find(result.not_assessed, name) != result.not_assessed.end();
  });
  // A device cannot pass on a compression test alone.
  bool const in_shear =
      std::ranges::any_of(result.passed, [](auto const& name) { return name != rules::name(rules::Quantity::K_v); });
  result.verdict = !result.failed.empty() ? Verdict::fail
                   : in_shear             ? Verdict::pass
                   : information          ? Verdict::information
                                          : Verdict::not_assessed;
  result.as_corrected = acceptance.as_corrected && result.verdict == Verdict::pass;
  return result;
}

std::optional<Verdict> verdict_on(LotAcceptance const& lot, DeviceResult const& device) {
  if (!device.acceptance.assessments.empty()) return device_verdict(device.acceptance).verdict;
  bool const left_out = lot.has_rules() && !device.properties.refusal.empty();
  return left_out ? std::optional(Verdict::not_assessed) : std::nullopt;
}

OverallVerdict overall_verdict(Summary const& summary) {
  OverallVerdict overall;
  auto const& acceptance = summary.acceptance;
  auto const title = short_title(acceptance.rules);
  if (!acceptance.has_rules() || !acceptance.rules.verified()) {
    overall.sentence = acceptance.has_rules()
                           ? fmt::format("{}: no verdict, the limits of this set are not verified", title)
                           : "no verdict: no rule set";
    if (acceptance.has_rules()) overall.mark = "LIMITS NOT VERIFIED";
    // The table [conditions] may name another rule set, which is verified. The lot may fail its limits, but cannot pass
    // on them alone, because they are too few.
    OverallVerdict of_conditions;
    add_dependence(of_conditions, summary);
    if (!of_conditions.failing.empty()) {
      of_conditions.sentence =
          fmt::format("{}; otherwise {}", sentence_of(of_conditions, summary.devices.size()), overall.sentence);
      overall = std::move(of_conditions);
      overall.word = overall.mark = "FAIL";
      overall.is_red = true;
    }
  } else {
    for (auto const& device : summary.devices) add_device(overall, device);
    add_lot(overall, acceptance, !summary.conditions_differ);
    add_dependence(overall, summary);
    bool const open = !overall.not_assessed.empty() ||
                      std::ranges::find(overall.requirements, Verdict::not_assessed, &Requirement::verdict) !=
                          overall.requirements.end();
    bool const nothing = overall.requirements.empty() && overall.not_assessed.empty();
    if (!nothing) overall.word = !overall.failing.empty() ? "FAIL" : open ? "INCOMPLETE" : "PASS";
    overall.as_corrected = overall.word == "PASS" && summary.without_corrections &&
                           summary.without_corrections->kind == FindingKind::verdict_rests_on_corrections;
    overall.sentence = nothing ? fmt::format("{}: no verdict, the set limits nothing of these tests", title)
                               : fmt::format("{}: {}", title, sentence_of(overall, summary.devices.size()));
    for (auto const& more : {values_not_compared(acceptance, overall.requirements), in_doubt(summary)})
      if (!nothing && !more.empty()) overall.sentence += "; " + more;
    if (overall.word != "PASS") overall.mark = overall.word, overall.is_red = !nothing;
  }
  // Data that were computed, not measured, say nothing about real devices.
  if (summary.title.find(not_measured) != std::string::npos) {
    overall.mark = "NOT MEASURED";
    overall.is_red = false;
    overall.sentence += "; not measured";
  }
  return overall;
}

std::string verdict_summary(Summary const& summary) {
  auto const verdict = overall_verdict(summary);
  return summary.acceptance.has_rules() || !verdict.word.empty() ? verdict.text() + "\n" : std::string();
}

std::optional<Finding> verdict_against(Summary const& summary, std::optional<std::string_view> device) {
  auto const& rules = summary.acceptance.rules;
  if (!device)
    return acceptance_failed(summary)
               ? std::optional(Finding{.kind = FindingKind::rule_set_not_kept_by_lot,
                                       .words = {{"verdict", overall_verdict(summary).sentence}}})
               : std::nullopt;
  if (!summary.acceptance.has_rules() || !rules.verified()) return std::nullopt;
  auto found = std::ranges::find(summary.devices, *device, &DeviceResult::name);
  // If two devices share a record, the first one has the verdict for both.
  if (found != summary.devices.end() && !found->acceptance.copy_of.empty())
    found = std::ranges::find(summary.devices, found->acceptance.copy_of, &DeviceResult::name);
  if (found == summary.devices.end()) return std::nullopt;
  auto const verdict = device_verdict(found->acceptance);
  if (verdict.verdict != Verdict::fail) return std::nullopt;
  return Finding{.kind = FindingKind::rule_set_not_kept_by_device,
                 .devices = {found->name},
                 .words = {{"rules", short_title(rules)}, {"failures", verdict.failures_text()}}};
}

}  // namespace isolaw::study
