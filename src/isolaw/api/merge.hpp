// One call that merges the parts of a campaign into the whole campaign.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "isolaw/api/calibrate.hpp"
#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/campaign/merge.hpp"

namespace isolaw {

struct MergeCallOptions {
  campaign::RunOptions run = {};                                  // for the analyses that follow the merge
  bool fresh = false;                                             // replaces another campaign in the directory
  std::function<void(campaign::MissingRun const&)> missing = {};  // called for every run that no part holds
};

// Copies the runs of `parts`, which are directories of CalibrateOptions::part or their stores, into `directory` as
// `isolaw merge` does. Then it finishes as calibrate() of the whole campaign would, with the same bytes in store and
// reports. After an interruption the contents are incomplete. Throws Error for a part that is damaged or belongs to
// another campaign, build or instruction set, and, after copying the rest, for missing parts or runs.
campaign::Contents merge(std::filesystem::path const& directory, std::vector<std::filesystem::path> const& parts,
                         MergeCallOptions const& options = {});

// The first half of merge(), for callers that hold the lock: missing runs go to options.missing and do not throw.
campaign::Merged merge_runs(DirectoryLock const& lock, std::filesystem::path const& directory,
                            std::vector<std::filesystem::path> const& parts, MergeCallOptions const& options);
// The store of a part: `part` itself if it is a file, else `name` in it. Throws Error for the store of `directory`.
std::filesystem::path store_of_part(std::filesystem::path const& part, std::filesystem::path const& directory,
                                    std::string const& name = store_name);

}  // namespace isolaw
