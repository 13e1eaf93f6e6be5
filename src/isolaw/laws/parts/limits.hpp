// Physical limits that many parameters share, and the sizes of a record that search boxes are scaled by.
#pragma once

#include <limits>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr Interval any_value{-infinity, infinity};
inline constexpr Interval not_negative{0.0, infinity};
inline constexpr Interval not_positive{-infinity, 0.0};
inline constexpr Interval positive{std::numeric_limits<double>::min(), infinity};

// A speed below 1e-146, in any unit, counts as rest: its square would lose digits or underflow.
inline constexpr double smallest_square = 1e-292;

constexpr double one(RecordScales const&) {
  return 1.0;
}
constexpr double disp(RecordScales const& s) {
  return s.disp;
}
constexpr double force(RecordScales const& s) {
  return s.force;
}
constexpr double strength(RecordScales const& s) {
  return s.strength;
}
constexpr double velocity(RecordScales const& s) {
  return s.velocity;
}
constexpr double stiffness(RecordScales const& s) {
  return s.stiffness;
}
constexpr double stiffness_per_disp2(RecordScales const& s) {
  return s.stiffness / (s.disp * s.disp);
}
constexpr double stiffness_per_disp4(RecordScales const& s) {
  return s.stiffness / (s.disp * s.disp * s.disp * s.disp);
}
constexpr double strength_per_disp2(RecordScales const& s) {
  return s.strength / (s.disp * s.disp);
}
constexpr double per_disp(RecordScales const& s) {
  return 1.0 / s.disp;
}
constexpr double per_velocity(RecordScales const& s) {
  return 1.0 / s.velocity;
}
constexpr double per_work(RecordScales const& s) {
  return 1.0 / s.work;
}
constexpr double disp_per_work(RecordScales const& s) {
  return s.disp / s.work;
}

}  // namespace isolaw::laws
