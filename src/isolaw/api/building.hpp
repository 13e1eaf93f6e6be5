// Studies an isolated building on devices drawn from a campaign's lot in one call, like the command `isolaw building`.
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

// Accelerations of the ground in m/s^2, at equal time steps from time 0. y is empty for a motion in one direction.
struct GroundMotion {
  std::string name;
  double step_s = 0.0;
  std::vector<double> x_m_s2;
  std::vector<double> y_m_s2 = {};
};

struct BuildingInput {
  std::filesystem::path file = {};         // path of a building file; isolaw building --template writes one
  std::string text = {};                   // contents of a building file; if given, `file` is not read
  std::vector<GroundMotion> motions = {};  // if given, these replace the motions in the file
  std::vector<std::pair<std::string, std::string>> settings = {};  // new values in [building]: {"draws", "200"}
};

struct BuildingOptions {
  int jobs = 0;                                         // number of threads; 0 for one per core
  std::optional<std::filesystem::path> directory = {};  // for runs and reports; if empty, none are kept
  bool fresh = false;                                   // discards a study that the directory holds
  std::function<void(std::size_t done, std::size_t total)> progress = {};  // after each analysis, one thread at a time
  std::function<bool()> interrupted = {};                                  // called between analyses, from any thread
};

// The response of the nominal building to a motion, by the implicit integrator. Each vector has one element for each
// time step.
struct BuildingHistory {
  std::vector<double> time_s;
  std::vector<std::array<double, 3>> base;              // relative to the ground: x and y in mm, rotation in rad
  std::vector<std::array<double, 2>> shear_kN;          // sum of all bearings, along x and y
  std::vector<std::vector<double>> acceleration_mm_s2;  // absolute: x and y of the base, then x and y of each floor
};

class Building {
 public:
  explicit Building(std::shared_ptr<StudiedBuilding const> study) : study_(std::move(study)) {}
  bool complete() const;  // false after an interruption; verdict(), bounds_are_enough() and json() then throw
  std::string verdict() const;
  std::optional<bool> bounds_are_enough() const;
  std::string json() const;  // the text of building.json
  std::vector<std::string> laws() const;
  std::size_t draws() const;
  std::size_t motions() const;
  // The values of a quantity of building.json for each law, draw and motion, row by row: the motion changes fastest,
  // the law slowest. A value is NaN if the run gave no finite number. Throws Error for an unknown quantity.
  std::vector<double> peaks(std::string_view quantity = "isolator_mm") const;
  // `law` counts from 0 in laws(), and `motion` counts from 0 to motions() - 1. Throws Error for a larger number.
  BuildingHistory history(std::size_t law, std::size_t motion) const;

 private:
  std::shared_ptr<StudiedBuilding const> study_;
};

// Studies the building. The files are the same, byte by byte, as those of the command for the same settings, motions
// and campaign. Throws Error for a wrong building, a law that was not analysed, or another study in the directory.
Building study_building(BuildingInput const& input, campaign::Contents const& contents,
                        BuildingOptions const& options = {});

}  // namespace isolaw
