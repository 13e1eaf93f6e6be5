#include "isolaw/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <tuple>

#include "isolaw/base/hash.hpp"
#include "isolaw/campaign/analyse.hpp"
#include "isolaw/campaign/parallel.hpp"
#include "isolaw/campaign/part_assignment.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::campaign {
namespace {

// A law to be fitted to a device. Its LawOnRecord is a hundred times larger, so it is made only while a task runs.
struct Target {
  std::size_t place;  // index in Contents::searches
  Search const* search;
  num::Stream stream;
};

struct Task {
  std::size_t target;
  int number;
};

// If every parameter is fixed, the box is a single point, and this point is the result of the search.
opt::SearchResult evaluate_fixed(Target const& target, fit::LawOnRecord const& model, Method method) {
  opt::SearchResult result;
  std::vector<double> parameters(target.search->box.parameters.size()), work;
  target.search->box.expand({}, parameters);
  double const value = model.objective(parameters, work);
  bool const finite = std::isfinite(value);
  result.evaluations = 1;
  result.failed_evaluations = finite ? 0 : 1;
  result.outcome = !finite                     ? Outcome::no_finite_value
                   : method == Method::genetic ? Outcome::all_generations
                                               : Outcome::confirmed;
  result.history = {value};
  return result;
}

opt::SearchResult search_by(Settings const& settings, Target const& target, fit::LawOnRecord const& model, int number,
                            std::function<bool()> const& interrupted) {
  if (target.search->box.free_count() == 0) return evaluate_fixed(target, model, settings.method);
  fit::IdentificationProblem const problem(model, target.search->box);
  auto const stream = target.stream.split(static_cast<std::uint64_t>(number));
  return settings.method == Method::genetic
             ? opt::minimise_genetic(problem, stream, settings.genetic, interrupted)
             : opt::minimise_multistart(problem, stream, settings.multistart, interrupted);
}

void fail(Run& run, std::string why) {  // keeps the run's counts and history, drops its parameters
  run.outcome = Outcome::no_finite_value;
  run.failure = std::move(why);
  run.objective = run.integration_shift = std::nan("");
  run.parameters.clear();
}

Run finished(Target const& target, fit::LawOnRecord const& model, int number, opt::SearchResult const& result) {
  Run run{.device = target.search->device,
          .law = target.search->law,
          .number = number,
          .outcome = result.outcome,
          .evaluations = result.evaluations,
          .failed_evaluations = result.failed_evaluations,
          .history = result.history};
  if (run.outcome == Outcome::no_finite_value) {
    fail(run, result.evaluations == 1
                  ? std::string("the one parameter set, all of it fixed, gives no finite force")
                  : fmt::format("none of the first {} parameter sets gave a finite force", result.evaluations));
    return run;
  }
  run.parameters.resize(target.search->box.parameters.size());
  target.search->box.expand(result.best, run.parameters);
  std::vector<double> work;  // scalar code gives the reported numbers, whichever vector code searched
  run.objective = model.objective(run.parameters, work);
  run.integration_shift = model.integration_shift(run.parameters);
  return run;
}

// If more than a thousandth of an optimum's objective is step error, the law is fitted again from this optimum in finer
// steps, until steps two and four times finer agree. The run fails if finer steps give no finite force.
void refit_in_finer_steps(Target const& target, fit::LawOnRecord model, Run& run) {
  constexpr double tolerance = 1e-3;
  if (!model.law().info.traits.path_integrated) return;
  std::vector<double> work;
  while (model.refinement() < finest_refinement) {
    auto const finer = model.refined(4 * model.refinement());
    double const twice = model.refined(2 * model.refinement()).objective(run.parameters, work),
                 four_times = finer.objective(run.parameters, work);
    double const moved = std::max(std::abs(twice - run.objective), std::abs(four_times - run.objective));
    if (moved <= tolerance * run.objective) return;
    auto const& box = target.search->box;
    fit::IdentificationProblem const problem(finer, box);
    run.refinement = finer.refinement();
    if (box.free_count() > 0) {
      auto const refit = opt::descend(problem, box.contract(run.parameters), 1.0);
      run.evaluations += refit.evaluations;
      run.failed_evaluations += refit.failed_evaluations;
      if (refit.usable()) box.expand(refit.best, run.parameters);
    }
    double const coarse = run.objective;
    run.objective = finer.objective(run.parameters, work);
    run.integration_shift = finer.integration_shift(run.parameters);
    if (!std::isfinite(run.objective))
      return fail(
          run,
          fmt::format(
              "the least objective found, {:.4g} with {} step(s) a sample, comes from the step size: with {} a sample these parameters give no finite force",
              coarse, model.refinement(), finer.refinement()));
    model = finer;
  }
}

std::vector<Task> missing_runs(Contents const& contents, std::vector<Target> const& targets) {
  std::set<std::tuple<std::size_t, std::string, int>> present;
  for (auto const& run : contents.runs) present.emplace(run.device, run.law, run.number);
  std::optional<RunAssignment> deal;
  if (contents.part) deal.emplace(contents, contents.part->of);
  auto const is_of_this_part = [&](Target const& target, int number) {
    return !deal || deal->part_of(target.place, number) == contents.part->number;
  };
  std::vector<Task> tasks;
  for (int number = 1; number <= contents.settings.runs; ++number)
    for (std::size_t t = 0; t < targets.size(); ++t)
      if (is_of_this_part(targets[t], number) &&
          !present.contains({targets[t].search->device, targets[t].search->law, number}))
        tasks.push_back({t, number});
  return tasks;
}

}  // namespace

