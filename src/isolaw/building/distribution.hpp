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

inline constexpr std::array shares{0.16, 0.50, 0.84, 0.95};   // the fractiles that the answers give
std::array<double, 4> fractiles(std::vector<double> values);  // at `shares`; NaN without values

// Bins of equal width from the smallest value to the largest. There is one bin if all values are equal.
struct Histogram {
  double from = 0.0, width = 0.0;
  std::vector<std::uint64_t> counts;
};
Histogram histogram(std::vector<double> const& values);

struct Distribution {
  double nominal = 0.0, lower = 0.0, upper = 0.0;  // the three analyses without draws, means over the motions
  std::array<double, 4> fractiles{};               // at `shares`, of the draws' means over the motions
  // The standard deviations of ln(response) due to the motions and due to the lot, by the law of total variance.
  double motion_std_ln = 0.0, lot_std_ln = 0.0;
  double lot_share = 0.0;                        // share of the lot in the variance of ln(response)
  std::optional<double> uncertain_std_ln;        // standard deviation of ln(median) over the re-estimated populations
  std::vector<std::array<double, 4>> by_motion;  // [motion] fractiles of the draws
  std::vector<double> nominal_by_motion;
  Histogram histogram = {};  // of the draws' means over the motions
};

// The list that cases_of() returns, and where each kind of case begins in it.
struct CasePlaces {
  explicit CasePlaces(Settings const& settings);
  std::vector<Case> cases;
  std::size_t first_draw = 0, draws = 0, first_uncertain = 0, first_factor = 0;
};

// The values of one quantity in all runs of a law.
struct Responses {
  std::vector<std::vector<double>> by_motion;  // [motion][case]
  std::vector<double> mean;                    // [case] mean over the motions
};
// `kept` is [motion][quantity][case], with one motion or more: a building file without motions is refused.
Responses responses_of(std::vector<std::vector<std::vector<double>>> const& kept, std::size_t quantity);
std::vector<double> finite_part(std::vector<double> const& values, std::size_t first, std::size_t count);

Distribution distribution_of(Responses const& responses, CasePlaces const& places, Settings const& settings);
// Standard deviation of ln(value), over the values above 0; 0 if there are fewer than two.
double spread_ln(std::vector<double> const& values);

}  // namespace isolaw::building
