// Devices x laws x runs: identified in parallel, stored as they finish.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/estimate.hpp"
#include "isolaw/campaign/profile.hpp"

namespace isolaw::campaign {

struct Progress {
  std::size_t done = 0, total = 0;     // of these
  bool analysis = false;               // of analyses, not of runs
  std::map<std::string, double> best;  // best objective so far per law
  double share = 0.0;                  // of all work, runs and analyses, what was there before counted as done
  double left_s = 0.0;                 // time until the end of the last of them, as far as can be told
};

struct RunOptions {
  int jobs = 0;                                    // threads, up to most_jobs; 0: one per core
  std::function<void(Progress const&)> progress;   // called from one thread at a time; must not throw
  std::function<bool()> interrupted;               // asked between generations or starts, from any thread
  std::function<void(int)> short_of_threads = {};  // told at the end how many there were where the system gave fewer
  Profile* profile = nullptr;                      // what the phases cost is added to it
  std::optional<Part> share = {};                  // of the analyses: see AnalyseOptions
  TaskDone task_done = {};                         // told of every run and analysis, as `progress` is
};

// Runs what `store` does not hold yet and adds it. The result of a run depends on (seed, device name, law, number) and
// the settings alone. Finished runs are kept whatever happens; returns false when interrupted before the last one.
bool run(Contents& contents, std::filesystem::path const& store, RunOptions const& options);

}  // namespace isolaw::campaign
