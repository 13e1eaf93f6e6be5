// Sums up the assessments of a device and of the lot in a word and a sentence. The text of a pass names the
// requirements that were met and those that were not assessed: a device that meets half of a standard does not pass the
// standard.
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
  // The names of the quantities that have a limit, each once: "K_eff" stands for both sides.
  std::vector<std::string> passed, failed, not_assessed;
  // For each failed quantity, its value farthest from the design value: "K_eff +23.0 %". The farthest comes first.
  std::vector<std::string> failures;
  std::string copy_of;        // the device with the same record that is assessed instead of this one; else empty
  bool as_corrected = false;  // the device passes, but only with the corrections that the user asked for

  // "pass on 1 of 2 (K_eff; not assessed: damping)", "pass as corrected", "fail: K_eff +23.0 %, damping -16.2 %",
  // "not assessed: the same record as D01"
  std::string text() const;
  // text() shortened for the cell of a table: "pass on 1 of 2", "fail", or "pass" if everything was compared.
  std::string brief() const;
  // The first three failures, and the number of further ones.
  std::string failures_text(std::string_view between = ", ") const;
};
DeviceVerdict device_verdict(DeviceAcceptance const& acceptance);

// The verdict on one device. A device is not assessed if its record has no properties to compare with the rule set.
// Returns nullopt without a rule set.
std::optional<rules::Verdict> verdict_on(LotAcceptance const& lot, DeviceResult const& device);

struct Requirement {
  std::string name;
  rules::Verdict verdict = rules::Verdict::not_assessed;  // a pass if every device and side passes
};

// A remark on a device or, if the name is empty, on the lot itself.
struct DeviceRemark {
  std::string device, remark;
};

// The verdict on the whole lot. FAIL: a device or the lot does not keep a limit of a verified rule set. INCOMPLETE:
// nothing fails, but a requirement or device was not assessed. PASS: everything passes. The word is empty without a
// verified rule set, and if no limit of the rule set applies to these tests.
struct OverallVerdict {
  std::string word;  // "PASS", "FAIL", "INCOMPLETE", or empty
  // True for a PASS that would be another verdict without the corrections that the user asked for. Reports show it as
  // "PASS as corrected".
  bool as_corrected = false;
  std::string sentence;  // the reasons, with devices and requirements; if `word` is empty, why there is no verdict
  std::vector<DeviceRemark> failing, not_assessed;
  std::vector<Requirement> requirements;
  // The words printed across a certificate that does not prove a pass. Red words: a test failed or is missing, and the
  // certificate may be signed as a report of the tests only. Grey words, such as "NOT MEASURED": nobody may sign it.
  std::string mark;
  bool is_red = false;

  std::string shown_word() const { return as_corrected ? word + " as corrected" : word; }
  std::string text() const { return word.empty() ? sentence : shown_word() + ": " + sentence; }
};
OverallVerdict overall_verdict(Summary const& summary);
// A lot whose title contains these words has no real devices, such as the built-in example lot.
inline constexpr std::string_view not_measured = "not measured";
std::string verdict_summary(Summary const& summary);
// Limits of a verified rule set that the device does not keep; without a device, those of the lot and all its devices.
std::optional<Finding> verdict_against(Summary const& summary, std::optional<std::string_view> device);

}  // namespace isolaw::study
