// BUILDING.toml: a building on bearings, the motions it is shaken with and what is asked of it. Each key is one row of
// a table, from which the reader, the messages and the template are made.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/option.hpp"
#include "isolaw/building/integrate.hpp"

namespace isolaw::building {

// What is asked, [building].
struct Settings {
  std::string title;
  std::vector<std::string> laws;  // empty: the one that the campaign recommends
  int draws = 1000;
  int populations = 0;  // drawn again of the tests' own uncertainty; 0: the population is taken as known
  int draws_of_each = 20;
  int seed = 1;
  double damping = 0.02;
  double lower = 0.0, upper = 0.0;  // factors on the forces of every bearing: the bound analyses
  double step_s = 0.005;
  double rest_s = 5.0;
};

// What stands at a place.
enum class Stands { draw, lot, device, lower, upper };
std::string_view name(Stands stands);  // as a building file says it; of a device its name stands there
struct BearingPlace {
  Point at;
  Stands stands = Stands::draw;
  std::string device;  // of Stands::device
};

struct BuildingFile {
  std::string file;
  Settings settings;
  Frame frame;
  std::vector<BearingPlace> bearings;
  std::optional<std::array<double, 4>> plan_mm;  // left, right, front, back
  std::vector<Motion> motions;

  Plan plan() const;
  // No motion shakes it along y.
  bool along_x_alone() const;
};

// A key of a table of the file; those of [building] are Python's keywords too. What is required has no usual value.
template <class Target>
struct FileKey : Option<Target> {
  bool required = false;
};
std::span<FileKey<Settings> const> settings_table();

// In place of what a building file has.
struct ReplacedKeys {
  std::vector<Motion> motions = {};  // of those of the file, where there are any
  isolaw::Values settings = {};      // of the keys of [building], by key
};

// A motion of a file, "x.AT2", or of two, "x.AT2,y.AT2". Throws Error.
Motion read_motion(std::string const& files);
// The same of many: one Error of everything wrong.
std::vector<Motion> read_motions(std::vector<std::string> const& files);
// Throws Error: no samples, a value or a step that is none, components of different length.
void require_sound(Motion const& motion);

// Throws one Error of everything wrong, with lines.
BuildingFile read_building(std::filesystem::path const& file, ReplacedKeys const& in_place = {});
BuildingFile read_building_text(std::string_view text, std::string const& name, std::filesystem::path const& folder,
                                ReplacedKeys const& in_place = {});
// Tables as a file has them, by their names; files of motions are sought in the working directory.
BuildingFile building_of(Json const& tables, ReplacedKeys const& in_place = {});

// A commented file of a building with five floors on 28 bearings.
std::string building_template();

}  // namespace isolaw::building
