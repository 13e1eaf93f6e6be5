#include "isolaw/study/verdict.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>

#include "isolaw/base/printable.hpp"

namespace isolaw::study {
namespace {

using rules::Verdict;

void add_once(std::vector<std::string>& names, std::string const& name) {
  if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// "K_eff" of "K_eff, positive side".
std::string property_of(rules::Assessment const& a) {
  return printable(a.quantity.substr(0, a.quantity.find(',')));
}

std::string failure(rules::Assessment const& a) {
  if (!a.deviation.empty()) return fmt::format("{} {}", property_of(a), a.deviation);
  if (!a.value) return property_of(a);
  return fmt::format("{} {:.4g}{}{}", property_of(a), *a.value, a.unit.empty() ? "" : " ", a.unit);
}

// The part of a set's title that people call it by: "NTC 2018" of "NTC 2018, elastomeric isolators: ...".
std::string short_title(rules::RuleSet const& rules) {
  return printable(rules.title.substr(0, rules.title.find_first_of(",:")));
}

void add_lot(std::vector<std::string>& failures, LotAcceptance const& acceptance) {
  auto const& lot = acceptance.lot;
  auto const add = [&](rules::Assessment const& a) {
    if (a.verdict == Verdict::fail)
      failures.push_back(fmt::format("{}, limit {}", a.deviation.empty() ? failure(a) : a.quantity + " " + a.deviation,
                                     printable(a.limit)));
  };
  add(lot.sample);
  for (auto const& quantity : lot.quantities)
    for (auto const& limit : quantity.mean_limits) add(limit);
}

}  // namespace

std::string DeviceVerdict::text() const {
  if (verdict == Verdict::fail) return "fail: " + failures_text();
  if (verdict != Verdict::pass || not_assessed.empty()) return std::string(rules::name(verdict));
  return fmt::format("pass ({}; not assessed: {})", fmt::join(passed, ", "), fmt::join(not_assessed, ", "));
}

std::string DeviceVerdict::failures_text(std::string_view between) const {
  constexpr std::size_t shown = 3;
  auto const count = std::min(shown, failures.size());
  auto const text =
      fmt::format("{}", fmt::join(failures.begin(), failures.begin() + static_cast<std::ptrdiff_t>(count), between));
  return failures.size() > count ? fmt::format("{} and {} more", text, failures.size() - count) : text;
}

DeviceVerdict device_verdict(std::vector<rules::Assessment> const& assessments) {
  DeviceVerdict made;
  struct Farthest {
    double off = 0.0;
    std::string name, text;
  };
  std::vector<Farthest> off;  // of each quantity
  bool limits = false, information = false;
  for (auto const& a : assessments) {
    // A quantity without a limit asks for nothing.
    if (a.limit.empty()) continue;
    limits = true;
    information = information || a.verdict == Verdict::information;
    if (a.verdict == Verdict::pass) add_once(made.passed, property_of(a));
    if (a.verdict == Verdict::not_assessed) add_once(made.not_assessed, property_of(a));
    if (a.verdict != Verdict::fail) continue;
    add_once(made.failed, property_of(a));
    Farthest const line{.off = std::abs(a.deviation_percent.value_or(0.0)), .name = property_of(a), .text = failure(a)};
    auto const same = std::ranges::find(off, line.name, &Farthest::name);
    if (same == off.end())
      off.push_back(line);
    else if (line.off > same->off)
      *same = line;
  }
  std::ranges::stable_sort(off, std::ranges::greater(), &Farthest::off);
  for (auto& line : off) made.failures.push_back(std::move(line.text));
  if (!limits)
    information = std::ranges::any_of(assessments, [](auto const& a) { return a.verdict == Verdict::information; });
  // Of a quantity with two sides, one of which could not be compared, none is said to pass.
  std::erase_if(made.passed, [&](auto const& name) {
    return std::ranges::find(made.not_assessed, name) != made.not_assessed.end();
  });
  // Of a device that is tested in shear a compression test alone says too little to pass.
  bool const in_shear =
      std::ranges::any_of(made.passed, [](auto const& name) { return name != rules::name(rules::Quantity::K_v); });
  made.verdict = !made.failed.empty() ? Verdict::fail
                 : in_shear           ? Verdict::pass
                 : information        ? Verdict::information
                                      : Verdict::not_assessed;
  return made;
}

std::optional<Verdict> verdict_on(LotAcceptance const& lot, DeviceResult const& device) {
  auto const& assessments = device.acceptance.assessments;
  if (!assessments.empty()) return device_verdict(assessments).verdict;
  bool const left_out = lot.has_rules() && !device.properties.refusal.empty();
  return left_out ? std::optional(Verdict::not_assessed) : std::nullopt;
}

std::string verdict_summary(Summary const& summary) {
  auto const& acceptance = summary.acceptance;
  if (!acceptance.has_rules()) return {};
  auto const title = short_title(acceptance.rules);
  if (!acceptance.rules.verified())
    return fmt::format("{}: no verdict, the limits of this set are not verified\n", title);
  std::size_t passed = 0, usable = 0;
  std::vector<std::string> failures, missing, lot;
  for (auto const& device : summary.devices) {
    if (device.status != "ok") continue;
    ++usable;
    auto const verdict = device_verdict(device.acceptance.assessments);
    passed += verdict.verdict == Verdict::pass ? 1u : 0u;
    if (verdict.verdict == Verdict::fail)
      failures.push_back(fmt::format("{} {}", printable(device.name), verdict.failures_text(" and ")));
    if (verdict.verdict == Verdict::pass)
      for (auto const& name : verdict.not_assessed) add_once(missing, name);
  }
  auto text = fmt::format("{}: {} of {} devices pass", title, passed, usable);
  if (!missing.empty()) text += fmt::format(" as far as assessed (not assessed: {})", fmt::join(missing, ", "));
  auto const count = failures.size();
  if (count > 0) {
    constexpr std::size_t shown = 10;
    failures.resize(std::min(count, shown));
    text += fmt::format(", {} fail{}: {}{}", count, count == 1 ? "s" : "", fmt::join(failures, ", "),
                        count > shown ? fmt::format(" and {} more", count - shown) : "");
  }
  if (passed + count < usable) text += fmt::format(", {} not assessed", usable - passed - count);
  add_lot(lot, acceptance);
  if (!lot.empty()) text += fmt::format("; the lot fails: {}", fmt::join(lot, "; "));
  return text + "\n";
}

std::string verdict_against(Summary const& summary, std::optional<std::string_view> device) {
  auto const& rules = summary.acceptance.rules;
  if (!summary.acceptance.has_rules() || !rules.verified()) return {};
  if (device) {
    auto const found = std::ranges::find(summary.devices, *device, &DeviceResult::name);
    if (found == summary.devices.end()) return {};
    auto const verdict = device_verdict(found->acceptance.assessments);
    if (verdict.verdict != Verdict::fail) return {};
    return fmt::format("{} fails {}: {}", printable(found->name), short_title(rules), verdict.failures_text());
  }
  if (!acceptance_failed(summary)) return {};
  auto text = verdict_summary(summary);
  while (text.ends_with('\n')) text.pop_back();
  return "the lot does not keep its rule set: " + text;
}

}  // namespace isolaw::study
