// Scripts that compute the parts of a campaign side by side and merge them: for Slurm, make and GNU parallel.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::app {

// The time and memory to ask a scheduler for.
struct PartNeeds {
  double part_s = 0.0, merge_s = 0.0;  // for a part and for the merge, with PartScript::jobs threads each
  std::uint64_t memory_bytes = 0;
};

struct PartScript {
  std::string program;              // a path, or a name that the shell finds
  std::filesystem::path directory;  // in which the script runs
  std::string command, store;       // the isolaw command that computes a part, and the file it leaves
  std::vector<std::string> words;   // options and input of that command, without --part, --out and --jobs
  std::vector<std::string> merge;   // options of isolaw merge
  std::string title;                // the lot's, for the script's first comment
  std::filesystem::path out;
  int parts = 1, jobs = 1;
  std::string instruction_set;  // the same for all parts, wherever they run
  PartNeeds needs;
};

inline constexpr std::array<std::string_view, 3> part_script_kinds{"slurm", "make", "parallel"};

// The text of the script. Names may hold blanks, quotes and dollar signs. Throws Error for an unknown kind, and for a
// name with a line break, which no Makefile can hold.
std::string part_script(std::string_view kind, PartScript const& script);

}  // namespace isolaw::app
