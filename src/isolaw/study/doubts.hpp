// What is known against one law of a campaign, for whoever takes it from there: exports and `simulate` say it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

struct Doubts {
  // What of its rule set the device, or the lot, does not keep; which devices the law of the lot says nothing of; and
  // the warnings of findings.hpp that concern the law on the device: the campaign, the search, the parameters, the
  // prediction, the record.
  std::vector<std::string> warnings;
  // "good: objective .03 on the blocks it was not fitted to (...)", or that it was not asked for.
  std::string prediction;
  std::string objection;  // why it should not be taken at all; empty otherwise
};

// Of the law on one device; without a device, of the one law of the lot.
Doubts doubts(Summary const& summary, std::string_view law, std::optional<std::string_view> device);

// "law bouc-wen, device 'a'", "law bouc-wen, the lot": whose parameters are taken.
std::string whose(std::string_view law, std::optional<std::string_view> device);

// Throws Error where there is an objection and the law is not taken anyway; `where` is whose().
void require_taken(Doubts const& doubts, std::string const& where, bool anyway);
// How each of them is said where it is.
std::string let_through(std::string_view objection);

// What of the tests a law was fitted to, in words: `part` is that of data::Selection, empty for all.
std::string part_text(std::string_view part);

}  // namespace isolaw::study
