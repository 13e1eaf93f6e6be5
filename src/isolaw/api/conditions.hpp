// The tests that a study of conditions compares. They come from a lot file, from a caller that passes the tables of a
// lot file as values, or from a campaign.
#pragma once

#include <filesystem>
#include <string>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/observed_tests.hpp"

namespace isolaw {

// Reads a lot file. The module `rules` checks the rule set and the design values in it. Throws Error as
// campaign::read_lot_file() does.
campaign::Lot read_lot(std::filesystem::path const& file, campaign::LotFileOptions options = {});
// Does the same for a JSON object with the tables of a lot file. The files that they name are sought in `folder`.
campaign::Lot read_lot(Json const& tables, std::filesystem::path const& folder, campaign::LotFileOptions options = {});

struct ConditionsSource {  // the input of study::build_conditions()
  campaign::ObservedTests observed;
  std::string title;
  campaign::Acceptance acceptance;
};

// `source` is a lot file with a table [conditions], whose records are then read, or the directory of a campaign that
// was made from such a file. A test that cannot be used has a refusal with the reason. Throws Error if there is no
// table [conditions], and for all faults of the lot file.
ConditionsSource conditions_source(std::filesystem::path const& source, bool allow_outside);
ConditionsSource conditions_source(Json const& tables, std::filesystem::path const& folder, bool allow_outside);

}  // namespace isolaw
