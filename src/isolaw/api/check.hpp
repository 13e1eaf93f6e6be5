// Checks the directory of a campaign, of the analysis of a building, or of both, for the command and Python.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/check.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw {

struct CheckedBuilding {
  std::size_t runs = 0, expected_runs = 0;  // runs checked against the hashes stored with them
  std::vector<std::string> faults;          // one sentence each

  bool is_sound() const { return faults.empty(); }
};

struct CheckedCampaign {
  // `check` also has an entry for each report or table beside the store that differs from what the store gives, unless
  // the file is only outdated. The entry is a fault or, if another build made the store, a difference.
  campaign::Check check;
  std::string missing;             // what an incomplete campaign still has to compute; empty if it is complete
  std::size_t compared_files = 0;  // reports and tables beside the store
  std::size_t outdated_files = 0;  // the number of compared files that were written before the last runs
  std::size_t runs_since = 0;      // the number of runs that were added after these files were written
  bool other_rules = false;        // the files state other rules, design values or lot size than the store
  std::string made_by;             // the builds that computed the store; empty if it was this build alone

  bool is_sound() const { return check.faults.empty() && check.differences.empty() && runs_since == 0; }
};

struct CheckedDirectory {
  std::optional<CheckedCampaign> campaign;
  std::optional<CheckedBuilding> building;

  bool is_sound() const { return (!campaign || campaign->is_sound()) && (!building || building->is_sound()); }
};

// A sentence about an incomplete campaign or a part of one: what it lacks, and how to go on.
std::string what_is_missing(study::Summary const& summary);
// Throws Error if `directory` holds neither a campaign nor the analysis of a building.
CheckedDirectory check_directory(std::filesystem::path const& directory);

}  // namespace isolaw
