// Describes how a response of the building is distributed over the draws of a study, and how much of its spread is due
// to the motions and how much to the lot.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>
#include "isolaw/building/runs.hpp"

namespace isolaw::building {

// For each of these shares, the answers give the response that this share of the draws does not exceed.
inline constexpr std::array shares{0.16, 0.50, 0.84, 0.95};
// The fractiles at `shares`. A draw without finite numbers counts as larger than all others, so a fractile that falls
// on such a draw is NaN. Without values all fractiles are NaN.
std::array<double, 4> fractiles(std::vector<double> values);
// A standard deviation or a mean over draws is given only if at least this share of the draws has finite numbers,
// because the draws without finite numbers are not a random selection.
inline constexpr double least_finite_share = 0.95;

// Bins of equal width from the smallest value to the largest. There is one bin if all values are equal.
struct Histogram {
  double from = 0.0, width = 0.0;
  std::vector<std::uint64_t> counts;
};
Histogram histogram(std::vector<double> const& values);

struct Distribution {
  // The response in the unit of the quantity, as a mean over the motions: of the nominal building and of the two bound
  // analyses, and the fractiles of the draws at `shares`.
  double nominal = 0.0, lower = 0.0, upper = 0.0;
  std::array<double, 4> fractiles{};
  // The standard deviations of ln(response) due to the motions and due to the lot, by the law of total variance, and
  // the share of the lot in the variance of ln(response). All three are NaN if fewer than least_finite_share of the
  // draws have finite numbers under some motion.
  double motion_std_ln = 0.0, lot_std_ln = 0.0, lot_share = 0.0;
  // Standard deviation of ln(median of the draws) over the populations that were estimated again (population_again()).
  std::optional<double> uncertain_std_ln;
  // Under each motion: the fractiles of the draws at `shares`, and the response of the nominal building.
  std::vector<std::array<double, 4>> by_motion;
  std::vector<double> nominal_by_motion;
  Histogram histogram = {};  // of the draws' responses (means over the motions); those that are not finite are left out
};

// The list that cases_of() returns, and the index at which each kind of case begins in it.
struct CasePlaces {
  explicit CasePlaces(Settings const& settings);
  std::vector<Case> cases;
  std::size_t first_draw = 0, draws = 0, first_uncertain = 0, first_factor = 0;
};

// The values of one quantity in all runs of a law.
struct Responses {
  std::vector<std::vector<double>> by_motion;  // [motion][case of CasePlaces::cases]
  std::vector<double> mean;                    // for each case the mean over the motions
};
// `kept` is [motion][quantity][case], with one motion or more: a building file without motions is refused.
Responses responses_of(std::vector<std::vector<std::vector<double>>> const& kept, std::size_t quantity);
std::vector<double> part_of(std::vector<double> const& values, std::size_t first, std::size_t count);
std::vector<double> finite_of(std::vector<double> values);

Distribution distribution_of(Responses const& responses, CasePlaces const& places, Settings const& settings);
// Standard deviation of ln(value); NaN if there are fewer than two values or if a value is not above 0.
double spread_ln(std::vector<double> const& values);

}  // namespace isolaw::building
