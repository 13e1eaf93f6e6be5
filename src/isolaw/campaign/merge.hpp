// Merges the parts of a campaign into one store, after checking that campaign, build and instruction set are the same.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

struct MissingRun {
  std::string device, law;
  int number = 0;
  int part = 0;  // the part that should hold it; 0 if the number of parts is not known
};

struct Merged {
  std::size_t added = 0, there = 0;  // runs copied, and runs that `out` held already or that came twice
  std::size_t analyses = 0;          // copied
  std::size_t missing = 0;
  int parts = 0;                          // the number of parts of the campaign; 0 if no store holds it
  std::vector<std::string> absent;        // given paths that do not exist
  std::map<int, std::size_t> missing_of;  // missing runs by MissingRun::part
};
// "5 runs are missing, of part 4/7 (4 runs), 5/7 (1 run)"; empty if none is missing.
std::string missing_text(Merged const& merged);
// Two refusals that merges of campaigns and of buildings share. The first throws Error if `absent` is not empty, since
// parts that are missing must not replace `out`. The second always throws: fewer runs would replace a complete `out`.
void refuse_absent(std::filesystem::path const& out, std::vector<std::string> const& absent);
[[noreturn]] void refuse_to_replace_whole(std::filesystem::path const& out, Merged const& merged);

struct MergeOptions {
  std::function<void()> before_replacing = {};                  // see Store::create
  std::function<void(std::size_t, std::size_t)> progress = {};  // called with the parts copied and their total
  std::function<void(MissingRun const&)> missing = {};          // called for each missing run, in the order of results
  bool fresh = false;  // replaces `out`, after everything that takes its place was checked and copied
};

// Adds the runs of the stores `parts` to the store `out`, which is created if it is missing, and the analyses of those
// stores that hold all runs. The order of the parts does not matter, and one may be given twice. All parts are checked
// before the first is copied. Each is copied in one transaction, so the same call completes a merge that was stopped.
// Memory holds the records and one run at a time. Throws Error for a store that is damaged or of another campaign,
// build or instruction set, for runs that contradict each other, and if `out` is a part itself or would lose runs.
Merged merge(std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts,
             MergeOptions const& options = {});

}  // namespace isolaw::campaign
