// Tells whether a finished store can be trusted: checks the file itself and computes its numbers again.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace isolaw::campaign {

struct Check {
  std::size_t devices = 0, searches = 0, runs = 0, expected_runs = 0, analyses = 0, expected_analyses = 0;
  double largest_difference = 0.0;       // the largest relative difference between a stored and a recomputed objective
  std::vector<std::string> faults;       // one sentence each; empty if the store is sound
  std::vector<std::string> differences;  // values that another build stored and this one computes differently
  bool of_another_build = false;         // whether another build computed any part of the store
};

// Runs SQLite's own check and checks indices and lengths. Cleans each raw record and makes each box again, and compares
// them with the stored ones. A run's parameters must lie in the box. The parameters of runs, of optima, and of the laws
// of the lot with and without each device must give the stored objectives. No objective of a profile may be below its
// optimum. Intervals are not computed again. Values may differ by fit::evaluation_tolerance, since another machine may
// have computed them. Throws Error if the file is no store.
Check check(std::filesystem::path const& file);

}  // namespace isolaw::campaign
