#include "isolaw/programs/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/named_device.hpp"
#include "isolaw/data/files/text.hpp"
#include "isolaw/study/draws.hpp"

namespace isolaw::programs {
namespace {

Option<ModelOptions> words(std::string_view key, std::string help, std::optional<std::string> ModelOptions::*place) {
  return {{.key = key, .help = std::move(help), .heading = Heading::model},
          [place](ModelOptions const& from) { return or_null(from.*place); },
          [place](ModelOptions& to, Json const& value) { to.*place = text_in(value); }};
}

// Reads a quantity such as "8.5m" and converts it by `in_ours`. Throws Error for an unknown unit or a number that is
// not above 0.
double quantity(std::string const& text, std::string_view where, std::string_view allowed,
                std::optional<double> (*in_ours)(std::string_view)) {
  auto const parts = number_and_unit(text);
  auto const unit = parts ? in_ours(parts->second) : std::nullopt;
  if (!parts || !unit || !(parts->first > 0.0))
    throw Error({.where = std::string(where), .found = data::in_quotes(text), .allowed = std::string(allowed)});
  return parts->first * *unit;
}

// Divides the carried weight among the bearings as the layout divides its loads, or equally if it has no loads.
void add_weight(Model& model, ModelOptions const& options, std::vector<LayoutRow> const& places) {
  bool const loads = places.front().load_kN.has_value();
  double sum = 0.0;
  for (auto const& place : places) sum += place.load_kN.value_or(0.0);
  if (!options.mass && !loads)
    throw Error({.where = "--mass",
                 .found = "is not given, and the layout has no column of loads",
                 .allowed = "the mass that the isolators carry, or its weight: 1200t, 12000kN",
                 .advice = "--mass 1200t, or a column 'load [kN]' in the layout"});
  // force_in_kN() reads t and kg as tonne-force and kilogram-force. The mass in --mass thus becomes a weight.
  model.weight_kN = options.mass ? quantity(*options.mass, "--mass",
                                            fmt::format("a number above 0 and a unit of mass or weight (t, kg, {})",
                                                        known_units(Dimension::force)),
                                            force_in_kN)
                                 : sum;
  model.weight_from = options.mass ? fmt::format("--mass {}{}", *options.mass,
                                                 loads ? ", shared as the layout's loads" : ", shared equally")
                                   : std::string("the sum of the layout's loads");
  model.centre_from = loads ? "of the loads" : "of the bearings, which carry equal loads";
  for (std::size_t i = 0; i < places.size(); ++i) {
    auto& bearing = model.bearings[i];
    bearing.load_kN =
        loads ? model.weight_kN * *places[i].load_kN / sum : model.weight_kN / static_cast<double>(places.size());
    model.x_mm += bearing.x_mm * bearing.load_kN / model.weight_kN;
    model.y_mm += bearing.y_mm * bearing.load_kN / model.weight_kN;
  }
  if (options.gyration) {
    model.gyration_mm =
        quantity(*options.gyration, "--gyration",
                 "a length above 0 with its unit: 8.5m (" + known_units(Dimension::length) + ")", length_in_mm);
    model.gyration_from = "--gyration";
    return;
  }
  auto const [left, right] = std::ranges::minmax(model.bearings, {}, &ModelBearing::x_mm);
  auto const [low, high] = std::ranges::minmax(model.bearings, {}, &ModelBearing::y_mm);
  model.gyration_mm = std::hypot(right.x_mm - left.x_mm, high.y_mm - low.y_mm) / std::sqrt(12.0);
  model.gyration_from = "of a uniform rectangle around the bearings";
  // A single bearing spans no rectangle. The model then holds the slab against turning, so any radius of gyration will
  // do.
  if (model.bearings.size() == 1) model.gyration_mm = 1000.0;
}

void add_vertical_stiffness(Model& model, ModelOptions const& options, std::vector<LayoutRow> const& places,
                            study::Summary const& summary, std::string_view device, bool lot) {
  bool const column = places.front().K_v_kN_per_mm.has_value();
  if (column && options.axial)
    throw Error({.where = "--axial", .found = "is given beside the layout's column K_v", .allowed = "one of them"});
  double one = 0.0;
  if (options.axial) {
    one = quantity(*options.axial, "--axial", "a stiffness above 0 with its unit: 1200kN/mm", parse_stiffness);
    model.K_v_from = "--axial";
  } else if (column) {
    model.K_v_from = "the layout";
  } else {
    std::size_t count = 0;
    for (auto const& each : summary.devices)
      if (each.vertical && (lot || each.name == device)) {
        one += each.vertical->K_v_kN_per_mm;
        ++count;
      }
    if (count == 0)
      throw Error(
          {.where = "--axial",
           .found = fmt::format("is not given, the layout has no column K_v, and {} no compression test",
                                lot ? std::string("the campaign has") : "device '" + std::string(device) + "' has"),
           .allowed = "the vertical stiffness of a bearing, from one of the three",
           .advice = "--axial 1200kN/mm; the displacements and forces in plan do not depend on it"});
    one /= static_cast<double>(count);
    model.K_v_from = count == 1 ? "the campaign's compression test"
                                : fmt::format("the mean of the campaign's {} compression tests", count);
  }
  for (std::size_t i = 0; i < places.size(); ++i)
    model.bearings[i].K_v_kN_per_mm = column ? *places[i].K_v_kN_per_mm : one;
}

void add_motions(Model& model, ModelOptions const& options) {
  model.motions.push_back(data::read_ground_motion(*options.ground_motion, options.stated));
  model.scale = options.scale;
  if (!options.ground_motion_y) return;
  model.motions.push_back(data::read_ground_motion(*options.ground_motion_y, options.stated));
  auto const &x = model.motions[0], &y = model.motions[1];
  auto const text = [](data::GroundMotion const& motion) {
    return fmt::format("{} has {} samples every {:.6g} s", motion.file, motion.acceleration_mm_s2.size(),
                       motion.step_s);
  };
  if (x.acceleration_mm_s2.size() != y.acceleration_mm_s2.size() || std::abs(x.step_s - y.step_s) > 1e-6 * x.step_s)
    throw Error({.where = "--ground-motion-y",
                 .found = text(x) + ", and " + text(y),
                 .allowed = "two components of one record, as long and as finely sampled as each other",
                 .advice = "both cut to the samples that they share"});
}

void add_draws(Model& model, ModelOptions const& options, campaign::Contents const& contents,
               study::Summary const& summary, std::string_view law, std::uint64_t seed) {
  if (options.draws == 0) return;
  auto const bearings = model.bearings.size(), draws = static_cast<std::size_t>(options.draws);
  if (draws * bearings > static_cast<std::size_t>(most_drawn_sets))
    throw Error(
        {.where = "--draws",
         .found = fmt::format("{} draws of {} bearings, {} sets of parameters", draws, bearings, draws * bearings),
         .allowed = fmt::format("{} sets in a file", most_drawn_sets),
         .advice = "files of fewer draws, each with its own --seed"});
  auto const drawn = study::draw_devices(contents, summary, law, draws * bearings, seed, "--draws");
  for (std::size_t d = 0; d < draws; ++d) {
    auto const first = drawn.values.begin() + static_cast<std::ptrdiff_t>(d * bearings);
    model.draws.emplace_back(first, first + static_cast<std::ptrdiff_t>(bearings));
  }
  model.seed = seed;
  model.draws_said = study::sentences(drawn);
}

}  // namespace

std::vector<Option<ModelOptions>> const& model_table() {
  auto [dt, unit] =
      data::stated_options<ModelOptions>("ground-motion-dt", "ground-motion-unit", at(&ModelOptions::stated));
  static std::vector<Option<ModelOptions>> const table{
      words(
          "layout",
          "file with a table of the isolators: columns x and y, optionally name, load, K_v (vertical stiffness), angle; units in the header",
          &ModelOptions::layout),
      words("mass", "mass or weight on the isolators, such as 1200t or 12000kN (default: the layout's loads)",
            &ModelOptions::mass),
      words("gyration",
            "radius of gyration of the mass, such as 8.5m (default: that of a uniform rectangle around the bearings)",
            &ModelOptions::gyration),
      words("axial",
            "vertical stiffness of a bearing, for example 1200kN/mm (default: from the layout or compression tests)",
            &ModelOptions::axial),
      words("ground-motion",
            "file of the ground acceleration along x: AT2 (PEER), or text with columns that name their units",
            &ModelOptions::ground_motion),
      words("ground-motion-y", "file of the ground acceleration along y, in the same form as that of --ground-motion",
            &ModelOptions::ground_motion_y),
      std::move(dt).under(Heading::model),
      std::move(unit).under(Heading::model),
      number<ModelOptions>("scale", "factor on the ground acceleration", at(&ModelOptions::scale),
                           {.least = 1e-6, .most = 1e6})
          .under(Heading::model),
      number<ModelOptions>(
          "draws",
          "number of buildings to analyse whose bearings are drawn at random from the lot, in place of the lower and upper bound",
          at(&ModelOptions::draws), {.least = 0, .most = most_drawn_sets})
          .under(Heading::model)};
  return table;
}

Model make_model(ModelOptions const& options, campaign::Contents const& contents, study::Summary const& summary,
                 std::string_view law, std::string_view device, std::uint64_t seed) {
  std::vector<Complaint> complaints;
  if (!options.layout)
    complaints.push_back({.where = "--layout",
                          .found = "is not given",
                          .allowed = "a file of the isolators' places",
                          .advice = "a file with 'x [m], y [m]' and a row for each isolator"});
  if (!options.ground_motion)
    complaints.push_back({.where = "--ground-motion",
                          .found = "is not given",
                          .allowed = "a file of the acceleration of the ground, AT2 or columns with units"});
  if (!complaints.empty()) throw Error(std::move(complaints));
  auto const places = read_layout(*options.layout);
  Model model;
  model.layout = *options.layout;
  for (auto const& place : places)
    model.bearings.push_back(
        {.name = place.name, .x_mm = place.x_mm, .y_mm = place.y_mm, .angle_deg = place.angle_deg});
  bool const lot = !campaign::named_device(contents, device);
  auto const collect = [&](auto const& add) {
    try {
      add();
    } catch (Error const& error) {
      complaints.insert(complaints.end(), error.complaints().begin(), error.complaints().end());
    }
  };
  collect([&] { add_weight(model, options, places); });
  collect([&] { add_vertical_stiffness(model, options, places, summary, device, lot); });
  collect([&] { add_motions(model, options); });
  if (!complaints.empty()) throw Error(std::move(complaints));
  add_draws(model, options, contents, summary, law, seed);
  return model;
}

}  // namespace isolaw::programs
