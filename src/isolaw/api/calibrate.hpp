// One call from records to a finished campaign.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw {

struct CalibrateOptions {
  campaign::RunOptions run = {};                        // threads, progress, interruption
  std::optional<std::filesystem::path> directory = {};  // where store and reports are kept; empty: nowhere
  bool fresh = false;                                   // start over where the directory holds another campaign
  std::string title = {};                               // of the lot, in its reports
  campaign::Acceptance acceptance = {};                 // what the tests are held to, see load_rules()
  std::optional<campaign::Part> part = {};              // its share of the runs alone, for merge(); has a directory
};

// A campaign's contents, and what was there of it in its directory.
struct Calibrated : campaign::Contents {
  Continued continued = {};
};

// Loads the rule set that is named and not yet there, and checks it and the design values. Throws Error.
void load_rules(campaign::Acceptance& acceptance);

// Brings the campaign of a store to its end, of which `contents` are, and writes its reports; what it returns is what
// another program would read there. Incomplete where it was interrupted; a part has no reports.
campaign::Contents finish_campaign(campaign::Contents contents, std::filesystem::path const& store,
                                   campaign::RunOptions const& options);

// Fits `settings.laws` (all where empty) to every record, as `isolaw calibrate` does: the same settings, records, names
// and seed give the same numbers, whatever the number of threads. A campaign that was interrupted is incomplete
// (complete() is false); one with a directory is continued by the same call. Throws Error: names that are empty or
// repeated, settings, no usable record, the directory, a part without one.
Calibrated calibrate(std::vector<campaign::NamedRecord> records, campaign::Settings const& settings,
                     CalibrateOptions const& options = {});

}  // namespace isolaw
