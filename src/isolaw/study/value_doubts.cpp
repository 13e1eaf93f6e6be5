#include "isolaw/study/value_doubts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "isolaw/data/properties/error_budget.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::study {
namespace {

constexpr double least_share = 0.02;

// The damping that the rule set judges (the mean of both sides) or, without it, the damping of the reported cycle.
std::optional<double> stated_damping(DeviceResult const& device) {
  double sum = 0.0, count = 0.0;
  for (auto const& a : device.acceptance.assessments)
    if (a.value && rules::is_of(a, rules::Quantity::damping)) sum += *a.value, count += 1.0;
  if (count > 0.0) return sum / count;
  return device.properties.reported ? device.properties.reported->damping() : std::nullopt;
}

std::optional<double> effect_of(DeviceResult const& device, std::string_view effect) {
  auto const found = std::ranges::find(device.effects, effect, &data::Effect::effect);
  return found == device.effects.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace

std::string ValueDoubt::text() const {
  return fmt::format("{} {:.3g} {}, or {:.3g} {} if {}", quantity, value, unit, otherwise, unit, condition);
}

std::vector<ValueDoubt> value_doubts(DeviceResult const& device) {
  std::vector<ValueDoubt> doubts;
  auto const damping = stated_damping(device);
  if (!damping || !(*damping > 0.0)) return doubts;
  // `points`: by how many percentage points the effect raises the damping.
  auto const add = [&](std::optional<double> points, FindingKind kind) {
    if (!points || std::abs(*points) < least_share * *damping) return;
    doubts.push_back({.quantity = std::string(rules::name(rules::Quantity::damping)),
                      .value = *damping,
                      .otherwise = std::max(0.0, *damping - *points),
                      .unit = "%",
                      .condition = wording::remark({.kind = kind})});
  };
  auto const skew = effect_of(device, data::damping_by_skew);
  add(skew, skew.value_or(0.0) < 0.0 ? FindingKind::if_late_force_is_moved : FindingKind::if_force_is_early);
  auto const jump = effect_of(device, data::damping_by_jump);
  auto const& corrections = device.raw.corrections;
  bool const friction_is_off =
      std::ranges::find(corrections, FindingKind::friction_removed, &Finding::kind) != corrections.end();
  add(jump, FindingKind::if_jump_is_of_rig);
  if (!jump && !friction_is_off) add(effect_of(device, data::damping_by_rig_friction), FindingKind::if_rig_rubs);
  return doubts;
}

}  // namespace isolaw::study
