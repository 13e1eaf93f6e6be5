#include "isolaw/campaign/campaign.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <tuple>

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/text.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::campaign {
namespace {

// Several files of one device as one history: time continues after a pause of one sampling interval.
data::TestRecord read_history(DeviceInput const& input) {
  auto record = data::read_record(input.files.front(), input.read);
  for (std::size_t i = 1; i < input.files.size(); ++i) {
    auto const next = data::read_record(input.files[i], input.read);
    auto const file = input.files[i].filename().string();
    if (next.has_time() != record.has_time())
      throw Error({.where = file,
                   .found = "only some of the device's files have a time channel",
                   .allowed = "all of them or none",
                   .advice = "--dt SECONDS"});
    if (record.has_time()) {
      double const pause = record.time_s.back() - record.time_s[record.time_s.size() - 2];
      double const offset = record.time_s.back() + pause - next.time_s.front();
      for (double const t : next.time_s) record.time_s.push_back(t + offset);
    }
    bool const loads = !record.load_kN.empty() && !next.load_kN.empty();
    if (!loads) record.load_kN.clear();
    auto const append = [](std::vector<double>& to, std::vector<double> const& from) {
      to.insert(to.end(), from.begin(), from.end());
    };
    append(record.disp_mm, next.disp_mm);
    append(record.force_kN, next.force_kN);
    if (loads) append(record.load_kN, next.load_kN);
    record.recognised.push_back(fmt::format("{} continues the history with {} samples", file, next.size()));
    for (auto const& line : next.warnings) record.warnings.push_back(file + ": " + line);
    record.sha256 = sha256(record.sha256 + next.sha256);
  }
  return record;
}

// Files as the lot file names them: results must not depend on the folder the program was started from.
std::string with_shown_files(std::string text, std::filesystem::path const& directory) {
  auto const prefix = directory.empty() ? std::string() : (directory / "").generic_string();
  if (prefix.empty()) return text;
  for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}

// Of what can be read of a refused device, so that another content is noticed.
std::string hash_of_files(DeviceInput const& input) {
  std::string hashes;
  for (auto const& file : input.files) {
    std::string bytes;
    try {
      bytes = data::load_text(file);
    } catch (Error const&) {
      continue;  // not to be read at all
    }
    auto const hash = sha256(bytes);
    hashes = hashes.empty() ? hash : sha256(hashes + hash);
  }
  return hashes;
}

Device prepare_device(DeviceInput const& input, data::CleanOptions const& cleaning) {
  Device device{
      .name = input.name, .file = input.shown_file, .info = input.info, .refusal = {}, .raw = {}, .record = {}};
  try {
    device.raw = read_history(input);
    device.record = data::clean(device.raw, cleaning);
  } catch (Error const& error) {
    device.refusal = with_shown_files(error.what(), input.directory);
    device.raw = {};
    device.record = {};
    device.raw.sha256 = hash_of_files(input);
  }
  device.raw.file = input.shown_file;
  return device;
}

Search prepare_search(std::size_t index, Device const& device, std::string const& law_id, Settings const& settings) {
  Search search{.device = index, .law = law_id, .refusal = {}, .box = {}};
  auto const& law = laws::find_law(law_id);
  try {
    fit::LawOnRecord const check(law, device.record, settings.integration, settings.turning_points);
    search.box = fit::make_box(law, settings.box, fit::scales_of(device.record, law.info), settings.overrides);
  } catch (Error const& error) {
    search.refusal = error.what();
  }
  return search;
}

// One law on one device, ready to be searched from several threads.
struct Target {
  Search const* search;
  fit::LawOnRecord model;
  num::Stream stream;
};

struct Task {
  std::size_t target;
  int number;
};

// Nothing is searched when every parameter is fixed: the one point is the answer.
opt::GeneticResult evaluate_fixed(Target const& target) {
  opt::GeneticResult result;
  std::vector<double> parameters(target.search->box.parameters.size()), work;
  target.search->box.expand({}, parameters);
  result.best_value = target.model.objective(parameters, work);
  result.evaluations = 1;
  result.outcome =
      std::isfinite(result.best_value) ? opt::GeneticOutcome::all_generations : opt::GeneticOutcome::no_finite_value;
  result.failed_evaluations = result.outcome == opt::GeneticOutcome::no_finite_value ? 1 : 0;
  result.history = {result.best_value};
  return result;
}

Run finished(Target const& target, int number, opt::GeneticResult const& result) {
  Run run{.device = target.search->device,
          .law = target.search->law,
          .number = number,
          .outcome = {},
          .objective = {},
          .integration_shift = {},
          .evaluations = result.evaluations,
          .failed_evaluations = result.failed_evaluations,
          .failure = {},
          .parameters = {},
          .history = result.history};
  bool const found = result.outcome != opt::GeneticOutcome::no_finite_value;
  run.outcome = !found                                             ? Outcome::no_finite_value
                : result.outcome == opt::GeneticOutcome::stagnated ? Outcome::stagnated
                                                                   : Outcome::all_generations;
  run.objective = run.integration_shift = std::nan("");
  if (!found) {
    run.failure = result.evaluations == 1
                      ? std::string("the one parameter set, all of it fixed, gives no finite force")
                      : fmt::format("none of the first {} parameter sets gave a finite force", result.evaluations);
    return run;
  }
  run.parameters.resize(target.search->box.parameters.size());
  target.search->box.expand(result.best, run.parameters);
  // What is reported comes from the scalar path, whatever evaluated the population.
  std::vector<double> work;
  run.objective = target.model.objective(run.parameters, work);
  run.integration_shift = target.model.integration_shift(run.parameters);
  return run;
}

std::vector<Task> missing_runs(Contents const& contents, std::vector<Target> const& targets) {
  std::set<std::tuple<std::size_t, std::string, int>> present;
  for (auto const& run : contents.runs) present.emplace(run.device, run.law, run.number);
  std::vector<Task> tasks;
  for (int number = 1; number <= contents.settings.runs; ++number)
    for (std::size_t t = 0; t < targets.size(); ++t)
      if (!present.contains({targets[t].search->device, targets[t].search->law, number})) tasks.push_back({t, number});
  return tasks;
}

// For a thread sanitizer, which cannot see into TBB: a turn at one mutex before a task, after it, and on both sides of
// all of them orders what the threads share for it too. Static, so that even the way to it is not shared.
void take_turn() {
#if defined(__SANITIZE_THREAD__)
  static constinit std::mutex handover;
  std::scoped_lock const turn(handover);
#endif
}

}  // namespace

Contents prepare(Lot const& lot) {
  Contents contents{.title = lot.title, .settings = lot.settings, .devices = {}, .searches = {}, .runs = {}};
  if (contents.settings.laws.empty()) contents.settings.laws = parse_laws("all");
  contents.settings.validate();
  for (auto const& input : lot.devices) contents.devices.push_back(prepare_device(input, contents.settings.clean));
  if (std::ranges::none_of(contents.devices, &Device::usable)) {
    std::vector<Complaint> complaints{
        {.where = "lot", .found = fmt::format("none of {} device(s) is usable", lot.devices.size())}};
    for (auto const& device : contents.devices) complaints.push_back({.where = device.name, .found = device.refusal});
    throw Error(complaints);
  }
  for (std::size_t d = 0; d < contents.devices.size(); ++d) {
    if (!contents.devices[d].usable()) continue;
    for (auto const& law : contents.settings.laws)
      contents.searches.push_back(prepare_search(d, contents.devices[d], law, contents.settings));
  }
  return contents;
}

bool run(Contents& contents, std::filesystem::path const& file, RunOptions const& options) {
  std::vector<Target> targets;
  num::Stream const campaign(contents.settings.seed);
  for (auto const& search : contents.searches) {
    if (!search.refusal.empty()) continue;
    auto const& device = contents.devices[search.device];
    targets.push_back({&search,
                       fit::LawOnRecord(laws::find_law(search.law), device.record, contents.settings.integration,
                                        contents.settings.turning_points),
                       campaign.split(stable_hash(device.name)).split(stable_hash(search.law))});
  }
  auto const tasks = missing_runs(contents, targets);
  if (tasks.empty() && Store::is_plain(file)) return contents.complete();
  auto store = Store::open(file);

  Progress progress{.done = contents.runs.size(), .total = contents.runs.size() + tasks.size(), .best = {}};
  auto const note = [&](Run const& run) {
    if (!run.usable()) return;
    auto const [entry, is_new] = progress.best.try_emplace(run.law, run.objective);
    entry->second = std::min(entry->second, run.objective);
  };
  for (auto const& run : contents.runs) note(run);

  std::atomic<bool> stop = false;
  auto const asked_to_stop = [&] {
    if (!stop && options.interrupted && options.interrupted()) stop = true;
    return stop.load();
  };
  std::mutex one_writer;
  auto const perform = [&](Task const& task) {
    if (asked_to_stop()) return;
    auto const& target = targets[task.target];
    auto const result = target.search->box.free_count() == 0
                            ? evaluate_fixed(target)
                            : opt::minimise_genetic(fit::IdentificationProblem(target.model, target.search->box),
                                                    target.stream.split(static_cast<std::uint64_t>(task.number)),
                                                    contents.settings.genetic, asked_to_stop);
    if (result.outcome == opt::GeneticOutcome::interrupted) return;
    auto run = finished(target, task.number, result);
    std::scoped_lock const lock(one_writer);
    store.add(run);
    note(run);
    ++progress.done;
    contents.runs.push_back(std::move(run));
    if (options.progress) options.progress(progress);
  };

  int const jobs = options.jobs > 0 ? options.jobs : tbb::this_task_arena::max_concurrency();
  tbb::global_control const threads(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(jobs));
  tbb::task_arena arena(jobs);
  take_turn();
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, tasks.size(), 1),
        [&](auto const& range) {
          take_turn();
          for (std::size_t i = range.begin(); i < range.end(); ++i) perform(tasks[i]);
          take_turn();
        },
        tbb::simple_partitioner());
  });
  take_turn();
  std::ranges::sort(contents.runs, {}, [](Run const& r) { return std::tie(r.device, r.law, r.number); });
  bool const complete = contents.complete();  // also when the wish to stop came during the last run
  store.finish();                             // also when interrupted: whoever reads it next finds one plain file
  return complete;
}

}  // namespace isolaw::campaign
