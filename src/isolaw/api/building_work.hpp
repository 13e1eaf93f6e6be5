// A building on devices from a campaign's lot, for the command, Python and api/building.hpp. Not public: needs Eigen.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/building/answers.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/building/runs.hpp"
#include "isolaw/campaign/contents.hpp"

namespace isolaw {

inline constexpr char const* building_store_name = "building.sqlite";
// Puts a building (building::read_building, building::building_of) on bearings of a campaign's lot. A building without
// a law takes the recommended one. `where` names the campaign in messages. Throws Error for a law not analysed.
building::Study building_study(building::BuildingFile file, campaign::Contents const& contents,
                               std::string const& where = "the campaign");
// The study's model. Called before anything is written. Throws Error for a building or a lot that cannot be analysed.
building::Model possible(building::Study const& study);

struct BuildingWork {
  int jobs = 0;                                         // threads; 0: one per core
  std::optional<std::filesystem::path> directory = {};  // for runs and reports; empty: none are kept
  bool fresh = false;                                   // start over if the directory holds a study
  building::StudyPart part = {};                        // the share of the runs to compute; a part needs a directory
  std::function<void(building::RunProgress const&)> progress = {};
  std::function<bool()> interrupted = {};
};

struct StudiedBuilding {
  building::Study study;
  bool complete = false;                     // false after an interruption
  std::size_t runs = 0;                      // in the store
  std::optional<building::Answers> answers;  // of a complete study that is not a part
  // Rows of building::Layout::count() measures for the draws: [law][draw][motion]. NaN if a run gave none.
  std::vector<double> measured;
  building::Layout layout;
};

// A quantity of every draw: [law][draw][motion]. Throws Error for an unknown quantity.
std::vector<double> peaks_of(StudiedBuilding const& studied, std::string_view quantity);
// Computes the runs that the directory does not hold yet (without a directory: all) and writes its reports. Store and
// reports have the same bytes as the program's, whatever the number of threads. Throws Error for a building that cannot
// be analysed, for another study in the directory, and for a part without a directory.
StudiedBuilding study_building(building::Study study, BuildingWork const& options = {});

}  // namespace isolaw
