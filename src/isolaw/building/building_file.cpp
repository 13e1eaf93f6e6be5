#include "isolaw/building/building_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/option.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/toml_reader.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/data/ground_motion.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::building {
namespace {

constexpr double mm_in_m = 1e3;
constexpr std::size_t most_bearings = 2000, most_floors = 100;

// The tables of a building file in its units, with the template's values, which are the defaults except in [[motion]].
struct BaseRow {
  double mass_Mg = 700.0, gyration_m = 9.0, x_m = 0.0, y_m = 0.0;
};
struct EqualFloors {
  int count = 5;
  double mass_Mg = 700.0, gyration_m = 9.0, period_x_s = 0.5, period_y_s = 0.5, rotation_ratio = 1.3;
};
struct FloorRow {
  double mass_Mg = 700.0, gyration_m = 9.0, x_m = 0.0, y_m = 0.0;
  double stiffness_x_kN_per_mm = 1200.0, stiffness_y_kN_per_mm = 1200.0, stiffness_rotation_GNm = 150.0;
  double stiffness_at_x_m = 0.0, stiffness_at_y_m = 0.0;
};
struct GridRow {
  int along = 7, across = 4;
  double spacing_x_m = 6.0, spacing_y_m = 6.0;
  std::string is = "draw";
};
struct BearingRow {
  double x_m = 0.0, y_m = 0.0;
  std::string is = "draw";
};
struct PlanRow {
  double left_m = -20.0, right_m = 20.0, front_m = -11.0, back_m = 11.0;
};
struct MotionRow {
  std::string x = "motion-1-x.csv", y = "motion-1-y.csv";
  double scale = 0.5;
  std::optional<double> step_s;
};

template <class Target>
using TomlKey = FileKey<Target>;
template <class Target>
using TomlKeys = std::vector<TomlKey<Target>>;

template <class Target, class Access>
TomlKey<Target> real(std::string_view key, std::string help, Access place, Limits limits = {}, bool required = false) {
  auto option = number<Target>(key, help, place, std::move(limits));
  option.help = std::move(help);
  return {std::move(option), required};
}
template <class Target>
TomlKey<Target> text(std::string_view key, std::string help, std::string Target::*place, bool required = false) {
  return {{{.key = key, .help = std::move(help)},
           [place](Target const& from) -> Json { return from.*place; },
           [place](Target& to, Json const& value) { to.*place = text_in(value); }},
          required};
}

Limits positive(double most = 1e9) {
  return {.least = 1e-9, .most = most, .words = "a number above 0"};
}

TomlKeys<Settings> const& settings_keys() {
  static TomlKeys<Settings> const keys = [] {
    TomlKeys<Settings> rows;
    rows.push_back(text("title", "title of the report", &Settings::title));
    rows.push_back({{{.key = "laws",
                      .kind = Kind::list,
                      .help = "laws to compare, by id; an empty list: the one that the campaign recommends"},
                     [](Settings const& s) -> Json { return s.laws; },
                     [](Settings& s, Json const& value) {
                       s.laws.clear();
                       for (auto const& law : value.is_array() ? value : Json::array({value}))
                         s.laws.emplace_back(laws::find_law(text_in(law)).info.id);
                     }},
                    false});
    rows.push_back(real<Settings>("draws",
                                  "buildings to draw; each draws a device of its own for every bearing marked draw",
                                  at(&Settings::draws), {.least = 1, .most = 1e6}));
    rows.push_back(real<Settings>("populations",
                                  "re-estimated lots, which show how uncertain a few tests leave the lot; 0: none",
                                  at(&Settings::populations), {.least = 0, .most = 1e4}));
    rows.push_back(real<Settings>("draws_of_each", "buildings to draw from each of these lots",
                                  at(&Settings::draws_of_each), {.least = 2, .most = 1e4}));
    rows.push_back(real<Settings>("seed", "seed of all draws", at(&Settings::seed), {.least = 0, .most = 2147483647}));
    rows.push_back(real<Settings>("damping", "damping ratio of every mode of the superstructure on a fixed base",
                                  at(&Settings::damping), {.least = 0.0, .most = 0.5}));
    rows.push_back(real<Settings>("lower", "factor on the force of every bearing in the lower bound analysis",
                                  at(&Settings::lower), {.least = 0.05, .most = 1.0}, true));
    rows.push_back(real<Settings>("upper", "and in the upper bound analysis", at(&Settings::upper),
                                  {.least = 1.0, .most = 20.0}, true));
    rows.push_back(
        real<Settings>("step_s", "longest integration step", at(&Settings::step_s), {.least = 1e-5, .most = 0.05}));
    rows.push_back(real<Settings>(
        "rest_s", "seconds to continue after the ground motion ends, before the residual displacement is read",
        at(&Settings::rest_s), {.least = 0.0, .most = 120.0}));
    return rows;
  }();
  return keys;
}

template <class Row>
void slab_keys(TomlKeys<Row>& rows) {
  rows.push_back(real<Row>("mass_Mg", "mass in Mg (t)", at(&Row::mass_Mg), positive(), true));
  rows.push_back(
      real<Row>("gyration_m", "radius of gyration about the vertical axis", at(&Row::gyration_m), positive(1e4), true));
}
template <class Row>
void place_keys(TomlKeys<Row>& rows, std::string const& point) {
  Limits const within{.least = -1e4, .most = 1e4};
  rows.push_back(real<Row>("x_m", point + " in plan", at(&Row::x_m), within));
  rows.push_back(real<Row>("y_m", "", at(&Row::y_m), within));
}

TomlKeys<BaseRow> const& base_keys() {
  static auto const keys = [] {
    TomlKeys<BaseRow> rows;
    slab_keys(rows);
    place_keys(rows, "centre of mass");
    return rows;
  }();
  return keys;
}
TomlKeys<EqualFloors> const& equal_floors_keys() {
  static auto const keys = [] {
    TomlKeys<EqualFloors> rows{real<EqualFloors>("count", "floors above the base slab", at(&EqualFloors::count),
                                                 {.least = 0, .most = most_floors}, true)};
    slab_keys(rows);
    rows.push_back(real<EqualFloors>("period_x_s", "first period on a fixed base", at(&EqualFloors::period_x_s),
                                     positive(100.0), true));
    rows.push_back(real<EqualFloors>("period_y_s", "", at(&EqualFloors::period_y_s), positive(100.0), true));
    rows.push_back(real<EqualFloors>("rotation_ratio",
                                     "frequency of the first torsional mode over the lower of these two",
                                     at(&EqualFloors::rotation_ratio), positive(100.0)));
    return rows;
  }();
  return keys;
}
TomlKeys<FloorRow> const& floor_keys() {
  static auto const keys = [] {
    TomlKeys<FloorRow> rows;
    slab_keys(rows);
    place_keys(rows, "centre of mass");
    Limits const within{.least = -1e4, .most = 1e4};
    rows.push_back(real<FloorRow>("stiffness_x_kN_per_mm", "stiffness of the storey below it",
                                  at(&FloorRow::stiffness_x_kN_per_mm), positive(1e12), true));
    rows.push_back(
        real<FloorRow>("stiffness_y_kN_per_mm", "", at(&FloorRow::stiffness_y_kN_per_mm), positive(1e12), true));
    rows.push_back(real<FloorRow>("stiffness_rotation_GNm",
                                  "torsional stiffness in GN m per radian, about its centre of stiffness",
                                  at(&FloorRow::stiffness_rotation_GNm), positive(1e12), true));
    rows.push_back(
        real<FloorRow>("stiffness_at_x_m", "centre of stiffness in plan", at(&FloorRow::stiffness_at_x_m), within));
    rows.push_back(real<FloorRow>("stiffness_at_y_m", "", at(&FloorRow::stiffness_at_y_m), within));
    return rows;
  }();
  return keys;
}
constexpr std::string_view stands_help =
    "draw: a device drawn from the lot; lot: the lot's law; lower, upper: that law times the factor above; or the name of a tested device";
TomlKeys<GridRow> const& grid_keys() {
  static auto const keys = [] {
    Limits const many{.least = 1, .most = 200};
    return TomlKeys<GridRow>{
        real<GridRow>("along", "bearings along x, centred on the plan", at(&GridRow::along), many, true),
        real<GridRow>("across", "and along y", at(&GridRow::across), many, true),
        real<GridRow>("spacing_x_m", "", at(&GridRow::spacing_x_m), positive(1e3), true),
        real<GridRow>("spacing_y_m", "", at(&GridRow::spacing_y_m), positive(1e3), true),
        text("is", std::string(stands_help), &GridRow::is)};
  }();
  return keys;
}
TomlKeys<BearingRow> const& bearing_keys() {
  static auto const keys = [] {
    Limits const within{.least = -1e4, .most = 1e4};
    return TomlKeys<BearingRow>{real<BearingRow>("x_m", "place in plan", at(&BearingRow::x_m), within, true),
                                real<BearingRow>("y_m", "", at(&BearingRow::y_m), within, true),
                                text("is", std::string(stands_help), &BearingRow::is)};
  }();
  return keys;
}
TomlKeys<PlanRow> const& plan_keys() {
  static auto const keys = [] {
    Limits const within{.least = -1e4, .most = 1e4};
    return TomlKeys<PlanRow>{real<PlanRow>("left_m", "edges of the slab along x", at(&PlanRow::left_m), within, true),
                             real<PlanRow>("right_m", "", at(&PlanRow::right_m), within, true),
                             real<PlanRow>("front_m", "and along y", at(&PlanRow::front_m), within, true),
                             real<PlanRow>("back_m", "", at(&PlanRow::back_m), within, true)};
  }();
  return keys;
}
TomlKeys<MotionRow> const& motion_keys() {
  static auto const keys = TomlKeys<MotionRow>{
      text("x", "file of the ground acceleration along x: AT2, or columns with units", &MotionRow::x, true),
      text("y", "and along y; leave out for a single component", &MotionRow::y),
      real<MotionRow>("scale", "factor on both accelerations", at(&MotionRow::scale), positive(1e3)),
      real<MotionRow>("step_s", "seconds between samples, for files without time", at(&MotionRow::step_s),
                      positive(10.0))};
  return keys;
}

struct TableInfo {
  std::string_view name, help;
};
constexpr TableInfo settings_info{"building", "The analysis. Lengths in m, masses in Mg (t), times in s."},
    base_info{"base", "The slab on the bearings. All coordinates in plan share one system of axes."},
    floors_info{"floors", "Equal floors; or one [[floor]] for each, from the lowest up."},
    floor_info{"floor", "One floor and the storey below it, instead of [floors]."},
    grid_info{"grid", "Bearings on a regular grid; or one [[bearing]] for each."},
    bearing_info{"bearing", "One bearing, instead of or besides [grid]."},
    plan_info{"plan",
              "The edges of the slab. Its corners are where displacements are reported; no bearing may stand outside."},
    motion_info{"motion",
                "One ground motion each; files relative to this one. isolaw building --motion replaces them."};

template <class Row>
void read_row(toml::table const& from, std::string const& file, TableInfo const& info, TomlKeys<Row> const& keys,
              Row& row, std::vector<Complaint>& complaints) {
  TomlTable table(from, file, fmt::format("[{}]", info.name), complaints);
  for (auto const& key : keys) {
    table.json(key.key, [&](Json const& value) { key.set(row, value); });
    if (key.required && table.find(key.key) == nullptr)
      table.complain(fmt::format("[{}] has no {}", info.name, key.key),
                     key.limits ? key.limits->text() : std::string("a value"));
  }
  table.refuse_unknown();
}

template <class Row>
std::optional<Row> read_table(TomlTable& root, std::string const& file, TableInfo const& info,
                              TomlKeys<Row> const& keys, Row row, std::vector<Complaint>& complaints) {
  auto const* table = root.table(info.name);
  if (table == nullptr) return std::nullopt;
  read_row(*table, file, info, keys, row, complaints);
  return row;
}

template <class Row>
std::vector<Row> read_tables(TomlTable& root, std::string const& file, TableInfo const& info, TomlKeys<Row> const& keys,
                             Row const& usual, std::size_t most, std::vector<Complaint>& complaints) {
  std::vector<Row> rows;
  auto const* node = root.find(info.name);
  if (node == nullptr) return rows;
  auto const* list = node->as_array();
  if (list == nullptr || list->size() > most || !list->is_homogeneous(toml::node_type::table)) {
    root.complain(*node, fmt::format("'{}' is no list of tables", info.name),
                  fmt::format("[[{}]], {} of them at most", info.name, most));
    return rows;
  }
  for (auto const& item : *list) read_row(*item.as_table(), file, info, keys, rows.emplace_back(usual), complaints);
  return rows;
}

BearingPlace place_of(double x_m, double y_m, std::string const& is) {
  BearingPlace bearing{.at = {x_m * mm_in_m, y_m * mm_in_m}, .stands = Stands::device, .device = is};
  for (auto const stands : {Stands::draw, Stands::lot, Stands::lower, Stands::upper})
    if (is == name(stands)) bearing = {.at = bearing.at, .stands = stands, .device = {}};
  return bearing;
}

Motion motion_of(std::filesystem::path const& folder, MotionRow const& row) {
  auto const in = [&](std::string const& name) {
    std::filesystem::path const path(name);
    return path.is_absolute() ? path : folder / path;
  };
  auto const x = data::read_ground_motion(in(row.x), row.step_s);
  Motion motion{
      .name = std::filesystem::path(row.x).stem().string(), .step_s = x.step_s, .x_mm_s2 = x.acceleration_mm_s2};
  if (!row.y.empty()) {
    auto const y = data::read_ground_motion(in(row.y), row.step_s);
    if (y.acceleration_mm_s2.size() != motion.x_mm_s2.size() || std::abs(y.step_s - x.step_s) > 1e-6 * x.step_s)
      throw Error({.where = y.file,
                   .found = fmt::format("{} samples every {:.6g} s, and {} has {} every {:.6g} s",
                                        y.acceleration_mm_s2.size(), y.step_s, x.file, motion.x_mm_s2.size(), x.step_s),
                   .allowed = "two components of one length and step"});
    motion.y_mm_s2 = y.acceleration_mm_s2;
  }
  for (double& a : motion.x_mm_s2) a *= row.scale;
  for (double& a : motion.y_mm_s2) a *= row.scale;
  return motion;
}

// Converts JSON to the tables that the parser makes of a file, but without line numbers.
toml::table table_of(Json const& value, int depth);
toml::array array_of(Json const& value, int depth);
template <class Insert>
void insert_toml(Json const& value, int depth, Insert const& insert) {
  constexpr int deepest = 4;  // for example x_m of a [[bearing]]
  if (depth > deepest)
    throw Error({.where = "building", .found = "tables or lists nested deeper than any building needs"});
  if (value.is_object()) return insert(table_of(value, depth));
  if (value.is_array()) return insert(array_of(value, depth));
  if (value.is_boolean()) return insert(value.get<bool>());
  if (value.is_number_integer()) return insert(value.get<std::int64_t>());
  if (value.is_number()) return insert(value.get<double>());
  if (value.is_string()) return insert(value.get<std::string>());
  // null counts as not given
}
toml::table table_of(Json const& value, int depth) {
  toml::table table;
  for (auto const& [key, item] : value.items())
    insert_toml(item, depth + 1, [&, name = key](auto node) { table.insert(name, std::move(node)); });
  return table;
}
toml::array array_of(Json const& value, int depth) {
  toml::array array;
  for (auto const& item : value) insert_toml(item, depth + 1, [&](auto node) { array.push_back(std::move(node)); });
  return array;
}

MotionRow row_of(std::string const& files) {
  auto const comma = files.find(',');
  return {.x = files.substr(0, comma),
          .y = comma == std::string::npos ? "" : files.substr(comma + 1),
          .scale = 1.0,
          .step_s = {}};
}

void write_value(std::string& out, Json const& value) {
  if (value.is_string()) return void(out += fmt::format("\"{}\"", value.get<std::string>()));
  if (!value.is_array()) return void(out += value.dump());
  out += '[';
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (i > 0) out += ", ";
    write_value(out, value[i]);
  }
  out += ']';
}

