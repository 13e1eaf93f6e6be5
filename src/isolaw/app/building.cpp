#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "isolaw/api/building_work.hpp"
#include "isolaw/api/campaign_directory.hpp"
#include "isolaw/api/merge.hpp"
#include "isolaw/app/commands.hpp"
#include "isolaw/app/interruption.hpp"
#include "isolaw/app/report.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/base/write_file.hpp"
#include "isolaw/building/answers.hpp"
#include "isolaw/building/arrangement.hpp"
#include "isolaw/building/linear_oscillator.hpp"
#include "isolaw/building/plausibility.hpp"
#include "isolaw/building/synthetic_motion.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/channels/ground_motion.hpp"
#include "isolaw/render/figures/building_figures.hpp"
#include "isolaw/render/json/building_json.hpp"
#include "isolaw/render/tables/tables.hpp"
#include "isolaw/render/write.hpp"
#include "isolaw/wording/table.hpp"
#include "isolaw/wording/words.hpp"

namespace isolaw::app {
namespace {

// Shows which share of the analyses is done: on a terminal in one line that changes, in a log file with a new line
// every half minute.
class BuildingProgress {
 public:
  BuildingProgress() = default;
  BuildingProgress(BuildingProgress const&) = delete;
  BuildingProgress& operator=(BuildingProgress const&) = delete;
  ~BuildingProgress() {
    if (drawn_) say("\r\033[K");
  }

  void show(building::RunProgress const& progress) {
    auto const now = Clock::now();
    if (!first_) first_ = progress.done;
    constexpr std::chrono::seconds pause(30);
    if (!terminal_ && now - last_ < pause) return;
    last_ = now;
    // Does not count analyses that an earlier call left in the store, because they took none of the time measured here.
    auto const fresh = static_cast<double>(progress.done - *first_);
    auto const left = static_cast<double>(progress.total - progress.done);
    double const spent_s = std::chrono::duration<double>(now - start_).count();
    auto const line = fmt::format(
        "{:.0f} % done, {}, {}/{} analyses",
        std::floor(100.0 * static_cast<double>(progress.done) / static_cast<double>(progress.total)),
        fresh > 0.0 ? fmt::format("{:.0f} s left", spent_s / fresh * left) : "started", progress.done, progress.total);
    if (!terminal_) return say("{}\n", line);
    drawn_ = true;
    say("\r{} \033[K", line);
  }

