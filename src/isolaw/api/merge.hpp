// One call from the parts of a campaign to the whole of it.
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
  campaign::RunOptions run = {};  // of the analyses
  bool fresh = false;             // replaces another campaign in the directory
  std::function<void(campaign::MissingRun const&)> missing = {};
};

// Puts into `directory` the runs of `parts`, directories of CalibrateOptions::part (or their stores), as `isolaw merge`
// does, and ends as calibrate() of the whole does: the same bytes in the store and in the reports. The contents are
// incomplete where it was interrupted. Throws Error: a part that is damaged, or of another campaign, build or
// instruction set; parts that are not there and runs that are missing, what was there having been copied.
campaign::Contents merge(std::filesystem::path const& directory, std::vector<std::filesystem::path> const& parts,
                         MergeCallOptions const& options = {});

// Its first half, for who finishes by other means and holds the directory: what is missing is told, not thrown.
campaign::Merged merge_runs(DirectoryLock const& lock, std::filesystem::path const& directory,
                            std::vector<std::filesystem::path> const& parts, MergeCallOptions const& options);
// Whether a part is named by itself, not by its directory. Throws Error where it lies in the directory merged into.
std::filesystem::path store_of_part(std::filesystem::path const& part, std::filesystem::path const& directory,
                                    std::string const& name = store_name);

}  // namespace isolaw