template <class Row>
void write_table(std::string& out, TableInfo const& info, TomlKeys<Row> const& keys, Row const& row, bool list,
                 bool in_use) {
  std::string_view const off = in_use ? "" : "# ";
  out += fmt::format("\n# {}\n{}{}{}{}\n", info.help, off, list ? "[[" : "[", info.name, list ? "]]" : "]");
  for (auto const& key : keys) {
    auto const value = key.get(row);
    bool const given = !value.is_null() && in_use;
    out += fmt::format("{}{} = ", given ? "" : "# ", key.key);
    if (value.is_null())
      out += "0.01";
    else
      write_value(out, value);
    if (!key.help.empty()) out += fmt::format("  # {}", key.help);
    out += '\n';
  }
}

}  // namespace

std::string_view name(Stands stands) {
  switch (stands) {
    case Stands::draw:
      return "draw";
    case Stands::lot:
      return "lot";
    case Stands::lower:
      return "lower";
    case Stands::upper:
      return "upper";
    case Stands::device:
      return "tested device";
  }
  return "";
}

Plan BuildingFile::plan() const {
  Plan places;
  for (auto const& bearing : bearings) places.bearings.push_back(bearing.at);
  if (plan_mm) {
    auto const [left, right, front, back] = *plan_mm;
    places.corners = {{left, front}, {left, back}, {right, front}, {right, back}};
  }
  return places;
}