 private:
  using Clock = std::chrono::steady_clock;
  bool terminal_ = is_terminal(StandardStream::error), drawn_ = false;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  std::optional<std::size_t> first_;
};

// Tells the user that motions given with --motion are not scaled. The scales in the building file belong to the motions
// that they replace.
void say_motions(building::BuildingFile const& file, std::filesystem::path const& path) {
  if (file.replaced_scales.empty()) return;
  auto const [least, most] = std::ranges::minmax(file.replaced_scales);
  bool const scaled = least != 1.0 || most != 1.0;
  say("{} of --motion {} used as given, with scale 1, in place of {} of {}{}\n", counted(file.motions.size(), "motion"),
      file.motions.size() == 1 ? "is" : "are", counted(file.replaced_scales.size(), "motion"), shown(path),
      !scaled ? std::string()
      : least == most
          ? fmt::format(", which had scale {:g}; a [[motion]] in the file scales a motion", least)
          : fmt::format(", which had scales from {:g} to {:g}; a [[motion]] in the file scales a motion", least, most));
}

// Returns a cell of a table with a right-aligned number, or "-" if there is no number.
std::string cell(std::optional<double> value, int width = 9, int digits = 4) {
  return value && std::isfinite(*value) ? fmt::format(" {:>{}.{}g}", *value, width, digits)
                                        : fmt::format(" {:>{}}", "-", width);
}
std::string decimals_cell(double value, int width, int decimals) {
  return std::isfinite(value) ? fmt::format(" {:>{}.{}f}", value, width, decimals) : fmt::format(" {:>{}}", "-", width);
}

std::string signed_cell(std::optional<double> value, int decimals) {
  return value && std::isfinite(*value) ? fmt::format(" {:+.{}f}", *value, decimals) : " -";
}

std::string kept_text(building::LimitCheck const& judged) {
  switch (judged.limit_kept) {
    case building::LimitKept::yes:
      return "kept";
    case building::LimitKept::open:
      return "draws too few to tell";
    case building::LimitKept::no:
      break;
  }
  return fmt::format("NOT KEPT: {}",
                     judged.broken_by.ends_with("failed")
                         ? fmt::format("no numbers ({})", judged.broken_by.substr(0, judged.broken_by.find(' ')))
                         : std::string(judged.broken_by));
}

// Returns the first cells of a limit's row: the name of the limit and the allowed response.
std::string limit_text(building::LimitCheck const& judged, UnitSystem const& units) {
  auto const& quantity = building::quantity(judged.quantity);
  auto const shown = shown_unit(quantity.unit, units);
  auto const title = fmt::format("{}{}", judged.limit == building::tested_mm ? "tested " : "", quantity.title);
  return fmt::format("{:<32}{}",
                     shown.unit.empty() || shown.unit == "-" ? title : title + " [" + std::string(shown.unit) + "]",
                     cell(shown.factor * judged.allowed));
}

// Returns a table with one line for each limit: the allowed value, the values of the nominal building and of the bound
// analyses, the 95 % fractile of the draws, the share of the draws that keep the limit, and whether the limit is kept.
// The table has no columns for bounds or draws that were not analysed.
std::string limits_text(building::LawAnswer const& law, UnitSystem const& units) {
  if (law.limit_checks.empty()) return {};
  bool const bounds = law.limit_checks.front().bound.has_value(), draws = law.limit_checks.front().p95.has_value();
  auto text = fmt::format("{:<32} {:>9} {:>9}{}{}\n", "", "allowed", "nominal", bounds ? "    bounds" : "",
                          draws ? "      95 %   kept by" : "");
  for (auto const& each : law.limit_checks) {
    auto const factor = shown_unit(building::quantity(each.quantity).unit, units).factor;
    text += limit_text(each, units) + cell(factor * each.nominal);
    if (bounds) text += cell(factor * *each.bound);
    if (draws) text += cell(factor * *each.p95) + fmt::format(" {:>8.1f}%", 100.0 * *each.share_kept);
    text += fmt::format("  {}\n", kept_text(each));
  }
  return text;
}

// Returns a table with a line for each limit and a column for each law. A cell has the largest response that is
// compared with the limit, and says whether the limit is kept.
std::string limits_by_law(std::vector<building::LawAnswer> const& laws, UnitSystem const& units) {
  constexpr int width = 36;
  auto text = fmt::format("{:<32} {:>9}", "", "allowed");
  for (auto const& law : laws) text += fmt::format("  {:<{}}", law.law, width);
  text = std::string(text.substr(0, text.find_last_not_of(' ') + 1)) + "\n";
  for (std::size_t i = 0; i < laws.front().limit_checks.size(); ++i) {
    auto line = limit_text(laws.front().limit_checks[i], units);
    for (auto const& law : laws) {
      // The laws may have been fitted to different tests, so for one of them the limit of the tested displacement may
      // be missing.
      auto const found =
          std::ranges::find(law.limit_checks, laws.front().limit_checks[i].limit, &building::LimitCheck::limit);
      if (found == law.limit_checks.end()) {
        line += fmt::format("  {:<{}}", "", width);
        continue;
      }
      double most = found->nominal;
      for (auto const& other : {found->bound, found->p95})
        if (other && !std::isnan(most) && !(*other <= most)) most = *other;
      auto const factor = shown_unit(building::quantity(found->quantity).unit, units).factor;
      line += fmt::format("  {:<{}}", cell(factor * most, 0).substr(1) + " " + kept_text(*found), width);
    }
    text += std::string(line.substr(0, line.find_last_not_of(' ') + 1)) + "\n";
  }
  return text;
}

// Returns the table of the limits for the first law with a result. If there are several laws, a table of all laws
// follows it.
std::string all_limits_text(building::Study const& study, building::Answers const& answers) {
  auto const& units = study.units();
  auto const law = std::ranges::find_if(answers.laws, building::has_result);
  if (law == answers.laws.end() || law->limit_checks.empty()) return {};
  auto text = limits_text(*law, units);
  if (answers.laws.size() > 1) text += "\n" + limits_by_law(answers.laws, units);
  if (study.file.motions.size() < building::motions_for_a_mean) text += "These are the largest of the motions.\n";
  return text + "\n";
}

void print_answers(building::Study const& study, building::Answers const& answers) {
  auto const& units = study.units();
  auto const length = shown_unit("mm", units);
  auto text = wording::paragraph(answers.verdict, units) + "\n\n" + all_limits_text(study, answers);
  text += wording::paragraph(answers.about_bounds, units) + "\n\n";
  bool const drawn = std::ranges::any_of(answers.laws, [](auto const& law) { return law.draws > 0; });
  text +=
      fmt::format("{}, {}, weight {:.0f} {}; means over the motions{}\n", counted(study.file.motions.size(), "motion"),
                  counted(study.file.bearings.size(), "bearing"), units.from_kN(answers.weight_kN), units.force.symbol,
                  drawn ? ", fractiles over " + counted(study.file.settings.draws, "draw") : std::string());
  if (drawn) text += "lot and motion: standard deviations of ln(response), so 0.24 is a scatter of about 24 %\n";
  auto const quantities = building::quantities();
  for (auto const& line : render::building_lines(answers, units)) text += line + "\n";
  for (auto const& law : answers.laws) {
    if (!building::has_result(law)) {
      text += fmt::format("\n{}: no result. {}\n", law.law, wording::capitalised(building::why_without_result(law)));
      continue;
    }
    text += fmt::format("\n{}\n{:<24} {:>9} {:>9} {:>9}", law.law, "", "lower", "nominal", "upper");
    if (drawn) text += "      16 %      50 %      84 %      95 %    lot motion";
    text += '\n';
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      auto const& d = law.distributions[q];
      auto const factor = shown_unit(quantities[q].unit, units).factor;
      auto const add = [&](double v) { text += cell(std::abs(v) < 1e-9 ? 0.0 : factor * v); };
      text += fmt::format("{:<24}", name_in(quantities[q].key, units));
      for (double const v : {d.lower, d.nominal, d.upper}) add(v);
      if (drawn) {
        for (double const v : d.fractiles) add(v);
        text += decimals_cell(d.lot_std_ln, 6, 3) + decimals_cell(d.motion_std_ln, 6, 3);
      }
      text += '\n';
    }
    text += fmt::format("energy error at most {:.1e}; {} runs failed\n", law.worst_balance, law.failed);
    for (std::size_t m = 0; m < law.checked.size(); ++m) {
      auto const& c = law.checked[m];
      if (c.outcome != building::name(building::Outcome::completed)) {
        text += fmt::format("{}: the implicit analysis of the nominal building stopped: {}\n",
                            printable(study.file.motions[m].name), c.outcome);
        continue;
      }
      auto const missed = c.missed_mm ? fmt::format("{:.{}f}", length.factor * *c.missed_mm, length.decimals(3)) : "-";
      text += fmt::format(
          "{}: implicit {:.{}f} {} (misses {}), energy error {:.1e}, draws' path{} %, equivalent linear{} %: {}\n",
          printable(study.file.motions[m].name), length.factor * *c.isolator_mm, length.decimals(2), length.unit,
          missed, *c.balance, signed_cell(c.draws_error_percent, 2), signed_cell(c.equivalent_error_percent, 0),
          c.outcome);
    }
  }
  print(text);
}

void print_arrangement(building::Study const& study, building::Answers const& answers) {
  auto const length = shown_unit("mm", study.units());
  for (std::size_t l = 0; l < study.laws.size(); ++l) {
    auto const& law = study.laws[l];
    std::vector<std::string> names;
    std::vector<double> stiffness;
    double const at = answers.laws[l].distributions.front().nominal;
    auto const period_s = answers.laws[l].checked.front().equivalent_period_s;
    if (!std::isfinite(at) || !period_s) {
      print(
          fmt::format("\n{}: no arrangement, since the nominal building has no finite displacement or no positive "
                      "effective stiffness\n",
                      law.law));
      continue;
    }
    for (auto const& [name, values] : law.devices) {
      names.push_back(name);
      stiffness.push_back(
          building::effective(law.law, values, at, *period_s, building::coupling_of(law.law, values)).stiffness_kN_mm);
    }
    std::vector<building::Point> places;
    for (auto const& b : study.file.bearings) places.push_back(b.at);
    auto const arrangement = building::arrange(places, study.file.frame.base.centre, stiffness);
    std::string text = fmt::format(
        "\n{}: eccentricity of stiffness {:.{}f} {}, {:.{}f} {} in the order of their names\nx_m,y_m,device\n", law.law,
        length.factor * arrangement.eccentricity_mm, length.decimals(1), length.unit,
        length.factor * arrangement.in_order_mm, length.decimals(1), length.unit);
    for (std::size_t i = 0; i < places.size(); ++i)
      text += fmt::format("{:g},{:g},{}\n", places[i].x_mm / 1e3, places[i].y_mm / 1e3,
                          printable(names[arrangement.device[i]]));
    print(text);
  }
}

int nominal_alone(building::Study const& study, std::filesystem::path const& out) {
  auto const folder = out / "histories";
  make_folder(folder);
  auto const floors = study.file.frame.floors.size();
  building::Layout const layout{floors, study.file.bearings.size()};
  std::vector<Finding> doubts;
  for (auto const& law : study.laws) doubts.insert(doubts.end(), law.doubts.begin(), law.doubts.end());
  for (auto const& line : wording::lines(doubts, wording::with_building, study.units(), render::from_calibration))
    say("{}\n", line);
  auto warnings = building::study_doubts(study);
  print("law,motion,outcome,isolator_mm,base_acceleration_g,roof_acceleration_g,energy_error,file\n");
  bool all = true;
  std::vector<std::vector<std::vector<double>>> measured;
  for (auto const& law : study.laws) {
    measured.emplace_back();
    for (std::size_t m = 0; m < study.file.motions.size(); ++m) {
      auto const& motion = study.file.motions[m];
      auto const run = building::nominal_run(study, law, motion);
      auto const file = fmt::format("{}-{}.csv", law.law, m + 1);
      write_file(folder / file, building::history_csv(run, motion));
      auto const acceleration = [&](std::size_t diaphragm) {
        return run.measured[layout.acceleration(diaphragm)] / data::gravity_mm_s2;
      };
      bool const completed = run.outcome == building::Outcome::completed;
      all = all && completed;
      auto const numbers = fmt::format("{:.6g},{:.6g},{:.6g},{:.2e}", run.value(building::Measure::isolator),
                                       acceleration(0), acceleration(floors), run.value(building::Measure::balance));
      // The values that an analysis reached before it stopped are no response of the building, so they are not printed.
      print(fmt::format("{},{},{},{},{}\n", law.law, printable(motion.name), building::name(run.outcome),
                        completed ? numbers : ",,,", file));
      measured.back().push_back(completed ? run.measured : std::vector<double>());
      if (!completed) say("{}, {}: {}\n", law.law, printable(motion.name), printable(run.stop_reason));
      if (completed)
        std::ranges::move(building::run_doubts(run, law.law, motion.name, law.tested_mm), std::back_inserter(warnings));
    }
  }
  for (auto const& line : wording::lines(warnings, wording::with_building, study.units())) say("{}\n", line);
  auto const answers = building::answer_of_nominal(study, measured);
  say("{}\n{}{}\n", wording::paragraph(answers.verdict, study.units()), all_limits_text(study, answers), shown(folder));
  return all && answers.holds != false ? exit_done : exit_with_refusals;
}

std::string full_name(std::filesystem::path const& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

// Makes the names of motion files absolute. A text such as "x.AT2,y.AT2" holds the names of two files, one for each
// direction.
std::vector<std::string> full_names(std::vector<std::string> motions) {
  for (auto& motion : motions) {
    auto const comma = motion.find(',');
    motion = full_name(std::filesystem::path(motion.substr(0, comma))) +
             (comma == std::string::npos ? "" : "," + full_name(std::filesystem::path(motion.substr(comma + 1))));
  }
  return motions;
}

}  // namespace

building::Study building_study(BuildingArguments const& a) {
  if (!a.file || !a.from)
    throw Error({.where = "isolaw building",
                 .found = a.file   ? "no campaign is given (--from)"
                          : a.from ? "no building file is given"
                                   : "no building file and no campaign is given",
                 .allowed = "isolaw building BUILDING.toml --from CAMPAIGN",
                 .advice = "isolaw building --template"});
  auto file = building::read_building(*a.file, {.motions = building::read_motions(a.motions, a.stated)});
  auto study = isolaw::building_study(std::move(file), campaign::Store::read(*a.from / store_name), a.from->string());
  if (a.report_units) study.report_units = find_unit_system(*a.report_units, "--report-units").id;
  return study;
}

int building(BuildingArguments const& a, std::vector<std::string> const& command_line) {
  if (a.print_template) {
    print(building::building_template());
    return exit_done;
  }
  auto const part = a.part ? std::optional(campaign::parse_part(*a.part)) : std::nullopt;
  if (part && (a.json || a.arrange || a.nominal))
    throw Error({.where = a.json      ? "--json"
                          : a.arrange ? "--arrange"
                                      : "--nominal",
                 .found = "a part has no answers",
                 .advice = "isolaw merge OUT PARTS... of all of them"});
  auto const study = building_study(a);
  if (a.arrange)
    for (auto const& law : study.laws)
      if (law.devices.size() < study.file.bearings.size())
        throw Error(
            {.where = "--arrange",
             .found = fmt::format("{} tested devices for {} bearings", law.devices.size(), study.file.bearings.size()),
             .allowed = "a tested device for each place"});
  auto const figures = render::figure_choice(a.figures);
  auto const out = a.out.value_or(std::filesystem::path("out") / "building");
  checked_model(study);
  say_motions(study.file, *a.file);
  if (a.nominal) return nominal_alone(study, out);
  BuildingWork options{.jobs = a.jobs.value_or(0), .directory = out, .fresh = a.fresh};
  if (part) options.part = {*part, full_name(*a.file), full_name(*a.from), full_names(a.motions), a.stated};
  options.interrupted = interrupted;
  auto const studied = [&] {
    SignalGuard const guard;
    BuildingProgress line;
    options.progress = [&](building::RunProgress const& progress) { line.show(progress); };
    return study_building(study, options);
  }();
  if (!studied.lost.empty()) say("{}\n", printable(studied.lost));
  auto const file = out / building_store_name;
  if (!studied.complete) {
    say("interrupted: {} are kept in {}\nto continue: {}\n", counted(studied.runs, "finished run"), shown(file),
        to_continue(command_line));
    return exit_with_refusals;
  }
  if (part) {
    say("part {} of {} is finished: {} in {}\nonce all parts are finished: isolaw merge OUT PARTS...\n", part->number,
        part->total, counted(studied.runs, "run"), shown(file));
    return exit_done;
  }
  auto const& answers = *studied.answers;
  if (figures != render::FigureChoice::none)
    say_drawn(render::write_building_figures(answers, study.units(), out), out, "the same command");
  if (a.json)
    print(render::building_json(study, answers));
  else
    print_answers(study, answers);
  if (a.arrange) print_arrangement(study, answers);
  say("{}\n", shown(out / "building.html"));
  bool const all_ran = std::ranges::all_of(answers.laws, [](auto const& law) { return law.failed == 0; });
  return all_ran && answers.holds != false ? exit_done : exit_with_refusals;
}

namespace {
struct Holds {
  bool campaign = false, study = false;
};
Holds what_it_holds(std::filesystem::path const& path) {
  std::error_code unknown;
  bool const study = path.filename() == building_store_name;
  if (std::filesystem::is_regular_file(path, unknown)) return {!study, study};
  return {std::filesystem::exists(path / store_name, unknown),
          std::filesystem::exists(path / building_store_name, unknown)};
}

[[noreturn]] void refuse_both(std::filesystem::path const& where, std::string found, std::string advice) {
  throw Error({.where = where.string(),
               .found = std::move(found),
               .allowed = "campaigns or studies of buildings, in directories of their own",
               .advice = std::move(advice)});
}

}  // namespace

bool merges_buildings(MergeArguments const& arguments) {
  constexpr char const* both = "holds a campaign and a study of a building";
  std::optional<std::filesystem::path> campaign, study;
  for (auto const& part : arguments.parts) {
    auto const holds = what_it_holds(part);
    if (holds.campaign && holds.study)
      refuse_both(part, both,
                  fmt::format("naming the one that is meant: {} or {}", (part / store_name).string(),
                              (part / building_store_name).string()));
    if (holds.campaign) campaign = part;
    if (holds.study) study = part;
  }
  if (campaign && study)
    refuse_both(*study, fmt::format("is a study of a building; {} is a campaign", campaign->string()),
                "a merge for each");
  auto const& directory = arguments.directory;
  auto const there = what_it_holds(directory);
  if (arguments.parts.empty() && there.campaign && there.study)
    refuse_both(directory, both, "moving one of the stores to another directory");
  if ((study && there.campaign) || (campaign && there.study))
    refuse_both(directory, fmt::format("holds {}", study ? "a campaign" : "a study of a building"),
                "another directory to merge into");
  return study || (!campaign && there.study);
}

namespace {

void answers_that_are_there(std::filesystem::path const& directory, bool json) {
  auto const file = directory / "building.json";
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown)) {
    say("all runs are there; to compute the answers: isolaw building BUILDING.toml --from CAMPAIGN --out {}\n",
        shown(directory));
    return;
  }
  constexpr ReadLimits limits{
      .largest_bytes = 1U << 30, .allowed = "building.json as isolaw wrote it", .when_too_large = "removing it"};
  auto const text = read_file(file, limits);
  auto const answers = nlohmann::json::parse(text, nullptr, false);
  auto const verdict = answers.is_object() ? answers.find("verdict") : answers.end();
  if (verdict == answers.end() || !verdict->is_string())
    throw Error({.where = file.string(),
                 .found = "holds no answers",
                 .allowed = std::string(limits.allowed),
                 .advice = "isolaw building with --out " + directory.string() + ", which makes it again"});
  print(json ? text : printable(verdict->get<std::string>()));
  say("all runs and answers are there: {}\nto compute the answers again: isolaw building BUILDING.toml --from CAMPAIGN --out {}\n",
      shown(directory / "building.html"), shown(directory));
}

}  // namespace

