#include "isolaw/building/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <iterator>
#include <mutex>
#include <utility>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/base/words.hpp"
#include "isolaw/campaign/maker.hpp"
#include "isolaw/campaign/parallel.hpp"
#include "isolaw/campaign/setting_table.hpp"

namespace isolaw::building {

using campaign::StoreKind;
using campaign::sqlite::Connection;
using campaign::sqlite::Statement;
using campaign::sqlite::Transaction;

// A hash of the source files on which the numbers of a run depend. The build generates it (CMakeLists.txt).
extern char const* const sources_hash;

namespace {

using Path = std::filesystem::path;

campaign::Maker building_maker() {
  auto maker = campaign::this_maker();
  maker.build = sources_hash;
  return maker;
}

void create(Path const& file, std::vector<StudyProperty> const& properties, StudyPart const& part,
            std::function<void()> const& before_replacing = {}) {
  auto const fill = [&](Connection const& db) {
    Transaction transaction(db);
    building_store().begin(db, {building_maker()}, part.part);
    if (part.part) {
      campaign::write_meta(db, "file", part.building_file);
      campaign::write_meta(db, "from", part.campaign);
      campaign::write_meta(db, "motions", Json(part.motions).dump());
      campaign::write_meta(db, "stated", Json(part.stated).dump());
    }
    Statement insert(db, "INSERT INTO study VALUES (?, ?, ?)");
    for (auto const& [kind, name, value] : properties)
      insert.bind(std::string_view(kind), std::string_view(name), std::string_view(value)).insert();
    transaction.commit();
  };
  StoreKind::create(file, fill, before_replacing);
}

StudyPart read_study_part(Connection const& db) {
  StudyPart part{.part = campaign::read_part(db)};
  if (!part.part) return part;
  part.building_file = campaign::meta(db, "file");
  part.campaign = campaign::meta(db, "from");
  part.motions = Json::parse(campaign::meta(db, "motions")).get<std::vector<std::string>>();
  auto const stated = Json::parse(campaign::meta(db, "stated"));
  for (auto const& [key, value] : stated.items()) part.stated[key] = value;
  return part;
}

std::vector<StudyProperty> read_properties(Connection const& db) {
  std::vector<StudyProperty> properties;
  Statement select(db, "SELECT kind, name, value FROM study ORDER BY rowid");
  while (select.row()) {
    auto& property = properties.emplace_back();
    select.read(property.kind, property.name, property.value);
  }
  return properties;
}

std::size_t runs_in(Connection const& db) {
  Statement select(db, "SELECT count(*) FROM runs");
  std::size_t count = 0;
  if (select.row()) select.read(count);
  return count;
}

std::vector<StudyProperty> of_kind(std::vector<StudyProperty> properties, std::string_view kind) {
  std::erase_if(properties, [&](StudyProperty const& property) { return property.kind != kind; });
  return properties;
}

// Returns a text for each difference, such as "seed: 1 there, 2 now".
std::vector<std::string> differences_of(std::vector<StudyProperty> const& there, std::vector<StudyProperty> const& now,
                                        campaign::Sides const& sides = {}) {
  std::vector<std::string> found;
  for (auto const& [kind, other] :
       std::initializer_list<std::pair<std::string_view, std::string_view>>{{"setting", ""},
                                                                            {"building", "another building: "},
                                                                            {"motion", "other values of motion "},
                                                                            {"law", "another lot of "}}) {
    auto const a = of_kind(there, kind), b = of_kind(now, kind);
    auto const differ = [&](std::string const& what, std::string const& one, std::string const& another) {
      if (one != another) found.push_back(fmt::format("{}{} {}, {} {}", what, one, sides.one, another, sides.other));
      return one != another;
    };
    if (differ("", counted(a.size(), kind), counted(b.size(), kind))) continue;
    for (std::size_t i = 0; i < a.size(); ++i) {
      auto const name = printable(a[i].name);
      if (differ(fmt::format("{} {}: ", kind, i + 1), name, printable(b[i].name)) || a[i].value == b[i].value) continue;
      if (other.empty())
        differ(name + ": ", printable(a[i].value), printable(b[i].value));
      else
        found.push_back(fmt::format("{}{}", other, name));
    }
  }
  return found;
}

Connection opened(Path const& file, std::vector<StudyProperty> const& properties, bool fresh, StudyPart const& part) {
  if (fresh || !std::filesystem::exists(file)) {
    create(file, properties, part);
    return building_store().to_write(file);
  }
  campaign::sqlite::remove_unfinished(file);
  auto db = building_store().to_write(file);
  StoreKind::as_ours(file, [&] {
    auto const held = campaign::read_part(db);
    // If the store holds a part of a study, a merge will read this file. The merge would not notice that the file was
    // cut off within a database page, so the file is checked here.
    if (held) campaign::require_sound(file, "--fresh to start over");
    auto different = differences_of(read_properties(db), properties);
    auto const named = [](std::optional<campaign::Part> const& which) {
      return which ? "part " + campaign::text(*which) : "all of it";
    };
    if (held != part.part) different.push_back(fmt::format("{} there, {} now", named(held), named(part.part)));
    if (!different.empty())
      throw Error({.where = file.string(),
                   .found = "the runs of another building, of other settings or of another campaign: " +
                            joined(different, "; "),
                   .allowed = "the same, which is continued",
                   .advice = "--fresh to start over, or another --out"});
    // A study must not mix runs of two builds, which may give different numbers, or of two instruction sets, which
    // differ in the last digits.
    auto const me = building_maker();
    for (auto const& maker : campaign::read_makers(db))
      if (!same_build(maker, me) || maker.instruction_set != me.instruction_set)
        throw Error(
            {.where = file.string(),
             .found = fmt::format("computed by isolaw {} with instruction set {}; this is {} with {}", text(maker),
                                  maker.instruction_set, text(me), me.instruction_set),
             .allowed = "runs of one build and instruction set in a study",
             .advice = fmt::format(
                 "the isolaw that computed it (isolaw --version tells its build), with ISOLAW_SIMD={}; --fresh to start over, or another --out",
                 maker.instruction_set)});
  });
  return db;
}

// A hash that is stored with a run, to show later whether its stored numbers are still those that were computed.
std::string hash_of(RunStore::Row const& run) {
  auto const* const bytes = reinterpret_cast<char const*>(run.measured.data());
  return sha256(fmt::format("{};{};{};", run.law, run.motion, run.place) +
                std::string(bytes, run.measured.size() * sizeof(double)))
      .substr(0, 16);
}

// Returns the hash that is stored with a text of RunStore::save_text(), to show later whether the text was changed.
std::string hash_of_kept(std::size_t law, std::size_t place, std::string_view text) {
  return sha256(fmt::format("{};{};{}", law, place, text));
}

std::string number_of(RunStore::Row const& run) {
  return fmt::format("run {} of law {} under motion {}", run.place + 1, run.law + 1, run.motion + 1);
}
constexpr std::string_view has_changed = "has other numbers than when it was computed";

// The runs that a complete store holds, and how many measures each run has.
struct Expected {
  std::vector<StudyProperty> laws, motions;
  std::vector<Case> cases;
  std::size_t measures = 0;
  Blocks blocks() const { return {laws.size(), motions.size(), cases.size()}; }
};
Expected expected_runs(Connection const& db) {
  auto const properties = read_properties(db);
  auto const value = [&](std::string_view kind, std::string_view name) {
    for (auto const& property : properties)
      if (property.kind == kind && property.name == name) return property.value;
    throw Error({.found = fmt::format("no value of {}", name)});
  };
  FileTables tables;
  for (auto const& key : settings_table())
    if (key.changes_runs) key.set(tables, value_of(key.kind, {value("setting", key.key)}));
  return {.laws = of_kind(properties, "law"),
          .motions = of_kind(properties, "motion"),
          .cases = cases_of(tables.building),
          .measures = Json::parse(value("building", "measures")).get<std::size_t>()};
}

}  // namespace

StoreKind const& building_store() {
  static StoreKind const kind({.store = "store of building runs",
                               .file = "building.sqlite of isolaw building",
                               .whole = "study",
                               .same = "the same building, motions, lot and settings",
                               .command = "isolaw building",
                               .input = "BUILDING.toml",
                               .once_more = "compute it again",
                               .advice = "--fresh, which starts over a study of an older isolaw"},
                              3, R"sql(
CREATE TABLE study (kind TEXT NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL);
CREATE TABLE runs (law INTEGER, motion INTEGER, place INTEGER, measured BLOB, hash TEXT, PRIMARY KEY (law, motion, place)) WITHOUT ROWID;
CREATE TABLE nominal (law INTEGER, place INTEGER, content TEXT, hash TEXT, PRIMARY KEY (law, place)) WITHOUT ROWID;
)sql");
  return kind;
}

CheckedRuns check_runs(Path const& file) {
  return building_store().read(file, [](Connection const& db) {
    auto const expected = expected_runs(db);
    CheckedRuns checked{.expected = expected.blocks().runs(), .faults = {}};
    Statement select(db, "SELECT law, motion, place, measured, hash FROM runs ORDER BY law, motion, place");
    while (select.row()) {
      RunStore::Row row;
      std::string hash;
      select.read(row.law, row.motion, row.place, row.measured, hash);
      ++checked.runs;
      if (hash != hash_of(row)) checked.faults.push_back(fmt::format("{} {}", number_of(row), has_changed));
    }
    Statement kept(db, "SELECT law, place, content, hash FROM nominal ORDER BY law, place");
    while (kept.row()) {
      std::size_t law = 0, place = 0;
      std::string content, hash;
      kept.read(law, place, content, hash);
      if (hash != hash_of_kept(law, place, content))
        checked.faults.push_back(
            fmt::format("what is kept of the nominal building of law {} {}", law + 1, has_changed));
    }
    return checked;
  });
}

Blocks::Block Blocks::at(std::size_t number) const {
  constexpr std::size_t size = 2 * lane_width;
  auto const from = number % blocks_per_motion() * size;
  return {.law = number / blocks_per_motion() / motions_,
          .motion = number / blocks_per_motion() % motions_,
          .from = from,
          .to = std::min(cases_, from + size)};
}

std::size_t Blocks::blocks_per_motion() const {
  constexpr std::size_t size = 2 * lane_width;
  return (cases_ + size - 1) / size;
}

RunStore::RunStore(Path const& file, std::vector<StudyProperty> const& properties, bool fresh, StudyPart const& part)
    : file_(file), db_(opened(file, properties, fresh, part)) {}

std::size_t RunStore::runs_there() const {
  return runs_in(db_);
}

bool RunStore::is_there(Blocks::Block const& block) const {
  Statement select(db_, "SELECT count(*) FROM runs WHERE law = ? AND motion = ? AND place >= ? AND place < ?");
  select.bind(block.law, block.motion, block.from, block.to);
  std::size_t count = 0;
  if (select.row()) select.read(count);
  return count == block.to - block.from;
}

void RunStore::add(std::vector<Row> const& rows) {
  Transaction transaction(db_);
  {
    // A merge in another process may have stored some of these rows already. Rows that are in the store stay as they
    // are.
    Statement insert(db_, "INSERT OR IGNORE INTO runs VALUES (?, ?, ?, ?, ?)");
    for (auto const& row : rows) insert.bind(row.law, row.motion, row.place, row.measured, hash_of(row)).insert();
  }
  transaction.commit();
}

void RunStore::for_each_run(std::size_t law, std::size_t motion,
                            std::function<void(std::size_t, std::vector<double> const&)> const& take) const {
  Statement select(db_, "SELECT place, measured, hash FROM runs WHERE law = ? AND motion = ? ORDER BY place");
  select.bind(law, motion);
  while (select.row()) {
    Row row{.law = law, .motion = motion};
    std::string hash;
    select.read(row.place, row.measured, hash);
    if (hash != hash_of(row))
      throw Error({.where = file_.string(),
                   .found = fmt::format("{} {}", number_of(row), has_changed),
                   .allowed = "runs as isolaw building stored them",
                   .advice = "--fresh, which computes them again"});
    take(row.place, row.measured);
  }
}

std::string RunStore::stored_text(std::size_t law, std::size_t place) const {
  Statement select(db_, "SELECT content, hash FROM nominal WHERE law = ? AND place = ?");
  select.bind(law, place);
  std::string content, hash;
  if (select.row()) select.read(content, hash);
  if (!content.empty() && hash != hash_of_kept(law, place, content))
    throw Error({.where = file_.string(),
                 .found = fmt::format("what is kept of the nominal building of law {} {}", law + 1, has_changed),
                 .allowed = "results as isolaw building stored them",
                 .advice = "--fresh, which computes them again"});
  return content;
}

void RunStore::save_text(std::size_t law, std::size_t place, std::string const& text) const {
  Statement insert(db_, "INSERT OR REPLACE INTO nominal VALUES (?, ?, ?, ?)");
  auto const hash = hash_of_kept(law, place, text);
  insert.bind(law, place, std::string_view(text), std::string_view(hash)).insert();
}

std::vector<StudyProperty> properties_of(Study const& study) {
  std::vector<StudyProperty> properties;
  std::string content;
  auto const add = [&](auto const&... values) { ((content += fmt::format("{};", values)), ...); };
  auto const add_all = [&](auto const& values) {
    add(values.size());
    for (auto const& v : values) add(v);
  };
  auto const add_matrix = [&](lot::SquareMatrix const& rows) {
    for (auto const& row : rows) add_all(row);
  };
  auto const hashed = [&](std::string const& kind, std::string const& name) {
    properties.push_back({kind, name, sha256(std::exchange(content, {}))});
  };
  FileTables const tables{.building = study.file.settings};
  for (auto const& key : settings_table())
    if (key.changes_runs) properties.push_back({"setting", std::string(key.key), text_of(key.get(tables))});
  auto const slab = [&](Diaphragm const& d) { add(d.mass_Mg, d.gyration_mm, d.centre.x_mm, d.centre.y_mm); };
  slab(study.file.frame.base);
  for (auto const& floor : study.file.frame.floors) {
    slab(floor.slab);
    add(floor.below.centre.x_mm, floor.below.centre.y_mm);
    for (Eigen::Index i = 0; i < 9; ++i) add(floor.below.stiffness(i / 3, i % 3));
  }
  hashed("building", "structure");
  for (auto const& b : study.file.bearings) add(b.at.x_mm, b.at.y_mm, static_cast<int>(b.kind), b.device);
  if (study.file.plan_mm) add_all(*study.file.plan_mm);
  hashed("building", "plan");
  auto const measures = Layout{study.file.frame.floors.size(), study.file.bearings.size()}.count();
  properties.push_back({"building", "measures", std::to_string(measures)});
  for (auto const& m : study.file.motions) {
    add(m.step_s);
    add_all(m.x_mm_s2);
    add_all(m.y_mm_s2);
    hashed("motion", m.name);
  }
  auto const add_law = [&](LawSource const& law) {
    auto const& p = law.population;
    add_all(law.lot);
    add_all(law.median);
    add_all(p.mean);
    add(p.devices);
    add_matrix(p.estimates);
    add_matrix(p.uncertainty);
    add_matrix(p.covariance);
    for (auto const transform : p.transforms) add(static_cast<int>(transform));
    for (auto const& place : law.place) add(place ? *place + 1 : 0);
    for (auto const& limits : law.limits) add(limits.lower, limits.upper);
    for (auto const& bound : {law.lower, law.upper})
      if (bound) add(bound->elastic, bound->hysteretic);
    for (auto const& [name, values] : law.devices) {
      add(name);
      add_all(values);
    }
  };
  for (auto const& law : study.laws) {
    add_law(law);
    for (auto const& springs : law.springs) add_law(springs);
    hashed("law", law.law);
  }
  return properties;
}

Options options_of(Study const& study, Model const& model, Devices const& devices, Motion const& motion) {
  auto const stiffest = devices.bearings(devices.parameters_of({.kind = CaseKind::upper}));
  std::vector<std::array<double, 4>> first;
  for (auto const& bearing : stiffest) {
    auto const force = bearing->trial({0.0, 0.0}, {0.0, 0.0}, study.file.settings.step_s);
    auto const& k = force.by_displacement;
    first.push_back({k[0][0], k[0][1], k[1][0], k[1][1]});
  }
  double const stable_s = longest_explicit_step(model, first);
  Options const options{.longest_step_s = std::min(study.file.settings.step_s, stable_s),
                        .rest_s = study.file.settings.rest_s};
  auto const steps = steps_of(motion, options.longest_step_s, options.rest_s);
  if (steps.count <= most_steps) return options;
  bool const stiff = stable_s < study.file.settings.step_s;
  auto const& base = study.file.frame.base;
  throw Error(
      {.where = stiff ? "base" : "step_s",
       .found = fmt::format(
           "{} steps of {:.3g} s under {}{}", steps.count, steps.dt, printable(motion.name),
           stiff
               ? fmt::format(": the base has a mass of {:.3g} t and a radius of gyration of {:.3g} mm, too little for "
                             "bearings so stiff",
                             base.mass_Mg, base.gyration_mm)
               : std::string()),
       .allowed = fmt::format("at most {} steps in a run", most_steps),
       .advice =
           stiff ? "the mass and the radius of gyration of the real slab" : "a longer step, or a shorter motion"});
}

Runs::Runs(Study const& study, std::function<bool()> const& interrupted)
    : study_(study),
      model_(Structure(study.file.frame), study.file.plan()),
      cases_(cases_of(study.file.settings)),
      blocks_(study.laws.size(), study.file.motions.size(), cases_.size()) {
  for (auto const& law : study.laws)
    for (auto const& motion : study.file.motions) {
      // If the law has the same coupling as under the previous motion, the Devices object of that motion is copied. The
      // copies share the populations that are estimated again, so these are made only once.
      bool const alike =
          &motion != study.file.motions.data() && devices_.back().coupling() == coupling_under(motion, law);
      alike ? devices_.push_back(devices_.back()) : void(devices_.emplace_back(law, study.file, motion));
      options_.push_back(options_of(study, model_, devices_.back(), motion));
      options_.back().interrupted = interrupted;
    }
}

std::vector<RunStore::Row> Runs::compute(Blocks::Block const& block) const {
  auto const& devices = devices_[place(block)];
  std::vector<double> values;
  for (auto place = block.from; place < block.to; ++place) {
    auto const parameters = devices.parameters_of(cases_[place]);
    values.insert(values.end(), parameters.begin(), parameters.end());
  }
  auto const out = respond(model_, study_.laws[block.law].law, values, study_.file.motions[block.motion],
                           options_[place(block)], devices.coupling());
  auto const count = static_cast<std::ptrdiff_t>(model_.layout().count());
  std::vector<RunStore::Row> rows;
  auto row = out.begin();
  for (auto place = block.from; place < block.to; ++place, row += count)
    rows.push_back({block.law, block.motion, place, {row, row + count}});
  return rows;
}

namespace {

// Collects finished rows and stores many at a time, since each transaction waits for the disk.
class Rows {
 public:
  explicit Rows(RunStore& store) : store_(store) {}
  void add(std::vector<RunStore::Row> rows) {
    std::ranges::move(rows, std::back_inserter(waiting_));
    constexpr std::size_t many = 256;
    constexpr std::chrono::milliseconds long_ago(500);
    if (waiting_.size() >= many || Clock::now() - stored_at_ > long_ago) store();
  }
  void store() {
    if (!waiting_.empty()) store_.add(waiting_);
    waiting_.clear();
    stored_at_ = Clock::now();
  }

