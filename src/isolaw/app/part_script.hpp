// Scripts that compute the parts of a campaign side by side and merge them: for Slurm, make and GNU parallel.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace isolaw::app {

// What a part asks a scheduler for.
struct PartNeeds {
  double part_s = 0.0, merge_s = 0.0;  // as measured here, for so many threads as it is given
  std::uint64_t memory_bytes = 0;
};

struct PartScript {
  std::string program;              // as a shell finds it
  std::filesystem::path directory;  // where the command was given
  std::string command, store;       // of isolaw, which computes a part; and the file that it leaves
  std::vector<std::string> words;   // options and input of that command; without --part, --out and --jobs
  std::vector<std::string> merge;   // options of isolaw merge
  std::string title;                // of the lot, for people
  std::filesystem::path out;
  int parts = 1, jobs = 1;
  std::string instruction_set;  // the same for all, wherever they run
  PartNeeds needs;
};

inline constexpr std::array<std::string_view, 3> part_script_kinds{"slurm", "make", "parallel"};

// The text of the script. Names may hold blanks, quotes and dollar signs. Throws Error: a kind that is none; a line
// break in a name, which no Makefile can hold.
std::string part_script(std::string_view kind, PartScript const& of);

}  // namespace isolaw::app
