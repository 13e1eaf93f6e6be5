// What the assessments of a device come to, in a word and a sentence. A pass says what passed and what nobody compared:
// half of a standard's requirements kept is no pass of the standard.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct DeviceVerdict {
  rules::Verdict verdict = rules::Verdict::not_assessed;
  // Of the lines with a limit, what is compared once each: "K_eff" for both sides.
  std::vector<std::string> passed, failed, not_assessed;
  // What failed, each quantity by its line farthest off the design value, the farthest first: "K_eff +23.0 %".
  std::vector<std::string> failures;
  std::string copy_of;  // the device whose record it is

  // "pass on 1 of 2 (K_eff; not assessed: damping)", "fail: K_eff +23.0 %, damping -16.2 %", "not assessed: the same
  // record as D01"
  std::string text() const;
  // The same in a table's cell: "pass on 1 of 2", "fail", "pass" where all were compared.
  std::string brief() const;
  // The first of the failures, and how many more there are.
  std::string failures_text(std::string_view between = ", ") const;
};
DeviceVerdict device_verdict(DeviceAcceptance const& acceptance);

// The word for a device of an inspection or a campaign: not assessed where its record has no properties that a rule set
// could be held to; nullopt where nothing was asked.
std::optional<rules::Verdict> verdict_on(LotAcceptance const& lot, DeviceResult const& device);

// What the set asks for, each once: "K_eff" for both sides of every device, "sample size", "mean K_eff".
struct Requirement {
  std::string name;
  rules::Verdict verdict = rules::Verdict::not_assessed;  // passes where every device and line does
};

// A device and what is said of it; the lot itself has no name.
struct DeviceRemark {
  std::string device, remark;
};

// One verdict of the whole. FAIL: a device or the lot does not keep a limit of a verified set. INCOMPLETE: none fails,
// but a requirement or a device was not assessed. PASS: neither. Without a verified set there is no word.
struct OverallVerdict {
  std::string word;      // "PASS", "FAIL", "INCOMPLETE", or empty
  std::string sentence;  // what it stands on, devices and requirements named; without a word why there is none
  std::vector<DeviceRemark> failing, not_assessed;
  std::vector<Requirement> requirements;
  // What stands across a certificate that nobody can sign, and whether in red; empty: it can be signed.
  std::string mark;
  bool is_red = false;

  std::string text() const { return word.empty() ? sentence : word + ": " + sentence; }
};
OverallVerdict overall_verdict(Summary const& summary);

// A lot whose title says this is not of devices; the example lot's does.
inline constexpr std::string_view not_measured = "not measured";

// The text of it on a line of its own; empty without a rule set.
std::string verdict_summary(Summary const& summary);
// The limits of a verified rule set that are not kept: by the device, where one is named, else by the lot.
std::optional<Finding> verdict_against(Summary const& summary, std::optional<std::string_view> device);

}  // namespace isolaw::study