bool BuildingFile::along_x_alone() const {
  return std::ranges::all_of(motions, [](Motion const& motion) { return motion.y_mm_s2.empty(); });
}

std::string building_template(int motions) {
  std::string out =
      "# A building on isolators for `isolaw building`. Lines that start with # are explanations or not in use.\n";
  Settings settings;
  settings.title = "Five floors on 28 bearings";
  settings.lower = 0.9;
  settings.upper = 1.1;
  write_table(out, settings_info, settings_keys(), settings, false, true);
  write_table(out, base_info, base_keys(), BaseRow{}, false, true);
  write_table(out, floors_info, equal_floors_keys(), EqualFloors{}, false, true);
  write_table(out, floor_info, floor_keys(), FloorRow{}, true, false);
  write_table(out, grid_info, grid_keys(), GridRow{}, false, true);
  write_table(out, bearing_info, bearing_keys(), BearingRow{}, true, false);
  write_table(out, plan_info, plan_keys(), PlanRow{}, false, true);
  for (int i = 1; i <= motions; ++i) {
    MotionRow motion;
    motion.x = fmt::format("motion-{}-x.csv", i);
    motion.y = fmt::format("motion-{}-y.csv", i);
    write_table(out, motion_info, motion_keys(), motion, true, true);
  }
  return out;
}

