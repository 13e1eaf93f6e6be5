// One call from a building and a campaign to what the lot's scatter makes of it, as `isolaw building`.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw {

struct StudiedBuilding;

// Accelerations of the ground at equal steps, the first at time 0; without y of one direction.
struct GroundMotion {
  std::string name;
  double step_s = 0.0;
  std::vector<double> x_m_s2;
  std::vector<double> y_m_s2 = {};
};

struct BuildingInput {
  std::filesystem::path file = {};                                 // a building file (isolaw building --template)
  std::string text = {};                                           // or what would stand in one
  std::vector<GroundMotion> motions = {};                          // in place of its own
  std::vector<std::pair<std::string, std::string>> settings = {};  // of [building]: {"draws", "200"}
};

struct BuildingOptions {
  int jobs = 0;                                         // threads; 0: one per core
  std::optional<std::filesystem::path> directory = {};  // where runs and reports are kept; empty: nowhere
  bool fresh = false;                                   // start over where another building is there
  std::function<void(std::size_t done, std::size_t total)> progress = {};  // analyses; one thread at a time
  std::function<bool()> interrupted = {};                                  // asked between them, from any thread
};

// The nominal building under one motion, by the implicit path: of the base relative to the ground along x and y in mm
// and its rotation, and the sum of the bearings' forces on it.
struct BuildingHistory {
  std::vector<double> time_s;
  std::vector<std::array<double, 3>> base;
  std::vector<std::array<double, 2>> shear_kN;
  std::vector<std::vector<double>> acceleration_mm_s2;  // in space, of the base and every floor: x and y of each
};

class Building {
 public:
  explicit Building(std::shared_ptr<StudiedBuilding const> of) : of_(std::move(of)) {}
  bool complete() const;  // not interrupted; nothing else is there otherwise
  std::string verdict() const;
  std::optional<bool> bounds_are_enough() const;
  std::string json() const;  // building.json
  std::vector<std::string> laws() const;
  std::size_t draws() const;
  std::size_t motions() const;
  // A quantity of building.json of every draw: [law][draw][motion]; NaN where a run gave none. Throws Error.
  std::vector<double> peaks(std::string_view quantity = "isolator_mm") const;
  // Throws Error: no such law or motion.
  BuildingHistory history(std::size_t law, std::size_t motion) const;

 private:
  std::shared_ptr<StudiedBuilding const> of_;
};

// The same settings, motions and campaign give the same bytes in a directory as the program writes, whatever the number
// of threads. Throws Error: all that is wrong in the building, a law that was not analysed, another study there.
Building study_building(BuildingInput const& input, campaign::Contents const& contents,
                        BuildingOptions const& options = {});

}  // namespace isolaw