 private:
  using Clock = std::chrono::steady_clock;
  RunStore& store_;
  std::vector<RunStore::Row> waiting_;
  Clock::time_point stored_at_ = Clock::now();
};

}  // namespace

bool run_all(Study const& study, RunStore& store, std::size_t threads, RunAllOptions const& options) {
  std::atomic<bool> stopped = false;
  auto const stop = [&] {
    if (!stopped && options.interrupted && options.interrupted()) stopped = true;
    return stopped.load();
  };
  Runs const runs(study, stop);
  auto const& blocks = runs.blocks();
  // The runs that the store lacks, in groups that are computed together: as many as there are lanes, or a single run if
  // runs are integrated one by one.
  std::vector<Blocks::Block> left;
  RunProgress progress;
  for (std::size_t number = 0; number < blocks.count(); ++number) {
    if (options.part && Blocks::part_of(number, options.part->total) != options.part->number) continue;
    auto const block = blocks.at(number);
    auto const together = runs.one_by_one(block) ? 1 : lane_width;
    for (auto from = block.from; from < block.to; from += together) {
      Blocks::Block const some{
          .law = block.law, .motion = block.motion, .from = from, .to = std::min(block.to, from + together)};
      progress.total += some.to - some.from;
      if (store.is_there(some))
        progress.done += some.to - some.from;
      else
        left.push_back(some);
    }
  }
  std::mutex one_at_a_time;
  Rows rows(store);
  auto const take = [&](std::vector<RunStore::Row> finished) {
    std::scoped_lock const lock(one_at_a_time);
    progress.done += finished.size();
    rows.add(std::move(finished));
    if (options.progress) options.progress(progress);
  };
  auto const perform = [&](Blocks::Block const& some) {
    if (stop()) return;
    try {
      take(runs.compute(some));
    } catch (InterruptedRun const&) {
      // These runs were interrupted and have no result. stop() ends the runs of the other threads too.
    }
  };
  try {
    campaign::for_each_in_parallel(left.size(), threads, [&](std::size_t i) { perform(left[i]); });
  } catch (...) {
    rows.store();
    throw;
  }
  rows.store();
  return progress.done == progress.total;
}

namespace {

class StudyMerge : public campaign::Merge {
 public:
  explicit StudyMerge(std::function<void(MissingRun const&)> const& missing)
      : Merge(building_store(), building_maker()), missing_(missing) {}
  StudyPart part = {};  // which part the first of the merged files holds, and the paths of its input files

