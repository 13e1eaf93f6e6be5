// The analyses of a building: run by as many threads as there are, kept in one SQLite file, continued where they were
// interrupted. Rows are written in one order whatever the threads do.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "isolaw/building/lanes.hpp"
#include "isolaw/building/sources.hpp"

namespace isolaw::building {

struct Study {
  BuildingFile file;
  std::vector<LawSource> laws;
};

class RunStore {
 public:
  // Opens or creates the file. `of` says what the runs are of: another in the file is refused (Error), unless `fresh`.
  RunStore(std::filesystem::path const& file, std::string const& of, bool fresh);
  ~RunStore();
  RunStore(RunStore const&) = delete;
  RunStore& operator=(RunStore const&) = delete;

  struct Row {
    std::size_t law = 0, motion = 0, place = 0;  // place: in cases_of()
    std::vector<double> measured;
  };
  std::size_t tasks_done() const;  // from the first on
  void add(std::size_t tasks_done, std::vector<Row> const& rows);
  // take(place, measured) for every run of a law under a motion, in order.
  void each(std::size_t law, std::size_t motion,
            std::function<void(std::size_t, std::vector<double> const&)> const& take) const;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

// Everything that the numbers depend on, as text.
std::string fingerprint(Study const& study);

struct RunProgress {
  std::size_t done = 0, total = 0;  // analyses
};
// Throws Error as Devices; std::runtime_error of what `progress` throws ends the runs, those stored remain.
void run_all(Study const& study, RunStore& store, std::size_t threads,
             std::function<void(RunProgress const&)> const& progress = {});

// The step of the explicit path for a law under a motion: that of the settings, halved where the bearings are stiffer.
Options options_of(Study const& study, Model const& model, Devices const& devices);

}  // namespace isolaw::building
