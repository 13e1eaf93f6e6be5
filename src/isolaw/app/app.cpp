#include "isolaw/app/app.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <new>
#include <ranges>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "isolaw/app/commands.hpp"
#include "isolaw/app/part_script.hpp"
#include "isolaw/app/say.hpp"
#include "isolaw/app/usage.hpp"
#include "isolaw/app/version_text.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/programs/exports.hpp"

namespace isolaw::app {
namespace {

using Words = std::vector<std::string>;

void add_option(CLI::App& command, OptionInfo const& option, Values& given, std::string_view other_name = {}) {
  auto const name = "--" + (other_name.empty() ? option.option() : std::string(other_name));
  auto const take = [&given, name, key = std::string(option.key), kind = option.kind](Words const& words) {
    given[key] = value_of(kind, words);
    bool const number = kind == Kind::whole || kind == Kind::real;
    if (number && given[key].is_string()) throw CLI::ConversionError(name, words);
  };
  auto const take_word = [take](std::string const& word) { take({word}); };
  auto const type = option.kind == Kind::whole ? "INT" : option.kind == Kind::real ? "FLOAT" : "TEXT";
  if (option.kind == Kind::flag)
    command.add_flag_callback(
        name, [take] { take({}); }, option.help);
  else if (option.kind == Kind::repeated)
    command.add_option_function<Words>(name, take, option.help)->allow_extra_args(false);
  else
    command.add_option_function<std::string>(name, take_word, option.help)->type_name(type);
}

// Of a motion, which has no force: `of_test` is false. One whose name the command takes for itself is left to the lot
// file.
void add_reading(CLI::App& command, Values& read, bool of_test = true) {
  for (auto const& option : data::reading_table()) {
    auto const other_name = of_test ? std::string_view() : option.motion_option;
    auto const name = other_name.empty() ? option.option() : std::string(other_name);
    bool const taken = command.get_option_no_throw("--" + name) != nullptr;
    if ((of_test || !option.of_test) && !taken) add_option(command, option, read, other_name);
  }
}

void add_acceptance(CLI::App& command, Values& acceptance) {
  for (auto const& option : campaign::acceptance_table()) add_option(command, option, acceptance);
}

void add_vertical(CLI::App& command, std::vector<std::string>& vertical) {
  command
      .add_option("--vertical", vertical,
                  "DEVICE=FILE: the compression test of a device, which gives K_v; may be repeated")
      ->allow_extra_args(false);
}

void add_figures(CLI::App& command, std::string& figures) {
  command.add_option("--figures", figures,
                     "for print, with data and gnuplot scripts: lot (default), all (of every device too), none");
}

void add_jobs(CLI::App& c, std::optional<int>& jobs) {
  c.add_option("--jobs", jobs,
               fmt::format("threads, 0 to {} (one per core); the results do not depend on it", campaign::most_jobs))
      ->check(CLI::Range(0, campaign::most_jobs));
}

// What decides results, and where they go.
void add_campaign(CLI::App& c, CalibrateArguments& a) {
  for (auto const& setting : campaign::setting_table())
    if (!setting.stored_only) add_option(c, setting, a.settings);
  add_reading(c, a.read);
  add_acceptance(c, a.acceptance);
  add_vertical(c, a.vertical);
  add_jobs(c, a.jobs);
  c.add_option("--out", a.out, "directory of the results (out/<name of the lot>)");
  add_figures(c, a.figures);
  c.add_flag("--allow-outside", a.allow_outside, "the lot file may name records outside its own folder");
}

void add_calibrate(CLI::App& c, CalibrateArguments& a) {
  c.add_option("inputs", a.inputs, "a lot file (.toml), test records, or a directory of them")->required();
  add_campaign(c, a);
  c.add_option("--part", a.part, "K/N: only the K-th of N even shares of the runs, for isolaw merge");
  c.add_flag("--fresh", a.fresh, "start over where the directory holds another campaign");
  c.add_flag("--json", a.json, "print summary.json and the profile instead of the ranking");
}

void add_simulate(CLI::App& c, SimulateArguments& a) {
  c.add_option("law", a.law, "a law (isolaw laws lists them)")->required();
  c.add_option("--parameters", a.parameters,
               "file of its parameters, name = value in TOML or JSON, in the law's units");
  c.add_option("--from", a.from, "in place of it, a campaign's directory, with --device");
  c.add_option("--device", a.device, "of --from: the device whose law is taken, or lot for the one law of all");
  c.add_option("--set", a.set, "parameter=value, over what file or campaign say; may be repeated")
      ->allow_extra_args(false);
  c.add_option("--motion", a.motion, "file of the displacement history, read as a record is; force is not needed")
      ->required();
  add_reading(c, a.read, false);
  for (auto const* key : {"integration", "turning-points", "dead-band"}) {
    auto option = *campaign::find_setting(key);
    option.help += "; with --from, as the campaign had it";
    add_option(c, option, a.how);
  }
  c.add_option("--refinement", a.refinement, "steps per sample (1, or as the campaign had it)");
  c.add_option("--bidirectional", a.bidirectional,
               "two displacements, two forces: coupled, for laws with such a form, or springs around the circle");
  c.add_option("--second-disp", a.second_disp,
               "of --bidirectional: column of the displacement across the first, which --columns names");
  c.add_option("--softening", a.softening,
               "of coupled: by distance (default), or axis: each axis by the largest displacement along it");
  c.add_option("--springs", a.springs,
               "of springs: fitted to the device's record as they are (default with --from and a device), or given");
  c.add_option("--out", a.out, "file to write, instead of standard output");
  c.add_flag("--anyway", a.anyway, "with --from: though the law's prediction is unusable");
}

void add_building(CLI::App& c, BuildingArguments& a) {
  c.add_option("file", a.file, "the building (isolaw building --template prints one)");
  c.add_option("--from", a.from, "the campaign's directory, whose lot the bearings are of");
  c.add_option("--motion", a.motions,
               "FILE, or FILE,FILE of two components, in place of the file's motions; several may follow");
  c.add_option("--out", a.out, "directory of the results (out/building)");
  c.add_option("--jobs", a.jobs,
               fmt::format("threads, 0 to {} (one per core); the results do not depend on it", campaign::most_jobs))
      ->check(CLI::Range(0, campaign::most_jobs));
  c.add_option("--part", a.part, "K/N: only the K-th of N even shares of the runs, for isolaw merge");
  c.add_option("--figures", a.figures, "for print, with data and gnuplot scripts: lot (default), none");
  c.add_flag("--nominal", a.nominal,
             "the nominal building alone, over time: its response to every motion as CSV; no draws, no bounds");
  c.add_flag("--arrange", a.arrange, "also put the tested devices where least eccentricity is left");
  c.add_flag("--fresh", a.fresh, "start over where the directory holds runs of another building");
  c.add_flag("--template", a.print_template, "print a commented building file");
  c.add_flag("--json", a.json, "print building.json");
}

int dispatch(CLI::App& app, int argc, char** argv) {
  std::vector<std::pair<CLI::App*, std::function<int()>>> commands;
  auto const add = [&](char const* name, char const* description, std::function<int()> run) -> CLI::App& {
    return *commands.emplace_back(app.add_subcommand(name, description), std::move(run)).first;
  };

  CalibrateArguments calibrate_arguments;
  add_calibrate(add("calibrate", "Identify the laws on every device; statistics, ranking, report",
                    [&] {
                      return calibrate(calibrate_arguments, {argv, argv + argc});
                    }),
                calibrate_arguments);

  InitArguments init_arguments;
  auto& init_command =
      add("init", "Recognise records and write them down as a lot file", [&] { return init(init_arguments); });
  init_command.add_option("files", init_arguments.files, "test records, or a directory of them")->required();
  add_reading(init_command, init_arguments.read);
  init_command.add_option("--like", init_arguments.like, "a lot file whose way of reading these records share");
  init_command.add_option("--out", init_arguments.out, "lot file to write (lot.toml)");
  init_command.add_flag("--force", init_arguments.force, "overwrite it");

  InspectArguments inspect_arguments;
  auto& inspect_command =
      add("inspect", "What records hold, what was recognised and why; cycles, properties, verdicts, the lot",
          [&] { return inspect(inspect_arguments); });
  inspect_command.add_option("inputs", inspect_arguments.inputs, "test records, a directory, or a lot file")
      ->required();
  add_reading(inspect_command, inspect_arguments.read);
  add_acceptance(inspect_command, inspect_arguments.acceptance);
  add_vertical(inspect_command, inspect_arguments.vertical);
  inspect_command.add_option("--out", inspect_arguments.out,
                             "also write a page with drawn loops, tables and JSON there");
  inspect_command.add_flag("--allow-outside", inspect_arguments.allow_outside,
                           "the lot file may name records outside its own folder");
  inspect_command.add_flag("--json", inspect_arguments.json, "for machines");

  ReportArguments report_arguments;
  std::filesystem::path directory;
  bool json = false;
  auto& report_command = add("report", "Make summary, tables and page again from a campaign's store",
                             [&] { return report(report_arguments); });
  report_command.add_option("directory", report_arguments.directory, "the campaign's directory")->required();
  add_acceptance(report_command, report_arguments.acceptance);
  report_command.add_option("--out", report_arguments.out, "directory of the results (the campaign's)");
  add_figures(report_command, report_arguments.figures);
  report_command.add_flag("--json", report_arguments.json, "print summary.json instead of the ranking");

  MergeArguments merge_arguments;
  auto& merge_command =
      add("merge", "Make one campaign, or building study, of the parts that several machines computed", [&] {
        return merge(merge_arguments, {argv, argv + argc});
      });
  merge_command.add_option("directory", merge_arguments.directory, "directory of the whole campaign or study")
      ->required();
  merge_command.add_option(
      "parts", merge_arguments.parts,
      "directories of isolaw calibrate --part or isolaw building --part, in any order; none: what is there is finished");
  merge_command.add_option(
      "--part", merge_arguments.part,
      "K/N: examine only the K-th of N even shares of the devices, for isolaw merge of all such directories; given all "
      "of them, of the lot's laws");
  add_jobs(merge_command, merge_arguments.jobs);
  add_figures(merge_command, merge_arguments.figures);
  merge_command.add_flag("--copy-only", merge_arguments.copy_only,
                         "no analyses, no reports: isolaw merge DIRECTORY makes them later");
  merge_command.add_flag("--fresh", merge_arguments.fresh, "start over where the directory holds another campaign");
  merge_command.add_flag("--json", merge_arguments.json, "print summary.json and the profile instead of the ranking");

  PartsArguments parts_arguments;
  auto& parts_command =
      add("parts",
          "Print a script that computes a campaign or a building study in parts, by a scheduler, and merges them", [&] {
            for (auto const* option : app.get_subcommand("parts")->get_options())
              if (option->count() > 0) parts_arguments.given.push_back(option->get_name());
            return parts(parts_arguments, argv[0]);
          });
  parts_command
      .add_option("lot", parts_arguments.lot,
                  "a lot file (.toml), or a directory of records; with --campaign a building file")
      ->required();
  parts_command.add_option("count", parts_arguments.count, "parts; some two or three for each thread there is")
      ->required();
  parts_command
      .add_option("--to", parts_arguments.to,
                  joined(part_script_kinds) + " (where a record ends, its `to`, a lot file says)")
      ->required();
  parts_command.add_option("--campaign", parts_arguments.campaign,
                           "of a building file: the campaign's directory, whose lot the bearings are of");
  parts_command.add_option("--motion", parts_arguments.motions, "of a building file: as of isolaw building");
  add_campaign(parts_command, parts_arguments.calibrate);

  SampleArguments sample_arguments;
  auto& sample_command = add("sample", "Draw devices from a lot's population of a law's parameters, as CSV",
                             [&] { return sample(sample_arguments); });
  sample_command.add_option("directory", sample_arguments.directory, "the campaign's directory")->required();
  sample_command.add_option("--law", sample_arguments.law, "id of the law")->required();
  sample_command.add_option("--count", sample_arguments.count, "devices to draw (100)");
  auto seed = *campaign::find_setting("seed");
  seed.help = "seed of the draws (the campaign's)";
  add_option(sample_command, seed, sample_arguments.seed);

  ExportArguments export_arguments;
  auto& export_command = add("export", "A law of a campaign for an analysis program, with its check",
                             [&] { return export_law(export_arguments); });
  export_command.add_option("directory", export_arguments.directory, "the campaign's directory")->required();
  export_command.add_option("--law", export_arguments.law, "id of the law")->required();
  export_command.add_option("--device", export_arguments.device, "name of the device, or lot: the one law of the lot")
      ->required();
  export_command
      .add_option("--to", export_arguments.to,
                  joined(programs::targets() | std::views::transform(&programs::Target::name)))
      ->required();
  add_acceptance(export_command, export_arguments.acceptance);
  export_command.add_option(
      "--units", export_arguments.units,
      fmt::format("{} ({})", joined(programs::unit_systems | std::views::transform(&programs::UnitSystem::id)),
                  programs::unit_systems[0].id));
  for (auto const& option : programs::model_table()) add_option(export_command, option, export_arguments.model);
  add_option(export_command, seed, export_arguments.seed);
  export_command.add_option("--out", export_arguments.out, "file to write (standard output)");
  export_command.add_flag("--anyway", export_arguments.anyway,
                          "though the law's prediction is unusable, or what stands in for it is far off");
  SimulateArguments simulate_arguments;
  add_simulate(add("simulate", "The force of a law under any displacement history, cyclic or seismic, as CSV",
                   [&] { return simulate(simulate_arguments); }),
               simulate_arguments);

  BuildingArguments building_arguments;
  add_building(add("building", "The isolated building: bearings drawn from the lot, against the bound analyses",
                   [&] {
                     return building(building_arguments, {argv, argv + argc});
                   }),
               building_arguments);

  std::string rule_set;
  auto& rules_command = add("rules", "The rule sets, or the file of one; template to write your own",
                            [&] { return list_rules(rule_set, json); });
  rules_command.add_option("name", rule_set, "a rule set, or template");
  rules_command.add_flag("--json", json, "the list for machines");

  auto& bench_command =
      add("bench", "A signature of what is computed, and the speed of every law here", [&] { return bench(json); });
  bench_command.add_flag("--json", json, "for machines");

  auto& check_command = add("check", "Whether a campaign's store is sound: its file, and every number computed again",
                            [&] { return check(directory); });
  check_command.add_option("directory", directory, "the campaign's directory")->required();

  std::string law;
  bool markdown = false;
  auto& laws_command = add("laws", "The catalogue of laws, or one law with its parameters",
                           [&] { return list_laws(law, json, markdown); });
  laws_command.add_option("id", law, "a law");
  laws_command.add_flag("--json", json, "for machines");
  laws_command.add_flag("--markdown", markdown, "all of them as a page");

  std::vector<std::string> keywords, other_keywords;
  auto& keywords_command = add("keywords", "Tables of options as parameters of the Python package, for its stub",
                               [&] { return list_keywords(keywords, other_keywords); });
  keywords_command.group("");
  keywords_command.add_option("which", keywords, "settings, acceptance, reading, motion, or single ones")->required();
  keywords_command.add_option("--but", other_keywords, "not these");

  bool example_building = false;
  auto& example_command = add("example", "Write the built-in example lot, or a building",
                              [&] { return example(directory, example_building); });
  example_command.add_option("directory", directory, "where to")->required();
  example_command.add_flag("--building", example_building,
                           "a building file with motions made for it, in place of the lot");

  require_known_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // help, version
    throw Error(usage_complaints(app, error));
  }
  return std::ranges::find_if(commands, [](auto const& each) { return each.first->parsed(); })->second();
}

// Who reads a failure besides the person at the terminal: nobody, a program that asked for --json, the page's engine.
enum class Reader { none, program, engine };

// The engine puts this word before the command, which does not see it.
constexpr std::string_view word_of_engine = "--errors-as-json";

Reader reader_of(int argc, char** argv) {
  if (argc > 1 && argv[1] == word_of_engine) return Reader::engine;
  for (int i = 1; i < argc && argv[i] != std::string_view("--"); ++i)
    if (argv[i] == std::string_view("--json")) return Reader::program;
  return Reader::none;
}

// One line: for a program on standard output, unless something stands there already; else at standard error.
void give(Reader reader, std::string_view object) {
  if (reader == Reader::program && !has_printed && std::ferror(stdout) == 0) {
    print(object);
    std::fflush(stdout);
  } else if (reader != Reader::none) {
    say("{}\n", object);
  }
}

// In words, and as an object where somebody reads it; returns the exit code.
int fail(Reader reader, std::string_view kind, std::vector<Complaint> const& complaints, int code) {
  for (auto const& complaint : complaints) say("isolaw: {}\n", to_string(complaint));
  JsonWriter out;
  out.begin_object().key("error").begin_object().member("kind", kind).key("complaints");
  write_complaints(out, complaints);
  out.end_object().member("exit", code).end_object();
  give(reader, out.take());
  return code;
}

int fail_without_memory(Reader reader) {
  constexpr std::string_view advice =
      "fewer devices or shorter records at once, fewer --jobs, --samples-per-cycle 200, a smaller --population, or a machine with more memory";
  say("isolaw: out of memory; try: {}\n", advice);
  // As fail() has it, without an allocation.
  fmt::memory_buffer object;
  fmt::format_to(
      std::back_inserter(object),
      R"({{"error":{{"kind":"memory","complaints":[{{"where":"","found":"out of memory","allowed":"","advice":"{}","names":[]}}]}},"exit":{}}})",
      advice, exit_internal);
  give(reader, {object.data(), object.size()});
  return exit_internal;
}

int fail_without_output(Reader reader) {
  return fail(reader, "system", {{.found = "standard output cannot be written"}}, exit_internal);
}

}  // namespace

