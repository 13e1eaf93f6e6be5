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
#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::building {

using campaign::sqlite::Connection;
using campaign::sqlite::Statement;
using campaign::sqlite::Transaction;

extern char const* const sources_hash;  // from the build (CMakeLists.txt)

namespace {

using Kind = StudyProperty::Kind;
using Path = std::filesystem::path;

// Names of Kind in the store, in the order of Kind.
constexpr std::array<std::string_view, 6> kinds{"setting", "building", "motion", "law", "maker", "part"};

void create_run_tables(Connection const& db) {
  db.execute("CREATE TABLE study (kind TEXT NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL)");
  db.execute(
      "CREATE TABLE runs (law INTEGER, motion INTEGER, place INTEGER, measured BLOB, PRIMARY KEY (law, motion, place)) WITHOUT ROWID");
}

template <class Read>
auto read_as_study(Path const& file, Read&& read) {
  try {
    return read();
  } catch (Error const& error) {
    throw Error({.where = file.generic_string(),
                 .found = "no store of building runs, or a damaged one: " + error.complaints().front().found,
                 .allowed = "building.sqlite of isolaw building",
                 .advice = campaign::sqlite::advice_on_damaged});
  }
}

void require_sound(Path const& file, std::string const& again) {
  auto const faults = read_as_study(file, [&] { return campaign::sqlite::integrity(file); });
  if (!faults.empty())
    throw Error({.where = file.generic_string(),
                 .found = "is damaged: " + faults.front(),
                 .allowed = "stores as isolaw left them",
                 .advice = "copying it once more, or " + again});
}

std::vector<StudyProperty> read_properties(Connection const& db, Path const& file) {
  return read_as_study(file, [&] {
    std::vector<StudyProperty> properties;
    Statement select(db, "SELECT kind, name, value FROM study ORDER BY rowid");
    while (select.row()) {
      std::string kind;
      auto& property = properties.emplace_back();
      select.read(kind, property.name, property.value);
      auto const place = std::ranges::find(kinds, kind);
      if (place == kinds.end()) throw Error({.found = "a trait of kind " + in_quotes(kind)});
      property.kind = static_cast<Kind>(place - kinds.begin());
    }
    if (properties.empty()) throw Error({.found = "it does not say what its runs are of"});
    return properties;
  });
}

std::size_t runs_in(Connection const& db) {
  Statement select(db, "SELECT count(*) FROM runs");
  std::size_t count = 0;
  if (select.row()) select.read(count);
  return count;
}

std::vector<StudyProperty> without(std::vector<StudyProperty> properties, Kind kind) {
  std::erase_if(properties, [&](StudyProperty const& property) { return property.kind == kind; });
  return properties;
}

std::vector<StudyProperty> of_kind(std::span<StudyProperty const> properties, Kind kind) {
  std::vector<StudyProperty> found;
  std::ranges::copy_if(properties, std::back_inserter(found),
                       [&](StudyProperty const& property) { return property.kind == kind; });
  return found;
}

// Two builds may give different numbers, and two instruction sets differ in the last digits.
void require_same_maker(Path const& file, std::span<StudyProperty const> there, campaign::Maker const& now,
                        std::string const& again) {
  auto const maker = maker_of(there);
  if (!campaign::same_build(maker, now))
    throw Error({.where = file.generic_string(),
                 .found = fmt::format("computed by isolaw {}; this is {}, whose numbers may differ",
                                      campaign::text(maker), campaign::text(now)),
                 .allowed = "runs of one build in a study",
                 .advice = "the isolaw that computed it (isolaw --version tells its build), or " + again});
  if (maker.instruction_set != now.instruction_set)
    throw Error({.where = file.generic_string(),
                 .found = fmt::format("computed with instruction set {}; this is {}", maker.instruction_set,
                                      now.instruction_set),
                 .allowed = "runs of one instruction set in a study",
                 .advice = fmt::format("ISOLAW_SIMD={}, or {}", maker.instruction_set, again)});
}

campaign::Maker building_maker() {
  auto maker = campaign::this_maker();
  maker.build = sources_hash;
  return maker;
}

std::string of_part(std::optional<campaign::Part> const& part) {
  return part ? "part " + campaign::text(*part) : "all of it";
}

}  // namespace