std::span<FileKey<Settings> const> settings_table() {
  return settings_keys();
}

Motion read_motion(std::string const& files) {
  return motion_of({}, row_of(files));
}

std::vector<Motion> read_motions(std::vector<std::string> const& files) {
  std::vector<Motion> motions;
  std::vector<Complaint> complaints;
  for (auto const& file : files) {
    try {
      motions.push_back(read_motion(file));
    } catch (Error const& error) {
      complaints.insert(complaints.end(), error.complaints().begin(), error.complaints().end());
    }
  }
  if (!complaints.empty()) throw Error(std::move(complaints));
  return motions;
}

void require_sound(Motion const& motion) {
  auto const refuse = [&](std::string found, std::string allowed) {
    throw Error(
        {.where = "motion " + in_quotes(motion.name), .found = std::move(found), .allowed = std::move(allowed)});
  };
  constexpr double longest_step_s = 10.0;
  if (!(motion.step_s > 0.0 && motion.step_s <= longest_step_s))
    refuse(fmt::format("a step of {} s", motion.step_s), fmt::format("above 0, to {} s", longest_step_s));
  if (motion.x_mm_s2.size() < 2) refuse(counted(motion.x_mm_s2.size(), "sample"), "two or more");
  if (!motion.y_mm_s2.empty() && motion.y_mm_s2.size() != motion.x_mm_s2.size())
    refuse(fmt::format("{} samples along x and {} along y", motion.x_mm_s2.size(), motion.y_mm_s2.size()),
           "two components of one length");
  for (auto const* values : {&motion.x_mm_s2, &motion.y_mm_s2})
    if (auto const bad = std::ranges::find_if_not(*values, [](double a) { return std::isfinite(a); });
        bad != values->end())
      refuse(fmt::format("sample {} is no number", bad - values->begin() + 1), "finite accelerations");
}

