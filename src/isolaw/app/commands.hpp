// Declares the commands and their arguments. Each command writes results to standard output and messages to standard
// error, and returns the exit code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/api/export.hpp"
#include "isolaw/base/option.hpp"

namespace isolaw::building {
struct Study;
}

namespace isolaw::app {

inline constexpr int exit_done = 0, exit_with_refusals = 1, exit_wrong_usage = 2, exit_internal = 3;

// Members of type Values hold the options that the user gave. They override a lot file and a campaign's store.
struct CalibrateArguments {
  std::vector<std::filesystem::path> inputs;  // one lot file, or records
  Values settings, read, acceptance;
  std::vector<std::string> vertical;  // DEVICE=FILE of compression tests
  std::optional<std::filesystem::path> out;
  std::optional<int> jobs;
  std::optional<std::string> part;  // such as "3/40", the third of 40 parts
  std::string figures = "lot";
  bool fresh = false;
  bool same_device = false;    // the records are tests of one device
  bool allow_outside = false;  // the lot file may name files outside its folder
  bool json = false, details = false;
};
int calibrate(CalibrateArguments const& arguments, std::vector<std::string> const& command_line);

struct MergeArguments {
  std::filesystem::path directory;
  std::vector<std::filesystem::path> parts;
  std::optional<std::string> part;  // such as "3/40": compute only this part of the analyses
  std::optional<int> jobs;
  std::string figures = "lot";
  bool copy_only = false, fresh = false, json = false, details = false;
};
// Merges parts of a campaign. The result is the same as if one machine had computed the whole campaign.
int merge(MergeArguments const& arguments, std::vector<std::string> const& command_line);
// Returns whether the parts belong to a building study, which merge_buildings() merges, and not to a campaign. If there
// are no parts, the directory of the result decides. Throws Error if parts or directory hold both kinds.
bool merges_buildings(MergeArguments const& arguments);
int merge_buildings(MergeArguments const& arguments);

struct PartsArguments {
  std::filesystem::path lot;
  CalibrateArguments calibrate;                   // `inputs` stays empty: `lot` replaces it
  std::optional<std::filesystem::path> campaign;  // if given, `lot` is a building file
  std::vector<std::string> motions;
  Values stated;                   // --motion-dt and --motion-unit (building::stated_table())
  std::vector<std::string> given;  // names of all options given
  int count = 0;
  std::string to;  // one of part_script_kinds
};
int parts(PartsArguments const& arguments, std::string const& program);

struct InspectArguments {
  std::vector<std::filesystem::path> inputs;  // one lot file, or records
  Values read, acceptance;
  std::vector<std::string> vertical;         // DEVICE=FILE of compression tests
  std::optional<std::filesystem::path> out;  // the directory for the page, tables and JSON
  bool same_device = false, allow_outside = false;
  bool json = false, details = false;
};
int inspect(InspectArguments const& arguments);

struct ConditionsArguments {
  std::filesystem::path lot;                         // a lot file with [conditions], or a campaign made from one
  std::optional<std::filesystem::path> out;          // the directory for conditions.json
  std::optional<std::filesystem::path> write_rules;  // a new rule file for the measured factors
  std::optional<int> devices;  // for the plan of tests: how many devices to test at each end of the design range
  bool allow_outside = false, json = false, details = false, plan = false, at_reference = false;
};
int conditions(ConditionsArguments const& arguments);

struct InitArguments {
  std::vector<std::filesystem::path> files;
  Values read;
  std::optional<std::filesystem::path> like;  // a lot file whose settings, rules and reading options are copied
  std::filesystem::path out = "lot.toml";
  bool same_device = false, force = false;
};
int init(InitArguments const& arguments);

struct ReportArguments {
  std::filesystem::path directory;
  std::optional<std::filesystem::path> out;  // the directory for the results; empty: the campaign's directory
  Values acceptance;
  std::string figures = "lot";
  bool json = false, details = false;
};
int report(ReportArguments const& arguments);

struct SampleArguments {
  std::filesystem::path directory;
  std::string law;
  int count = 100;
  Values seed;  // the option --seed, if given
};
int sample(SampleArguments const& arguments);

struct ExportArguments {
  std::filesystem::path directory;
  ExportOptions options;
  std::optional<std::filesystem::path> out;  // empty: standard output
};
int export_law(ExportArguments const& arguments);

struct SimulateArguments {
  std::string law;
  std::optional<std::filesystem::path> parameters;  // a file of parameters
  std::optional<std::filesystem::path> from;  // else a campaign's directory; `device` is then a device's name or "lot"
  std::optional<std::string> device;
  std::vector<std::string> set;
  std::filesystem::path motion;
  Values read, how;  // how: settings such as --integration and --dead-band
  std::optional<int> refinement;
  std::optional<std::filesystem::path> out;
  std::optional<std::string> bound = {};  // "lower" or "upper": the bound law over the design conditions
  bool anyway = false;                    // simulate even if the prediction is unusable
  std::optional<std::string> bidirectional, second_disp, softening, springs;
};
int simulate(SimulateArguments const& arguments);

struct BuildingArguments {
  // `file`: BUILDING.toml; `from`: a campaign's directory; `out`: the directory for the results.
  std::optional<std::filesystem::path> file, from, out = {};
  std::vector<std::string> motions = {};  // "x.AT2" or "x.AT2,y.AT2"; they replace the file's motions
  Values stated = {};                     // --motion-dt and --motion-unit (building::stated_table())
  std::optional<int> jobs = {};
  std::optional<std::string> part = {};  // such as "3/40", the third of 40 parts
  std::optional<std::string> report_units = {};
  std::string figures = "lot";
  bool print_template = false, fresh = false, arrange = false, nominal = false, json = false;
};
int building(BuildingArguments const& arguments, std::vector<std::string> const& command_line);
// Reads the building file and the campaign. Throws Error if one of them is not given. A single Error lists all faults
// in both.
building::Study building_study(BuildingArguments const& arguments);
void write_example_building(std::filesystem::path const& directory);

int list_rules(std::string const& name, bool json);
int check(std::filesystem::path const& directory);
int bench(bool json);
int list_laws(std::string const& id, bool json, bool markdown);
// Prints options as keyword parameters of a Python function. `which` names single options or whole tables of options.
// `but` names options of these tables that are left out.
int list_keywords(std::vector<std::string> const& which, std::vector<std::string> const& but);
// Prints the keys of [[device.test]] as JSON, and what the names of `files` propose for them. The files need not exist.
int list_test_keys(std::vector<std::filesystem::path> const& files);
struct ExampleArguments {
  std::filesystem::path directory;
  bool building = false, tests = false, conditions = false;
};
int example(ExampleArguments const& arguments);

}  // namespace isolaw::app
