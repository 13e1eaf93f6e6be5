// Reads BUILDING.toml: a building on bearings, the ground motions and the analyses to compute. Each key is one row of a
// table, which the reader, the messages and the template share.
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

// The table [building].
struct Settings {
  std::string title;
  std::vector<std::string> laws;  // empty: the law that the campaign recommends
  int draws = 1000;
  int populations = 0;  // estimated again within the tests' uncertainty; 0: the population is taken as known
  int draws_of_each = 20;
  int seed = 1;
  double damping = 0.02;
  double lower = 0.0, upper = 0.0;  // factors of the bound analyses, on the forces of every bearing
  double step_s = 0.005;
  double rest_s = 5.0;
};

// The device at a place: drawn from the lot, the lot's law, a tested device, or the lot's law times a bound's factor.
enum class Stands { draw, lot, device, lower, upper };
std::string_view name(Stands stands);  // the word in building files, or "tested device"
struct BearingPlace {
  Point at;
  Stands stands = Stands::draw;
  std::string device;  // name; empty unless Stands::device
};

struct BuildingFile {
  std::string file;
  Settings settings;
  Frame frame;
  std::vector<BearingPlace> bearings;
  std::optional<std::array<double, 4>> plan_mm;  // left, right, front, back
  std::vector<Motion> motions;

  Plan plan() const;
  bool along_x_alone() const;
};

// A key in a table of the file. The keys of [building] are Python keywords too. A required key has no default.
template <class Target>
struct FileKey : Option<Target> {
  bool required = false;
};
std::span<FileKey<Settings> const> settings_table();

struct ReplacedKeys {
  std::vector<Motion> motions = {};  // if there are any, they replace all motions
  isolaw::Values settings = {};      // by key of [building]
};

// Reads a motion from one file, "x.AT2", or two, "x.AT2,y.AT2". Throws Error.
Motion read_motion(std::string const& files);
// Reads many; throws one Error with the complaints about all of them.
std::vector<Motion> read_motions(std::vector<std::string> const& files);
// Throws Error for fewer than two samples, values that are not finite, a step not in (0, 10] s, and components of
// different length.
void require_sound(Motion const& motion);
// Throws one Error with all complaints and their lines. Paths of motions are relative to the file, or to `folder`.
BuildingFile read_building(std::filesystem::path const& file, ReplacedKeys const& in_place = {});
BuildingFile read_building_text(std::string_view text, std::string const& name, std::filesystem::path const& folder,
                                ReplacedKeys const& in_place = {});
// `tables` by name, as in a file; paths of motions are relative to the working directory.
BuildingFile building_of(Json const& tables, ReplacedKeys const& in_place = {});
std::string building_template(int motions = 1);

}  // namespace isolaw::building
