// Merges the parts of a campaign into the whole campaign in one call.
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
  campaign::RunOptions run = {};                                  // for analyses after the merge
  bool fresh = false;                                             // discards another campaign in the directory
  std::function<void(campaign::MissingRun const&)> missing = {};  // called for each run that is in no part
};

// Copies the runs of `parts` into `directory`, like the command `isolaw merge`, then makes analyses and reports. A part
// is the directory of a calibrate() call with CalibrateOptions::part, or its store. The files are the same, byte by
// byte, as those of a campaign that was not divided into parts; after an interruption they are incomplete. Throws Error
// for a damaged part and for a part of another campaign, build or instruction set. If parts or runs are missing, it
// copies all others before it throws Error.
campaign::Contents merge(std::filesystem::path const& directory, std::vector<std::filesystem::path> const& parts,
                         MergeCallOptions const& options = {});

// Does the first half of merge(): copies the runs only. The caller holds the lock on the directory. For each missing
// run it calls options.missing and throws nothing.
campaign::MergeResult merge_runs(DirectoryLock const& lock, std::filesystem::path const& directory,
                                 std::vector<std::filesystem::path> const& parts, MergeCallOptions const& options);
// Returns `part` if it is a file, else the file `name` in the folder `part`. Throws Error if this file is the store of
// `directory` itself.
std::filesystem::path store_of_part(std::filesystem::path const& part, std::filesystem::path const& directory,
                                    std::string const& name = store_name);

}  // namespace isolaw
