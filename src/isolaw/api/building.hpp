// One call that studies an isolated building on devices drawn from a campaign's lot, as `isolaw building` does.
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

// Accelerations of the ground in m/s^2, [steps], at equal steps from time 0. A motion in one direction has an empty y.
struct GroundMotion {
  std::string name;
  double step_s = 0.0;
  std::vector<double> x_m_s2;
  std::vector<double> y_m_s2 = {};
};

struct BuildingInput {
  std::filesystem::path file = {};                                 // a building file (isolaw building --template)
  std::string text = {};                                           // or the text of one, which replaces it
  std::vector<GroundMotion> motions = {};                          // replace the file's motions, if not empty
  std::vector<std::pair<std::string, std::string>> settings = {};  // replace keys of [building]: {"draws", "200"}
};

struct BuildingOptions {
  int jobs = 0;                                                            // threads; 0: one per core
  std::optional<std::filesystem::path> directory = {};                     // for runs and reports; empty: none are kept
  bool fresh = false;                                                      // start over if the directory holds a study
  std::function<void(std::size_t done, std::size_t total)> progress = {};  // in analyses; one thread at a time calls it
  std::function<bool()> interrupted = {};                                  // asked between analyses, from any thread
};

// The nominal building under one motion, by the implicit path. Every member has one element per step.
struct BuildingHistory {
  std::vector<double> time_s;
  std::vector<std::array<double, 3>> base;              // base relative to the ground: x and y in mm, rotation in rad
  std::vector<std::array<double, 2>> shear_kN;          // sum of the bearings' forces along x and y
  std::vector<std::vector<double>> acceleration_mm_s2;  // absolute, x and y of the base, then of every floor
};

class Building {
 public:
  explicit Building(std::shared_ptr<StudiedBuilding const> study) : study_(std::move(study)) {}
  bool complete() const;  // false after an interruption: verdict(), bounds_are_enough() and json() then throw
  std::string verdict() const;
  std::optional<bool> bounds_are_enough() const;
  std::string json() const;  // building.json
  std::vector<std::string> laws() const;
  std::size_t draws() const;
  std::size_t motions() const;
  // A quantity of building.json, in its unit, for every draw: [law][draw][motion], NaN if a run gave no finite numbers.
  // Throws Error for an unknown quantity.
  std::vector<double> peaks(std::string_view quantity = "isolator_mm") const;
  // Throws Error if `law` or `motion` is not below laws().size() or motions().
  BuildingHistory history(std::size_t law, std::size_t motion) const;

 private:
  std::shared_ptr<StudiedBuilding const> study_;
};

// With equal settings, motions and campaign the directory gets the same bytes as from the program, whatever the number
// of threads. Throws Error for a wrong building, a law that was not analysed, and another study in the directory.
Building study_building(BuildingInput const& input, campaign::Contents const& contents,
                        BuildingOptions const& options = {});

}  // namespace isolaw