bool run(Contents& contents, std::filesystem::path const& file, RunOptions const& options) {
  Meter own(options.profile);
  std::vector<Target> targets;
  num::Stream const campaign(contents.settings.seed);
  for (std::size_t place = 0; place < contents.searches.size(); ++place) {
    auto const& search = contents.searches[place];
    if (!search.refusal.empty()) continue;
    auto const& device = contents.devices[search.device];
    targets.push_back({place, &search, campaign.split(stable_hash(device.name)).split(stable_hash(search.law))});
  }
  auto const tasks = missing_runs(contents, targets);
  if (tasks.empty() && contents.complete() && sqlite::is_plain(file)) {
    campaign_store().put_in_order(file);
    return true;
  }
  std::optional<Store> opened = Store::open(file);
  auto& store = *opened;

  std::size_t const jobs =
      options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : std::max(1U, std::thread::hardware_concurrency());
  Progress progress{
      .done = contents.runs.size(), .total = contents.runs.size() + tasks.size(), .analysis = false, .best = {}};
  Estimate estimate(contents);
  if (contents.part) {
    for (auto const kind : task_kinds) estimate.expect_none(kind);
    for (auto const& task : tasks) estimate.expect(TaskKind::run, targets[task.target].search->law);
  }
  if (options.share && !every_device_examined(contents))
    for (auto const kind : {TaskKind::lot, TaskKind::left_out}) estimate.expect_none(kind);
  auto const tell = [&] {
    if (!options.progress) return;
    progress.share = estimate.share();
    progress.left_s = estimate.left_s();
    options.progress(progress);
  };
  auto const note = [&](Run const& run) {
    if (!run.usable()) return;
    auto const [entry, is_new] = progress.best.try_emplace(run.law, run.objective);
    entry->second = std::min(entry->second, run.objective);
  };
  for (auto const& run : contents.runs) note(run);
  contents.runs.reserve(progress.total);

  std::atomic<bool> stop = false;
  auto const asked_to_stop = [&] {
    if (!stop && options.interrupted && options.interrupted()) stop = true;
    return stop.load();
  };
  std::mutex one_writer;
  auto const perform = [&](Task const& task) {
    if (asked_to_stop()) return;
    Meter meter(options.profile);
    auto const& target = targets[task.target];
    auto model = law_on_device(contents, target.search->device, target.search->law);
    auto const result = search_by(contents.settings, target, model, task.number, asked_to_stop);
    if (result.outcome == Outcome::interrupted) return;
    auto run = finished(target, model, task.number, result);
    if (run.usable() && contents.settings.method == Method::best &&
        contents.settings.integration == laws::Integration::converged)
      refit_in_finer_steps(target, std::move(model), run);
    std::scoped_lock const lock(one_writer);
    note(run);
    store.add(run);  // nothing below may fail: a task that ran out of memory is repeated and would be stored twice
    ++progress.done;
    meter.count_evaluations(Phase::search, run.evaluations);
    estimate.done(TaskKind::run, run.law);
    contents.runs.push_back(std::move(run));
    tell();
    meter.lap(Phase::search);
  };

  own.lap(Phase::search);
  auto worked = for_each_in_parallel(tasks.size(), jobs, [&](std::size_t i) { perform(tasks[i]); });
  Meter::restart();
  bool short_of_threads = worked < std::min(jobs, tasks.size());
  std::ranges::sort(contents.runs, {}, [](Run const& r) { return std::tie(r.device, r.law, r.number); });
  own.lap(Phase::search);
  if (options.profile != nullptr) options.profile->mark({Phase::search});
  bool const whole = !contents.part && contents.runs.size() == contents.expected_runs();
  if (contents.settings.analysis && whole && !asked_to_stop()) {
    progress.analysis = true;
    auto const threads = analyse(contents, store,
                                 {.threads = jobs,
                                  .progress =
                                      [&](std::size_t done, std::size_t total) {
                                        progress.done = done;
                                        progress.total = total;
                                        tell();
                                      },
                                  .interrupted = asked_to_stop,
                                  .profile = options.profile,
                                  .estimate = &estimate,
                                  .share = options.share});
    Meter::restart();
    if (threads < jobs) {
      worked = short_of_threads ? std::min(worked, threads) : threads;
      short_of_threads = true;
    }
  }
  if (short_of_threads && options.short_of_threads) options.short_of_threads(static_cast<int>(worked));
  bool const complete = contents.complete();  // may be true although an interruption was asked for during the last run
  bool const plain = store.finish();          // after an interruption too, so that the next reader finds one plain file
  opened.reset();
  if (complete && plain) campaign_store().put_in_order(file);
  own.lap(Phase::report);
  return complete;
}

}  // namespace isolaw::campaign
