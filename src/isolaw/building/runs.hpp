// Runs the analyses of a building on several threads and stores them in one SQLite file. An interrupted study is
// continued, and several machines may share one: their parts are merged into the file that one machine would have made.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/building/lanes.hpp"
#include "isolaw/building/sources.hpp"
#include "isolaw/campaign/contents.hpp"
#include "isolaw/campaign/merge.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::building {

struct Study {
  BuildingFile file;
  std::vector<LawSource> laws;
};

// One thing that the runs of a store depend on. A part of a study also has rows that say which part it is.
struct StudyProperty {
  enum class Kind { setting, building, motion, law, maker, part };
  Kind kind = Kind::setting;
  std::string name, value;
  bool operator==(StudyProperty const&) const = default;
};
// Everything that the numbers depend on: settings by value, inputs by hash, the program and its instruction set.
std::vector<StudyProperty> properties_of(Study const& study);
// The rows of a part: its number, and the paths of the inputs that a merged study needs for its answers.
std::vector<StudyProperty> properties_of(campaign::Part const& part, std::string const& building_file,
                                         std::string const& campaign, std::vector<std::string> const& motions);
// A text for each difference, such as "seed: 1 there, 2 now". Parts and makers are not compared.
std::vector<std::string> differences(std::span<StudyProperty const> there, std::span<StudyProperty const> now,
                                     campaign::Sides const& sides = {});
campaign::Maker maker_of(std::span<StudyProperty const> properties);
std::optional<campaign::Part> part_of(std::span<StudyProperty const> properties);
std::string value_of(std::span<StudyProperty const> properties, StudyProperty::Kind kind,
                     std::string_view name);  // empty if there is none

// Cuts the runs of a study into blocks, by law, motion and place in cases_of(). Threads and parts share the blocks.
class Blocks {
 public:
  Blocks(std::size_t laws, std::size_t motions, std::size_t cases) : laws_(laws), motions_(motions), cases_(cases) {}
  struct Block {
    std::size_t law, motion, from, to;  // places from <= place < to
  };
  std::size_t count() const { return laws_ * motions_ * blocks_per_motion(); }
  Block at(std::size_t number) const;
  std::size_t runs() const { return laws_ * motions_ * cases_; }
  // The part, counted from 1, that computes a block. Blocks of one law cost the same, so dealing in turn is even.
  static int part_of(std::size_t number, int parts) {
    return static_cast<int>(number % static_cast<std::size_t>(parts)) + 1;
  }

 private:
  std::size_t blocks_per_motion() const;
  std::size_t laws_, motions_, cases_;
};

class RunStore {
 public:
  // Opens or creates the file. Throws Error if its runs have other properties, unless `fresh` starts it over.
  RunStore(std::filesystem::path const& file, std::vector<StudyProperty> const& properties, bool fresh);
  ~RunStore();
  RunStore(RunStore const&) = delete;
  RunStore& operator=(RunStore const&) = delete;

  // Creates or replaces the file. If the program is killed meanwhile, the old or the new file remains, whole.
  static void create(std::filesystem::path const& file, std::vector<StudyProperty> const& properties);

  struct Row {
    std::size_t law = 0, motion = 0, place = 0;  // place: in cases_of()
    std::vector<double> measured;
  };
  std::size_t runs_there() const;
  bool is_there(Blocks::Block const& block) const;
  void add(std::vector<Row> const& rows);
  void each(std::size_t law, std::size_t motion,
            std::function<void(std::size_t, std::vector<double> const&)> const& take) const;
  // Rewrites a closed store in a fixed order, so that equal runs are equal files (campaign/sqlite.hpp).
  static void put_in_order(std::filesystem::path const& file);

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

struct MissingRun {
  std::string law, motion, analysis;
  int part = 0;  // the part that should hold it; 0 if the number of parts is not known
};
struct MergedStudy : campaign::Merged {
  std::vector<StudyProperty> part;  // the first part's rows of Kind::part
};
struct MergeOptions {
  std::function<void()> before_replacing = {};          // called when the study's outputs become outdated
  std::function<void(MissingRun const&)> missing = {};  // called for each missing run, in order
  bool fresh = false;  // replaces `out`, after everything that takes its place was checked and copied
};
// Adds the runs of the stores `parts` to the store `out`, as campaign::merge does; all are checked before the first is
// copied. Throws Error for a store that is damaged or of another study, build or instruction set, for runs that
// contradict each other, and if `out` is a part itself or would lose runs.
MergedStudy merge(std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts,
                  MergeOptions const& options = {});

// Computes the runs of a study; any thread may compute any block. The constructor throws Error like Devices.
class Runs {
 public:
  explicit Runs(Study const& study);  // the study must outlive it
  Blocks const& blocks() const { return blocks_; }
  std::vector<RunStore::Row> of(Blocks::Block const& block) const;
  // Whether the block's runs use the implicit path, one by one, as all runs do whose law is not in its coupled form.
  bool one_by_one(Blocks::Block const& block) const { return devices_[block.law].coupling() != Coupling::coupled; }

 private:
  Study const& study_;
  Model model_;
  std::vector<Case> cases_;
  std::vector<Devices> devices_;  // [law]
  std::vector<Options> options_;  // [law]
  Blocks blocks_;
};

struct RunProgress {
  std::size_t done = 0, total = 0;  // analyses
};
struct RunAllOptions {
  std::function<void(RunProgress const&)> progress = {};  // by one thread at a time; an exception ends the runs
  std::optional<campaign::Part> part = {};                // computes this part only
  std::function<bool()> interrupted = {};                 // asked between runs, from any thread
};
// Throws Error like Runs. Finished runs are stored, whatever ends the call. Returns false if it was interrupted.
bool run_all(Study const& study, RunStore& store, std::size_t threads, RunAllOptions const& options = {});
// The options of a law's runs. Their step is the smaller of the settings' step and longest_explicit_step() for the
// bearings of the upper bound analysis at rest.
Options options_of(Study const& study, Model const& model, Devices const& devices);

}  // namespace isolaw::building
