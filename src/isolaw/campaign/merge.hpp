// A campaign that was computed in parts, made one again: checks that they are of one campaign, one build and one
// instruction set, and copies their runs.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

struct MissingRun {
  std::string device, law;
  int number = 0;
  int part = 0;  // that should hold it; 0: nobody knows how the campaign was dealt
};

struct Merged {
  std::size_t added = 0, there = 0;  // runs: copied, and there before or in two parts
  std::size_t analyses = 0;          // copied
  std::size_t missing = 0;
  int parts = 0;                          // that the campaign was dealt into; 0: none says so
  std::vector<std::string> absent;        // parts that are not there
  std::map<int, std::size_t> missing_of;  // by MissingRun::part
};
// "5 runs are missing, of part 4/7 (4 runs), 5/7 (1 run)"; empty where none is.
std::string missing_text(Merged const& merged);

// What merges of campaigns and of buildings refuse alike: `out` is to be replaced by parts that are not all there, or,
// every run in it, by fewer.
void refuse_absent(std::filesystem::path const& out, std::vector<std::string> const& absent);
[[noreturn]] void refuse_to_replace_whole(std::filesystem::path const& out, Merged const& merged);

struct MergeOptions {
  std::function<void()> before_replacing = {};                  // see Store::create
  std::function<void(std::size_t, std::size_t)> progress = {};  // parts copied, of all
  std::function<void(MissingRun const&)> missing = {};          // told of each, in the order of results
  bool fresh = false;  // replaces another campaign, once all that takes its place was judged and copied
};

// Adds to the store `out`, which is made where there is none, the runs of the stores `parts`, and what those that hold
// all runs have examined of devices. Neither their order nor
// one that is given twice matters. Every one is checked before the first is copied, and each is copied in one
// transaction, so that a merge that was stopped is done again by the same call. Memory holds the records, and of the
// results one run at a time. Throws Error: a store that is damaged, of another campaign, build or instruction set, runs
// that contradict one another, an `out` that is a part, or would lose what it has.
Merged merge(std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts,
             MergeOptions const& options = {});

}  // namespace isolaw::campaign
