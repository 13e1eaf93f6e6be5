// The tests that a study of conditions compares. They come from a lot file, from the same tables in a program, or from
// a campaign.
#pragma once

#include <filesystem>
#include <string>

#include "isolaw/base/option.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/observed_tests.hpp"

namespace isolaw {

// Reads a lot file, including its rule set and design values, which the module `rules` checks. Throws Error as
// campaign::read_lot_file() does.
campaign::Lot read_lot(std::filesystem::path const& file, campaign::LotFileOptions options = {});
// The same for the tables of a lot file. The files that they name are sought in `folder`.
campaign::Lot read_lot(Json const& tables, std::filesystem::path const& folder, campaign::LotFileOptions options = {});

struct ConditionsSource {  // what study::build_conditions() takes
  campaign::ObservedTests observed;
  std::string title;
  campaign::Acceptance acceptance;
};

// `source` is a lot file with a table [conditions], or the directory of a campaign that was made from one. Reads the
// records of a lot file. A test that cannot be used says why. Throws Error if there is no such table, and with
// everything that is wrong in the lot file.
ConditionsSource conditions_source(std::filesystem::path const& source, bool allow_outside);
ConditionsSource conditions_source(Json const& tables, std::filesystem::path const& folder, bool allow_outside);

}  // namespace isolaw
