#include "isolaw/app/app.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iterator>
#include <memory>
#include <new>
#include <optional>
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
#include "isolaw/base/error.hpp"
#include "isolaw/base/json.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/system.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/building/building_file.hpp"
#include "isolaw/campaign/setting_table.hpp"
#include "isolaw/data/reading.hpp"
#include "isolaw/programs/exports.hpp"
#include "isolaw/study/conditions_plan.hpp"

namespace isolaw::app {
namespace {

using Words = std::vector<std::string>;

constexpr char const* a_campaign = "directory of a campaign";

CLI::Option* under(Heading heading, CLI::Option* option) {
  return option->group(std::string(title(heading)));
}

void add_option(CLI::App& command, OptionInfo const& option, Values& given, std::string_view other_name = {}) {
  auto const name = "--" + (other_name.empty() ? option.option() : std::string(other_name));
  auto const take = [&given, name, key = std::string(option.key), kind = option.kind](Words const& words) {
    given[key] = value_of(kind, words);
    bool const number = kind == Kind::whole || kind == Kind::real;
    if (number && given[key].is_string()) throw CLI::ConversionError(name, words);
  };
  auto const take_word = [take](std::string const& word) { take({word}); };
  auto const type = option.kind == Kind::whole ? "INT" : option.kind == Kind::real ? "FLOAT" : "TEXT";
  CLI::Option* added = nullptr;
  if (option.kind == Kind::flag)
    added = command.add_flag_callback(
        name, [take] { take({}); }, option.help);
  else if (option.kind == Kind::repeated)
    added = command.add_option_function<Words>(name, take, option.help)->allow_extra_args(false);
  else
    added = command.add_option_function<std::string>(name, take_word, option.help)->type_name(type);
  under(option.heading, added);
}

// Adds the options for reading records, or for reading a motion. Leaves out an option if the command already has
// another option with the same name.
void add_reading(CLI::App& command, Values& read, bool of_test = true) {
  for (auto const& option : data::reading_table()) {
    auto const other_name = of_test ? std::string_view() : option.motion_option;
    auto const name = other_name.empty() ? option.option() : std::string(other_name);
    bool const taken = command.get_option_no_throw("--" + name) != nullptr;
    if ((of_test || !option.of_test) && !taken) add_option(command, option, read, other_name);
  }
}

std::string unit_ids() {
  return joined(unit_systems | std::views::transform(&UnitSystem::id));
}

// Adds the options of campaign::acceptance_table(). A command that writes no report gets none of the options for how
// reports look; `reports` is then false.
void add_acceptance(CLI::App& c, Values& acceptance, bool reports = true) {
  for (auto const& option : campaign::acceptance_table()) {
    bool const is_look = option.key == "report-units" || option.key == "letterhead";
    if (reports || !is_look) add_option(c, option, acceptance);
  }
}

void add_vertical(CLI::App& c, std::vector<std::string>& vertical) {
  under(Heading::acceptance,
        c.add_option("--vertical", vertical,
                     "DEVICE=FILE: compression test of a device, for its vertical stiffness K_v; may be repeated"))
      ->allow_extra_args(false);
}

void add_allow_outside(CLI::App& c, bool& allow_outside) {
  under(Heading::reading,
        c.add_flag("--allow-outside", allow_outside, "allow the lot file to name records outside its own folder"));
}

void add_figures(CLI::App& c, std::string& figures) {
  under(
      Heading::running,
      c.add_option(
          "--figures", figures,
          "which figures to write for printing, with data and gnuplot scripts: lot (default), all (also those of every device), or none"));
}

void add_jobs(CLI::App& c, std::optional<int>& jobs) {
  auto const help = fmt::format("number of threads, 0 to {} (default 0: one per core); the results do not depend on it",
                                campaign::most_jobs);
  under(Heading::running, c.add_option("--jobs", jobs, help))
      ->check(CLI::Range(0, campaign::most_jobs).description(""));
}

void add_part(CLI::App& c, std::optional<std::string>& part) {
  under(Heading::running,
        c.add_option("--part", part,
                     "K/N, such as 3/40: compute only part 3 of 40 of the runs; isolaw merge joins the parts"));
}

void add_fresh(CLI::App& c, bool& fresh) {
  under(Heading::running, c.add_flag("--fresh", fresh, "start over, even if the directory holds another campaign"));
}

void add_same_device(CLI::App& c, bool& same_device) {
  under(Heading::reading, c.add_flag("--same-device", same_device,
                                     "all files are tests of one device, which share the parameters of each law"));
}

// Adds the options that the commands `calibrate` and `parts` share: those that decide the results, and the folder of
// the results.
void add_campaign(CLI::App& c, CalibrateArguments& a) {
  for (auto const& setting : campaign::setting_table())
    if (!setting.stored_only) add_option(c, setting, a.settings);
  add_reading(c, a.read);
  add_same_device(c, a.same_device);
  add_acceptance(c, a.acceptance);
  add_vertical(c, a.vertical);
  add_jobs(c, a.jobs);
  c.add_option("--out", a.out, "directory for the results (default out/<name of the lot>)");
  add_figures(c, a.figures);
  add_allow_outside(c, a.allow_outside);
}

void add_printing(CLI::App& c, bool& json, bool& details) {
  under(Heading::running,
        c.add_flag("--json", json, "print summary.json, with the computing time of each phase, instead of text"));
  under(Heading::running, c.add_flag("--details", details, "print every table, finding and warning"));
}

void add_seed(CLI::App& c, Values& seed) {
  auto option = *campaign::find_setting("seed");
  option.help = "seed of the random draws (default: the campaign's)";
  option.heading = Heading::model;
  add_option(c, option, seed);
}

// The program's commands. Each command keeps its arguments, which CLI11 fills from the command line. run_given() runs
// the command that the user gave.
class Commands {
 public:
  Commands(CLI::App& app, Words line) : app_(app), line_(std::move(line)) {}

