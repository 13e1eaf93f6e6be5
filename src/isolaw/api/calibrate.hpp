// One call that fits laws to records and finishes with a campaign and its reports.
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
  std::optional<std::filesystem::path> directory = {};  // for store and reports; empty: none are kept
  bool fresh = false;                                   // start over if the directory holds a campaign
  std::string title = {};                               // the lot's title in its reports
  campaign::Acceptance acceptance = {};                 // rule set and design values for the tests, see load_rules()
  std::optional<campaign::Part> part = {};              // compute only this share, for merge(); needs a directory
};

struct Calibrated : campaign::Contents {  // with the differences from the directory's campaign before
  Continued continued = {};
};

// Loads the text of the named rule set unless it is loaded, and checks it and the design values. Throws Error.
void load_rules(campaign::Acceptance& acceptance);
// Computes the missing runs and analyses of the store's campaign, whose contents are given, and writes its reports
// beside the store, but none for a part. Returns the contents as read from the store, incomplete after an interruption.
campaign::Contents finish_campaign(campaign::Contents contents, std::filesystem::path const& store,
                                   campaign::RunOptions const& options);
// Fits `settings.laws` (the usual laws if empty) to every record, as `isolaw calibrate` does: the same settings,
// records, names and seed give the same numbers, whatever the number of threads. After an interruption complete() is
// false; the same call continues a campaign that has a directory. Throws Error for empty or repeated names, wrong
// settings, no usable record, an unusable directory, and a part without a directory.
Calibrated calibrate(std::vector<campaign::NamedRecord> records, campaign::Settings const& settings,
                     CalibrateOptions const& options = {});

}  // namespace isolaw
