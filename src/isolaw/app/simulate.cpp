// Implements `isolaw simulate`, which computes the force of a law under any displacement history.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <numbers>

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
#include "isolaw/campaign/named_device.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/fit/as_springs.hpp"
#include "isolaw/fit/in_plane.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/laws/plane/in_plane.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/design_bounds.hpp"
#include "isolaw/study/doubts.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::app {
namespace {

constexpr int finest = 1000;  // the largest number of integration steps per sample

struct Chosen {
  FittedLaw law;
  study::Doubts doubts;               // the campaign's doubts about the fitted law
  std::string origin;                 // "device 'a'" or "the lot"; empty if the law is not from a campaign
  std::vector<std::string> changes;   // values given with --set; the law then differs from the campaign's
  std::optional<Finding> bound = {};  // if the simulated law is a bound law: the finding that describes it
  // The record and the search box of the fit. They are set only if the law was fitted to one device and --set changed
  // nothing.
  struct Fit {
    data::FitRecord record;
    fit::SearchBox box;
  };
  std::optional<Fit> fit = {};
};

// Replaces the fitted law by the bound law: the same law with parameters for the lower or upper bound over the design
// conditions. Springs around the circle then get these parameters too.
void take_bound(SimulateArguments const& a, study::Summary const& summary, laws::LawEntry const& law, Chosen& chosen) {
  if (*a.bound != "lower" && *a.bound != "upper")
    throw Error({.where = "--bound", .found = *a.bound, .allowed = "lower or upper"});
  auto const bounds = study::design_bounds(summary, law, chosen.law.parameters);
  if (bounds.obstacle)
    throw Error({.where = "--bound",
                 .found = wording::remark(*bounds.obstacle),
                 .allowed = "a campaign whose tests cover all design conditions of its lot file",
                 .advice = "isolaw conditions LOT.toml"});
  auto const& bound = *a.bound == "lower" ? *bounds.lower : *bounds.upper;
  chosen.law.parameters = bound.law.parameters;
  chosen.law.springs.reset();
  chosen.fit.reset();
  chosen.bound = study::about_bound(*a.bound, bound);
}

Chosen chosen_law(SimulateArguments const& a, laws::LawEntry const& law) {
  if (a.parameters && a.from)
    throw Error({.where = "--parameters and --from", .found = "both are given", .allowed = "one of them"});
  if (a.anyway && !a.from)
    throw Error({.where = "--anyway",
                 .found = "is given alone",
                 .allowed = "with --from DIR: other parameters are taken without it"});
  if (a.bound && (!a.from || !a.set.empty()))
    throw Error({.where = "--bound",
                 .found = a.from ? "is given with --set" : "is given without --from",
                 .allowed = "with --from DIR and without --set"});
  if (a.from.has_value() != a.device.has_value())
    throw Error({.where = a.from ? "--from" : "--device",
                 .found = "is given alone",
                 .allowed = "--from DIR with --device NAME, or --device lot for the one law of the lot"});
  Chosen chosen;
  std::vector<NamedValue> values;
  auto where = std::string("--parameters");
  if (a.parameters) {
    values = read_parameter_file(*a.parameters, law);
    where = shown(*a.parameters);
  } else if (a.from) {
    where = shown(*a.from);
    auto const contents = campaign::Store::read(*a.from / store_name);
    chosen.law = fitted_law(contents, law.info.id, *a.device);
    auto const device =
        campaign::named_device(contents, *a.device) ? std::optional<std::string_view>(*a.device) : std::nullopt;
    chosen.origin = device ? "device '" + *a.device + "'" : std::string("the lot");
    chosen.changes = a.set;
    if (chosen.changes.empty()) {
      if (auto const index = campaign::named_device(contents, *a.device))
        for (auto const& search : contents.searches)
          if (search.device == *index && search.law == law.info.id)
            chosen.fit = Chosen::Fit{contents.devices[*index].record, search.box};
      auto const summary = study::build_summary(contents);
      chosen.doubts = study::doubts(summary, law.info.id, device);
      study::require_no_objection(chosen.doubts, study::law_and_device_text(law.info.id, device), a.anyway);
      if (a.bound) take_bound(a, summary, law, chosen);
    }
    for (std::size_t i = 0; i < law.parameters.size(); ++i)
      values.push_back({.name = std::string(law.parameters[i].name), .value = chosen.law.parameters[i]});
  }
  std::vector<NamedValue> changes;
  for (auto const& text : a.set) changes.push_back(parse_named_value(text, "--set"));
  std::erase_if(values, [&](auto const& value) {
    return std::ranges::find(changes, value.name, &NamedValue::name) != changes.end();
  });
  values.insert(values.end(), changes.begin(), changes.end());
  // For a fit that --set did not change, limits on several parameters together are not checked, because a search box
  // may reach beyond such limits.
  auto& taken = chosen.law;
  taken.parameters = parameters_in_order(law, values, where,
                                         a.from && changes.empty() ? JointLimits::unchecked : JointLimits::checked);
  campaign::Settings how;
  how.integration = taken.integration;
  how.turning_points = taken.turning_points;
  campaign::apply(a.how, how);
  taken.integration = how.integration;
  taken.turning_points = how.turning_points;
  if (!a.from && a.how.contains("dead-band") && !how.clean.dead_band_mm)
    throw Error({.where = "--dead-band",
                 .found = "auto is given without --from: it is computed from the noise of the record of a fit",
                 .allowed = "a number of mm"});
  taken.dead_band_mm = how.clean.dead_band_mm.value_or(taken.dead_band_mm);
  if (a.refinement) taken.refinement = *a.refinement;
  if (taken.refinement < 1 || taken.refinement > finest)
    throw Error({.where = "--refinement",
                 .found = fmt::format("{}", taken.refinement),
                 .allowed = fmt::format("1 to {} steps per sample", finest)});
  return chosen;
}

std::vector<std::string> facts(Chosen const& chosen) {
  if (chosen.origin.empty()) return {};
  auto const& [tested, fitted] = chosen.law.ranges;
  auto const reach = fmt::format("{}, {}, up to {:.4g} mm; tested up to {:.4g} mm", chosen.origin,
                                 study::part_text(chosen.law.part), fitted.disp_mm, tested.disp_mm);
  if (!chosen.changes.empty())
    return {
        fmt::format("fitted to {}", reach),
        fmt::format("changed by --set {}: how well this law fits or predicts is not known", joined(chosen.changes))};
  std::vector<std::string> lines{fmt::format("fitted to {}", reach), wording::remark(chosen.doubts.prediction)};
  if (chosen.bound) lines.push_back(wording::remark(*chosen.bound));
  std::ranges::move(wording::lines(chosen.doubts.findings, wording::with_law), std::back_inserter(lines));
  if (chosen.doubts.objection) lines.push_back(study::override_warning(wording::remark(*chosen.doubts.objection)));
  return lines;
}

void say_what_it_is(laws::LawEntry const& law, Chosen const& chosen, data::TestRecord const& motion) {
  say("{}\n", shown(motion.file));
  for (auto const& finding : motion.recognised)
    if (finding.kind != FindingKind::no_time_column) say("  {}\n", wording::remark(finding));
  for (auto const& line : wording::remarks(motion.warnings)) say("  warning: {}\n", line);
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

std::vector<std::string> as_warnings(std::vector<std::string> lines) {
  for (auto& line : lines) line.insert(0, "warning: ");
  return lines;
}

// Returns the result as CSV. Numbers have so many digits that reading them gives the same doubles again.
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

struct TwoDirections {
  laws::Bidirectional how;
  laws::plane::Softening softening;
  bool as_given;  // true: springs use the law's own parameters; false: parameters fitted for springs
  std::string second_disp;
};
std::optional<TwoDirections> two_directions(SimulateArguments const& a) {
  if (!a.bidirectional) {
    if (a.second_disp || a.softening || a.springs)
      throw Error({.where = a.second_disp ? "--second-disp"
                            : a.softening ? "--softening"
                                          : "--springs",
                   .found = "is given alone",
                   .allowed = "with --bidirectional coupled or springs"});
    return std::nullopt;
  }
  auto const word = [](char const* option, std::string const& given, std::string_view first, std::string_view second) {
    if (given == first || given == second) return given == first;
    throw Error({.where = option, .found = given, .allowed = fmt::format("{} or {}", first, second)});
  };
  TwoDirections directions{};
  bool const coupled = word("--bidirectional", *a.bidirectional, "coupled", "springs");
  directions.how = coupled ? laws::Bidirectional::coupled : laws::Bidirectional::springs;
  if (a.softening) {
    if (!coupled)
      throw Error({.where = "--softening",
                   .found = "is given with springs, each of which keeps its own peak",
                   .allowed = "with --bidirectional coupled"});
    if (!word("--softening", *a.softening, "distance", "axis")) directions.softening = laws::plane::Softening::by_axis;
  }
  if (a.springs) {
    if (coupled)
      throw Error({.where = "--springs",
                   .found = "is given with a coupled law, whose parameters are those of one direction",
                   .allowed = "with --bidirectional springs"});
    directions.as_given = word("--springs", *a.springs, "given", "fitted");
  }
  if (!a.second_disp)
    throw Error({.where = "--bidirectional",
                 .found = "is given without the second displacement",
                 .allowed = "--second-disp COLUMN, and --columns disp=COLUMN for the first"});
  directions.second_disp = *a.second_disp;
  return directions;
}

void require_none_of_one_direction(FittedLaw const& law) {
  auto const refuse = [](std::string_view option, std::string_view allowed) {
    throw Error({.where = std::string(option),
                 .found = "is of a path in one direction, known ahead",
                 .allowed = std::string(allowed) + " with --bidirectional"});
  };
  if (law.integration != laws::Integration::converged) refuse("--integration paper", "--integration converged");
  if (law.turning_points != laws::TurningPoints::as_sampled)
    refuse("--turning-points interpolated", "--turning-points sampled");
}

double distance(laws::plane::Vector<double> const& a) {
  return std::hypot(a.x, a.y);
}

std::string fit_as_springs(laws::LawEntry const& law, Chosen const& chosen, FittedLaw& taken) {
  bool const stored = taken.springs.has_value();
  auto const springs =
      stored ? *taken.springs
             : fit::fitted_as_springs(law, chosen.fit->record, chosen.fit->box, taken.parameters, taken.refinement);
  taken.parameters = springs.parameters;
  return fmt::format(
             "springs with parameters of their own, fitted to {}: objective {:.4g}; {:.4g} with those of the law, whose own is {:.4g}",
             chosen.fit ? "the device's record" : "the devices' records", springs.fitted, springs.given, springs.law) +
         (stored ? "; as the campaign stored them" : "");
}
std::vector<std::string> left_open(fit::LawInPlane const& law, TwoDirections const& two, fit::PlaneMotion const& motion,
                                   bool as_given) {
  double size = 0.0, fastest = 0.0;
  for (auto const& at : motion.disp_mm) size = std::max(size, distance(at));
  for (auto const& v : motion.vel_mm_s) fastest = std::max(fastest, distance(v));
  if (size == 0.0) return {};
  double const cycle = fastest > 0.0 ? 2.0 * std::numbers::pi * size / fastest : 1.0;
  std::vector<std::string> lines;
  if (two.how == laws::Bidirectional::springs && !laws::springs_follow(law.law->info.id))
    std::ranges::move(
        wording::lines(
            {{.kind = FindingKind::unequal_sides, .law = std::string(law.law->info.id), .words = {{"how", "springs"}}}},
            wording::with_law),
        std::back_inserter(lines));
  if (two.how == laws::Bidirectional::springs && as_given)
    lines.push_back(fmt::format(
        "springs round the knee: along one direction, at {:.4g} mm, their work differs by {:+.2f} % from the work of the law",
        size, 100.0 * (fit::work_of_springs_on_a_line(law, size, cycle) - 1.0)));
  else if (law.dead_band_mm > 0.0 && law.law->info.traits.remembers)
    lines.push_back(fmt::format(
        "warning: the dead band of {:.4g} mm that the law was fitted with is defined along one direction, and is not used here",
        law.dead_band_mm));
  // The comparison below needs the law's own parameters. Springs may have other ones, which were fitted for springs;
  // then there is no comparison.
  if (two.how == laws::Bidirectional::springs && !as_given) return lines;
  // A sine of the period `cycle` is as fast as the user's motion. A figure of eight of the same period would be sqrt(2)
  // times as fast, so its period is taken sqrt(2) times as long.
  auto const rules = fit::on_a_figure_of_eight(law, size, std::numbers::sqrt2 * cycle);
  if (rules.size() < 2) return lines;
  auto const [peak, work] = fit::largest_difference_of(rules);
  lines.push_back(fmt::format(
      "tests in one direction leave open, on a figure of eight of {:.4g} mm: {:.2g} % of the peak force, {:.2g} % of the work of a turn",
      size, 100.0 * peak, 100.0 * work));
  for (auto const& of : rules)
    lines.push_back(fmt::format("  {}: {:.4g} kN, {:.4g} kN mm", of.rule, of.peak_kN, of.work_kN_mm));
  return lines;
}

std::string plane_csv_text(std::string_view law, std::vector<std::string> const& known, fit::PlaneMotion const& motion,
                           std::vector<laws::plane::Vector<double>> const& force_kN) {
  std::string text;
  if (!known.empty()) text += fmt::format("# isolaw {}, forces of {}\n", version(), law);
  for (auto const& line : known) text += "# " + printable(line) + "\n";
  bool const has_time = !motion.vel_mm_s.empty();
  text +=
      has_time
          ? "time [s],displacement x [mm],displacement y [mm],velocity x [mm/s],velocity y [mm/s],force x [kN],force y [kN]\n"
          : "displacement x [mm],displacement y [mm],force x [kN],force y [kN]\n";
  for (std::size_t i = 0; i < motion.disp_mm.size(); ++i) {
    auto const &d = motion.disp_mm[i], &f = force_kN[i];
    if (has_time) {
      auto const& v = motion.vel_mm_s[i];
      text += fmt::format("{},{},{},{},{},{},{}\n", motion.time_s[i], d.x, d.y, v.x, v.y, f.x, f.y);
    } else {
      text += fmt::format("{},{},{},{}\n", d.x, d.y, f.x, f.y);
    }
  }
  return text;
}

void write_or_print(SimulateArguments const& a, std::string const& text) {
  if (!a.out) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return;
  }
  std::vector<std::filesystem::path> inputs{a.motion};
  if (a.parameters) inputs.push_back(*a.parameters);
  write_output(*a.out, text, inputs);
  say("written: {}\n", shown(*a.out));
}

Error no_finite_force(laws::LawEntry const& law, std::ptrdiff_t sample) {
  return Error({.where = "law " + std::string(law.info.id),
                .found = fmt::format("no finite force from sample {} on with these parameters", sample + 1),
                .allowed = "parameters of a device like this one",
                .advice = "--refinement 4, finer steps; isolaw laws " + std::string(law.info.id)});
}

int simulate_in_plane(SimulateArguments const& a, TwoDirections const& two, laws::LawEntry const& law, Chosen chosen,
                      data::ReadOptions options) {
  auto& taken = chosen.law;
  require_none_of_one_direction(taken);
  bool const fits = two.how == laws::Bidirectional::springs && !two.as_given;
  bool const stored = taken.springs && chosen.changes.empty();
  if (fits && a.springs && !chosen.fit && !stored)
    throw Error({.where = "--springs",
                 .found = "parameters that were not fitted to a device's record",
                 .allowed = "fitted, with --from DIR and --device NAME and without --set"});
  auto const first = data::read_motion(a.motion, options);
  options.columns[data::Channel::disp] = two.second_disp;
  auto const second = data::read_motion(a.motion, options);
  if (first.size() != second.size())
    throw Error(
        {.where = shown(a.motion),
         .found = fmt::format("{} values of the first displacement, {} of the second", first.size(), second.size()),
         .allowed = "as many of each"});
  if (!law.info.traits.rate_independent && !first.has_time())
    throw Error({.where = "law " + std::string(law.info.id),
                 .found = "the motion has no time channel, and this law depends on velocity",
                 .allowed = "a rate-independent law without time",
                 .advice = "--dt SECONDS, the sampling interval"});
  auto const x = data::motion_of(first), y = data::motion_of(second);
  fit::PlaneMotion motion{.time_s = x.time_s, .disp_mm = {}, .vel_mm_s = {}};
  data::FitRecord reach = x;  // distance from the origin and speed, for warnings about motions beyond the tests
  for (std::size_t i = 0; i < x.size(); ++i) {
    motion.disp_mm.push_back({x.disp_mm[i], y.disp_mm[i]});
    reach.disp_mm[i] = distance(motion.disp_mm[i]);
    if (!x.has_time()) continue;
    motion.vel_mm_s.push_back({x.vel_mm_s[i], y.vel_mm_s[i]});
    reach.vel_mm_s[i] = distance(motion.vel_mm_s[i]);
  }
  std::optional<std::string> springs_line;
  if (fits && (chosen.fit || stored)) springs_line = fit_as_springs(law, chosen, taken);
  fit::LawInPlane const in_plane{&law, taken.parameters, taken.dead_band_mm, taken.refinement};
  auto const force_kN = fit::force_kN(law, in_plane.form(two.how, two.softening), motion);
  say_what_it_is(law, chosen, first);
  auto lines = as_warnings(beyond_what_is_known(law, taken, reach));
  if (springs_line) lines.push_back(*springs_line);
  auto const open = left_open(in_plane, two, motion, !springs_line);
  lines.insert(lines.end(), open.begin(), open.end());
  for (auto const& line : lines) say("  {}\n", line);
  if (auto const bad = std::ranges::find_if_not(force_kN, [](auto const& f) { return std::isfinite(distance(f)); });
      bad != force_kN.end())
    throw no_finite_force(law, bad - force_kN.begin());
  double peak = 0.0;
  for (auto const& f : force_kN) peak = std::max(peak, distance(f));
  say("  {} samples, in two directions {}, force up to {:.4g} kN\n", force_kN.size(), *a.bidirectional, peak);
  auto known = facts(chosen);
  if (!known.empty()) known.insert(known.end(), lines.begin(), lines.end());
  write_or_print(a, plane_csv_text(law.info.id, known, motion, force_kN));
  return exit_done;
}

}  // namespace