  CLI::App& add(std::string const& name, char const* description, char const* example, std::function<int()> run) {
    auto* const command = app_.add_subcommand(name, description)->group("Commands");
    under(Heading::running, command->get_help_ptr());
    command->footer(std::string(example_mark) + example);
    return *commands_.emplace_back(command, std::move(run)).first;
  }

  template <class Arguments>
  struct Added {
    CLI::App& command;
    Arguments& arguments;
  };
  template <class Arguments>
  Added<Arguments> add(std::string const& name, char const* description, char const* example,
                       std::function<int(Arguments&)> run) {
    auto const arguments = std::make_shared<Arguments>();
    auto& command = add(name, description, example, [arguments, run = std::move(run)] { return run(*arguments); });
    return {command, *arguments};
  }

  CLI::App const& app() const { return app_; }
  Words const& line() const { return line_; }  // the words of the command line
  int run_given() const {
    return std::ranges::find_if(commands_, [](auto const& each) { return each.first->parsed(); })->second();
  }

 private:
  CLI::App& app_;
  Words line_;
  std::vector<std::pair<CLI::App*, std::function<int()>>> commands_;
};

void add_calibrate(Commands& commands) {
  auto const [c, a] = commands.add<CalibrateArguments>(
      "calibrate", "Fit laws to the tests of every device, compare the laws, and write a report",
      "isolaw calibrate d01.csv d02.csv --out out/lot",
      [&](auto const& arguments) { return calibrate(arguments, commands.line()); });
  c.add_option("inputs", a.inputs, "a lot file (.toml), test records, or a directory of them")->required();
  add_campaign(c, a);
  add_part(c, a.part);
  add_fresh(c, a.fresh);
  add_printing(c, a.json, a.details);
}

void add_init(Commands& commands) {
  auto const [c, a] =
      commands.add<InitArguments>("init", "Recognise records and write a lot file that says how to read them",
                                  "isolaw init d01.csv d02.csv --out lot.toml", init);
  c.add_option("files", a.files, "test records, or a directory of them")->required();
  add_reading(c, a.read);
  add_same_device(c, a.same_device);
  c.add_option("--like", a.like, "lot file from which to copy settings and reading options");
  c.add_option("--out", a.out, "lot file to write (default lot.toml)");
  c.add_flag("--force", a.force, "overwrite the lot file");
}

void add_inspect(Commands& commands) {
  auto const [c, a] = commands.add<InspectArguments>(
      "inspect", "Show how records were read, their cycles and properties, and the verdicts on devices and lot",
      "isolaw inspect d01.csv d02.csv --rules ntc-2018 --design K_eff=0.62,damping=19.5,disp=208", inspect);
  c.add_option("inputs", a.inputs, "a lot file (.toml), test records, or a directory of them")->required();
  add_reading(c, a.read);
  add_same_device(c, a.same_device);
  add_acceptance(c, a.acceptance);
  add_vertical(c, a.vertical);
  c.add_option("--out", a.out, "directory in which to write a page with the loops, tables and inspection.json");
  add_allow_outside(c, a.allow_outside);
  c.add_flag("--json", a.json, "print inspection.json instead of text");
  c.add_flag(
      "--details", a.details,
      "also print the skeleton curve, bilinear loops, and energy, stiffness and residual displacement of each cycle");
}

void add_conditions(Commands& commands) {
  auto const [c, a] = commands.add<ConditionsArguments>(
      "conditions", "Show how temperature, rate, load, ageing and history change the properties of devices",
      "isolaw conditions lot.toml", conditions);
  c.add_option("lot", a.lot, "a lot file with a table [conditions], or the directory of a campaign made from one")
      ->required();
  c.add_option("--out", a.out, "directory for conditions.json, tables and figures");
  add_allow_outside(c, a.allow_outside);
  c.add_flag("--json", a.json, "print conditions.json instead of text");
  c.add_flag("--details", a.details, "also list every test and how it is used");
  c.add_flag(
      "--plan", a.plan,
      "print which tests are still needed so that enough devices are tested at every extreme of the design conditions");
  c.add_option("--devices", a.devices,
               fmt::format("with --plan: how many devices are to be tested at every extreme, 1 to {} (default: {})",
                           study::most_planned_devices, study::usual_planned_devices))
      ->check(CLI::Range(1, study::most_planned_devices).description(""));
  c.add_flag(
      "--at-reference", a.at_reference,
      "print the values of acceptance tests that were not made at the reference conditions, as measured and converted to these conditions");
  c.add_option("--write-rules", a.write_rules,
               "write the measured factors into this new rule file, for use with other lots");
}

void add_report(Commands& commands) {
  auto const [c, a] = commands.add<ReportArguments>(
      "report", "Write the summary, tables and page of a campaign again from its store",
      "isolaw report out/lot --rules ntc-2018 --design K_eff=0.62,damping=19.5,disp=208", report);
  c.add_option("directory", a.directory, a_campaign)->required();
  add_acceptance(c, a.acceptance);
  c.add_option("--out", a.out, "directory for the results (default: the campaign's)");
  add_figures(c, a.figures);
  add_printing(c, a.json, a.details);
}

void add_merge(Commands& commands) {
  auto const [c, a] = commands.add<MergeArguments>(
      "merge", "Join the parts of a campaign or building study that several machines computed",
      "isolaw merge out/lot part-1 part-2 part-3",
      [&](auto const& arguments) { return merge(arguments, commands.line()); });
  c.add_option("directory", a.directory, "directory of the whole campaign or study")->required();
  c.add_option(
      "parts", a.parts,
      "directories of the parts, in any order. Without parts, merge makes the analyses and reports of the campaign in the directory, once all of its runs are there; for a building study it prints the verdict");
  c.add_option(
      "--part", a.part,
      "K/N, such as 3/40: analyse only the third of 40 shares of the devices; if all devices are analysed already, fit only the third of 40 shares of the laws to the whole lot");
  add_jobs(c, a.jobs);
  add_figures(c, a.figures);
  c.add_flag("--copy-only", a.copy_only,
             "copy the runs only; isolaw merge DIRECTORY makes the analyses and reports of a campaign later");
  add_fresh(c, a.fresh);
  add_printing(c, a.json, a.details);
}

void add_parts(Commands& commands) {
  auto const [c, a] = commands.add<PartsArguments>(
      "parts", "Print a script that computes a campaign or building study in parts and merges them",
      "isolaw parts lot.toml 40 --to slurm > submit.sh", [&](auto& arguments) {
        for (auto const* option : commands.app().get_subcommand("parts")->get_options())
          if (option->count() > 0) arguments.given.push_back(option->get_name());
        return parts(arguments, commands.line().front());
      });
  c.add_option("lot", a.lot, "a lot file (.toml), or a directory of records; with --campaign a building file")
      ->required();
  c.add_option("count", a.count, "number of parts, usually two or three for each processor core that computes them")
      ->required();
  c.add_option(
       "--to", a.to,
       "program that runs the parts of the campaign: " + joined(part_script_kinds) +
           " (this --to does not limit the time that is read from records; for that, use the key `to` of a lot file)")
      ->required();
  c.add_option("--campaign", a.campaign,
               "for a building file: directory of the campaign whose lot supplies the bearings");
  c.add_option("--motion", a.motions,
               "for a building file: ground motions to use instead of those of the file, as in isolaw building");
  for (auto const& option : building::stated_table()) add_option(c, option, a.stated);
  add_campaign(c, a.calibrate);
}

void add_sample(Commands& commands) {
  auto const [c, a] = commands.add<SampleArguments>(
      "sample", "Draw random devices from the lot's population, and print a law's parameters for each as CSV",
      "isolaw sample out/lot --law bouc-wen --count 1000 > devices.csv", sample);
  c.add_option("directory", a.directory, a_campaign)->required();
  c.add_option("--law", a.law, "id of the law")->required();
  c.add_option("--count", a.count, "number of devices to draw (default 100)");
  add_seed(c, a.seed);
}

void add_export(Commands& commands) {
  auto const [c, a] = commands.add<ExportArguments>(
      "export", "Write a fitted law for an analysis program, in a file that can check itself",
      "isolaw export out/lot --law bouc-wen --device lot --to opensees --out bearing.tcl", export_law);
  c.add_option("directory", a.directory, a_campaign)->required();
  c.add_option("--law", a.options.law, "id of the law")->required();
  c.add_option("--device", a.options.device,
               "name of the device, or the word lot for the law that was fitted to all devices together")
      ->required();
  c.add_option("--to", a.options.to,
               "program or form for which the law is written: " +
                   joined(programs::targets() | std::views::transform(&programs::Target::name)))
      ->required();
  add_acceptance(c, a.options.acceptance, false);
  c.add_option("--units", a.options.units,
               fmt::format("units of the file: {} (default: the units of the campaign's reports)", unit_ids()));
  c.add_option("--name", a.options.name,
               fmt::format("name of what the file defines (namespace, commands): letters, digits and _, at most {} "
                           "(default: made of isolaw, the law, the campaign, the device and the units)",
                           programs::longest_name));
  c.add_option(
      "--motion", a.options.motions,
      "ground motions under which isolaw compares the law with a material that was fitted to replace it: AT2 files, or text with columns that name their units "
      "(default: --ground-motion, or artificial motions)");
  for (auto const& option : building::stated_table()) add_option(c, option, a.options.stated);
  for (auto const& option : programs::model_table()) add_option(c, option, a.options.model);
  add_seed(c, a.options.seed);
  c.add_option("--out", a.out, "file to write (default: standard output)");
  c.add_flag("--anyway", a.options.anyway,
             "export even if the law's prediction is unusable, if within the tested displacements its force is "
             "impossible (not finite, far above the force at the peaks, with jumps, or giving back more energy than it "
             "takes), or if the analysis program's material differs too much from the law");
}

void add_simulate(Commands& commands) {
  auto const [c, a] = commands.add<SimulateArguments>(
      "simulate", "Compute the force of a law under a displacement history, cyclic or seismic, as CSV",
      "isolaw simulate bouc-wen --from out/lot --device d01 --motion u.csv --out force.csv", simulate);
  c.add_option("law", a.law, "id of a law (isolaw laws lists them)")->required();
  c.add_option("--motion", a.motion, "file of the displacement history, read like a record; force is not needed")
      ->required();
  c.add_option("--from", a.from, "directory of the campaign that fitted the law; needs --device");
  c.add_option("--device", a.device,
               "with --from: name of the device, or the word lot for the law that was fitted to all devices together");
  c.add_option(
      "--bound", a.bound,
      "lower or upper: compute the law that bounds stiffness and energy over the design conditions; with --from, if the campaign's lot file has a table [conditions]");
  c.add_option("--parameters", a.parameters,
               "instead of --from: file of parameters, name = value in TOML or JSON, in the law's units");
  c.add_option("--set", a.set, "change a parameter of the file or campaign: K1=2.5; may be repeated")
      ->allow_extra_args(false);
  add_reading(c, a.read, false);
  for (auto const* key : {"integration", "turning-points", "dead-band"}) {
    auto option = *campaign::find_setting(key);
    option.help = option.key == "dead-band"
                      ? "laws that remember turning points ignore movements smaller than this, in mm, 0 to "
                        "10000 (default 0; with --from that of the campaign)"
                      : option.help + "; with --from the default is that of the campaign";
    add_option(c, option, a.how);
  }
  auto const add = [&command = c](Heading heading, char const* name, auto& value, char const* help) {
    under(heading, command.add_option(name, value, help));
  };
  add(Heading::search, "--refinement", a.refinement,
      "integration steps per sample (default 1; if --from is given, as many as the campaign used)");
  add(Heading::plane, "--bidirectional", a.bidirectional,
      "compute the force in two directions: coupled, from the law's own form for two directions, refused if it has none; springs, from springs around a circle, each of which follows the law (default: one direction only)");
  add(Heading::plane, "--second-disp", a.second_disp,
      "column of the displacement in the second direction (--columns names the column of the first direction)");
  add(Heading::plane, "--softening", a.softening,
      "with --bidirectional coupled: the force softens with the largest distance from the origin so far (distance, default), or with the largest displacement so far along each axis (axis)");
  add(Heading::plane, "--springs", a.springs,
      "with --bidirectional springs: fitted, the springs have parameters that were fitted for springs; given, they have the law's own parameters. Default: fitted if the campaign of --from has such a fit and --set changes nothing, otherwise given");
  c.add_option("--out", a.out, "file to write (default: standard output)");
  c.add_flag("--anyway", a.anyway,
             "with --from: simulate even if the law's prediction is unusable or its force is not possible");
}

void add_building(Commands& commands) {
  auto const [c, a] = commands.add<BuildingArguments>(
      "building",
      "Analyse an isolated building with bearings drawn at random from the lot, and with lower and upper bounds",
      "isolaw building building.toml --from out/lot",
      [&](auto const& arguments) { return building(arguments, commands.line()); });
  c.add_option("file", a.file, "a building file (isolaw building --template prints one)");
  c.add_option("--from", a.from, "directory of the campaign whose lot supplies the bearings");
  c.add_option(
      "--motion", a.motions,
      "ground motions to use, unscaled, instead of those of the building file: FILE, or FILE,FILE for two components; several may follow");
  for (auto const& option : building::stated_table()) add_option(c, option, a.stated);
  c.add_option("--out", a.out, "directory for the results (default out/building)");
  add_jobs(c, a.jobs);
  add_part(c, a.part);
  c.add_option("--report-units", a.report_units,
               fmt::format("units that reports show: {} (default: the units of the campaign's reports)", unit_ids()));
  c.add_option("--figures", a.figures,
               "which figures to write for printing, with data and gnuplot scripts: lot (default), or none");
  c.add_flag(
      "--nominal", a.nominal,
      "compute only the nominal building, in which the lot's median parameters replace random ones: whether it keeps the limits, and its response to every motion over time as CSV");
  c.add_flag(
      "--arrange", a.arrange,
      "also print where to put each tested device so that the centre of stiffness is nearest to the centre of mass");
  c.add_flag("--fresh", a.fresh, "start over, even if the directory holds runs of another building");
  c.add_flag("--template", a.print_template, "print a commented building file");
  c.add_flag("--json", a.json, "print building.json");
}

void add_rules(Commands& commands) {
  struct Arguments {
    std::string name;
    bool json = false;
  };
  auto const [c, a] = commands.add<Arguments>(
      "rules", "List the rule sets, print one, check and print a rule file, or print a template to write your own",
      "isolaw rules template > contract.toml",
      [](auto const& arguments) { return list_rules(arguments.name, arguments.json); });
  c.add_option("name", a.name, "name of a rule set, a rule file, or the word template");
  c.add_flag("--json", a.json, "print the list as JSON");
}

void add_bench(Commands& commands) {
  auto const [c, json] = commands.add<bool>(
      "bench", "Print the speed of every law on this machine, and a checksum (signature) of the computed numbers",
      "isolaw bench", bench);
  c.add_flag("--json", json, "print JSON");
}

void add_check(Commands& commands) {
  auto const [c, directory] = commands.add<std::filesystem::path>(
      "check", "Check that a campaign's store is intact, and compute its numbers again", "isolaw check out/lot", check);
  c.add_option("directory", directory, a_campaign)->required();
}

void add_laws(Commands& commands) {
  struct Arguments {
    std::string law;
    bool json = false, markdown = false;
  };
  auto const [c, a] = commands.add<Arguments>(
      "laws", "List the laws, or show one law with its parameters", "isolaw laws bouc-wen",
      [](auto const& arguments) { return list_laws(arguments.law, arguments.json, arguments.markdown); });
  c.add_option("id", a.law, "id of a law");
  c.add_flag("--json", a.json, "print JSON");
  c.add_flag("--markdown", a.markdown, "print all laws as one page of Markdown");
}

void add_keywords(Commands& commands) {
  struct Arguments {
    std::vector<std::string> which, but;
  };
  auto const [c, a] = commands.add<Arguments>(
      "keywords", "Print options as parameters of the Python package, for its stub", "isolaw keywords settings",
      [](auto const& arguments) { return list_keywords(arguments.which, arguments.but); });
  c.group("");
  c.add_option("which", a.which, "settings, acceptance, reading, motion, or single options")->required();
  c.add_option("--but", a.but, "options to leave out");
}

void add_test_keys(Commands& commands) {
  struct Arguments {
    std::vector<std::filesystem::path> files;
  };
  auto const [c, a] = commands.add<Arguments>(
      "test-keys", "Print the keys of [[device.test]], and what names of files propose for them, as JSON",
      "isolaw test-keys P1_T-20C.csv", [](auto const& arguments) { return list_test_keys(arguments.files); });
  c.group("");
  c.add_option("files", a.files, "names of records");
}

void add_reference(Commands& commands) {
  auto const run = [&] {
    print_reference(commands.app());
    return exit_done;
  };
  commands.add("reference", "Print the page of the command line, docs/cli.md", "isolaw reference", run).group("");
}

void add_example(Commands& commands) {
  auto const [c, a] = commands.add<ExampleArguments>(
      "example",
      "Write the built-in example lot, example tests, tests under several conditions, or an example building",
      "isolaw example lot", example);
  c.add_option("directory", a.directory, "directory to write to")->required();
  c.add_flag(
      "--tests", a.tests,
      "write another lot instead: tests of three amplitudes, with scragging, a soft bearing and a faulty channel");
  c.add_flag("--building", a.building, "write a building file and motions instead of the lot");
  c.add_flag("--conditions", a.conditions, "write tests under several conditions instead of the lot");
}

int dispatch(CLI::App& app, int argc, char** argv) {
  Commands commands(app, {argv, argv + argc});
  for (auto const add : {add_calibrate, add_init, add_inspect, add_conditions, add_report, add_merge, add_parts,
                         add_sample, add_export, add_simulate, add_building, add_rules, add_bench, add_check, add_laws,
                         add_keywords, add_test_keys, add_reference, add_example})
    add(commands);

  require_known_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // the user asked for --help or --version
    throw Error(usage_complaints(app, error));
  }
  return commands.run_given();
}

// Says who reads error messages as JSON: nobody, a program that ran isolaw with --json, or the engine of isolaw's web
// page (page/engine).
enum class Reader { none, program, engine };

// The engine of the web page puts this word in front of the command. run() removes it from the command line.
constexpr std::string_view word_of_engine = "--errors-as-json";

Reader reader_of(int argc, char** argv) {
  if (argc > 1 && argv[1] == word_of_engine) return Reader::engine;
  for (int i = 1; i < argc && argv[i] != std::string_view("--"); ++i)
    if (argv[i] == std::string_view("--json")) return Reader::program;
  return Reader::none;
}

void give(Reader reader, std::string_view object) {
  if (reader == Reader::program && !has_printed && std::ferror(stdout) == 0) {
    print(object);
    std::fflush(stdout);
  } else if (reader != Reader::none) {
    say("{}\n", object);
  }
}
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
  // Writes the same JSON as fail(), but allocates no memory.
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
  prepare_process(argc, argv);
  auto const reader = reader_of(argc, argv);
  if (reader == Reader::engine) {
    argv[1] = argv[0];
    ++argv;
    --argc;
  }
  try {
    CLI::App app(
        "isolaw: fit force-displacement laws to the tests of a production lot of seismic isolators, and rank them",
        "isolaw");
    app.allow_windows_style_options(false);  // so that a path such as "/lot" is not an option
    app.set_version_flag("--version", version_text());
    app.formatter(help_format());
    app.footer("isolaw COMMAND --help lists the options of a command.");
    app.require_subcommand(1);
    int const code = dispatch(app, argc, argv);
    // fflush does not report the failure of an earlier write, so ferror is called too.
    return std::fflush(stdout) != 0 || std::ferror(stdout) != 0 ? fail_without_output(reader) : code;
  } catch (Error const& error) {
    return fail(reader, "input", error.complaints(), exit_wrong_usage);
  } catch (std::bad_alloc const&) {
    return fail_without_memory(reader);
  } catch (std::filesystem::filesystem_error const& error) {
    // Tells two cases apart: the user gave a path that the system cannot follow, or the system itself failed.
    bool const is_of_user = error.code() == std::errc::too_many_symbolic_link_levels ||
                            error.code() == std::errc::filename_too_long || error.code() == std::errc::not_a_directory;
    return fail(reader, is_of_user ? "input" : "system",
                {{.where = error.path1().string(), .found = error.code().message()}},
                is_of_user ? exit_wrong_usage : exit_internal);
  } catch (std::system_error const& error) {
    if (std::ferror(stdout) != 0) return fail_without_output(reader);
    return fail(reader, "system", {{.found = "cannot write: " + error.code().message()}}, exit_internal);
  } catch (std::exception const& error) {
    return fail(reader, "internal", {{.found = "internal error: " + printable(error.what())}}, exit_internal);
  }
}

}  // namespace isolaw::app
