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

#include "isolaw/base/error.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/base/printable.hpp"
#include "isolaw/campaign/analyse.hpp"
#include "isolaw/campaign/parallel.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/text.hpp"
#include "isolaw/fit/joint_limits.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::campaign {
namespace {

// Several files of one device as one history: time continues after a pause of one sampling interval.
data::TestRecord read_history(DeviceInput const& input) {
  auto record = data::read_record(input.files.front(), input.read);
  for (std::size_t i = 1; i < input.files.size(); ++i)
    data::continue_with(record, data::read_record(input.files[i], input.read), input.files[i].filename().string());
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
  Device device{.name = input.name, .file = input.shown_file, .info = input.info};
  try {
    device.raw = read_history(input);
    device.record = data::clean(device.raw, cleaning);
  } catch (Error const& error) {
    device.refusal = with_shown_files(error.what(), input.directory);
    device.raw = {};
    device.raw.sha256 = hash_of_files(input);
  }
  device.raw.file = input.shown_file;
  return device;
}

Search prepare_search(std::size_t index, Device const& device, std::string const& law_id, Settings const& settings) {
  Search search{.device = index, .law = law_id};
  auto const& law = laws::find_law(law_id);
  try {
    fit::LawOnRecord const check(law, device.record, settings.integration, settings.turning_points);
    auto box = search_box(law, device.record, settings);
    fit::require_joint_limits(law, box, settings.overrides);
    search.box = std::move(box);
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
opt::SearchResult evaluate_fixed(Target const& target, Method method) {
  opt::SearchResult result;
  std::vector<double> parameters(target.search->box.parameters.size()), work;
  target.search->box.expand({}, parameters);
  double const value = target.model.objective(parameters, work);
  bool const finite = std::isfinite(value);
  result.evaluations = 1;
  result.failed_evaluations = finite ? 0 : 1;
  result.outcome = !finite                     ? Outcome::no_finite_value
                   : method == Method::genetic ? Outcome::all_generations
                                               : Outcome::confirmed;
  result.history = {value};
  return result;
}

opt::SearchResult search_by(Settings const& settings, Target const& target, int number,
                            std::function<bool()> const& interrupted) {
  if (target.search->box.free_count() == 0) return evaluate_fixed(target, settings.method);
  fit::IdentificationProblem const problem(target.model, target.search->box);
  auto const stream = target.stream.split(static_cast<std::uint64_t>(number));
  return settings.method == Method::genetic
             ? opt::minimise_genetic(problem, stream, settings.genetic, interrupted)
             : opt::minimise_multistart(problem, stream, settings.multistart, interrupted);
}

// Keeps how the search went, and none of what it found.
void fail(Run& run, std::string why) {
  run.outcome = Outcome::no_finite_value;
  run.failure = std::move(why);
  run.objective = run.integration_shift = std::nan("");
  run.parameters.clear();
}

Run finished(Target const& target, int number, opt::SearchResult const& result) {
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
  // What is reported comes from the scalar path, whatever evaluated the population.
  std::vector<double> work;
  run.objective = target.model.objective(run.parameters, work);
  run.integration_shift = target.model.integration_shift(run.parameters);
  return run;
}

// An optimum that owes more than a thousandth of its value to the step of the integration is none of the law's: the law is
// fitted again from there in finer steps, until steps two and four times finer agree. One without a finite force in finer
// steps is the steps' alone, and no result.
void refit_in_finer_steps(Target const& target, Run& run) {
  constexpr double tolerance = 1e-3;
  constexpr int finest = 64;
  if (!target.model.law().info.traits.path_integrated) return;
  std::vector<double> work;
  auto model = target.model;
  while (model.refinement() < finest) {
    auto const finer = model.refined(4 * model.refinement());
    double const twice = model.refined(2 * model.refinement()).objective(run.parameters, work),
                 four_times = finer.objective(run.parameters, work);
    double const moved = std::max(std::abs(twice - run.objective), std::abs(four_times - run.objective));
    if (moved <= tolerance * run.objective) return;
    auto const& box = target.search->box;
    fit::IdentificationProblem const problem(finer, box);
    run.refinement = finer.refinement();
    if (box.free_count() > 0) {
      auto const again = opt::descend(problem, box.contract(run.parameters), 1.0);
      run.evaluations += again.evaluations;
      run.failed_evaluations += again.failed_evaluations;
      if (again.usable()) box.expand(again.best, run.parameters);
    }
    double const coarse = run.objective;
    run.objective = finer.objective(run.parameters, work);
    run.integration_shift = finer.integration_shift(run.parameters);
    if (!std::isfinite(run.objective))
      return fail(
          run,
          fmt::format(
              "the least objective found, {:.4g} in {} step(s) a sample, is of the steps alone: in {} a sample these parameters give no finite force",
              coarse, model.refinement(), finer.refinement()));
    model = finer;
  }
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

}  // namespace

fit::SearchBox search_box(laws::LawEntry const& law, data::FitRecord const& record, Settings const& settings) {
  auto box = fit::make_box(law, settings.box, fit::scales_of(record, law.info), settings.overrides);
  return settings.method == Method::best ? fit::on_logarithmic_scales(std::move(box), law) : box;
}

namespace {

Contents without_devices(std::string const& title, Acceptance const& acceptance, Settings const& settings) {
  Contents contents{.title = title, .acceptance = acceptance, .settings = settings};
  contents.settings.laws.clear();
  contents.settings.complete();
  contents.settings.validate();
  return contents;
}

// Names as a lot file would take them.
void check_names(std::vector<NamedRecord> const& records) {
  std::vector<Complaint> complaints;
  std::set<std::string> seen;
  for (auto const& [name, record, info] : records) {
    auto const where = "device '" + printable(name) + "'";
    if (name.empty() || name.size() > longest_name || !is_printable(name))
      complaints.push_back({where, "is no name", fmt::format("printable text of at most {} bytes", longest_name), {}});
    else if (!seen.insert(name).second)
      complaints.push_back({where, "is there twice", "a name for each", {}});
  }
  if (records.empty()) complaints.push_back({"records", "there are none", "one or more", {}});
  if (!complaints.empty()) throw Error(std::move(complaints));
}

Device cleaned(NamedRecord&& given, data::CleanOptions const& cleaning) {
  Device device{.name = std::move(given.name),
                .file = given.record.file,
                .info = std::move(given.info),
                .raw = std::move(given.record)};
  try {
    device.record = data::clean(device.raw, cleaning);
  } catch (Error const& error) {
    device.refusal = error.what();
    auto const sha256 = device.raw.sha256;
    device.raw = {};
    device.raw.file = device.file;
    device.raw.sha256 = sha256;
  }
  return device;
}

Contents with_searches(Contents contents, std::vector<std::string> const& laws) {
  contents.settings.laws = laws.empty() ? parse_laws(usual_laws) : laws;
  contents.settings.validate();
  // Not in validate(): a store that was made before is read all the same.
  for (auto const& id : contents.settings.laws)
    fit::require_joint_limits(laws::find_law(id), contents.settings.overrides);
  if (std::ranges::none_of(contents.devices, &Device::usable)) {
    std::vector<Complaint> complaints{
        {.where = "lot", .found = fmt::format("none of {} device(s) is usable", contents.devices.size())}};
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

}  // namespace

Contents prepare_devices(Lot const& lot) {
  auto contents = without_devices(lot.title, lot.acceptance, lot.settings);
  for (auto const& input : lot.devices) contents.devices.push_back(prepare_device(input, contents.settings.clean));
  return contents;
}

Contents prepare(Lot const& lot) {
  return with_searches(prepare_devices(lot), lot.settings.laws);
}

Contents prepare(std::vector<NamedRecord> records, Settings const& settings, std::string const& title) {
  check_names(records);
  auto contents = without_devices(title, {}, settings);
  for (auto& record : records) contents.devices.push_back(cleaned(std::move(record), contents.settings.clean));
  return with_searches(std::move(contents), settings.laws);
}

bool run(Contents& contents, std::filesystem::path const& file, RunOptions const& options) {
  std::vector<Target> targets;
  num::Stream const campaign(contents.settings.seed);
  for (auto const& search : contents.searches) {
    if (!search.refusal.empty()) continue;
    auto const& device = contents.devices[search.device];
    targets.push_back({&search, law_on_device(contents, search.device, search.law),
                       campaign.split(stable_hash(device.name)).split(stable_hash(search.law))});
  }
  auto const tasks = missing_runs(contents, targets);
  if (tasks.empty() && contents.complete() && Store::is_plain(file)) return true;
  auto store = Store::open(file);

  Progress progress{
      .done = contents.runs.size(), .total = contents.runs.size() + tasks.size(), .analysis = false, .best = {}};
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
    auto const& target = targets[task.target];
    auto const result = search_by(contents.settings, target, task.number, asked_to_stop);
    if (result.outcome == Outcome::interrupted) return;
    auto run = finished(target, task.number, result);
    if (run.usable() && contents.settings.method == Method::best &&
        contents.settings.integration == laws::Integration::converged)
      refit_in_finer_steps(target, run);
    std::scoped_lock const lock(one_writer);
    note(run);
    store.add(run);  // after it nothing may fail: a run that ran out of memory is tried again
    ++progress.done;
    contents.runs.push_back(std::move(run));
    if (options.progress) options.progress(progress);
  };

  std::size_t const jobs =
      options.jobs > 0 ? static_cast<std::size_t>(options.jobs) : std::max(1U, std::thread::hardware_concurrency());
  auto worked = for_each_in_parallel(tasks.size(), jobs, [&](std::size_t i) { perform(tasks[i]); });
  bool short_of_threads = worked < std::min(jobs, tasks.size());
  std::ranges::sort(contents.runs, {}, [](Run const& r) { return std::tie(r.device, r.law, r.number); });
  if (contents.settings.analysis && contents.runs.size() == contents.expected_runs() && !asked_to_stop()) {
    progress.analysis = true;
    auto const threads = analyse(contents, store,
                                 {.threads = jobs,
                                  .progress =
                                      [&](std::size_t done, std::size_t total) {
                                        progress.done = done;
                                        progress.total = total;
                                        if (options.progress) options.progress(progress);
                                      },
                                  .interrupted = asked_to_stop});
    if (threads < jobs) {
      worked = short_of_threads ? std::min(worked, threads) : threads;
      short_of_threads = true;
    }
  }
  if (short_of_threads && options.short_of_threads) options.short_of_threads(static_cast<int>(worked));
  bool const complete = contents.complete();  // also when the wish to stop came during the last run
  store.finish();                             // also when interrupted: whoever reads it next finds one plain file
  return complete;
}

}  // namespace isolaw::campaign
