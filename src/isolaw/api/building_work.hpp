// One call from a building and a campaign to what the lot's scatter makes of it: what the command, Python and
// api/building.hpp do. Not public: these headers need Eigen.
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

// A building (building::read_building, building::building_of) on bearings of a campaign's lot. Without laws it takes
// the one that the campaign recommends. `where` is the campaign in messages. Throws Error: a law that was not analysed.
building::Study building_study(building::BuildingFile file, campaign::Contents const& contents,
                               std::string const& where = "the campaign");

// Its model; asked before anything is made. Throws Error: what is no building, or of no lot.
building::Model possible(building::Study const& study);

struct BuildingWork {
  int jobs = 0;                                         // threads; 0: one per core
  std::optional<std::filesystem::path> directory = {};  // where runs and reports are kept; empty: nowhere
  bool fresh = false;                                   // start over where another building is there
  std::optional<campaign::Part> part = {};              // its share of the runs alone; has a directory
  std::vector<building::Trait> words_of_part = {};      // kept with a part, for the answers of its whole
  std::function<void(building::RunProgress const&)> progress = {};
  std::function<bool()> interrupted = {};
};

struct StudiedBuilding {
  building::Study study;
  bool complete = false;                     // not interrupted
  std::size_t runs = 0;                      // in the store
  std::optional<building::Answers> answers;  // of a complete study
  // Of the draws, in rows of building::Layout::count() numbers: [law][draw][motion]. NaN where a run gave none.
  std::vector<double> measured;
  building::Layout layout;
};

// A quantity of every draw: [law][draw][motion]. Throws Error: no such quantity.
std::vector<double> peaks_of(StudiedBuilding const& of, std::string_view quantity);

// Computes the runs, or those that a directory does not hold yet, and writes the reports there; the same bytes in store
// and reports as the program's, whatever the number of threads. Throws Error: what is no building, another study in
// the directory, a part without one.
StudiedBuilding study_building(building::Study study, BuildingWork const& options = {});

}  // namespace isolaw
