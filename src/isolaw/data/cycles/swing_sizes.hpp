// The small and the large swings of a device's tests. A law that is fitted to the small ones and judged on the large
// ones shows how well it predicts motions that are larger than those it was fitted to.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/cycles/swings.hpp"

namespace isolaw::data {

// A swing is small if |x| at both of its turns is at most this share of the largest |x| at any turn of the tests.
inline constexpr double small_swing = 0.7;

struct SwingSizes {
  // The weights of a test's samples within its small and within its large swings. A list is empty if the test takes no
  // part: less than a twentieth of its weight lies in such swings.
  struct Test {
    std::vector<double> small, large;
  };
  std::vector<Test> tests = {};  // as the records
  // Whether the tests show how a law goes on to larger swings: they have at least two large and four small swings, and
  // each of the two sizes holds at least a twentieth of the weight, as a mean over the tests.
  bool tell = false;
};

// The record's swings of which the objective counts every sample.
std::vector<Swing> scored_swings(FitRecord const& record);

// Swings with a sample that the objective does not count are left out. A record's weights must be those of `weighting`,
// or empty for those of time.
SwingSizes swing_sizes(std::span<FitRecord const> tests, Weighting weighting);

}  // namespace isolaw::data
