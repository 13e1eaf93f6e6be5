// Collects the findings against one law of a campaign, for the commands export, simulate and building.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/warnings.hpp"

namespace isolaw::study {

// Grades the law's prediction of the blocks that it was not fitted to: FindingKind::prediction_good to
// prediction_unusable. If no block was left out of the fit, the finding is prediction_larger_swings, with the error on
// larger swings than those fitted, or prediction_unknown if this error is not known.
Finding prediction_of(Summary const& summary, LawResult const& law);

struct Doubts {
  // Limits that the device or the lot does not keep, devices that the lot's law leaves out, warnings about the law, and
  // how far the campaign's laws disagree.
  std::vector<Finding> findings;
  Finding prediction;
  std::optional<Finding> objection;  // why the law should not be used at all
};

// The doubts about the law on one device or, if `device` is empty, about the lot's law.
Doubts doubts(Summary const& summary, std::string_view law, std::optional<std::string_view> device);
// Returns "law bouc-wen, device 'a'" or "law bouc-wen, the lot". Messages begin so, to say which law they are about and
// whether it was fitted to one device or to the lot.
std::string law_and_device_text(std::string_view law, std::optional<std::string_view> device);
// Throws Error if there is an objection and `anyway` is false. `where` begins the message, such as a text from
// law_and_device_text().
void require_no_objection(Doubts const& doubts, std::string const& where, bool anyway);
std::string override_warning(std::string_view objection);
// Names the part of the tests that a law was fitted to. `part` is a data::Selection as text, empty for all tests.
std::string part_text(std::string_view part);

}  // namespace isolaw::study
