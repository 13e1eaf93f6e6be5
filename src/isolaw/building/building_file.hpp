// Reads BUILDING.toml: a building on bearings, the ground motions and the analyses to compute. Each key is a FileKey,
// one row of a table that serves the reader, the messages and the template alike.
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
#include "isolaw/data/channels/ground_motion.hpp"

namespace isolaw::building {

// Factors on the elastic and on the hysteretic part of a bearing's forces.
struct PartFactors {
  double elastic = 1.0, hysteretic = 1.0;
  bool is_whole() const { return elastic == hysteretic; }
  bool operator==(PartFactors const&) const = default;
};
constexpr PartFactors whole(double factor) {
  return {factor, factor};
}

// The table [building] of a building file.
struct Settings {
  std::string title = {};
  std::vector<std::string> laws = {};  // ids of the laws to compute; empty: the law that the campaign recommends
  int draws = 500;
  // How often the population is estimated again (population_again()). The scatter of these estimates shows how
  // uncertain the medians are because only few devices were tested. If the number is below 2, the reports do not show
  // this.
  int populations = 0;
  int draws_of_each = 20;
  int seed = 1;
  double damping = 0.02;
  // Factors of the bound analyses, on the forces of every bearing. If empty, LawSource::lower and upper apply, which
  // give the bounds over the design conditions of the lot.
  std::optional<PartFactors> lower = whole(0.0), upper = whole(0.0);
  double step_s = 0.005;
  double rest_s = 5.0;
};

// The table [limits] of a building file: the largest responses that the building may have.
struct ResponseLimits {
  std::optional<double> bearing_mm, clearance_mm, base_shear_over_weight, floor_acceleration_g;
};

// Which bearing stands on a place: a draw from the lot, the lot's law, a tested device, or the lot's law times the
// lower or upper factor.
enum class BearingKind { draw, lot, device, lower, upper };
// Returns the word that stands for `kind` in a building file. For BearingKind::device, where a building file has the
// name of the device, it returns "tested device".
std::string_view name(BearingKind kind);
struct BearingPlace {
  Point at;
  BearingKind kind = BearingKind::draw;
  std::string device;  // the device's name if `kind` is BearingKind::device, else empty
};

struct BuildingFile {
  std::string file;
  Settings settings;
  ResponseLimits limits = {};
  Frame frame;
  std::vector<BearingPlace> bearings;
  std::optional<std::array<double, 4>> plan_mm;  // edges of the slab in plan: left and right in x, front and back in y
  std::vector<Motion> motions;
  // The factors `scale` of the file's own motions, if ReplacedKeys::motions has taken the place of these motions.
  std::vector<double> replaced_scales = {};

  Plan plan() const;
};

// The structs from Slab to FileTables are the tables of a building file, in the file's units. FileTables has one member
// for each table. For a list such as [[floor]] it holds the one table of the list that is being read or written. The
// initial values of required keys are those that building_template() shows, except for the files of motions and the
// factors of [building].
struct Slab {
  double mass_Mg = 700.0, gyration_m = 9.0, x_m = 0.0, y_m = 0.0;
};
struct EqualFloors : Slab {
  int count = 5;
  double period_x_s = 0.5, period_y_s = 0.5, rotation_ratio = 1.3;
};
struct FloorRow : Slab {
  double stiffness_x_kN_per_mm = 1200.0, stiffness_y_kN_per_mm = 1200.0, stiffness_rotation_GNm = 150.0;
  double stiffness_at_x_m = 0.0, stiffness_at_y_m = 0.0;
};
struct GridRow {
  int count_x = 7, count_y = 4;
  double spacing_x_m = 6.0, spacing_y_m = 6.0;
  std::string kind_or_device = "draw";
};
struct BearingRow {
  double x_m = 0.0, y_m = 0.0;
  std::string kind_or_device = "draw";
};
struct PlanRow {
  double left_m = -20.0, right_m = 20.0, front_m = -11.0, back_m = 11.0;
};
struct MotionRow {
  std::string x, y;
  double scale = 1.0;
  data::StatedMotion stated = {.how_step = "step_s", .how_unit = "unit", .where = " in its [[motion]]"};
};
struct FileTables {
  Settings building = {};
  ResponseLimits limits = {};
  Slab base = {};
  EqualFloors floors = {};
  FloorRow floor = {};
  GridRow grid = {};
  BearingRow bearing = {};
  PlanRow plan = {};
  MotionRow motion = {};
};

// A key of a building file, as one row of a table. Files are read, checked and written by this table. The keys of
// [building] are also keyword arguments in Python.
struct FileKey : Option<FileTables> {
  std::string_view table;
  bool required = false;  // true: the key has no default, and a file without it is refused
  // For a key of [building]: true if a run's numbers depend on its value, so that a store of runs keeps it.
  bool changes_runs = true;
};
std::span<FileKey const> settings_table();  // the keys of [building]

struct ReplacedKeys {
  std::vector<Motion> motions = {};  // if there are any, they replace all motions of the file
  isolaw::Values settings = {};      // new values for keys of [building]
};

// Options of the command line for facts that the files given to --motion do not state, such as the time step.
std::span<Option<data::StatedMotion> const> stated_table();
// Reads a motion along x from one file, "x.AT2", or along x and y from two, "x.AT2,y.AT2". Throws Error.
Motion read_motion(std::string const& files, data::StatedMotion const& stated = {});
// Reads several motions. `stated` holds values of stated_table(). Throws one Error with the complaints about all of
// them.
std::vector<Motion> read_motions(std::vector<std::string> const& files, isolaw::Values const& stated = {});
// Throws Error for fewer than two samples, values that are not finite, a step not in (0, 10] s, and components of
// different length.
void require_sound(Motion const& motion);
// read_building() and read_building_text() throw one Error with all complaints and their lines. Paths of motions are
// relative to the folder of `file`, or to `folder`.
BuildingFile read_building(std::filesystem::path const& file, ReplacedKeys const& in_place = {});
BuildingFile read_building_text(std::string_view text, std::string const& name, std::filesystem::path const& folder,
                                ReplacedKeys const& in_place = {});
// Reads the tables from JSON, with names as in a file. Paths of motions are relative to the working directory.
BuildingFile building_of(Json const& tables, ReplacedKeys const& in_place = {});
std::string building_template(int motions = 1);

}  // namespace isolaw::building
