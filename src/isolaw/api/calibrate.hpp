// One call from records to a finished campaign.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/campaign.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw {

struct CalibrateOptions {
  campaign::RunOptions run = {};                        // threads, progress, interruption
  std::optional<std::filesystem::path> directory = {};  // where store and reports are kept; empty: nowhere
  bool fresh = false;                                   // start over where the directory holds another campaign
  std::string title = {};                               // of the lot, in its reports
};

// Fits `settings.laws` (all where empty) to every record, as `isolaw calibrate` does: the same settings, records, names
// and seed give the same numbers, whatever the number of threads. A campaign that was interrupted is incomplete
// (complete() is false); one with a directory is continued by the same call. Throws Error: names that are empty or
// repeated, settings, no usable record, the directory.
campaign::Contents calibrate(std::vector<campaign::NamedRecord> records, campaign::Settings const& settings,
                             CalibrateOptions const& options = {});

}  // namespace isolaw
