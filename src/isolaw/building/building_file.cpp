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
#include "isolaw/building/limits.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/laws/catalogue.hpp"

namespace isolaw::building {
namespace {

constexpr double mm_in_m = 1e3;
constexpr double most_drawn = 2e6;  // a study with more drawn buildings is refused
constexpr double most_g = 1e3;      // a ground motion with a larger acceleration, in g, is refused

struct TableInfo {
  std::string_view name, help;
  std::size_t most = 0;  // the table is a list [[name]] of at most so many tables; 0: it is a single table [name]
};
constexpr TableInfo settings_info{"building", "The analysis. Lengths in m, masses in Mg (t), times in s."},
    limits_info{"limits", "The largest responses that the building may have. Leave out what is not limited."},
    base_info{"base", "The slab on the bearings. All coordinates in plan share one system of axes."},
    floors_info{"floors", "Equal floors; or one [[floor]] for each, from the lowest up."},
    floor_info{"floor", "One floor and the storey below it, instead of [floors].", 100},
    grid_info{"grid", "Bearings on a regular grid; or one [[bearing]] for each."},
    bearing_info{"bearing", "One bearing, instead of or besides [grid].", 2000},
    plan_info{
        "plan",
        "The edges of the slab. Its corners are where displacements are reported; no bearing and no centre of mass may stand outside."},
    motion_info{
        "motion",
        "One ground motion each; files relative to this one. isolaw building --motion replaces them and their scales.",
        1000};

Limits positive(double most = 1e9) {
  return {.least = 1e-9, .most = most, .words = fmt::format("a number above 0, {:g} at most", most)};
}

void take_part(std::string_view part, Json const& factor, PartFactors& to) {
  Limits const limits{.least = 0.05, .most = 20.0};
  if (part == "elastic")
    to.elastic = real_of(factor, limits);
  else if (part == "hysteretic")
    to.hysteretic = real_of(factor, limits);
  else
    refuse(std::string(part), "elastic and hysteretic");
}

// Reads a factor on the whole force, the word "conditions", or one factor each for the elastic and the hysteretic part
// of the force. Two factors come as a table or as a text that factors_of() made. TomlTable::json() passes a table
// twice: first with its first factor only, then with both.
void take_factors(Json const& value, Limits const& limits, std::optional<PartFactors>& to) {
  if (value == "conditions") return to.reset();
  auto const text = value.is_string() ? value.get<std::string>() : std::string();
  auto const comma = text.find(',');
  if (!value.is_object() && comma == std::string::npos) return void(to = whole(real_of(value, limits)));
  if (!to) to = whole(0.0);
  if (value.is_object())
    for (auto const& [part, factor] : value.items()) take_part(part, factor, *to);
  else
    for (auto const& item : {text.substr(0, comma), text.substr(comma + 1)}) {
      auto const equals = std::min(item.find('='), item.size() - 1);
      take_part(item.substr(0, equals), or_null(number_in<double>(std::string_view(item).substr(equals + 1))), *to);
    }
}

Json factors_of(std::optional<PartFactors> const& factors) {
  if (!factors) return "conditions";
  if (factors->is_whole()) return factors->elastic;
  return fmt::format("elastic={},hysteretic={}", factors->elastic, factors->hysteretic);
}

std::vector<FileKey> make_keys() {
  using F = FileTables;
  constexpr bool required = true;
  constexpr std::string_view stands_help =
      "draw: a device drawn at random from the lot; lot: the law of the lot; lower, upper: the law of the lot as in that bound analysis; or the name of a tested device";
  Limits const within{.least = -1e4, .most = 1e4}, many{.least = 1, .most = 200};
  std::vector<FileKey> keys;
  std::string_view table;
  auto const real = [&](std::string_view key, std::string_view help, auto place, Limits const& limits,
                        bool is_required = false) {
    auto option = number<F>(key, {}, place, limits);
    option.help = help;
    keys.push_back({std::move(option), table, is_required});
  };
  auto const text = [&](std::string_view key, std::string_view help, auto place, bool is_required = false) {
    keys.push_back({{{.key = key, .help = std::string(help)},
                     [place](F const& from) -> Json { return place(from); },
                     [place, is_required](F& to, Json const& value) {
                       if (is_required && text_in(value).empty()) refuse(value, "a text that is not empty");
                       place(to) = text_in(value);
                     }},
                    table,
                    is_required});
  };
  auto const slab = [&](auto of) {
    real("mass_Mg", "mass in Mg (t)", at(of, &Slab::mass_Mg), positive(), required);
    real("gyration_m", "radius of gyration about the vertical axis", at(of, &Slab::gyration_m), positive(1e4),
         required);
  };
  auto const centre = [&](auto of) {
    real("x_m", "centre of mass in plan", at(of, &Slab::x_m), within);
    real("y_m", "", at(of, &Slab::y_m), within);
  };

  table = settings_info.name;
  auto const settings = [](auto member) { return at(&F::building, member); };
  text("title", "title of the report", settings(&Settings::title));
  keys.back().changes_runs = false;
  keys.push_back({{{.key = "laws",
                    .kind = Kind::list,
                    .help = "ids of the laws to compare; an empty list means the law that the campaign recommends"},
                   [](F const& f) -> Json { return f.building.laws; },
                   [](F& f, Json const& value) {
                     auto& laws = f.building.laws;
                     laws.clear();
                     for (auto const& law : value.is_array() ? value : Json::array({value})) {
                       std::string id(laws::find_law(text_in(law)).info.id);
                       if (std::ranges::find(laws, id) != laws.end()) refuse(law, "each law once");
                       laws.push_back(std::move(id));
                     }
                   }},
                  table});
  keys.back().changes_runs = false;
  real("draws",
       "number of buildings to draw; in each, every bearing marked draw is a device drawn at random; 0: only the "
       "nominal building and the bound analyses",
       settings(&Settings::draws), {.least = 0, .most = 1e6});
  real("populations",
       "number of lots estimated again at random, to see how uncertain the lot is after few tests; 0: none",
       settings(&Settings::populations), {.least = 0, .most = 1e4});
  real("draws_of_each", "number of buildings to draw from each of these lots", settings(&Settings::draws_of_each),
       {.least = 2, .most = 1e4});
  real("seed", "seed of all draws", settings(&Settings::seed), {.least = 0, .most = 2147483647});
  real("damping", "damping ratio of every mode of the superstructure on a fixed base", settings(&Settings::damping),
       {.least = 0.0, .most = 0.5});
  auto const bound = [&](std::string_view key, std::string_view help, std::optional<PartFactors> Settings::*member,
                         Limits const& limits) {
    Option<F> option{{.key = key, .kind = Kind::real, .help = std::string(help), .limits = limits},
                     [member](F const& f) { return factors_of(f.building.*member); },
                     [member, limits](F& f, Json const& value) { take_factors(value, limits, f.building.*member); }};
    option.type = "float | Literal[\"conditions\"] | dict[str, float]";
    keys.push_back({std::move(option), table, required});
  };
  bound(
      "lower",
      "factor on the force of every bearing in the lower bound analysis, { elastic = 0.9, hysteretic = 0.8 } for a factor on each part of the force, or \"conditions\": the lower bound law over the design conditions of the lot",
      &Settings::lower,
      {.least = 0.05, .most = 1.0, .words = "0.05 to 1, a table of elastic and hysteretic, or \"conditions\""});
  bound("upper", "the same in the upper bound analysis", &Settings::upper,
        {.least = 1.0, .most = 20.0, .words = "1 to 20, a table of elastic and hysteretic, or \"conditions\""});
  real("step_s", "longest integration step", settings(&Settings::step_s), {.least = 1e-5, .most = 0.05});
  real("rest_s", "seconds to continue after the ground motion ends, before the residual displacement is read",
       settings(&Settings::rest_s), {.least = 0.0, .most = 120.0});

  table = limits_info.name;
  for (auto const& limit : limit_rows) real(limit.key, limit.help, at(&F::limits, limit.value), positive());

  table = base_info.name;
  slab(&F::base);
  centre(&F::base);

  table = floors_info.name;
  real("count", "number of floors above the base slab", at(&F::floors, &EqualFloors::count),
       {.least = 0, .most = static_cast<double>(floor_info.most)}, required);
  slab(&F::floors);
  real("period_x_s", "first period on a fixed base", at(&F::floors, &EqualFloors::period_x_s), positive(100.0),
       required);
  real("period_y_s", "", at(&F::floors, &EqualFloors::period_y_s), positive(100.0), required);
  real("rotation_ratio",
       "frequency of the first torsional mode divided by the lower of the first frequencies along x and y",
       at(&F::floors, &EqualFloors::rotation_ratio), positive(100.0));

  table = floor_info.name;
  slab(&F::floor);
  centre(&F::floor);
  real("stiffness_x_kN_per_mm", "stiffness of the storey below the floor",
       at(&F::floor, &FloorRow::stiffness_x_kN_per_mm), positive(1e12), required);
  real("stiffness_y_kN_per_mm", "", at(&F::floor, &FloorRow::stiffness_y_kN_per_mm), positive(1e12), required);
  real("stiffness_rotation_GNm", "torsional stiffness in GN m per radian, about its centre of stiffness",
       at(&F::floor, &FloorRow::stiffness_rotation_GNm), positive(1e12), required);
  real("stiffness_at_x_m", "centre of stiffness in plan", at(&F::floor, &FloorRow::stiffness_at_x_m), within);
  real("stiffness_at_y_m", "", at(&F::floor, &FloorRow::stiffness_at_y_m), within);

  table = grid_info.name;
  real("along", "number of bearings along x; the grid is centred on the plan", at(&F::grid, &GridRow::count_x), many,
       required);
  real("across", "number of bearings along y", at(&F::grid, &GridRow::count_y), many, required);
  real("spacing_x_m", "", at(&F::grid, &GridRow::spacing_x_m), positive(1e3), required);
  real("spacing_y_m", "", at(&F::grid, &GridRow::spacing_y_m), positive(1e3), required);
  text("is", stands_help, at(&F::grid, &GridRow::kind_or_device));

  table = bearing_info.name;
  real("x_m", "place in plan", at(&F::bearing, &BearingRow::x_m), within, required);
  real("y_m", "", at(&F::bearing, &BearingRow::y_m), within, required);
  text("is", stands_help, at(&F::bearing, &BearingRow::kind_or_device));

  table = plan_info.name;
  real("left_m", "edges of the slab along x", at(&F::plan, &PlanRow::left_m), within, required);
  real("right_m", "", at(&F::plan, &PlanRow::right_m), within, required);
  real("front_m", "edges of the slab along y", at(&F::plan, &PlanRow::front_m), within, required);
  real("back_m", "", at(&F::plan, &PlanRow::back_m), within, required);

  table = motion_info.name;
  text("x", "file of the ground acceleration along x: AT2, or columns with units", at(&F::motion, &MotionRow::x),
       required);
  text("y", "file of the ground acceleration along y; leave it out for a single component",
       at(&F::motion, &MotionRow::y));
  real("scale", "factor on both accelerations", at(&F::motion, &MotionRow::scale), positive(1e3));
  for (auto& stated : data::stated_options<F>("step_s", "unit", at(&F::motion, &MotionRow::stated)))
    keys.push_back({std::move(stated), table});
  return keys;
}

std::span<FileKey const> keys_of(std::string_view table) {
  static auto const keys = make_keys();
  auto const first = std::ranges::find(keys, table, &FileKey::table);
  auto const end = std::find_if(first, keys.end(), [&](FileKey const& key) { return key.table != table; });
  return std::span(keys).subspan(static_cast<std::size_t>(first - keys.begin()), static_cast<std::size_t>(end - first));
}

// Reads the tables of a file, one at a time, into one FileTables object.
class FileReader {
 public:
  FileReader(toml::table const& parsed, std::string const& file) : root(parsed, file, "", complaints), file_(file) {}

