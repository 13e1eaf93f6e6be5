// `isolaw simulate`: the force of a law under any displacement history.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/api/fitted.hpp"
#include "isolaw/api/parameters.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/lot_of.hpp"
#include "isolaw/app/output.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/version.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/doubts.hpp"

namespace isolaw::app {
namespace {

constexpr int finest = 1000;  // steps per sample

double largest(std::vector<double> const& values) {
  double found = 0.0;
  for (double const value : values) found = std::max(found, std::abs(value));
  return found;
}

struct Chosen {
  FittedLaw law;
  study::Doubts doubts;              // of a campaign's law as it was fitted
  std::string origin;                // "device 'a'", "the lot"; empty: of no campaign
  std::vector<std::string> changes;  // of --set: then it is no longer the law that the campaign fitted
};

// What --parameters, --from and --set come to; the names are checked with everything else.
Chosen chosen_law(SimulateArguments const& a, laws::LawEntry const& law) {
  if (a.parameters && a.from)
    throw Error({.where = "--parameters and --from", .found = "both are given", .allowed = "one of them"});
  if (a.anyway && !a.from)
    throw Error({.where = "--anyway",
                 .found = "is given alone",
                 .allowed = "with --from DIR: other parameters are taken without it"});
  if (a.from.has_value() != a.device.has_value())
    throw Error({.where = a.from ? "--from" : "--device",
                 .found = "is given alone",
                 .allowed = "--from DIR with --device NAME, or --device lot for the one law of the lot"});
  Chosen made;
  std::vector<NamedValue> values;
  auto where = std::string("--parameters");
  if (a.parameters) {
    values = read_parameter_file(*a.parameters, law);
    where = shown(*a.parameters);
  } else if (a.from) {
    where = shown(*a.from);
    auto const contents = campaign::Store::read(*a.from / store_name);
    made.law = fitted_law(contents, law.info.id, *a.device);
    auto const device = contents.device_or_lot(*a.device) ? std::optional<std::string_view>(*a.device) : std::nullopt;
    made.origin = device ? "device '" + *a.device + "'" : std::string("the lot");
    made.changes = a.set;
    if (made.changes.empty()) {
      made.doubts = study::doubts(study::build_summary(contents), law.info.id, device);
      study::require_taken(made.doubts, study::whose(law.info.id, device), a.anyway);
    }
    for (std::size_t i = 0; i < law.parameters.size(); ++i)
      values.push_back({.name = std::string(law.parameters[i].name), .value = made.law.parameters[i]});
  }
  std::vector<NamedValue> changes;
  for (auto const& text : a.set) changes.push_back(parse_named_value(text, "--set"));
  std::erase_if(values, [&](auto const& value) {
    return std::ranges::find(changes, value.name, &NamedValue::name) != changes.end();
  });
  values.insert(values.end(), changes.begin(), changes.end());
  // What a campaign fitted was accepted there: a search may end beyond a limit that its box crosses.
  auto& taken = made.law;
  taken.parameters =
      parameters_in_order(law, values, where, a.from && changes.empty() ? Together::left : Together::checked);
  campaign::Settings how;
  how.integration = taken.integration;
  how.turning_points = taken.turning_points;
  campaign::apply(a.how, how);
  taken.integration = how.integration;
  taken.turning_points = how.turning_points;
  taken.dead_band_mm = how.clean.dead_band_mm.value_or(taken.dead_band_mm);
  if (a.refinement) taken.refinement = *a.refinement;
  if (taken.refinement < 1 || taken.refinement > finest)
    throw Error({.where = "--refinement",
                 .found = fmt::format("{}", taken.refinement),
                 .allowed = fmt::format("1 to {} steps per sample", finest)});
  return made;
}

// What is known of a campaign's law: how far it was fitted and tested, how well it predicts, what speaks against it.
std::vector<std::string> facts(Chosen const& chosen) {
  if (chosen.origin.empty()) return {};
  auto const& [tested, fitted] = chosen.law.ranges;
  auto const reach = fmt::format("{}, {}, up to {:.4g} mm; tested up to {:.4g} mm", chosen.origin,
                                 study::part_text(chosen.law.part), fitted.disp_mm, tested.disp_mm);
  if (!chosen.changes.empty())
    return {
        fmt::format("fitted to {}", reach),
        fmt::format("changed by --set {}: how well this law fits or predicts is not known", joined(chosen.changes))};
  std::vector<std::string> lines{fmt::format("fitted to {}", reach), "prediction " + chosen.doubts.prediction};
  for (auto const& warning : chosen.doubts.warnings) lines.push_back("warning: " + warning);
  if (!chosen.doubts.objection.empty()) lines.push_back(study::let_through(chosen.doubts.objection));
  return lines;
}

void say_what_it_is(laws::LawEntry const& law, Chosen const& chosen, data::TestRecord const& motion) {
  say("{}\n", shown(motion.file));
  for (auto const& line : motion.recognised)
    if (!line.starts_with("no time column")) say("  {}\n", line);
  for (auto const& line : motion.warnings) say("  warning: {}\n", line);
  if (!motion.has_time()) say("  no time: the force of {} does not depend on it\n", law.info.id);
  say("{}\n ", law.info.id);
  for (std::size_t i = 0; i < law.parameters.size(); ++i)
    say(" {} = {:g}{}{}{}", law.parameters[i].name, chosen.law.parameters[i], law.parameters[i].unit == "1" ? "" : " ",
        law.parameters[i].unit == "1" ? "" : law.parameters[i].unit, i + 1 < law.parameters.size() ? "," : "\n");
  if (auto const beyond = law.unmet(chosen.law.parameters))
    say("  warning: {}, outside {}: no device has these parameters\n", beyond->found, beyond->statement);
  for (auto const& line : facts(chosen)) say("  {}\n", printable(line));
  if (chosen.law.refinement > 1) say("  integrated in {} steps per sample\n", chosen.law.refinement);
}

// What of the motion is beyond what is known of the law.
std::vector<std::string> cautions(laws::LawEntry const& law, FittedLaw const& chosen, data::FitRecord const& path) {
  std::vector<std::string> lines;
  auto const add_beyond = [&](double reached, double fitted, double tested, std::string_view unit) {
    constexpr double beyond = 1.02;
    auto const add = [&](double known, std::string_view what, std::string_view so) {
      lines.push_back(
          fmt::format("warning: the history reaches {:.4g} {}, {} {:.4g} {}{}", reached, unit, what, known, unit, so));
    };
    bool const is_part = tested > beyond * fitted;
    if (is_part && fitted > 0.0 && reached > beyond * fitted) add(fitted, "what the law was fitted to", "");
    if (tested > 0.0 && reached > beyond * tested) add(tested, "the test", ": beyond it nothing was measured");
  };
  auto const& [tested, fitted] = chosen.ranges;
  add_beyond(largest(path.disp_mm), fitted.disp_mm, tested.disp_mm, "mm");
  if (!law.info.traits.rate_independent)
    add_beyond(largest(path.vel_mm_s), fitted.vel_mm_s.value_or(0.0), tested.vel_mm_s.value_or(0.0), "mm/s");
  constexpr double at_zero = 1e-6;  // of the largest displacement
  if (double const x = path.disp_mm.front(); std::abs(x) > at_zero * largest(path.disp_mm))
    lines.push_back(fmt::format(
        "warning: the motion starts at {:.4g} mm: the device is taken as virgin there, its force as if it had come there without history; an analysis program starts at 0: put a path from 0 in front to compare",
        x));
  return lines;
}

// Numbers read back as the same doubles. Of a campaign's law what is known of it stands above them.
std::string csv_text(std::string_view law, std::vector<std::string> const& known, data::TestRecord const& motion,
                     data::FitRecord const& path, std::vector<double> const& force_kN) {
  std::string text;
  if (!known.empty()) text += fmt::format("# isolaw {}, force of {}\n", version(), law);
  for (auto const& line : known) text += "# " + printable(line) + "\n";
  if (!motion.has_time()) {
    text += "displacement [mm],force [kN]\n";
    for (std::size_t i = 0; i < motion.size(); ++i) text += fmt::format("{},{}\n", motion.disp_mm[i], force_kN[i]);
    return text;
  }
  text += "time [s],displacement [mm],velocity [mm/s],force [kN]\n";
  for (std::size_t i = 0; i < motion.size(); ++i)
    text += fmt::format("{},{},{},{}\n", motion.time_s[i], motion.disp_mm[i], path.vel_mm_s[i], force_kN[i]);
  return text;
}

}  // namespace

int simulate(SimulateArguments const& a) {
  auto const& law = laws::find_law(a.law);
  auto const chosen = chosen_law(a, law);
  data::ReadOptions options;
  apply(a.read, options);
  auto const motion = data::read_motion(a.motion, options);
  auto path = data::motion_of(motion);
  auto const& taken = chosen.law;
  path.dead_band_mm = taken.dead_band_mm;
  fit::LawOnMotion const model(law, path, taken.integration, taken.turning_points, taken.refinement);
  auto const force_kN = model.force_kN(taken.parameters);
  say_what_it_is(law, chosen, motion);
  auto const beyond = cautions(law, taken, path);
  for (auto const& line : beyond) say("  {}\n", line);
  if (auto const bad = std::ranges::find_if_not(force_kN, [](double f) { return std::isfinite(f); });
      bad != force_kN.end())
    throw Error(
        {.where = "law " + std::string(law.info.id),
         .found = fmt::format("no finite force from sample {} on with these parameters", bad - force_kN.begin() + 1),
         .allowed = "parameters of a device like this one",
         .advice = "--refinement 4, finer steps; isolaw laws " + std::string(law.info.id)});
  auto const [least, most] = std::ranges::minmax(force_kN);
  say("  {} samples, force from {:.4g} to {:.4g} kN\n", force_kN.size(), least, most);
  auto known = facts(chosen);
  if (!known.empty()) known.insert(known.end(), beyond.begin(), beyond.end());
  auto const text = csv_text(law.info.id, known, motion, path, force_kN);
  if (!a.out) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return exit_done;
  }
  std::vector<std::filesystem::path> inputs{a.motion};
  if (a.parameters) inputs.push_back(*a.parameters);
  write_output(*a.out, text, inputs);
  say("written: {}\n", shown(*a.out));
  return exit_done;
}

}  // namespace isolaw::app
