// Writes cyclic properties, their verdicts under a rule set and the results of the lot as JSON, for the page and
// `isolaw inspect --json`. Keys contain the units; docs/inspection-json.md describes the keys.
#pragma once

#include "isolaw/base/json.hpp"
#include "isolaw/render/json/results_json.hpp"
#include "isolaw/render/results.hpp"
#include "isolaw/study/verdict.hpp"

namespace isolaw::render {

// Adds to the JSON object of a device its members from `blocks` to `assessments`: cyclic properties, corrections,
// compression test, verdict and assessments.
void write_properties(JsonWriter& out, LotAcceptance const& lot, DeviceResult const& device,
                      UnitSystems systems = stored_units);
// Adds the member `tests`: one object for each test of the device, or an empty list if the device has only one test.
void write_tests(JsonWriter& out, DeviceResult const& device);
// Adds the overall verdict as the member `result`.
void write_verdict(JsonWriter& out, OverallVerdict const& verdict);
// Writes an object about the rule set and the lot, with the members rule_set, design and lot.
void write_acceptance(JsonWriter& out, LotAcceptance const& acceptance);

}  // namespace isolaw::render
