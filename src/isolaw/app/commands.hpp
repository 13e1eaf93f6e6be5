// The commands behind the command line: each takes its parsed options, writes results to standard output and messages
// to standard error, and returns the exit code. Wrong input throws isolaw::Error.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace isolaw::app {

inline constexpr int exit_done = 0, exit_with_refusals = 1, exit_wrong_usage = 2, exit_internal = 3;

// Options that say how records are read; what is given overrides the lot file.
struct ReadArguments {
  std::optional<std::string> columns, units;
  std::optional<double> dt_s;
  bool flip_force = false;
};

struct CalibrateArguments {
  std::vector<std::filesystem::path> inputs;  // one lot file, or records
  ReadArguments read;
  std::optional<std::string> laws, method, integration, turning_points, box, samples_per_cycle, seed;
  std::vector<std::string> set;
  std::optional<int> runs, population, generations, smooth;
  std::optional<double> stagnation_tolerance;
  bool center = false;
  std::optional<std::filesystem::path> out;
  std::optional<int> jobs;
  bool fresh = false;
  bool allow_outside = false;  // a lot file may name files outside its folder
  bool json = false;
};
int calibrate(CalibrateArguments const& arguments, std::vector<std::string> const& command_line);

struct InspectArguments {
  std::filesystem::path file;
  ReadArguments read;
  bool json = false;
};
int inspect(InspectArguments const& arguments);

struct InitArguments {
  std::vector<std::filesystem::path> files;
  ReadArguments read;
  std::filesystem::path out = "lot.toml";
  bool force = false;
};
int init(InitArguments const& arguments);

int report(std::filesystem::path const& directory, bool json);
int check(std::filesystem::path const& directory);
int bench(bool json);
int list_laws(std::string const& id, bool json);
int example(std::filesystem::path const& directory);

}  // namespace isolaw::app
