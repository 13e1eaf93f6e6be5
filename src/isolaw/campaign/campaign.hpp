// Computes a campaign in parallel: the runs of every law on every device, then the analyses. Each result is stored as
// soon as it is computed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/profile.hpp"

namespace isolaw::campaign {

struct Progress {
  std::size_t done = 0, total = 0;     // runs or analyses
  bool analysis = false;               // whether `done` and `total` count analyses
  std::map<std::string, double> best;  // best objective so far, by law
  std::span<Run const> runs = {};      // all finished runs, those stored earlier too
  std::string law = {}, device = {};   // of the latest result; `device` is empty for a result on the lot
  double share = 0.0;                  // estimated share of all work that is done, including work stored earlier
  double left_s = 0.0;                 // estimated time until all runs and analyses are done
};

struct RunOptions {
  int jobs = 0;                                        // threads, up to most_jobs; 0: one per core
  std::function<void(Progress const&)> progress = {};  // called from one thread at a time; must not throw
  std::function<bool()> interrupted = {};              // called between generations or starts, from any thread
  std::function<void(int)> short_of_threads = {};  // called at the end with the number of threads, if less than `jobs`
  Profile* profile = nullptr;                      // if given, gets the time and work of each phase
  std::optional<Part> share = {};                  // the part of the analyses to make: see AnalyseOptions
};

// Computes the runs and analyses that `store` does not hold yet and adds them. The result of a run depends only on
// (seed, device name, law, number) and the settings. Finished runs are kept whatever happens. Returns whether the
// campaign, or the part of it in `store`, is complete now.
bool run(Contents& contents, std::filesystem::path const& store, RunOptions const& options);

}  // namespace isolaw::campaign
