// What the assessments of a device come to, in a word and a sentence. A pass says what passed and what nobody compared:
// half of a standard's requirements kept is no pass of the standard.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct DeviceVerdict {
  rules::Verdict verdict = rules::Verdict::not_assessed;
  // Of the lines with a limit, what is compared once each: "K_eff" for both sides.
  std::vector<std::string> passed, failed, not_assessed;
  // What failed, each quantity by its line farthest off the design value, the farthest first: "K_eff +23.0 %".
  std::vector<std::string> failures;

  // "pass (K_eff; not assessed: damping)", "fail: K_eff +23.0 %, damping -16.2 %"
  std::string text() const;
  // The first of the failures, and how many more there are.
  std::string failures_text(std::string_view between = ", ") const;
};
DeviceVerdict device_verdict(std::vector<rules::Assessment> const& assessments);

// The word for a device of an inspection or a campaign: not assessed where its record has no properties that a rule set
// could be held to; nullopt where nothing was asked.
std::optional<rules::Verdict> verdict_on(LotAcceptance const& lot, DeviceResult const& device);

// "NTC 2018: 8 of 10 devices pass, 2 fail: D03 K_eff +23.0 %, D07 damping -16.2 %", and what of the lot itself fails;
// empty without a rule set.
std::string verdict_summary(Summary const& summary);
// The same on one line, where the set is verified and something is not kept; else empty. Of the device alone, where one
// is named.
std::string verdict_against(Summary const& summary, std::optional<std::string_view> device);

}  // namespace isolaw::study
