// Runs the analyses of a building on several threads and stores them in one SQLite file. If a study is interrupted, the
// next call continues it. Several machines may compute parts of a study. merge() joins their files to the file that one
// machine would have made.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/unit_system.hpp"
#include "isolaw/building/lanes.hpp"
#include "isolaw/building/sources.hpp"
#include "isolaw/campaign/merge_stores.hpp"

namespace isolaw::building {

struct Study {
  BuildingFile file;
  std::vector<LawSource> laws;
  // The units of the campaign's reports and of the building's reports. No stored number depends on them.
  std::string_view report_units = record_units.id;

  UnitSystem const& units() const { return find_unit_system(report_units); }
};

// One of the inputs on which the runs in a store depend.
struct StudyProperty {
  std::string kind, name, value;  // `kind` is "setting", "building", "motion" or "law"
  bool operator==(StudyProperty const&) const = default;
};
// Everything on which the runs' numbers depend besides the program and its instruction set: settings by value, inputs
// by hash.
std::vector<StudyProperty> properties_of(Study const& study);

// The part of a study that a store holds (nullopt: all of it), and the paths of the study's input files. A merge is
// given only the stores of the parts. It finds the input files by these paths, because it needs them to compute the
// answers.
struct StudyPart {
  std::optional<campaign::Part> part = {};
  std::string building_file = {}, campaign = {};
  std::vector<std::string> motions = {};
  isolaw::Values stated = {};  // what the user stated about the motions: options of stated_table()
};

// Cuts the runs of a study into blocks. A block holds some of the cases of one law under one motion. Each part of a
// study computes whole blocks.
class Blocks {
 public:
  Blocks(std::size_t laws, std::size_t motions, std::size_t cases) : laws_(laws), motions_(motions), cases_(cases) {}
  struct Block {
    // Indices of the law and the motion in the study. The block holds the cases with from <= index in cases_of() < to.
    std::size_t law, motion, from, to;
  };
  std::size_t count() const { return laws_ * motions_ * blocks_per_motion(); }
  Block at(std::size_t number) const;
  std::size_t runs() const { return laws_ * motions_ * cases_; }
  // Returns the part, counted from 1, that computes a block. The parts take blocks in turn. Their shares of the work
  // are about equal, since all blocks of one law take about the same time.
  static int part_of(std::size_t number, int parts) {
    return static_cast<int>(number % static_cast<std::size_t>(parts)) + 1;
  }

 private:
  std::size_t blocks_per_motion() const;
  std::size_t laws_, motions_, cases_;
};

class RunStore {
 public:
  // Opens or creates the file. Throws Error if its runs have other properties or are another part of the study, unless
  // `fresh` starts it over.
  RunStore(std::filesystem::path const& file, std::vector<StudyProperty> const& properties, bool fresh,
           StudyPart const& part = {});

  struct Row {
    // Indices of the law and the motion in the study, and of the case in cases_of().
    std::size_t law = 0, motion = 0, place = 0;
    std::vector<double> measured = {};
  };
  std::size_t runs_there() const;
  bool is_there(Blocks::Block const& block) const;
  void add(std::vector<Row> const& rows);
  // Calls take(place, measured) for each stored run of this law under this motion. Throws Error for a run whose numbers
  // have changed since it was stored.
  void for_each_run(std::size_t law, std::size_t motion,
                    std::function<void(std::size_t, std::vector<double> const&)> const& take) const;
  // save_text() stores a text of kept_text() (nominal_building.hpp), and stored_text() returns it. `place` is the index
  // of the motion to which the text belongs. The text of the BearingLoops has the number of motions as its place. If
  // there is no text, stored_text() returns an empty one. If the text has changed since it was stored, stored_text()
  // throws Error.
  std::string stored_text(std::size_t law, std::size_t place) const;
  void save_text(std::size_t law, std::size_t place, std::string const& text) const;

 private:
  std::filesystem::path file_;
  campaign::sqlite::Connection db_;
};
campaign::StoreKind const& building_store();

struct CheckedRuns {
  std::size_t runs = 0, expected = 0;
  std::vector<std::string> faults;  // a text for each run whose numbers have changed since they were computed
};
// Compares each run in the store with the hash that was stored with it. Throws Error as StoreKind::read() does.
CheckedRuns check_runs(std::filesystem::path const& file);

struct MissingRun {
  std::string law, motion, analysis;
  int part = 0;  // the part, counted from 1, that should hold the run; 0 if the number of parts is not known
};
struct MergedStudy : campaign::MergeResult {
  StudyPart part = {};  // which part the first of the merged files holds, and the paths of its input files
};
struct MergeOptions {
  std::function<void()> before_replacing = {};          // called when the study's outputs become outdated
  std::function<void(MissingRun const&)> missing = {};  // called for each missing run, in the order of the blocks
  bool fresh = false;  // true: an output file of another study is overwritten (campaign::Merge::run)
};
// Merges the stores `parts` into the store `out`. See campaign::Merge::run() for what it checks.
MergedStudy merge(std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts,
                  MergeOptions const& options = {});

// Computes the runs of a study; any thread may compute any block. The constructor throws the same Errors as that of
// Devices.
class Runs {
 public:
  // The study must outlive this object. A run throws InterruptedRun once `interrupted` returns true.
  explicit Runs(Study const& study, std::function<bool()> const& interrupted = {});
  Blocks const& blocks() const { return blocks_; }
  std::vector<RunStore::Row> compute(Blocks::Block const& block) const;
  // Returns whether the runs of a block are integrated implicitly, one by one: those of every coupling but `coupled`
  // are.
  bool one_by_one(Blocks::Block const& block) const { return devices_[place(block)].coupling() != Coupling::coupled; }

 private:
  Study const& study_;
  Model model_;
  std::vector<Case> cases_;
  std::size_t place(Blocks::Block const& block) const { return block.law * study_.file.motions.size() + block.motion; }
  std::vector<Devices> devices_;  // one for each law and motion, at place()
  std::vector<Options> options_;
  Blocks blocks_;
};

struct RunProgress {
  std::size_t done = 0, total = 0;  // number of runs that are stored, and of all runs to compute
};
struct RunAllOptions {
  std::function<void(RunProgress const&)> progress = {};  // called by one thread at a time; an exception ends the runs
  std::optional<campaign::Part> part = {};                // the part of the study to compute; nullopt: all of it
  std::function<bool()> interrupted = {};  // asked between and during runs, from any thread; true ends the runs
};
// Computes the runs that the store lacks and stores them. Returns false if it was interrupted. Throws Error like the
// constructor of Runs. If a run throws, run_all() first stores the runs that have finished and then rethrows.
bool run_all(Study const& study, RunStore& store, std::size_t threads, RunAllOptions const& options = {});
// The options of a law's runs under a motion. The step is that of the settings, but at most longest_explicit_step() for
// the stiffness that the bearings of the upper bound analysis have at rest. Throws Error if a run would take more than
// most_steps.
inline constexpr std::size_t most_steps = 2'000'000;
Options options_of(Study const& study, Model const& model, Devices const& devices, Motion const& motion);

}  // namespace isolaw::building
