// Judges whether the two bound analyses of a building cover the responses of its draws. A bound analysis multiplies all
// forces of the bearings by the lower or the upper factor. A draw is the building with bearings drawn from the lot.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>
#include "isolaw/base/finding.hpp"
#include "isolaw/building/distribution.hpp"
#include "isolaw/building/quantities.hpp"

namespace isolaw::building {

// The bounds suffice if the responses of the two bound analyses enclose this share of the drawn buildings.
inline constexpr double wanted_share = 0.95;

struct Coverage {
  std::string_view quantity;  // Quantity::key of the response that is compared
  double share_inside = 0.0;  // share of the draws whose response lies between those of the two bound analyses, 0 to 1
  // The 95 % confidence interval of `share_inside`, Clopper and Pearson 1934.
  double interval_low = 0.0, interval_high = 0.0;
  // Shares of the draws with a response below both bounds, and above both. A response that is not finite counts as
  // above.
  double share_below = 0.0, share_above = 0.0;
  // The narrowest factors 1 - a and 1 + a on all forces that suffice: the analyses with these factors and those between
  // them (grid_factor) enclose `wanted_share` of the draws. nullopt if even all analyses of the grid together enclose
  // fewer draws.
  std::optional<double> factor_low, factor_high;
  // FindingKind::bounds_not_monotonic if the nominal response is not between those of the bound analyses.
  std::optional<Finding> monotony = {};
  std::string not_monotonic = {};  // the sentence of `monotony`, in kN and mm; empty if `monotony` is
};
Finding covering_factors(Coverage const& coverage);

// `draws` holds the responses of the draws, and `grid` those of the analyses with all forces times grid_factor(i). If a
// building collapsed in the model, its response is not a number; it then lies outside of all bounds.
Coverage coverage_of(Quantity const& quantity, std::vector<double> const& draws, Distribution const& d,
                     std::vector<double> const& grid);

// Clopper and Pearson's confidence interval of the share found / trials. It is 0 to 1 without trials.
std::array<double, 2> binomial_interval(std::size_t found, std::size_t trials, double level = 0.95);
// The number of draws that would be enough to show that at least wanted_share of all buildings keep a limit, if the
// share of draws that keep it stays at found / trials: the least number for which the confidence interval of this share
// begins at wanted_share or above. nullopt if a hundred thousand draws are too few.
std::optional<std::size_t> draws_that_tell(std::size_t found, std::size_t trials);

}  // namespace isolaw::building
