// What a careful reader must know before trusting a campaign or an inspection, and what to do about it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// A finer integration step moving the objective by more than this is worth a warning.
inline constexpr double large_integration_shift = 1e-3;

struct Warning {
  // "not complete", "refused", "copies", "degradation", "law not identified", "failed runs", "failed evaluations",
  // "not adequate", "prediction", "not predicted", "search", "undetermined", "outlier", "at bound", "integration",
  // "record"
  std::string topic;
  std::string sentence;
  // Of single devices: which, and what of them; the sentence holds both.
  std::vector<std::string> devices = {};
  std::string remark = {};
};
// What a reader does about a warning: "Look at the records", ...; those of one action stand together on the page.
std::string_view action(Warning const& warning);

// Of a campaign or an inspection, the most serious topic first.
std::vector<Warning> warnings(Summary const& summary);
// Of some of its laws and devices alone; what only the whole can tell, copies and whether a law describes the devices,
// is taken from there.
std::vector<Warning> warnings(Summary const& whole, Summary const& part);

// What a reader of one device alone is told, of each in the order of the summary: the warnings of its record, and which
// other devices have the same one. Of those together `warnings` says it.
std::vector<std::vector<std::string>> device_warnings(Summary const& summary);

// For a terminal: remarks of one topic that differ in their numbers alone as one, "D01, D02 and 3 more: noise of 0.1 to
// 0.3 mm ..."; each in full stands in JSON and on the page.
std::vector<Warning> in_few_lines(std::vector<Warning> const& warnings);

}  // namespace isolaw::study
