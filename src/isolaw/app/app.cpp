#include "isolaw/app/app.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <system_error>

#include "isolaw/app/commands.hpp"
#include "isolaw/base/error.hpp"

namespace isolaw::app {
namespace {

void add_reading(CLI::App& command, ReadArguments& read) {
  command.add_option("--columns", read.columns,
                     "time=...,disp=...,force=...,load=...: column names or 1-based numbers");
  command.add_option("--units", read.units, "disp=cm,force=tonf,time=s: units the files do not state");
  command.add_option("--dt", read.dt_s, "sampling interval in seconds of files without a time column");
  command.add_flag("--flip-force", read.flip_force, "reverse the sign of the force");
}

void add_calibrate(CLI::App& app, CalibrateArguments& a) {
  auto& c = *app.add_subcommand("calibrate", "Identify every law on every device; statistics, ranking, report");
  c.add_option("inputs", a.inputs, "a lot file (.toml), or test records")->required();
  c.add_option("--laws", a.laws, "all, or ids separated by commas (isolaw laws lists them)");
  c.add_option("--method", a.method, "ga: the genetic algorithm of the paper");
  c.add_option("--integration", a.integration, "converged (default), or paper: one Runge-Kutta step per sample");
  c.add_option("--runs", a.runs, "independent runs per law and device (20)");
  c.add_option("--population", a.population, "individuals (100)");
  c.add_option("--generations", a.generations, "generations, the initial one included (50)");
  c.add_option("--stagnation-tolerance", a.stagnation_tolerance,
               "relative improvement that counts as none; 20 generations without improvement end a run (0)");
  c.add_option("--seed", a.seed, "seed of the campaign (1)");
  c.add_option("--box", a.box,
               "search box: auto, scaled from each record (default), or published, Table 4 of the paper");
  c.add_option("--set", a.set, "law.parameter=value | lower:upper | free; may be repeated")->allow_extra_args(false);
  c.add_option("--smooth", a.smooth, "window of the centred moving average, odd (1: none)");
  c.add_option("--samples-per-cycle", a.samples_per_cycle, "thin records to this many samples per cycle, or all (200)");
  c.add_flag("--center", a.center, "remove the offset of displacement and force");
  add_reading(c, a.read);
  c.add_option("--jobs", a.jobs, "threads (one per core); the results do not depend on it")->check(CLI::Range(0, 4096));
  c.add_option("--out", a.out, "directory of the results (out/<name of the lot>)");
  c.add_flag("--fresh", a.fresh, "start over where the directory holds another campaign");
  c.add_flag("--json", a.json, "print summary.json instead of the ranking");
}

int dispatch(CLI::App& app, int argc, char** argv) {
  CalibrateArguments calibrate_arguments;
  add_calibrate(app, calibrate_arguments);

  InitArguments init_arguments;
  auto& init_command = *app.add_subcommand("init", "Recognise records and write them down as a lot file");
  init_command.add_option("files", init_arguments.files, "test records")->required();
  add_reading(init_command, init_arguments.read);
  init_command.add_option("--out", init_arguments.out, "lot file to write (lot.toml)");
  init_command.add_flag("--force", init_arguments.force, "overwrite it");

  InspectArguments inspect_arguments;
  auto& inspect_command =
      *app.add_subcommand("inspect", "What one record holds, what was recognised and why, its properties");
  inspect_command.add_option("file", inspect_arguments.file, "a test record")->required();
  add_reading(inspect_command, inspect_arguments.read);
  inspect_command.add_flag("--json", inspect_arguments.json, "for machines");

  std::filesystem::path directory;
  bool json = false;
  auto& report_command = *app.add_subcommand("report", "Make summary, tables and page again from a campaign's store");
  report_command.add_option("directory", directory, "the campaign's directory")->required();
  report_command.add_flag("--json", json, "print summary.json instead of the ranking");

  std::string law;
  auto& laws_command = *app.add_subcommand("laws", "The catalogue of laws, or one law with its parameters");
  laws_command.add_option("id", law, "a law");
  laws_command.add_flag("--json", json, "for machines");

  auto& example_command = *app.add_subcommand("example", "Write the built-in example lot");
  example_command.add_option("directory", directory, "where to")->required();

  if (argc > 1 && argv[1][0] != '-') {
    auto const names = app.get_subcommands([&](CLI::App* command) { return command->get_name() == argv[1]; });
    if (names.empty()) {
      std::string known;
      for (auto const* command : app.get_subcommands([](CLI::App*) { return true; }))
        known += (known.empty() ? "" : ", ") + command->get_name();
      throw Error({.where = std::string("isolaw ") + argv[1],
                   .found = "no such command",
                   .allowed = known,
                   .advice = "isolaw --help"});
    }
  }
  try {
    app.parse(argc, argv);
  } catch (CLI::ParseError const& error) {
    return app.exit(error) == 0 ? exit_done : exit_wrong_usage;
  }
  if (app.got_subcommand("calibrate")) return calibrate(calibrate_arguments, {argv, argv + argc});
  if (app.got_subcommand("init")) return init(init_arguments);
  if (app.got_subcommand("inspect")) return inspect(inspect_arguments);
  if (app.got_subcommand("report")) return report(directory, json);
  if (app.got_subcommand("laws")) return list_laws(law, json);
  return example(directory);
}

}  // namespace

int run(int argc, char** argv) {
  try {
    CLI::App app("isolaw: from the test records of a production lot of seismic isolators to calibrated, ranked laws",
                 "isolaw");
    app.set_version_flag("--version", ISOLAW_VERSION);
    app.require_subcommand(1);
    int const code = dispatch(app, argc, argv);
    if (std::fflush(stdout) != 0) {
      std::fputs("isolaw: standard output cannot be written\n", stderr);
      return exit_internal;
    }
    return code;
  } catch (Error const& error) {
    for (auto const& complaint : error.complaints()) std::fprintf(stderr, "isolaw: %s\n", to_string(complaint).c_str());
    return exit_wrong_usage;
  } catch (std::system_error const& error) {
    std::fprintf(stderr, "isolaw: cannot write: %s\n", error.code().message().c_str());
    return exit_internal;
  } catch (std::exception const& error) {
    std::fprintf(stderr, "isolaw: internal error: %s\n", error.what());
    return exit_internal;
  }
}

}  // namespace isolaw::app