  // Reads a table if the file has it, and returns whether it has.
  bool read(TableInfo const& info) {
    auto const* table = root.table(info.name);
    if (table != nullptr) read_row(*table, info);
    return table != nullptr;
  }
  template <class Row>
  std::vector<Row> read_list(TableInfo const& info, Row FileTables::*row) {
    std::vector<Row> rows;
    auto const* node = root.find(info.name);
    if (node == nullptr) return rows;
    auto const* list = node->as_array();
    if (list == nullptr || list->size() > info.most || !list->is_homogeneous(toml::node_type::table)) {
      root.complain(*node, fmt::format("'{}' is no list of tables", info.name),
                    fmt::format("[[{}]], {} of them at most", info.name, info.most));
      return rows;
    }
    for (auto const& item : *list) {
      tables.*row = {};
      read_row(*item.as_table(), info);
      rows.push_back(tables.*row);
    }
    return rows;
  }

  FileTables tables = {};
  std::vector<Complaint> complaints = {};
  TomlTable root;

 private:
  void read_row(toml::table const& from, TableInfo const& info) {
    auto const name = info.most > 0 ? fmt::format("[[{}]]", info.name) : fmt::format("[{}]", info.name);
    TomlTable table(from, file_, name, complaints);
    for (auto const& key : keys_of(info.name)) {
      table.json(key.key, [&](Json const& value) { key.set(tables, value); });
      if (key.required && table.find(key.key) == nullptr)
        table.complain(fmt::format("{} has no {}", name, key.key),
                       key.limits ? key.limits->text() : std::string("a value"));
    }
    table.refuse_unknown();
  }

