// Cyclic properties, what a rule set says of them and the view of the lot as JSON: the page and `isolaw inspect --json`
// hold the same objects. Keys carry the units; docs/inspection-json.md describes them.
#pragma once

#include "isolaw/base/json.hpp"
#include "isolaw/render/results.hpp"
#include "isolaw/study/verdict.hpp"

namespace isolaw::render {

// Members of a device's object: blocks, reported, properties_refusal, samples_per_cycle, notes, corrections,
// counting_block, verdicts, doubts, assessments.
void write_properties(JsonWriter& out, LotAcceptance const& lot, DeviceResult const& device);

// The verdict of the whole, as `result`.
void write_verdict(JsonWriter& out, OverallVerdict const& verdict);

// The object of the lot: rule_set, design, lot.
void write_acceptance(JsonWriter& out, LotAcceptance const& acceptance);

}  // namespace isolaw::render
