// Merges the parts of a campaign into one store.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "isolaw/campaign/merge_stores.hpp"

namespace isolaw::campaign {

struct MissingRun {
  std::string device, law;
  int number = 0;
  int part = 0;  // the part that should hold it; 0 if the number of parts is not known
};

struct MergeOptions {
  std::function<void()> before_replacing = {};          // see StoreKind::create
  std::function<void(MissingRun const&)> missing = {};  // called for each missing run, in the order of results
  bool fresh = false;                                   // see Merge::run
};

// Merges as Merge::run() does, and copies the analyses from those stores that hold all runs. Memory holds the records
// and one run at a time.
MergeResult merge(std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts,
                  MergeOptions const& options = {});

}  // namespace isolaw::campaign
