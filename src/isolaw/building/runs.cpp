#include "isolaw/building/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/parallel.hpp"
#include "isolaw/campaign/sqlite.hpp"

namespace isolaw::building {

using campaign::sqlite::Connection;
using campaign::sqlite::Statement;
using campaign::sqlite::Transaction;

struct RunStore::Handle {
  Connection db;
};

RunStore::RunStore(std::filesystem::path const& file, std::string const& of, bool fresh) {
  bool const there = std::filesystem::exists(file);
  if (there && fresh)
    for (auto const* end : {"", "-wal", "-shm", "-journal"}) std::filesystem::remove(file.string() + end);
  bool const open = there && !fresh;
  handle_ = std::make_unique<Handle>(Handle{open ? Connection::to_write(file) : Connection::create(file)});
  auto const& db = handle_->db;
  if (open) {
    std::string found;
    Statement select(db, "SELECT made_of FROM study");
    if (select.row()) found = select.text();
    if (found == of) return;
    throw Error({.where = file.generic_string(),
                 .found = "the runs of another building, of other settings or of another campaign",
                 .allowed = "the same, which is continued",
                 .advice = "--fresh to start over, or another --out"});
  }
  Transaction transaction(db);
  db.execute("CREATE TABLE study (made_of TEXT NOT NULL, tasks INTEGER NOT NULL)");
  db.execute(
      "CREATE TABLE runs (law INTEGER, motion INTEGER, place INTEGER, measured BLOB, PRIMARY KEY (law, motion, place)) WITHOUT ROWID");
  Statement(db, "INSERT INTO study VALUES (?, 0)").bind(std::string_view(of)).insert();
  transaction.commit();
}

RunStore::~RunStore() = default;

std::size_t RunStore::tasks_done() const {
  Statement select(handle_->db, "SELECT tasks FROM study");
  std::size_t count = 0;
  if (select.row()) select.read(count);
  return count;
}

void RunStore::add(std::size_t tasks_done, std::vector<Row> const& rows) {
  auto const& db = handle_->db;
  Transaction transaction(db);
  {
    Statement insert(db, "INSERT INTO runs VALUES (?, ?, ?, ?)");
    for (auto const& row : rows) insert.bind(row.law, row.motion, row.place, row.measured).insert();
    Statement(db, "UPDATE study SET tasks = ?").bind(tasks_done).insert();
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

std::string fingerprint(Study const& study) {
  std::string all;
  auto const add = [&](auto const&... values) { ((all += fmt::format("{};", values)), ...); };
  auto const add_all = [&](auto const& values) {
    add(values.size());
    for (auto const& v : values) add(v);
  };
  auto const& s = study.file.settings;
  add(s.draws, s.populations, s.draws_of_each, s.seed, s.damping, s.lower, s.upper, s.step_s, s.rest_s);
  auto const slab = [&](Diaphragm const& d) { add(d.mass_Mg, d.gyration_mm, d.centre.x_mm, d.centre.y_mm); };
  slab(study.file.frame.base);
  for (auto const& floor : study.file.frame.floors) {
    slab(floor.slab);
    add(floor.below.centre.x_mm, floor.below.centre.y_mm);
    for (Eigen::Index i = 0; i < 9; ++i) add(floor.below.stiffness(i / 3, i % 3));
  }
  for (auto const& b : study.file.bearings) add(b.at.x_mm, b.at.y_mm, static_cast<int>(b.stands), b.device);
  if (study.file.plan_mm) add_all(*study.file.plan_mm);
  for (auto const& m : study.file.motions) {
    add(m.step_s);
    add_all(m.x_mm_s2);
    add_all(m.y_mm_s2);
  }
  for (auto const& law : study.laws) {
    add(law.law);
    add_all(law.lot);
    add_all(law.median);
    for (auto const& row : law.population.covariance) add_all(row);
    for (auto const& row : law.population.uncertainty) add_all(row);
    for (auto const& [name, values] : law.devices) {
      add(name);
      add_all(values);
    }
  }
  return fmt::format("{} {}", sha256(all), num::name(num::instruction_set()));
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

void run_all(Study const& study, RunStore& store, std::size_t threads,
             std::function<void(RunProgress const&)> const& progress) {
  Model const model(Structure(study.file.frame), study.file.plan());
  auto const cases = cases_of(study.file.settings);
  auto const motions = study.file.motions.size();
  std::vector<Devices> devices;
  std::vector<Options> options;
  for (auto const& law : study.laws) {
    devices.emplace_back(law, study.file);
    options.push_back(options_of(study, model, devices.back()));
  }
  constexpr std::size_t block = 2 * lane_width, chunk = 16;
  std::size_t const blocks = (cases.size() + block - 1) / block, total = study.laws.size() * motions * blocks;
  auto const count = model.layout().count();
  for (std::size_t first = store.tasks_done(); first < total; first += chunk) {
    std::size_t const last = std::min(total, first + chunk);
    std::vector<std::vector<RunStore::Row>> made(last - first);
    campaign::for_each_in_parallel(last - first, threads, [&](std::size_t i) {
      std::size_t const task = first + i, part = task % blocks, motion = task / blocks % motions,
                        law = task / blocks / motions;
      std::vector<double> values;
      std::size_t const from = part * block, to = std::min(cases.size(), from + block);
      for (std::size_t c = from; c < to; ++c) {
        auto const one = devices[law].of(cases[c]);
        values.insert(values.end(), one.begin(), one.end());
      }
      auto const out = respond(model, study.laws[law].law, values, study.file.motions[motion], options[law],
                               devices[law].coupling());
      for (std::size_t c = from; c < to; ++c) {
        auto const row = out.begin() + static_cast<std::ptrdiff_t>((c - from) * count);
        made[i].push_back({law, motion, c, {row, row + static_cast<std::ptrdiff_t>(count)}});
      }
    });
    std::vector<RunStore::Row> rows;
    for (auto& part : made) std::ranges::move(part, std::back_inserter(rows));
    store.add(last, rows);
    if (progress) progress({.done = last * cases.size() / blocks, .total = total * cases.size() / blocks});
  }
}

}  // namespace isolaw::building
