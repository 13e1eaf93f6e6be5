// Collects the findings that a careful reader must know before relying on a campaign or an inspection. Each is computed
// once, as fields; wording/table.hpp makes its sentence and says what to do about it.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// A finer integration step that moves the objective by more than this is worth a warning.
inline constexpr double large_integration_shift = 1e-3;
// The part of a campaign that findings are wanted for: one law or all, on one device or all.
struct Scope {
  std::optional<std::string_view> law = {}, device = {};

  bool covers(LawResult const& one) const { return !law || *law == one.id; }
  bool covers_device(std::string_view name) const { return !device || *device == name; }
};

// Findings within the scope. Whether a law describes the devices, and which devices share a record, is always judged on
// the whole campaign.
std::vector<Finding> warnings(Summary const& summary, Scope const& scope = {});
// For each device, in the order of the summary: the findings on its record and on sharing it with other devices.
std::vector<std::vector<Finding>> device_warnings(Summary const& summary);

}  // namespace isolaw::study