namespace {

BuildingFile read_parsed(toml::table parsed, std::string const& name, std::filesystem::path const& folder,
                         ReplacedKeys const& in_place) {
  if (!in_place.settings.empty()) {
    auto* const settings = parsed.insert(settings_info.name, toml::table()).first->second.as_table();
    for (auto const& [key, value] : in_place.settings)
      if (settings != nullptr)
        insert_toml(value, 0, [&, name = key](auto node) { settings->insert_or_assign(name, std::move(node)); });
  }
  std::vector<Complaint> complaints;
  TomlTable root(parsed, name, "", complaints);
  BuildingFile file{.file = name, .settings = {}, .frame = {}, .bearings = {}, .plan_mm = {}, .motions = {}};
  auto const settings = read_table(root, name, settings_info, settings_keys(), Settings{}, complaints);
  auto const base = read_table(root, name, base_info, base_keys(), BaseRow{}, complaints);
  auto const equal = read_table(root, name, floors_info, equal_floors_keys(), EqualFloors{}, complaints);
  auto const floors = read_tables(root, name, floor_info, floor_keys(), FloorRow{}, most_floors, complaints);
  auto const grid = read_table(root, name, grid_info, grid_keys(), GridRow{}, complaints);
  auto const bearings = read_tables(root, name, bearing_info, bearing_keys(), BearingRow{}, most_bearings, complaints);
  auto const plan = read_table(root, name, plan_info, plan_keys(), PlanRow{}, complaints);
  auto rows = read_tables(root, name, motion_info, motion_keys(),
                          MotionRow{.x = {}, .y = {}, .scale = 1.0, .step_s = {}}, 1000, complaints);
  root.refuse_unknown();
  auto const lacks = [&](TableInfo const& info, std::string const& allowed) {
    root.complain(fmt::format("no [{}]", info.name), allowed, "isolaw building --template");
  };
  if (!settings) lacks(settings_info, "what is asked, with the bounds' factors");
  if (!base) lacks(base_info, "the slab on the bearings");
  if (equal && !floors.empty()) root.complain("[floors] and [[floor]]", "one of them");
  if (!grid && bearings.empty())
    root.complain("no bearings", "[grid], or [[bearing]] with their places", "isolaw building --template");

  if (settings) file.settings = *settings;
  if (base)
    file.frame.base = {.mass_Mg = base->mass_Mg,
                       .gyration_mm = base->gyration_m * mm_in_m,
                       .centre = {base->x_m * mm_in_m, base->y_m * mm_in_m}};
  file.frame.damping = {file.settings.damping};
  if (equal)
    file.frame.floors = equal_floors(
        static_cast<std::size_t>(equal->count),
        {.mass_Mg = equal->mass_Mg, .gyration_mm = equal->gyration_m * mm_in_m, .centre = file.frame.base.centre},
        equal->period_x_s, equal->period_y_s, equal->rotation_ratio);
  for (auto const& floor : floors)
    file.frame.floors.push_back(
        {.below = storey(floor.stiffness_x_kN_per_mm, floor.stiffness_y_kN_per_mm, floor.stiffness_rotation_GNm * 1e9,
                         {floor.stiffness_at_x_m * mm_in_m, floor.stiffness_at_y_m * mm_in_m}),
         .slab = {.mass_Mg = floor.mass_Mg,
                  .gyration_mm = floor.gyration_m * mm_in_m,
                  .centre = {floor.x_m * mm_in_m, floor.y_m * mm_in_m}}});
  double middle_x = 0.0, middle_y = 0.0;
  if (plan) {
    if (!(plan->left_m < plan->right_m) || !(plan->front_m < plan->back_m))
      root.complain(*root.find(plan_info.name), "edges in the wrong order", "left_m < right_m, front_m < back_m");
    file.plan_mm =
        std::array{plan->left_m * mm_in_m, plan->right_m * mm_in_m, plan->front_m * mm_in_m, plan->back_m * mm_in_m};
    middle_x = 0.5 * (plan->left_m + plan->right_m), middle_y = 0.5 * (plan->front_m + plan->back_m);
  }
  if (grid)
    for (int i = 0; i < grid->along; ++i)
      for (int j = 0; j < grid->across; ++j)
        file.bearings.push_back(place_of(middle_x + (i - 0.5 * (grid->along - 1)) * grid->spacing_x_m,
                                         middle_y + (j - 0.5 * (grid->across - 1)) * grid->spacing_y_m, grid->is));
  for (auto const& b : bearings) file.bearings.push_back(place_of(b.x_m, b.y_m, b.is));
  if (file.bearings.size() > most_bearings)
    root.complain(fmt::format("{} bearings", file.bearings.size()), fmt::format("{} at most", most_bearings));
  if (file.plan_mm)
    for (std::size_t i = 0; i < file.bearings.size(); ++i) {
      auto const [x, y] = file.bearings[i].at;
      auto const [left, right, front, back] = *file.plan_mm;
      if (x < left || x > right || y < front || y > back) {
        root.complain(
            *root.find(plan_info.name),
            fmt::format("bearing {} at ({:g}, {:g}) m stands outside the plan", i + 1, x / mm_in_m, y / mm_in_m),
            fmt::format("{:g} to {:g} m along x, {:g} to {:g} m along y", left / mm_in_m, right / mm_in_m,
                        front / mm_in_m, back / mm_in_m));
        break;
      }
    }
  auto const take = [&](auto const& sound) {
    try {
      file.motions.push_back(sound());
    } catch (Error const& error) {
      complaints.insert(complaints.end(), error.complaints().begin(), error.complaints().end());
    }
  };
  for (auto const& motion : in_place.motions) take([&] { return (require_sound(motion), motion); });
  if (in_place.motions.empty())
    for (auto const& row : rows) take([&] { return motion_of(folder, row); });
  if (in_place.motions.empty() && rows.empty())
    root.complain("no motions", "[[motion]], or --motion FILES", "isolaw building --template");
  throw_complaints(std::move(complaints), name);
  return file;
}

}  // namespace

BuildingFile read_building_text(std::string_view content, std::string const& name, std::filesystem::path const& folder,
                                ReplacedKeys const& in_place) {
  return read_parsed(parse_toml(content, name, {.kind = "building file", .advice = "isolaw building --template"}), name,
                     folder, in_place);
}

BuildingFile building_of(Json const& tables, ReplacedKeys const& in_place) {
  if (!tables.is_object())
    throw Error({.where = "building", .found = shown(tables), .allowed = "tables as a building file has them"});
  return read_parsed(table_of(tables, 0), "building", {}, in_place);
}

BuildingFile read_building(std::filesystem::path const& file, ReplacedKeys const& in_place) {
  return read_building_text(read_file(file, {.largest_bytes = 1 << 20,
                                             .allowed = "a building file",
                                             .when_too_large = "isolaw building --template"}),
                            file.generic_string(), file.parent_path(), in_place);
}

}  // namespace isolaw::building
