// Writes scripts that compute the parts of a campaign side by side and merge them: for Slurm, make and GNU parallel.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::app {

// The time and memory that a script requests from the scheduler.
struct PartNeeds {
  double part_s = 0.0, merge_s = 0.0;  // the time of a part and of the merge, each with PartScript::jobs threads
  std::uint64_t memory_bytes = 0;
};

struct PartScript {
  std::string program;                  // a path, or a name that the shell finds
  std::filesystem::path directory;      // the directory in which the script runs
  std::string command, store;           // the isolaw command that computes a part, and the file that it writes
  std::vector<std::string> words;       // options and input of that command, without --part, --out and --jobs
  std::vector<std::string> merge = {};  // options of isolaw merge
  std::string title;                    // the lot's title, for the first comment of the script
  std::filesystem::path out;
  int parts = 1, jobs = 1;
  std::string instruction_set;  // all parts use the same one on every machine
  PartNeeds needs;
};

inline constexpr std::array<std::string_view, 3> part_script_kinds{"slurm", "make", "parallel"};

// Returns the text of a script. `kind` is one of part_script_kinds. File names may contain blanks, quotes and dollar
// signs. Throws Error for an unknown kind, and for a file name with a line break, which a Makefile cannot hold.
std::string part_script(std::string_view kind, PartScript const& script);

}  // namespace isolaw::app