int simulate(SimulateArguments const& a) {
  auto const& law = laws::find_law(a.law);
  auto const chosen = chosen_law(a, law);
  data::ReadOptions options;
  apply(a.read, options);
  if (auto const two = two_directions(a)) return simulate_in_plane(a, *two, law, chosen, options);
  auto const motion = data::read_motion(a.motion, options);
  auto path = data::motion_of(motion);
  auto const& taken = chosen.law;
  path.dead_band_mm = taken.dead_band_mm;
  fit::LawOnMotion const model(law, path, taken.integration, taken.turning_points, taken.refinement);
  auto const force_kN = model.force_kN(taken.parameters);
  say_what_it_is(law, chosen, motion);
  auto const beyond = as_warnings(cautions(law, taken, path));
  for (auto const& line : beyond) say("  {}\n", line);
  if (auto const bad = std::ranges::find_if_not(force_kN, [](double f) { return std::isfinite(f); });
      bad != force_kN.end())
    throw no_finite_force(law, bad - force_kN.begin());
  auto const [least, most] = std::ranges::minmax(force_kN);
  say("  {} samples, force from {:.4g} to {:.4g} kN\n", force_kN.size(), least, most);
  auto known = facts(chosen);
  if (!known.empty()) known.insert(known.end(), beyond.begin(), beyond.end());
  auto const text = csv_text(law.info.id, known, motion, path, force_kN);
  write_or_print(a, text);
  return exit_done;
}

}  // namespace isolaw::app
