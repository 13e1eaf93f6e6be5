// Sorts the swings of a device's tests into small and large ones. A law that is fitted to the small swings and judged
// on the large swings shows how well it predicts larger motions than it was fitted to.
#pragma once

#include <span>
#include <vector>

#include "isolaw/data/channels/record.hpp"
#include "isolaw/data/cycles/swings.hpp"

namespace isolaw::data {

// A swing is small if |x| at both of its turns is at most this share of the largest |x| at any turn of the tests.
inline constexpr double small_swing = 0.7;

struct SwingSizes {
  // The weights of a test's samples within its small swings, and within its large swings. If the swings of one size
  // hold less than a twentieth of the weight of all swings of the test, the list for this size is empty, because the
  // test shows too little about it.
  struct Test {
    std::vector<double> small, large;
  };
  std::vector<Test> tests = {};  // one for each record
  // Whether the tests show how a law predicts larger swings. For this they need at least two large and four small
  // swings, and each of the two sizes must hold at least a twentieth of the swings' weight, on average over the tests.
  bool shows_larger_swings = false;
};

// Returns the swings of the record in which the objective counts every sample.
std::vector<Swing> scored_swings(FitRecord const& record);

// Sorts the swings of `tests` by size. Leaves out swings with a sample that the objective does not count. `weighting`
// must be the weighting with which the records' weights were made. Records without weights are weighted by time.
SwingSizes swing_sizes(std::span<FitRecord const> tests, Weighting weighting);

}  // namespace isolaw::data
