// Devices x laws x runs: prepared, identified in parallel, stored as they finish.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/lot_file.hpp"

namespace isolaw::campaign {

// Reads and cleans every record and makes every box. A device that cannot be used is kept with its reason; throws Error
// only when none is usable.
Contents prepare(Lot const& lot);

// A record that a program holds already; its name counts as a device's in a lot file does.
struct NamedRecord {
  std::string name;
  data::TestRecord record;
  DeviceInfo info = {};
};
// The same of these. Throws Error also for names that no lot file could hold.
Contents prepare(std::vector<NamedRecord> records, Settings const& settings, std::string const& title);

// Only that: devices as they are read and cleaned, no boxes, none of the laws. Never throws for a device.
Contents prepare_devices(Lot const& lot);

// Where a law is searched on a record under these settings.
fit::SearchBox search_box(laws::LawEntry const& law, data::FitRecord const& record, Settings const& settings);

struct Progress {
  std::size_t done = 0, total = 0;
  bool analysis = false;               // of analyses, not of runs
  std::map<std::string, double> best;  // best objective so far per law
};

struct RunOptions {
  int jobs = 0;                                    // threads; 0: one per core
  std::function<void(Progress const&)> progress;   // called from one thread at a time; must not throw
  std::function<bool()> interrupted;               // asked between generations or starts, from any thread
  std::function<void(int)> short_of_threads = {};  // told at the end how many there were where the system gave fewer
};

// Runs what `store` does not hold yet and adds it. The result of a run depends on (seed, device name, law, number) and
// the settings alone. Finished runs are kept whatever happens; returns false when interrupted before the last one.
bool run(Contents& contents, std::filesystem::path const& store, RunOptions const& options);

}  // namespace isolaw::campaign