  std::string const& file_;
};

BearingPlace place_of(double x_m, double y_m, std::string const& is) {
  BearingPlace bearing{.at = {x_m * mm_in_m, y_m * mm_in_m}, .kind = BearingKind::device, .device = is};
  for (auto const kind : {BearingKind::draw, BearingKind::lot, BearingKind::lower, BearingKind::upper})
    if (is == name(kind)) bearing = {.at = bearing.at, .kind = kind, .device = {}};
  return bearing;
}

Motion motion_of(std::filesystem::path const& folder, MotionRow const& row) {
  auto const in = [&](std::string const& name) {
    std::filesystem::path const path(name);
    return path.is_absolute() ? path : folder / path;
  };
  auto const x = data::read_ground_motion(in(row.x), row.stated);
  Motion motion{
      .name = std::filesystem::path(row.x).stem().string(), .step_s = x.step_s, .x_mm_s2 = x.acceleration_mm_s2};
  auto const note_zero = [&](data::GroundMotion const& component, std::string axis) {
    if (component.zero_mm_s2)
      motion.notes.push_back({.kind = FindingKind::ground_zero_removed,
                              .numbers = {{"mean_g", *component.zero_mm_s2 / data::gravity_mm_s2}},
                              .words = {{"motion", motion.name}, {"axis", std::move(axis)}}});
  };
  note_zero(x, "x");
  if (!row.y.empty()) {
    auto const y = data::read_ground_motion(in(row.y), row.stated);
    note_zero(y, "y");
    if (std::abs(y.step_s - x.step_s) > 1e-6 * x.step_s)
      throw Error(
          {.where = y.file,
           .found = fmt::format("samples every {:.6g} s, and {} has them every {:.6g} s", y.step_s, x.file, x.step_s),
           .allowed = "two components of one step"});
    motion.y_mm_s2 = y.acceleration_mm_s2;
    auto const most = std::max(motion.x_mm_s2.size(), motion.y_mm_s2.size());
    bool const x_is_shorter = motion.x_mm_s2.size() < most;
    auto& shorter = x_is_shorter ? motion.x_mm_s2 : motion.y_mm_s2;
    if (shorter.size() < most)
      motion.notes.push_back({.kind = FindingKind::ground_padded,
                              .numbers = {{"samples", static_cast<double>(most - shorter.size())}},
                              .words = {{"motion", motion.name}, {"axis", x_is_shorter ? "x" : "y"}}});
    shorter.resize(most, 0.0);
  }
  for (double& a : motion.x_mm_s2) a *= row.scale;
  for (double& a : motion.y_mm_s2) a *= row.scale;
  return motion;
}

MotionRow row_of(std::string const& files, data::StatedMotion const& stated) {
  auto const comma = files.find(',');
  if (comma == 0 || comma + 1 == files.size() || files.empty() || comma != files.rfind(','))
    throw Error({.where = "motion",
                 .found = in_quotes(files),
                 .allowed = "FILE, or FILE,FILE for the components along x and y"});
  return {
      .x = files.substr(0, comma), .y = comma == std::string::npos ? "" : files.substr(comma + 1), .stated = stated};
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

void write_table(std::string& out, TableInfo const& info, FileTables const& tables, bool in_use = true) {
  std::string_view const off = in_use ? "" : "# ";
  auto const [open, close] = info.most > 0 ? std::pair("[[", "]]") : std::pair("[", "]");
  out += fmt::format("\n# {}\n{}{}{}{}\n", info.help, off, open, info.name, close);
  for (auto const& key : keys_of(info.name)) {
    auto const value = key.get(tables);
    out += fmt::format("{}{} = ", value.is_null() || !in_use ? "# " : "", key.key);
    if (value.is_null())
      out += key.kind == Kind::text ? "\"g\"" : "0.01";
    else
      write_value(out, value);
    if (!key.help.empty()) out += fmt::format("  # {}", key.help);
    out += '\n';
  }
}

}  // namespace

std::string_view name(BearingKind kind) {
  switch (kind) {
    case BearingKind::draw:
      return "draw";
    case BearingKind::lot:
      return "lot";
    case BearingKind::lower:
      return "lower";
    case BearingKind::upper:
      return "upper";
    case BearingKind::device:
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

std::string building_template(int motions) {
  std::string out =
      "# A building on isolators for `isolaw building`. Lines that start with # are explanations or not in use.\n";
  FileTables tables;
  tables.building.title = "Five floors on 28 bearings";
  tables.building.lower = whole(0.9);
  tables.building.upper = whole(1.1);
  tables.motion.scale = 0.5;
  tables.limits = {
      .bearing_mm = 200.0, .clearance_mm = 250.0, .base_shear_over_weight = 0.1, .floor_acceleration_g = 0.25};
  for (auto const& info : {settings_info, limits_info, base_info, floors_info}) write_table(out, info, tables);
  write_table(out, floor_info, tables, false);
  write_table(out, grid_info, tables);
  write_table(out, bearing_info, tables, false);
  write_table(out, plan_info, tables);
  for (int i = 1; i <= motions; ++i) {
    tables.motion.x = fmt::format("motion-{}-x.csv", i);
    tables.motion.y = fmt::format("motion-{}-y.csv", i);
    write_table(out, motion_info, tables);
  }
  return out;
}

std::span<FileKey const> settings_table() {
  return keys_of(settings_info.name);
}

std::span<Option<data::StatedMotion> const> stated_table() {
  static auto const table = data::stated_options<data::StatedMotion>(
      "motion-dt", "motion-unit", [](auto& stated) -> auto& { return stated; });
  return table;
}

Motion read_motion(std::string const& files, data::StatedMotion const& stated) {
  return motion_of({}, row_of(files, stated));
}

std::vector<Motion> read_motions(std::vector<std::string> const& files, isolaw::Values const& given) {
  data::StatedMotion stated{.how_step = "--motion-dt SECONDS", .how_unit = "--motion-unit UNIT"};
  lay_over(stated_table(), given, stated);
  if (files.empty() && !given.empty())
    throw Error({.where = "--" + given.begin()->first, .found = "is given alone", .allowed = "with --motion FILES"});
  std::vector<Motion> motions;
  std::vector<Complaint> complaints;
  for (auto const& file : files) {
    try {
      motions.push_back(read_motion(file, stated));
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
  for (auto const* component : {&motion.x_mm_s2, &motion.y_mm_s2})
    for (double const a : *component)
      if (std::abs(a) > most_g * data::gravity_mm_s2)
        refuse(fmt::format("an acceleration of {:.3g} g", a / data::gravity_mm_s2),
               fmt::format("up to {:.0f} g: the ground never moves so", most_g));
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

constexpr TomlMessages messages{.kind = "building file", .advice = "isolaw building --template"};

// Complains if a bound has a factor on one part of the force only, or if both factors of the lower bound are above 1 or
// both of the upper bound below 1.
void require_both_parts(TomlTable& root, Settings const& settings) {
  auto const require = [&](std::string_view key, std::optional<PartFactors> const& factors, double sign) {
    if (!factors || factors->is_whole()) return;
    auto const [elastic, hysteretic] = *factors;
    auto const advice =
        fmt::format("{} = {{ elastic = {}, hysteretic = {} }}", key, sign < 0.0 ? 0.9 : 1.1, sign < 0.0 ? 0.8 : 1.2);
    if (elastic == 0.0 || hysteretic == 0.0)
      root.complain(*root.find(settings_info.name),
                    fmt::format("{} has no factor on the {} part", key, elastic == 0.0 ? "elastic" : "hysteretic"),
                    "both factors", advice);
    else if (sign * (elastic - 1.0) < 0.0 && sign * (hysteretic - 1.0) < 0.0)
      root.complain(*root.find(settings_info.name),
                    fmt::format("both factors of {} are {} 1", key, sign < 0.0 ? "above" : "below"),
                    fmt::format("one of them {} 1, or 1", sign < 0.0 ? "below" : "above"), advice);
  };
  require("lower", settings.lower, -1.0);
  require("upper", settings.upper, 1.0);
}

BuildingFile read_parsed(toml::table parsed, std::string const& name, std::filesystem::path const& folder,
                         ReplacedKeys const& in_place) {
  if (!in_place.settings.empty()) {
    auto* const settings = parsed.insert(settings_info.name, toml::table()).first->second.as_table();
    if (settings != nullptr)
      for (auto const& [key, value] : toml_of(Json(in_place.settings), name, messages))
        settings->insert_or_assign(key, value);
  }
  FileReader reader(parsed, name);
  auto& root = reader.root;
  auto& complaints = reader.complaints;
  auto const& tables = reader.tables;
  auto const& equal = tables.floors;
  auto const& grid = tables.grid;
  auto const& plan = tables.plan;
  BuildingFile file{.file = name, .settings = {}, .frame = {}, .bearings = {}, .plan_mm = {}, .motions = {}};
  bool const has_settings = reader.read(settings_info);
  reader.read(limits_info);
  bool const has_base = reader.read(base_info), has_floors = reader.read(floors_info);
  auto const floors = reader.read_list(floor_info, &FileTables::floor);
  auto const before_places = complaints.size();
  bool const has_grid = reader.read(grid_info);
  auto const bearings = reader.read_list(bearing_info, &FileTables::bearing);
  bool const has_plan = reader.read(plan_info), places_are_known = complaints.size() == before_places;
  auto const motions = reader.read_list(motion_info, &FileTables::motion);
  root.refuse_unknown();
  auto const lacks = [&](TableInfo const& info, std::string const& allowed) {
    root.complain(fmt::format("no [{}]", info.name), allowed, "isolaw building --template");
  };
  if (!has_settings) lacks(settings_info, "what is asked, with the bounds' factors");
  if (!has_base) lacks(base_info, "the slab on the bearings");
  if (has_floors && !floors.empty()) root.complain("[floors] and [[floor]]", "one of them");
  if (root.find(grid_info.name) == nullptr && root.find(bearing_info.name) == nullptr)
    root.complain("no bearings", "[grid], or [[bearing]] with their places", "isolaw building --template");

  auto const diaphragm = [](Slab const& slab) {
    return Diaphragm{.mass_Mg = slab.mass_Mg,
                     .gyration_mm = slab.gyration_m * mm_in_m,
                     .centre = {slab.x_m * mm_in_m, slab.y_m * mm_in_m}};
  };
  auto const& s = file.settings;
  if (has_settings) file.settings = tables.building;
  if (has_settings && complaints.empty()) require_both_parts(root, s);
  file.limits = tables.limits;
  if (auto const drawn = s.draws + 1.0 * s.populations * s.draws_of_each; drawn > most_drawn)
    root.complain(fmt::format("{:.0f} buildings: draws + populations * draws_of_each", drawn),
                  fmt::format("{:.0f} at most", most_drawn));
  if (has_base) file.frame.base = diaphragm(tables.base);
  file.frame.damping = {file.settings.damping};
  if (has_floors) {
    auto slab = diaphragm(equal);
    slab.centre = file.frame.base.centre;
    file.frame.floors = equal_floors(static_cast<std::size_t>(equal.count), slab, equal.period_x_s, equal.period_y_s,
                                     equal.rotation_ratio);
  }
  for (auto const& row : floors)
    file.frame.floors.push_back(
        {.below = storey(row.stiffness_x_kN_per_mm, row.stiffness_y_kN_per_mm, row.stiffness_rotation_GNm * 1e9,
                         {row.stiffness_at_x_m * mm_in_m, row.stiffness_at_y_m * mm_in_m}),
         .slab = diaphragm(row)});
  double middle_x = 0.0, middle_y = 0.0;
  if (has_plan) {
    if (!(plan.left_m < plan.right_m) || !(plan.front_m < plan.back_m))
      root.complain(*root.find(plan_info.name), "edges in the wrong order", "left_m < right_m, front_m < back_m");
    file.plan_mm =
        std::array{plan.left_m * mm_in_m, plan.right_m * mm_in_m, plan.front_m * mm_in_m, plan.back_m * mm_in_m};
    middle_x = 0.5 * (plan.left_m + plan.right_m), middle_y = 0.5 * (plan.front_m + plan.back_m);
  }
  if (has_grid)
    for (int i = 0; i < grid.count_x; ++i)
      for (int j = 0; j < grid.count_y; ++j)
        file.bearings.push_back(place_of(middle_x + (i - 0.5 * (grid.count_x - 1)) * grid.spacing_x_m,
                                         middle_y + (j - 0.5 * (grid.count_y - 1)) * grid.spacing_y_m,
                                         grid.kind_or_device));
  for (auto const& b : bearings) file.bearings.push_back(place_of(b.x_m, b.y_m, b.kind_or_device));
  if (file.bearings.size() > bearing_info.most)
    root.complain(fmt::format("{} bearings", file.bearings.size()), fmt::format("{} at most", bearing_info.most));
  if (file.plan_mm && places_are_known && plan.left_m < plan.right_m && plan.front_m < plan.back_m) {
    auto const [left, right, front, back] = *file.plan_mm;
    auto const stands = [&, left = left, right = right, front = front, back = back](std::string const& what,
                                                                                    Point const& at) {
      bool const inside = at.x_mm >= left && at.x_mm <= right && at.y_mm >= front && at.y_mm <= back;
      if (!inside)
        root.complain(
            *root.find(plan_info.name),
            fmt::format("{} at ({:g}, {:g}) m stands outside the plan", what, at.x_mm / mm_in_m, at.y_mm / mm_in_m),
            fmt::format("{:g} to {:g} m along x, {:g} to {:g} m along y", left / mm_in_m, right / mm_in_m,
                        front / mm_in_m, back / mm_in_m));
      return inside;
    };
    for (std::size_t i = 0; i < file.bearings.size(); ++i)
      if (!stands(fmt::format("bearing {}", i + 1), file.bearings[i].at)) break;
    // A mass within the plan has a radius of gyration below half the diagonal. The limit is the whole diagonal, because
    // a floor may reach beyond the plan.
    double const most_mm = std::hypot(right - left, back - front);
    auto const lies = [&](std::string const& what, Diaphragm const& slab) {
      stands("the centre of mass of " + what, slab.centre);
      if (slab.gyration_mm > most_mm)
        root.complain(*root.find(plan_info.name),
                      fmt::format("{} has a radius of gyration of {:g} m", what, slab.gyration_mm / mm_in_m),
                      fmt::format("up to {:.3g} m, the diagonal of the plan", most_mm / mm_in_m));
    };
    if (has_base) lies("[base]", file.frame.base);
    for (std::size_t i = 0; i < file.frame.floors.size(); ++i)
      lies(fmt::format("floor {}", i + 1), file.frame.floors[i].slab);
  }
  auto const take = [&](auto const& sound) {
    try {
      file.motions.push_back(sound());
    } catch (Error const& error) {
      complaints.insert(complaints.end(), error.complaints().begin(), error.complaints().end());
    }
  };
  if (!in_place.motions.empty())
    for (auto const& row : motions) file.replaced_scales.push_back(row.scale);
  for (auto const& given : in_place.motions) take([&] { return (require_sound(given), given); });
  if (in_place.motions.empty())
    for (auto const& row : motions)
      if (!row.x.empty()) take([&] { return motion_of(folder, row); });
  if (in_place.motions.empty() && root.find(motion_info.name) == nullptr)
    root.complain("no motions", "[[motion]], or --motion FILES", "isolaw building --template");
  throw_complaints(std::move(complaints), name);
  // If no bearing is a draw, all draws would equal the nominal building, so none are computed. Populations that are
  // estimated again serve only to compare medians of draws, so there are none either.
  auto& settings = file.settings;
  if (settings.draws == 0 ||
      std::ranges::find(file.bearings, BearingKind::draw, &BearingPlace::kind) == file.bearings.end())
    settings.draws = settings.populations = 0;
  return file;
}

}  // namespace

BuildingFile read_building_text(std::string_view content, std::string const& name, std::filesystem::path const& folder,
                                ReplacedKeys const& in_place) {
  return read_parsed(parse_toml(content, name, messages), name, folder, in_place);
}

BuildingFile building_of(Json const& tables, ReplacedKeys const& in_place) {
  return read_parsed(toml_of(tables, "building", messages), "building", {}, in_place);
}

BuildingFile read_building(std::filesystem::path const& file, ReplacedKeys const& in_place) {
  return read_building_text(read_file(file, {.largest_bytes = 1 << 20,
                                             .allowed = "a building file",
                                             .when_too_large = "isolaw building --template"}),
                            file.generic_string(), file.parent_path(), in_place);
}

}  // namespace isolaw::building
