// The analyses of a building: run by as many threads as there are, kept in one SQLite file, continued where they were
// interrupted, shared by several machines and merged again. Rows lie in one order whoever computed them.
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

// What the runs of a store are of, a row for each thing that they depend on; of a part also which one it is.
struct StudyProperty {
  enum class Kind { setting, building, motion, law, maker, part };
  Kind kind = Kind::setting;
  std::string name, value;
  bool operator==(StudyProperty const&) const = default;
};
// Everything that the numbers depend on: settings by their values, inputs by hashes, who computes.
std::vector<StudyProperty> properties_of(Study const& study);
// Of a part: which one, and the words that its answers take: the building file, the campaign, files of motions.
std::vector<StudyProperty> properties_of(campaign::Part const& part, std::string const& building_file,
                                         std::string const& campaign, std::vector<std::string> const& motions);
// "seed: 1 there, 2 now", ...; of parts and makers nothing.
std::vector<std::string> differences(std::span<StudyProperty const> there, std::span<StudyProperty const> now,
                                     campaign::Sides const& sides = {});
campaign::Maker maker_of(std::span<StudyProperty const> traits);
std::optional<campaign::Part> part_of(std::span<StudyProperty const> traits);
std::string value_of(std::span<StudyProperty const> traits, StudyProperty::Kind kind,
                     std::string_view name);  // empty: not there

// The runs of a study as they are computed and dealt: in blocks, by law, motion, place in cases_of().
class Blocks {
 public:
  Blocks(std::size_t laws, std::size_t motions, std::size_t cases) : laws_(laws), motions_(motions), cases_(cases) {}
  struct Block {
    std::size_t law, motion, from, to;  // places
  };
  std::size_t count() const { return laws_ * motions_ * of_motion(); }
  Block at(std::size_t number) const;
  std::size_t runs() const { return laws_ * motions_ * cases_; }
  // In turn. Blocks of one law cost the same, so that parts are even.
  static int part_of(std::size_t number, int parts) {
    return static_cast<int>(number % static_cast<std::size_t>(parts)) + 1;
  }

 private:
  std::size_t of_motion() const;
  std::size_t laws_, motions_, cases_;
};

class RunStore {
 public:
  // Opens or creates the file. `of` says what the runs are of: another in the file is refused (Error), unless `fresh`.
  RunStore(std::filesystem::path const& file, std::vector<StudyProperty> const& of, bool fresh);
  ~RunStore();
  RunStore(RunStore const&) = delete;
  RunStore& operator=(RunStore const&) = delete;

  // Replaces a file of that name; when it is stopped, the former or the new one is there, whole.
  static void create(std::filesystem::path const& file, std::vector<StudyProperty> const& of);

  struct Row {
    std::size_t law = 0, motion = 0, place = 0;  // place: in cases_of()
    std::vector<double> measured;
  };
  std::size_t runs_there() const;
  bool is_there(Blocks::Block const& block) const;
  void add(std::vector<Row> const& rows);
  // take(place, measured) for every run of a law under a motion, in order.
  void each(std::size_t law, std::size_t motion,
            std::function<void(std::size_t, std::vector<double> const&)> const& take) const;
  // Of a store that is closed: equal runs are then equal files, see campaign/sqlite.hpp.
  static void put_in_order(std::filesystem::path const& file);

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

struct MissingRun {
  std::string law, motion, analysis;
  int part = 0;  // that should hold it; 0: nobody knows how the study was dealt
};
struct MergedStudy : campaign::Merged {
  std::vector<StudyProperty> part;  // of the first part: the words that its answers take
};
struct MergeOptions {
  std::function<void()> before_replacing = {};          // of what is made of a study that is there
  std::function<void(MissingRun const&)> missing = {};  // told of each, in the order of runs
  bool fresh = false;  // replaces another study, once all that takes its place was judged and copied
};
// As campaign::merge: adds to the store `out` the runs of the stores `parts`, each checked before the first is copied.
// Throws Error: a store that is damaged, of another study, build or instruction set, runs that contradict one another.
MergedStudy merge(std::filesystem::path const& out, std::vector<std::filesystem::path> const& parts,
                  MergeOptions const& options = {});

// Computes the runs of a study, any block from any thread. Throws Error as Devices.
class Runs {
 public:
  explicit Runs(Study const& study);  // which outlives it
  Blocks const& blocks() const { return blocks_; }
  std::vector<RunStore::Row> of(Blocks::Block const& block) const;
  // Whether its runs are made one by one, springs around the circle, each of which takes its time.
  bool one_by_one(Blocks::Block const& block) const { return devices_[block.law].coupling() != Coupling::coupled; }

 private:
  Study const& study_;
  Model model_;
  std::vector<Case> cases_;
  std::vector<Devices> devices_;  // of each law
  std::vector<Options> options_;
  Blocks blocks_;
};

struct RunProgress {
  std::size_t done = 0, total = 0;  // analyses
};
struct RunAllOptions {
  std::function<void(RunProgress const&)> progress = {};  // from one thread at a time; what it throws ends the runs
  std::optional<campaign::Part> part = {};                // its share alone
  std::function<bool()> interrupted = {};                 // asked between runs, from any thread
};
// Throws Error as Runs. Whatever ends the runs, those that are finished are stored; false: interrupted before the last.
bool run_all(Study const& study, RunStore& store, std::size_t threads, RunAllOptions const& options = {});

// The step of the explicit path for a law under a motion: that of the settings, halved where the bearings are stiffer.
Options options_of(Study const& study, Model const& model, Devices const& devices);

}  // namespace isolaw::building