campaign::Maker maker_of(std::span<StudyProperty const> properties) {
  return {.version = value_of(properties, Kind::maker, "version"),
          .build = value_of(properties, Kind::maker, "build"),
          .instruction_set = value_of(properties, Kind::maker, "instruction_set")};
}

std::optional<campaign::Part> part_of(std::span<StudyProperty const> properties) {
  auto const text = value_of(properties, Kind::part, "part");
  return text.empty() ? std::nullopt : std::optional(campaign::parse_part(text));
}

std::string value_of(std::span<StudyProperty const> properties, Kind kind, std::string_view name) {
  auto const found = std::ranges::find_if(
      properties, [&](StudyProperty const& property) { return property.kind == kind && property.name == name; });
  return found == properties.end() ? std::string() : found->value;
}

std::vector<StudyProperty> properties_of(campaign::Part const& part, std::string const& building_file,
                                         std::string const& campaign, std::vector<std::string> const& motions) {
  std::vector<StudyProperty> properties{
      {Kind::part, "part", campaign::text(part)}, {Kind::part, "file", building_file}, {Kind::part, "from", campaign}};
  for (auto const& motion : motions) properties.push_back({Kind::part, "motion", motion});
  return properties;
}

std::vector<std::string> differences(std::span<StudyProperty const> there, std::span<StudyProperty const> now,
                                     campaign::Sides const& sides) {
  std::vector<std::string> found;
  for (auto const kind : {Kind::setting, Kind::building, Kind::motion, Kind::law}) {
    auto const a = of_kind(there, kind), b = of_kind(now, kind);
    auto const word = kinds[static_cast<std::size_t>(kind)];
    if (a.size() != b.size()) {
      found.push_back(
          fmt::format("{} {}, {} {}", counted(a.size(), word), sides.one, counted(b.size(), word), sides.other));
      continue;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      auto const name = printable(a[i].name), was = printable(a[i].value), is = printable(b[i].value);
      if (a[i].name != b[i].name)
        found.push_back(
            fmt::format("{} {}: {} {}, {} {}", word, i + 1, name, sides.one, printable(b[i].name), sides.other));
      else if (a[i].value == b[i].value)
        continue;
      else if (kind == Kind::setting)
        found.push_back(fmt::format("{}: {} {}, {} {}", name, was, sides.one, is, sides.other));
      else
        found.push_back((kind == Kind::law      ? "another lot of "
                         : kind == Kind::motion ? "other values of motion "
                                                : "another building: ") +
                        name);
    }
  }
  return found;
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

struct RunStore::Handle {
  Connection db;
};

RunStore::RunStore(std::filesystem::path const& file, std::vector<StudyProperty> const& properties, bool fresh) {
  campaign::sqlite::remove_unfinished(file);
  campaign::sqlite::require_plain(file);
  if (fresh || !std::filesystem::exists(file)) {
    create(file, properties);
    handle_ = std::make_unique<Handle>(Handle{Connection::to_write(file)});
    return;
  }
  handle_ = std::make_unique<Handle>(Handle{Connection::to_write(file)});
  auto const found = read_properties(handle_->db, file);
  // A merge will read this part, and would take a file that was cut off within a page for a whole one.
  if (part_of(found)) require_sound(file, "--fresh to start over");
  if (found == properties) return;
  auto different = differences(found, properties);
  if (auto const a = part_of(found), b = part_of(properties); a != b)
    different.push_back(fmt::format("{} there, {} now", of_part(a), of_part(b)));
  if (!different.empty())
    throw Error(
        {.where = file.generic_string(),
         .found = "the runs of another building, of other settings or of another campaign: " + joined(different, "; "),
         .allowed = "the same, which is continued",
         .advice = "--fresh to start over, or another --out"});
  // From here only the maker can differ, or a part's paths, which are allowed to differ.
  require_same_maker(file, found, maker_of(properties), "--fresh to start over, or another --out");
}

void RunStore::create(Path const& file, std::vector<StudyProperty> const& properties) {
  auto const aside = campaign::sqlite::unfinished(file);
  {
    auto const db = Connection::create(aside);
    Transaction transaction(db);
    create_run_tables(db);
    Statement insert(db, "INSERT INTO study VALUES (?, ?, ?)");
    for (auto const& property : properties)
      insert
          .bind(kinds.at(static_cast<std::size_t>(property.kind)), std::string_view(property.name),
                std::string_view(property.value))
          .insert();
    transaction.commit();
  }
  campaign::sqlite::move_into_place(aside, file);
}

RunStore::~RunStore() = default;

std::size_t RunStore::runs_there() const {
  return runs_in(handle_->db);
}

bool RunStore::is_there(Blocks::Block const& block) const {
  Statement select(handle_->db, "SELECT count(*) FROM runs WHERE law = ? AND motion = ? AND place >= ? AND place < ?");
  select.bind(block.law, block.motion, block.from, block.to);
  std::size_t count = 0;
  if (select.row()) select.read(count);
  return count == block.to - block.from;
}

void RunStore::add(std::vector<Row> const& rows) {
  auto const& db = handle_->db;
  Transaction transaction(db);
  {
    // A merge in another program may have stored a part of the block already; its rows stay.
    Statement insert(db, "INSERT OR IGNORE INTO runs VALUES (?, ?, ?, ?)");
    for (auto const& row : rows) insert.bind(row.law, row.motion, row.place, row.measured).insert();
  }
  transaction.commit();
}

void RunStore::each(std::size_t law, std::size_t motion,
                    std::function<void(std::size_t, std::vector<double> const&)> const& take) const {
  Statement select(handle_->db, "SELECT place, measured FROM runs WHERE law = ? AND motion = ? ORDER BY place");
  select.bind(law, motion);
  while (select.row()) {
    std::size_t place = 0;
    std::vector<double> measured;
    select.read(place, measured);
    take(place, measured);
  }
}

void RunStore::put_in_order(std::filesystem::path const& file) {
  campaign::sqlite::put_in_order(file, create_run_tables);
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
  auto const hashed = [&](Kind kind, std::string const& name) {
    properties.push_back({kind, name, sha256(std::exchange(content, {}))});
  };
  auto const& s = study.file.settings;
  auto const setting = [&](char const* name, auto value) {
    properties.push_back({Kind::setting, name, fmt::format("{}", value)});
  };
  setting("draws", s.draws);
  setting("populations", s.populations);
  setting("draws_of_each", s.draws_of_each);
  setting("seed", s.seed);
  setting("damping", s.damping);
  setting("lower", s.lower);
  setting("upper", s.upper);
  setting("step_s", s.step_s);
  setting("rest_s", s.rest_s);
  auto const slab = [&](Diaphragm const& d) { add(d.mass_Mg, d.gyration_mm, d.centre.x_mm, d.centre.y_mm); };
  slab(study.file.frame.base);
  for (auto const& floor : study.file.frame.floors) {
    slab(floor.slab);
    add(floor.below.centre.x_mm, floor.below.centre.y_mm);
    for (Eigen::Index i = 0; i < 9; ++i) add(floor.below.stiffness(i / 3, i % 3));
  }
  hashed(Kind::building, "structure");
  for (auto const& b : study.file.bearings) add(b.at.x_mm, b.at.y_mm, static_cast<int>(b.stands), b.device);
  if (study.file.plan_mm) add_all(*study.file.plan_mm);
  hashed(Kind::building, "plan");
  auto const measures = Layout{study.file.frame.floors.size(), study.file.bearings.size()}.count();
  properties.push_back({Kind::building, "measures", std::to_string(measures)});
  for (auto const& m : study.file.motions) {
    add(m.step_s);
    add_all(m.x_mm_s2);
    add_all(m.y_mm_s2);
    hashed(Kind::motion, m.name);
  }
  for (auto const& law : study.laws) {
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
    add(law.as_springs);
    for (auto const& limits : law.limits) add(limits.lower, limits.upper);
    for (auto const& [name, values] : law.devices) {
      add(name);
      add_all(values);
    }
    hashed(Kind::law, law.law);
  }
  auto const maker = building_maker();
  properties.push_back({Kind::maker, "version", maker.version});
  properties.push_back({Kind::maker, "build", maker.build});
  properties.push_back({Kind::maker, "instruction_set", maker.instruction_set});
  return properties;
}

Options options_of(Study const& study, Model const& model, Devices const& devices) {
  auto const stiffest = devices.bearings(devices.of({.kind = CaseKind::upper}));
  std::vector<std::array<double, 4>> first;
  for (auto const& bearing : stiffest) {
    auto const force = bearing->trial({0.0, 0.0}, {0.0, 0.0}, study.file.settings.step_s);
    auto const& k = force.by_displacement;
    first.push_back({k[0][0], k[0][1], k[1][0], k[1][1]});
  }
  return {.longest_step_s = std::min(study.file.settings.step_s, longest_explicit_step(model, first)),
          .rest_s = study.file.settings.rest_s};
}

Runs::Runs(Study const& study)
    : study_(study),
      model_(Structure(study.file.frame), study.file.plan()),
      cases_(cases_of(study.file.settings)),
      blocks_(study.laws.size(), study.file.motions.size(), cases_.size()) {
  for (auto const& law : study.laws) {
    devices_.emplace_back(law, study.file);
    options_.push_back(options_of(study, model_, devices_.back()));
  }
}

std::vector<RunStore::Row> Runs::of(Blocks::Block const& block) const {
  auto const& devices = devices_[block.law];
  std::vector<double> values;
  for (auto place = block.from; place < block.to; ++place) {
    auto const parameters = devices.of(cases_[place]);
    values.insert(values.end(), parameters.begin(), parameters.end());
  }
  auto const out = respond(model_, study_.laws[block.law].law, values, study_.file.motions[block.motion],
                           options_[block.law], devices.coupling());
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
  Runs const runs(study);
  auto const& blocks = runs.blocks();
  std::vector<Blocks::Block> left;
  RunProgress progress;
  for (std::size_t number = 0; number < blocks.count(); ++number) {
    if (options.part && Blocks::part_of(number, options.part->of) != options.part->number) continue;
    auto const block = blocks.at(number);
    progress.total += block.to - block.from;
    if (store.is_there(block))
      progress.done += block.to - block.from;
    else
      left.push_back(block);
  }
  std::mutex one_at_a_time;
  Rows rows(store);
  std::atomic<bool> stopped = false;
  auto const stop = [&] {
    if (!stopped && options.interrupted && options.interrupted()) stopped = true;
    return stopped.load();
  };
  auto const take = [&](std::vector<RunStore::Row> finished) {
    std::scoped_lock const lock(one_at_a_time);
    progress.done += finished.size();
    rows.add(std::move(finished));
    if (options.progress) options.progress(progress);
  };
  auto const perform = [&](Blocks::Block const& block) {
    if (!runs.one_by_one(block)) {
      if (!stop()) take(runs.of(block));
      return;
    }
    for (auto place = block.from; place < block.to && !stop(); ++place)
      take(runs.of({.law = block.law, .motion = block.motion, .from = place, .to = place + 1}));
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

Blocks blocks_of(std::span<StudyProperty const> properties, std::vector<Case>& cases, Path const& file) {
  auto const whole = [&](std::string_view name) {
    auto const number = number_in<int>(value_of(properties, Kind::setting, name));
    constexpr int most = 100'000'000;
    if (!number || *number < 0 || *number > most)
      throw Error({.where = file.generic_string(),
                   .found = fmt::format("no number of its setting {}", name),
                   .allowed = "building.sqlite of isolaw building",
                   .advice = campaign::sqlite::advice_on_damaged});
    return *number;
  };
  Settings settings;
  settings.draws = whole("draws");
  settings.populations = whole("populations");
  settings.draws_of_each = whole("draws_of_each");
  cases = cases_of(settings);
  return {of_kind(properties, Kind::law).size(), of_kind(properties, Kind::motion).size(), cases.size()};
}

void take_runs(Connection const& db, Path const& file, campaign::Merged& merged, std::array<std::size_t, 3> const& most,
               std::string const& measures) {
  auto const theirs = Connection::to_read(file);
  auto const refuse = [&](RunStore::Row const& row, std::string_view what, std::string_view allowed) {
    throw Error(
        {.where = file.generic_string(),
         .found = fmt::format("run {} of law {} under motion {} {}", row.place + 1, row.law + 1, row.motion + 1, what),
         .allowed = std::string(allowed),
         .advice = "the part that is not sound again: isolaw building ... --part K/N --fresh"});
  };
  Transaction transaction(db);
  {
    Statement insert(db, "INSERT OR IGNORE INTO runs VALUES (?, ?, ?, ?)");
    Statement same(db, "SELECT 1 FROM runs WHERE law = ? AND motion = ? AND place = ? AND measured = ?");
    Statement select(theirs, "SELECT law, motion, place, measured FROM runs ORDER BY law, motion, place");
    while (select.row()) {
      RunStore::Row row;
      select.read(row.law, row.motion, row.place, row.measured);
      if (row.law >= most[0] || row.motion >= most[1] || row.place >= most[2] ||
          std::to_string(row.measured.size()) != measures)
        refuse(row, "does not belong to this study", "runs as isolaw building makes them");
      if (insert.bind(row.law, row.motion, row.place, row.measured).insert()) {
        ++merged.added;
        continue;
      }
      ++merged.there;
      if (!same.again(row.law, row.motion, row.place, row.measured).row())
        refuse(row, "is another one than that which is there already", "one result of a run, whoever computed it");
    }
  }
  transaction.commit();
}

constexpr char const* again_as_part = "isolaw building ... --part K/N --fresh, which computes it again";

// False also for a file that is not a store, which a merge may replace.
bool has_every_run(Path const& file) {
  try {
    auto const db = Connection::to_read(file);
    std::vector<Case> cases;
    return runs_in(db) == blocks_of(read_properties(db, file), cases, file).runs();
  } catch (Error const&) {
    return false;
  }
}
std::optional<campaign::Part> part_in(Path const& file) {
  try {
    return part_of(read_properties(Connection::to_read(file), file));
  } catch (Error const&) {
    return std::nullopt;
  }
}

// A merge must not replace a part, which may be the only copy of its runs.
void refuse_part(Path const& out, std::optional<campaign::Part> const& part) {
  if (part)
    throw Error({.where = out.generic_string(),
                 .found = fmt::format("is part {} itself", campaign::text(*part)),
                 .allowed = "a directory of its own for the whole study",
                 .advice = "another directory"});
}

}  // namespace

MergedStudy merge(Path const& out, std::vector<Path> const& parts, MergeOptions const& options) {
  auto const maker = building_maker();
  MergedStudy merged;
  std::optional<std::pair<Path, std::vector<StudyProperty>>> first;
  auto const examine = [&](Path const& file) {
    require_sound(file, again_as_part);
    auto const properties = read_properties(Connection::to_read(file), file);
    require_same_maker(file, properties, maker, again_as_part);
    if (!first) first.emplace(file, without(properties, Kind::part));
    if (without(properties, Kind::part) != first->second)
      throw Error({.where = file.generic_string(),
                   .found = fmt::format("of another study than {}: {}", first->first.generic_string(),
                                        joined(differences(first->second, properties,
                                                           {.one = "in " + first->first.generic_string(),
                                                            .other = "in " + file.generic_string()}),
                                               "; ")),
                   .allowed = "parts of one study: the same building, motions, lot and settings",
                   .advice = "leaving it out, or --part again with the command of the others"});
    auto const part = read_as_study(file, [&] { return part_of(properties); });
    if (part && merged.parts != 0 && merged.parts != part->of)
      throw Error({.where = file.generic_string(),
                   .found = fmt::format("is part {}; another is one of {}", campaign::text(*part), merged.parts),
                   .allowed = "parts of one deal",
                   .advice = "merging those of each deal into the same directory, one after the other"});
    if (part) merged.parts = part->of;
    if (part && merged.part.empty()) merged.part = of_kind(properties, Kind::part);
    return part;
  };
  std::vector<Path> files;
  for (auto const& part : parts) {
    if (std::filesystem::exists(part))
      files.push_back(part);
    else
      merged.absent.push_back(part.string());
  }
  bool const exists = std::filesystem::exists(out), continues = exists && !options.fresh,
             replaces = exists && options.fresh;
  if (replaces) {
    campaign::refuse_absent(out, merged.absent);
    refuse_part(out, part_in(out));
  }
  campaign::sqlite::remove_unfinished(out);
  if (continues) {
    if (!campaign::sqlite::is_plain(out))
      Connection::to_write(out).try_execute("SELECT 1 FROM sqlite_master");  // rolls back what a kill left open
    refuse_part(out, examine(out));
  }
  for (auto const& file : files) examine(file);
  if (!first)
    throw Error({.where = parts.empty() ? out.generic_string() : parts.front().generic_string(),
                 .found = "no part is there",
                 .allowed = "directories of isolaw building BUILDING.toml --part K/N --out DIR"});
  std::vector<Case> cases;
  auto const blocks = blocks_of(first->second, cases, first->first);
  auto const laws = of_kind(first->second, Kind::law), motions = of_kind(first->second, Kind::motion);
  // The old store stays until everything that replaces it was checked and copied.
  auto const target = replaces ? campaign::sqlite::unfinished(out) : out;
  std::optional<campaign::sqlite::Unfinished> unfinished;
  if (replaces) unfinished.emplace(out);
  if (!continues) {
    if (!replaces && options.before_replacing) options.before_replacing();
    RunStore::create(target, first->second);
  }
  {
    auto const db = Connection::to_write(target);
    for (auto const& file : files)
      take_runs(db, file, merged, {laws.size(), motions.size(), cases.size()},
                value_of(first->second, Kind::building, "measures"));
    Statement there(db, "SELECT 1 FROM runs WHERE law = ? AND motion = ? AND place = ?");
    for (std::size_t number = 0; number < blocks.count(); ++number) {
      auto const block = blocks.at(number);
      for (auto place = block.from; place < block.to; ++place) {
        if (there.again(block.law, block.motion, place).row()) continue;
        int const part = merged.parts > 0 ? Blocks::part_of(number, merged.parts) : 0;
        ++merged.missing;
        ++merged.missing_of[part];
        if (options.missing)
          options.missing({.law = laws[block.law].name,
                           .motion = motions[block.motion].name,
                           .analysis = text(cases[place]),
                           .part = part});
      }
    }
  }
  if (merged.missing == 0) RunStore::put_in_order(target);
  if (replaces) {
    if (merged.missing > 0 && has_every_run(out)) campaign::refuse_to_replace_whole(out, merged);
    if (options.before_replacing) options.before_replacing();
    campaign::sqlite::move_into_place(target, out);
  }
  return merged;
}

}  // namespace isolaw::building