int run(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file above the limit of its size is then a write that fails, with a message
  auto const reader = reader_of(argc, argv);
  if (reader == Reader::engine) {
    argv[1] = argv[0];
    ++argv;
    --argc;
  }
  try {
    CLI::App app("isolaw: from the test records of a production lot of seismic isolators to calibrated, ranked laws",
                 "isolaw");
    app.set_version_flag("--version", version_text());
    app.require_subcommand(1);
    int const code = dispatch(app, argc, argv);
    // Both: what failed while it was printed is no longer there to be flushed.
    return std::fflush(stdout) != 0 || std::ferror(stdout) != 0 ? fail_without_output(reader) : code;
  } catch (Error const& error) {
    return fail(reader, "input", error.complaints(), exit_wrong_usage);
  } catch (std::bad_alloc const&) {
    return fail_without_memory(reader);
  } catch (std::filesystem::filesystem_error const& error) {
    return fail(reader, "system", {{.where = error.path1().string(), .found = error.code().message()}}, exit_internal);
  } catch (std::system_error const& error) {
    if (std::ferror(stdout) != 0) return fail_without_output(reader);
    return fail(reader, "system", {{.found = "cannot write: " + error.code().message()}}, exit_internal);
  } catch (std::exception const& error) {
    return fail(reader, "internal", {{.found = "internal error: " + printable(error.what())}}, exit_internal);
  }
}

}  // namespace isolaw::app
