// Collects the findings that a careful reader must know before relying on a campaign or an inspection. Each finding is
// computed once, as fields; wording/table.hpp makes its sentence and says what to do about it.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// isolaw warns if 20 times finer integration steps change the objective by more than this (an absolute difference).
inline constexpr double large_integration_shift = 1e-3;
// The part of a campaign to report on: one law or all, on one device or all.
struct Scope {
  std::optional<std::string_view> law = {}, device = {};

  bool covers(LawResult const& one) const { return !law || *law == one.id; }
  bool covers_device(std::string_view name) const { return !device || *device == name; }
};

// The findings within the scope. A scope of one device does not change what is found about a law as a whole (whether it
// describes the devices, predicts, and stays plausible in a building's cycles): this is judged on all devices. A
// finding on devices with the same record names all of them if one of them is in the scope.
std::vector<Finding> warnings(Summary const& summary, Scope const& scope = {});
// For each device, in the order of the summary: the findings on its record and on other devices with the same record.
std::vector<std::vector<Finding>> device_warnings(Summary const& summary);

}  // namespace isolaw::study
