// Fits laws to records in one call and returns a campaign. Writes the reports if a directory is given.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw {

struct CalibrateOptions {
  campaign::RunOptions run = {};  // number of threads, and functions that report progress and ask for an interruption
  std::optional<std::filesystem::path> directory = {};  // for store and reports; if empty, none are kept
  bool fresh = false;                                   // discards a campaign that the directory holds
  std::string title = {};                               // title of the lot in the reports
  campaign::Acceptance acceptance =
      {};  // the rule set and design values for judging the tests; see complete_acceptance()
  std::optional<campaign::Part> part = {};  // computes only this part of the runs, for merge(); needs a directory
};

struct Calibrated : campaign::Contents {  // a campaign and, if it continues a stored one, what it adds to that
  Continuation continued = {};
};

// Fills in `acceptance`: if it has only the names of the files of a rule set or a letterhead, reads these files. Throws
// Error if a file or the design values are wrong.
void complete_acceptance(campaign::Acceptance& acceptance);
// Returns remarks on design values that are allowed but probably a mistake: design values without a rule set, or
// damping given as a share instead of a percentage.
std::vector<Complaint> remarks_on_design(campaign::Acceptance const& acceptance);
// Computes the runs and analyses that are missing in the store of this campaign. Writes the reports beside the store,
// unless the store holds only a part of a campaign. Returns what the store then holds, which is incomplete after an
// interruption.
campaign::Contents finish_campaign(campaign::Contents contents, std::filesystem::path const& store,
                                   campaign::RunOptions const& options);
// Fits `settings.laws` (the usual laws if empty) to every record, as the command `isolaw calibrate` does. The same
// settings, records, names and seed give the same numbers, whatever the number of threads. After an interruption
// complete() is false, and the same call with the same directory continues the campaign. Throws Error for empty or
// repeated names, wrong settings, no usable record, an unusable directory, and if `options` ask for a part of the
// campaign's runs but give no directory to keep it in.
Calibrated calibrate(std::vector<campaign::NamedRecord> records, campaign::Settings const& settings,
                     CalibrateOptions const& options = {});

}  // namespace isolaw
