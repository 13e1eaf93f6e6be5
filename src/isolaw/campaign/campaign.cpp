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

// A law to be fitted to a device. The LawOnRecord for this pair is made only while a task runs, because it takes a
// hundred times as much memory as a Target.
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
opt::SearchResult evaluate_fixed(fit::SearchBox const& box, fit::LawOnRecord const& model, Method method) {
  opt::SearchResult result;
  std::vector<double> parameters(box.parameters.size()), work;
  box.expand({}, parameters);
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

opt::SearchResult search_by(Settings const& settings, fit::SearchBox const& box, fit::LawOnRecord const& model,
                            num::Stream const& stream, std::function<bool()> const& interrupted) {
  if (box.free_count() == 0) return evaluate_fixed(box, model, settings.method);
  fit::IdentificationProblem const problem(model, box);
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

Run finished(Target const& target, fit::SearchBox const& box, fit::LawOnRecord const& model, int number,
             opt::SearchResult const& result) {
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
  run.parameters.resize(box.parameters.size());
  box.expand(result.best, run.parameters);
  // Scalar code computes the reported objective, so that it does not depend on the vector code of the search.
  std::vector<double> work;
  run.objective = model.objective(run.parameters, work);
  run.integration_shift = model.integration_shift(run.parameters);
  return run;
}

// If more than a thousandth of the objective at an optimum comes from the step size, fits the law again from there in
// finer steps. Goes on until steps two and four times finer give the same objective within this thousandth, or until
// finest_refinement. The run fails if finer steps give no finite force.
void refit_in_finer_steps(fit::SearchBox const& box, fit::LawOnRecord model, Run& run) {
  constexpr double tolerance = 1e-3;
  if (!model.law().info.traits.path_integrated) return;
  std::vector<double> work;
  while (model.refinement() < finest_refinement) {
    auto const finer = model.refined(4 * model.refinement());
    double const twice = model.refined(2 * model.refinement()).objective(run.parameters, work),
                 four_times = finer.objective(run.parameters, work);
    double const moved = std::max(std::abs(twice - run.objective), std::abs(four_times - run.objective));
    if (moved <= tolerance * run.objective) return;
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

// If a run ended at bounds of the automatic box, moves these bounds outwards by a factor of ten and repeats the
// descent, up to six times, until the run ends at no such bound or gains too little. If this has lowered the objective
// by a tenth or more, a whole search in the last box follows. `run` gets the better result, and `box` the last box in
// which the run gained. Returns false if interrupted.
bool search_beyond(Settings const& settings, Target const& target, fit::LawOnRecord const& model, Run& run,
                   fit::SearchBox& box, std::function<bool()> const& interrupted) {
  constexpr int most_rounds = 6;
  // A wider box is kept only if the objective falls by more than least_gain times itself plus visible_gain.
  constexpr double least_gain = 1e-3, visible_gain = 1e-5;
  constexpr double decisive_gain = 0.1;
  if (settings.method != Method::best || settings.box != fit::BoxKind::scaled || !run.usable()) return true;
  double const stopped = run.objective;
  std::vector<double> work, parameters(run.parameters.size());
  for (int round = 0; round < most_rounds; ++round) {
    auto wider = fit::box_beyond(box, model.law(), run.parameters, settings.overrides);
    if (!wider) break;
    auto const found = opt::descend(fit::IdentificationProblem(model, *wider), wider->contract(run.parameters), 1.0);
    run.evaluations += found.evaluations;
    run.failed_evaluations += found.failed_evaluations;
    if (!found.usable()) break;
    wider->expand(found.best, parameters);
    double const objective = model.objective(parameters, work);
    if (!(objective < (1.0 - least_gain) * run.objective - visible_gain)) break;
    run.parameters = parameters;
    run.objective = objective;
    run.history.push_back(objective);
    box = std::move(*wider);
  }
  if (run.objective < stopped) run.integration_shift = model.integration_shift(run.parameters);
  if (run.objective > (1.0 - decisive_gain) * stopped) return true;
  auto const stream = target.stream.split(static_cast<std::uint64_t>(run.number)).split(1);
  auto const result = search_by(settings, box, model, stream, interrupted);
  if (result.outcome == Outcome::interrupted) return false;
  auto again = finished(target, box, model, run.number, result);
  again.evaluations += run.evaluations;
  again.failed_evaluations += run.failed_evaluations;
  if (again.usable() && again.objective < run.objective) {
    run = std::move(again);
  } else {
    run.evaluations = again.evaluations;
    run.failed_evaluations = again.failed_evaluations;
  }
  return true;
}

std::vector<Target> targets_of(Contents const& contents) {
  std::vector<Target> targets;
  num::Stream const campaign(contents.settings.seed);
  for (std::size_t place = 0; place < contents.searches.size(); ++place) {
    auto const& search = contents.searches[place];
    if (!search.refusal.empty()) continue;
    auto const& device = contents.devices[search.device];
    targets.push_back({place, &search, campaign.split(stable_hash(device.name)).split(stable_hash(search.law))});
  }
  return targets;
}

std::vector<Task> missing_runs(Contents const& contents, std::vector<Target> const& targets) {
  std::set<std::tuple<std::size_t, std::string, int>> present;
  for (auto const& run : contents.runs) present.emplace(run.device, run.law, run.number);
  std::optional<RunAssignment> deal;
  if (contents.part) deal.emplace(contents, contents.part->total);
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

// Computes what a campaign lacks, puts each result into the store at once, and tells the caller of the progress.
class Computation {
 public:
  Computation(Contents& contents, Store& store, std::vector<Target> const& targets, std::vector<Task> const& tasks,
              RunOptions const& options)
      : contents_(contents),
        store_(store),
        targets_(targets),
        tasks_(tasks),
        options_(options),
        jobs_(options.jobs > 0 ? static_cast<std::size_t>(options.jobs)
                               : std::max(1U, std::thread::hardware_concurrency())),
        progress_{
            .done = contents.runs.size(), .total = contents.runs.size() + tasks.size(), .analysis = false, .best = {}},
        estimate_(contents) {
    expect_only_this_part();
    for (auto const& run : contents.runs) note(run);
    contents.runs.reserve(progress_.total);
  }

  void make_runs() {
    auto const threads = for_each_in_parallel(tasks_.size(), jobs_, [&](std::size_t i) { perform(tasks_[i]); });
    Meter::restart();
    count_threads(threads, std::min(jobs_, tasks_.size()));
    std::ranges::sort(contents_.runs, {}, [](Run const& r) { return std::tie(r.device, r.law, r.number); });
    contents_.take_boxes_of_best_runs();
  }

  void make_analyses() {
    bool const whole = !contents_.part && contents_.runs.size() == contents_.expected_runs();
    if (!contents_.settings.analysis || !whole || asked_to_stop()) return;
    progress_.analysis = true;
    auto const threads = analyse(contents_, store_,
                                 {.threads = jobs_,
                                  .progress =
                                      [&](AnalysisProgress const& now) {
                                        progress_.done = now.done;
                                        progress_.total = now.total;
                                        latest(now.law, now.device);
                                        tell();
                                      },
                                  .interrupted = [&] { return asked_to_stop(); },
                                  .profile = options_.profile,
                                  .estimate = &estimate_,
                                  .share = options_.share});
    Meter::restart();
    count_threads(threads, jobs_);
  }

  void tell_if_short_of_threads() const {
    if (too_few_threads_ && options_.short_of_threads) options_.short_of_threads(static_cast<int>(*too_few_threads_));
  }

 private:
  void expect_only_this_part() {
    if (contents_.part) {
      for (auto const kind : task_kinds) estimate_.expect_none(kind);
      for (auto const& task : tasks_) estimate_.expect(TaskKind::run, targets_[task.target].search->law);
    }
    if (options_.share && !every_device_examined(contents_))
      for (auto const kind : {TaskKind::lot, TaskKind::left_out}) estimate_.expect_none(kind);
  }

  void perform(Task const& task) {
    if (asked_to_stop()) return;
    Meter meter(options_.profile);
    auto const& target = targets_[task.target];
    auto const& settings = contents_.settings;
    auto model = law_on_device(contents_, target.search->device, target.search->law);
    auto box = target.search->first_box;
    auto const stop = [&] { return asked_to_stop(); };
    auto const stream = target.stream.split(static_cast<std::uint64_t>(task.number));
    auto const result = search_by(settings, box, model, stream, stop);
    if (result.outcome == Outcome::interrupted) return;
    auto run = finished(target, box, model, task.number, result);
    if (!search_beyond(settings, target, model, run, box, stop)) return;
    if (run.usable() && settings.method == Method::best && settings.integration == laws::Integration::converged)
      refit_in_finer_steps(box, std::move(model), run);
    if (run.usable() && !fit::same_bounds(box, target.search->first_box))
      for (auto const& p : box.parameters) run.box.insert(run.box.end(), {p.lower, p.upper});
    std::scoped_lock const lock(one_writer_);
    note(run);
    // Nothing below may fail for lack of memory, because for_each_in_parallel() would then repeat the task and store
    // the run a second time.
    store_.add(run);
    ++progress_.done;
    meter.count_evaluations(Phase::search, run.evaluations);
    estimate_.done(TaskKind::run, run.law);
    latest(run.law, run.device);
    contents_.runs.push_back(std::move(run));
    tell();
    meter.lap(Phase::search);
  }

  bool asked_to_stop() {
    if (!stop_ && options_.interrupted && options_.interrupted()) stop_ = true;
    return stop_;
  }

  void note(Run const& run) {
    if (!run.usable()) return;
    auto const [entry, is_new] = progress_.best.try_emplace(run.law, run.objective);
    entry->second = std::min(entry->second, run.objective);
  }

  void latest(std::string_view law, std::optional<std::size_t> device) {
    progress_.law = law;
    progress_.device = device ? contents_.devices[*device].name : std::string();
  }

  void tell() {
    if (!options_.progress) return;
    progress_.runs = contents_.runs;
    progress_.share = estimate_.share();
    progress_.left_s = estimate_.left_s();
    options_.progress(progress_);
  }

  void count_threads(std::size_t worked, std::size_t wanted) {
    if (worked < wanted) too_few_threads_ = std::min(worked, too_few_threads_.value_or(worked));
  }

  Contents& contents_;
  Store& store_;
  std::vector<Target> const& targets_;
  std::vector<Task> const& tasks_;
  RunOptions const& options_;
  std::size_t jobs_;
  Progress progress_;
  Estimate estimate_;
  std::optional<std::size_t> too_few_threads_;  // fewest threads that worked at a time, if fewer than wanted
  std::atomic<bool> stop_ = false;
  std::mutex one_writer_;
};

}  // namespace

bool run(Contents& contents, std::filesystem::path const& file, RunOptions const& options) {
  Meter own(options.profile);
  auto const targets = targets_of(contents);
  auto const tasks = missing_runs(contents, targets);
  if (tasks.empty() && contents.complete() && sqlite::is_plain(file)) {
    campaign_store().put_in_order(file);
    return true;
  }
  std::optional<Store> store = Store::open(file);
  Computation computation(contents, *store, targets, tasks, options);
  own.lap(Phase::search);
  computation.make_runs();
  own.lap(Phase::search);
  if (options.profile != nullptr) options.profile->mark({Phase::search});
  computation.make_analyses();
  computation.tell_if_short_of_threads();
  bool const complete = contents.complete();  // may be true although an interruption was asked for during the last run
  bool const plain = store->finish();         // also after an interruption, so that no log stays beside the store
  store.reset();
  if (complete && plain) campaign_store().put_in_order(file);
  own.lap(Phase::report);
  return complete;
}

}  // namespace isolaw::campaign