int merge_buildings(MergeArguments const& arguments) {
  auto const& directory = arguments.directory;
  std::vector<std::filesystem::path> stores;
  for (auto const& part : arguments.parts) stores.push_back(store_of_part(part, directory, building_store_name));
  building::MergedStudy merged;
  {
    make_directory(directory);
    DirectoryLock const lock(directory);
    render::remove_leftovers(directory);
    bool any = false;
    merged = building::merge(directory / building_store_name, stores,
                             {.before_replacing = [&] { render::remove_building_outputs(directory); },
                              .missing =
                                  [&](building::MissingRun const& run) {
                                    if (!std::exchange(any, true)) print("part,law,motion,analysis");
                                    print(fmt::format("{},{},{},{}", run.part > 0 ? std::to_string(run.part) : "",
                                                      run.law, render::csv_cell(run.motion), run.analysis));
                                  },
                              .fresh = arguments.fresh});
  }
  tell_merged(merged, directory, building_store_name);
  if (merged.missing > 0) return exit_with_refusals;
  int const named = merged.absent.empty() ? exit_done : exit_with_refusals;
  if (arguments.copy_only) return named;
  if (!merged.part.part) {
    answers_that_are_there(directory, arguments.json);
    return named;
  }
  BuildingArguments const whole{.file = merged.part.building_file,
                                .from = merged.part.campaign,
                                .out = directory,
                                .motions = merged.part.motions,
                                .stated = merged.part.stated,
                                .jobs = arguments.jobs,
                                .part = {},
                                .figures = arguments.figures,
                                .json = arguments.json};
  return std::max(named, building(whole, {"isolaw", "merge", directory.string()}));
}

void write_example_building(std::filesystem::path const& directory) {
  make_folder(directory);
  for (std::uint32_t i = 0; i < building::example_motions; ++i) {
    auto const motion = building::example_motion(i);
    for (auto const* axis : {"x", "y"}) {
      std::string file = fmt::format("# made, not recorded\ntime [s],acceleration_{} [m/s2]\n", axis);
      auto const& a = axis[0] == 'x' ? motion.x_mm_s2 : motion.y_mm_s2;
      for (std::size_t k = 0; k < a.size(); ++k)
        file += fmt::format("{:.2f},{:.6f}\n", 0.01 * static_cast<double>(k), 1e-3 * a[k]);
      write_file(directory / fmt::format("motion-{}-{}.csv", i + 1, axis), file);
    }
  }
  write_file(directory / "building.toml", building::building_template(building::example_motions));
}

}  // namespace isolaw::app