 private:
  std::vector<std::string> differences(Path const& first, Path const& file) override {
    auto const properties = building_store().read(file, read_properties);
    if (first == file) first_ = properties;
    return differences_of(first_, properties, {.one = "in " + first.string(), .other = "in " + file.string()});
  }

  void create(Path const& file, Path const& /*first*/, std::function<void()> const& before_replacing) override {
    building::create(file, first_, {}, before_replacing);
  }

  void copy_runs(Path const& to, std::vector<Path> const& parts, campaign::MergeResult& merged) override {
    auto const db = building_store().to_write(to);
    auto const expected = expected_runs(db);
    for (auto const& file : parts) {
      auto const theirs = building_store().to_read(file);
      StoreKind::as_ours(file, [&] {
        if (!part.part) part = read_study_part(theirs);
        take_runs(db, theirs, file, expected, merged);
      });
    }
  }

  static void take_runs(Connection const& db, Connection const& theirs, Path const& file, Expected const& expected,
                        campaign::MergeResult& merged) {
    auto const refuse = [&](RunStore::Row const& row, std::string_view what, std::string_view allowed) {
      throw Error({.where = file.string(),
                   .found = fmt::format("{} {}", number_of(row), what),
                   .allowed = std::string(allowed),
                   .advice = "the part that is not sound again: isolaw building ... --part K/N --fresh"});
    };
    Transaction transaction(db);
    Statement insert(db, "INSERT OR IGNORE INTO runs VALUES (?, ?, ?, ?, ?)");
    Statement same(db, "SELECT 1 FROM runs WHERE law = ? AND motion = ? AND place = ? AND measured = ?");
    Statement select(theirs, "SELECT law, motion, place, measured, hash FROM runs ORDER BY law, motion, place");
    while (select.row()) {
      RunStore::Row row;
      std::string hash;
      select.read(row.law, row.motion, row.place, row.measured, hash);
      if (row.law >= expected.laws.size() || row.motion >= expected.motions.size() ||
          row.place >= expected.cases.size() || row.measured.size() != expected.measures)
        refuse(row, "does not belong to this study", "runs as isolaw building makes them");
      if (hash != hash_of(row)) refuse(row, has_changed, "runs as isolaw building stored them");
      if (insert.bind(row.law, row.motion, row.place, row.measured, hash).insert()) {
        ++merged.added;
        continue;
      }
      ++merged.already_there;
      if (!same.again(row.law, row.motion, row.place, row.measured).row())
        refuse(row, "differs from the one that is there already", "one result of a run, whoever computed it");
    }
    transaction.commit();
  }

