// Studies a building on devices from a lot, for the command, Python and api/building.hpp. The header is not installed,
// because it needs Eigen.
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
// Makes the study of a building file and a campaign. If the file names no law, the study uses the recommended law.
// `where` names the campaign in messages. Throws Error for a law that was not analysed.
building::Study building_study(building::BuildingFile file, campaign::Contents const& contents,
                               std::string const& where = "the campaign");
// Makes the model of a study's building and lot. Callers do this before they write anything, since it throws Error if
// the building or the lot cannot be analysed.
building::Model checked_model(building::Study const& study);

struct BuildingWork {
  int jobs = 0;                                         // number of threads; 0 for one per core
  std::optional<std::filesystem::path> directory = {};  // for runs and reports; if empty, none are kept
  bool fresh = false;                                   // discards a study that the directory holds
  building::StudyPart part = {};                        // computes only this part of the runs; needs a directory
  std::function<void(building::RunProgress const&)> progress = {};
  std::function<bool()> interrupted = {};
};

struct StudiedBuilding {
  building::Study study;
  bool complete = false;                     // false after an interruption
  std::size_t runs = 0;                      // number of runs in the store
  std::string lost = {};                     // a sentence if `fresh` replaced a damaged or empty file; else empty
  std::optional<building::Answers> answers;  // empty if the study is incomplete or only a part of its runs was computed
  // The layout.count() measured numbers of each run, [law][draw][motion][number]. All are NaN if the run gave no finite
  // numbers.
  std::vector<double> measured;
  building::Layout layout;
};

// Returns the values of a quantity of building.json for each law, draw and motion; the motion changes fastest. Throws
// Error for an unknown quantity.
std::vector<double> peaks_of(StudiedBuilding const& studied, std::string_view quantity);
// Computes the runs that the directory does not hold yet, or all runs without a directory, and writes the reports. The
// files are the same, byte by byte, as those of the command. Throws Error for a building that cannot be analysed, for
// another study in the directory, and for a part without a directory.
StudiedBuilding study_building(building::Study study, BuildingWork const& options = {});

}  // namespace isolaw
