// Whether a finished store can be trusted: the file itself, and every number in it that can be computed again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace isolaw::campaign {

struct Check {
  std::size_t devices = 0, searches = 0, runs = 0, expected_runs = 0, analyses = 0, expected_analyses = 0;
  double largest_difference = 0.0;  // of an objective computed again, relative
  std::vector<std::string> faults;  // one sentence each; empty: sound
  // What another build computed and this one computes otherwise, which then is no fault; and whether it did.
  std::vector<std::string> differences;
  bool of_another_build = false;
};

// SQLite's own check of the file; that indices and lengths fit; that each device's raw record cleaned again is the
// record the laws saw, and the boxes are those made from it; that each run's parameters give its objective and lie in
// the box, and so for the optima, the laws of the lot and those without one device; profiles and intervals are held to
// their optimum alone. Values are compared within fit::evaluation_tolerance, so that another machine may check.
// Throws Error when the file is not a store at all.
Check check(std::filesystem::path const& file);

}  // namespace isolaw::campaign