  void tell_missing(Path const& file, campaign::MergeResult& merged) override {
    building_store().read(file, [&](Connection const& db) {
      auto const [laws, motions, cases, measures] = expected_runs(db);
      Blocks const blocks(laws.size(), motions.size(), cases.size());
      Statement there(db, "SELECT 1 FROM runs WHERE law = ? AND motion = ? AND place = ?");
      for (std::size_t number = 0; number < blocks.count(); ++number) {
        auto const block = blocks.at(number);
        int const of_part = merged.parts > 0 ? Blocks::part_of(number, merged.parts) : 0;
        for (auto place = block.from; place < block.to; ++place) {
          if (there.again(block.law, block.motion, place).row()) continue;
          ++merged.missing;
          ++merged.missing_of[of_part];
          if (missing_)
            missing_({.law = laws[block.law].name,
                      .motion = motions[block.motion].name,
                      .analysis = text(cases[place]),
                      .part = of_part});
        }
      }
    });
  }

  bool has_every_run(Path const& file) override {
    return building_store().read(file,
                                 [](Connection const& db) { return runs_in(db) == expected_runs(db).blocks().runs(); });
  }

  void complete(Path const& file, std::vector<Path> const& /*whole*/, campaign::MergeResult& /*merged*/) override {
    building_store().put_in_order(file);
  }

  std::function<void(MissingRun const&)> const& missing_;
  std::vector<StudyProperty> first_;
};

}  // namespace

MergedStudy merge(Path const& out, std::vector<Path> const& parts, MergeOptions const& options) {
  StudyMerge stores(options.missing);
  MergedStudy merged{stores.run(out, parts, options.fresh, options.before_replacing), {}};
  merged.part = std::move(stores.part);
  return merged;
}

}  // namespace isolaw::building
