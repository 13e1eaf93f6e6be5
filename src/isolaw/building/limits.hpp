// Judges whether a building holds: whether its responses keep the limits of the building file, and whether its bearings
// stay within the displacement of the tests.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>
#include "isolaw/building/distribution.hpp"

namespace isolaw::building {

// Building codes let a design use the mean response only with at least this number of motions (EN 1998-1, 4.3.3.4.3;
// ASCE 7-16, 17.3.3; chapter 16 of ASCE 7-16 asks for eleven).
inline constexpr std::size_t motions_for_a_mean = 7;

struct LimitInfo {
  std::string_view key;       // the limit's key in [limits] of a building file
  std::string_view quantity;  // Quantity::key of the response that it limits
  std::optional<double> ResponseLimits::*value;
  std::string_view help;
};
inline constexpr LimitInfo limit_rows[]{
    {"bearing_mm", "isolator_mm", &ResponseLimits::bearing_mm, "largest displacement that a bearing may have"},
    {"clearance_mm", "corner_mm", &ResponseLimits::clearance_mm,
     "displacement for which a corner of the base has room"},
    {"base_shear_over_weight", "shear_over_weight", &ResponseLimits::base_shear_over_weight,
     "sum of the forces of all bearings, divided by the weight"},
    {"floor_acceleration_g", "floor_acceleration_g", &ResponseLimits::floor_acceleration_g,
     "acceleration of any floor or of the base"},
};
// The text in LimitCheck::limit for the largest displacement to which the devices were tested. It is no key of the
// file.
inline constexpr std::string_view tested_mm = "tested_mm";

enum class LimitKept { yes, no, open };
std::string_view name(LimitKept keeps);

// Whether the buildings with one law keep one limit. Each response below is the one that building codes use for design:
// the mean over the motions if there are at least motions_for_a_mean of them, else the largest.
struct LimitCheck {
  std::string_view limit;       // LimitInfo::key, or tested_mm for the displacement of the tests
  std::string_view quantity;    // Quantity::key of the response
  double allowed = 0.0;         // the limit, in the unit of the quantity like all responses below
  double nominal = 0.0;         // response of the nominal building
  std::optional<double> bound;  // the larger response of the two bound analyses; NaN if one gave no finite numbers
  std::optional<double> p95;    // response that 95 % of the draws do not exceed, if bearings are drawn
  // Share of the draws that keep the limit, with its 95 % interval. A building that collapsed in the model keeps none.
  std::optional<double> share_kept, share_kept_low, share_kept_high;
  // `no` if the nominal building or a bound analysis breaks the limit, or if fewer than wanted_share of the draws keep
  // it. `open` if the draws are too few to tell whether wanted_share of all buildings keep it.
  LimitKept limit_kept = LimitKept::open;
  // The first of "nominal", "bounds" and "draws" that does not keep the limit, or "nominal failed" or "bounds failed"
  // if this analysis gave no finite numbers. Empty if the limit is kept or open.
  std::string_view broken_by = {};
  // draws_that_tell() if `limit_kept` is open: how many draws would be enough.
  std::optional<std::size_t> draws_wanted = {};
};
// Judges one limit. If `places` is given, `responses` holds all cases of places->cases. If not, `responses` holds the
// nominal building only, and only this is judged.
LimitCheck check_limit(std::string_view limit, std::string_view quantity, double allowed, Responses const& responses,
                       CasePlaces const* places = nullptr, bool has_draws = false);

}  // namespace isolaw::building
