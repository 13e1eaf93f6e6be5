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
  std::optional<std::filesystem::path> directory = {};  // where store and reports are kept; empty: nowhere
  bool fresh = false;                                   // start over where the directory holds a campaign
  std::string title = {};                               // the lot's title in its reports
  campaign::Acceptance acceptance = {};                 // rule set and design values for the tests, see load_rules()
  std::optional<campaign::Part> part = {};              // compute only this share, for merge(); needs a directory
};

struct Calibrated : campaign::Contents {  // and how they differ from what the directory held before
  Continued continued = {};
};

// Loads the text of the named rule set where it is not loaded yet, and checks it and the design values. Throws Error.
void load_rules(campaign::Acceptance& acceptance);
// Computes what is missing in the store's campaign, whose contents are given, and writes its reports beside the store;
// a part has none. Returns the contents as another program would read them, incomplete after an interruption.
campaign::Contents finish_campaign(campaign::Contents contents, std::filesystem::path const& store,
                                   campaign::RunOptions const& options);
// Fits `settings.laws` (the usual laws where empty) to every record, as `isolaw calibrate` does: the same settings,
// records, names and seed give the same numbers, whatever the number of threads. After an interruption complete() is
// false; the same call continues a campaign that has a directory. Throws Error for empty or repeated names, wrong
// settings, no usable record, an unusable directory, and a part without a directory.
Calibrated calibrate(std::vector<campaign::NamedRecord> records, campaign::Settings const& settings,
                     CalibrateOptions const& options = {});

}  // namespace isolaw
