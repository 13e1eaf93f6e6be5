#include "isolaw/campaign/estimate.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <new>
#include <utility>

#include "isolaw/fit/block_cost.hpp"

namespace isolaw::campaign {

std::string_view name(TaskKind kind) {
  constexpr std::string_view names[]{"run", "device", "lot", "left_out"};
  return names[static_cast<std::size_t>(kind)];
}

TaskLikelihood likely(TaskKind kind, TaskSize const& size) {
  // Evaluations of a device's record per squared number of free parameters, as the example lot and the measured bearing
  // needed with the paper's laws, above all abe.
  constexpr std::array<double, task_kinds> per_square{80.0, 220.0, 55.0, 6.0};
  // Time per step that descents spend outside the laws' code. Populations spend next to none.
  constexpr double around_s = 5e-9;
  bool const populations = kind == TaskKind::run && size.in_populations > 0.0;
  auto const free = static_cast<double>(std::max<std::size_t>(size.free, 1));
  double each = per_square[static_cast<std::size_t>(kind)] * free * free;
  if (populations) each = size.in_populations;
  // After the genetic algorithm an analysis first looks for the least objective, as a run of `best` does.
  else if (kind == TaskKind::device && size.in_populations > 0.0)
    each += per_square[static_cast<std::size_t>(TaskKind::run)] * free * free;
  return {each * static_cast<double>(size.devices),
          size.steps * (populations ? size.population_step_s : size.step_s + around_s)};
}

void Estimate::expect(TaskKind kind, std::string_view law, TaskLikelihood const& each, std::size_t left,
                      std::size_t done_before) {
  std::scoped_lock const lock(mutex_);
  auto& group = groups_[{kind, std::string(law)}];
  group.likely = each;
  group.left = left;
  group.done_before = done_before;
}

void Estimate::expect_left(TaskKind kind, std::map<std::string, std::size_t> const& by_law) {
  std::scoped_lock const lock(mutex_);
  for (auto& [key, group] : groups_)
    if (key.first == kind) {
      auto const found = by_law.find(key.second);
      group.left = found == by_law.end() ? 0 : found->second;
    }
}

std::size_t Estimate::begin(TaskKind kind, std::string_view law, double now_s) {
  std::scoped_lock const lock(mutex_);
  groups_.try_emplace({kind, std::string(law)});
  running_.emplace(next_, Running{kind, std::string(law), now_s});
  return next_++;
}

double Estimate::end(std::size_t task, int evaluations, double now_s) {
  std::scoped_lock const lock(mutex_);
  auto const entry = running_.extract(task);
  if (entry.empty()) return 0.0;
  auto const& [kind, law, since_s] = entry.mapped();
  auto& group = groups_[{kind, law}];
  if (group.left > 0) --group.left;
  ++group.measured;
  group.measured_s += now_s - since_s;
  group.evaluations += evaluations;
  return now_s - since_s;
}

void Estimate::give_up(std::size_t task) {
  std::scoped_lock const lock(mutex_);
  running_.erase(task);
}

std::map<Estimate::Key, double> Estimate::unit_s(double now_s) const {
  // Sums of measured and of guessed costs, whose ratio corrects other guesses.
  struct Ratio {
    double measured = 0.0, likely = 0.0;
    void add(double more_measured, double more_likely) {
      measured += more_measured;
      likely += more_likely;
    }
    double or_else(double other) const { return measured > 0.0 && likely > 0.0 ? measured / likely : other; }
  };
  Ratio all;
  std::map<std::string_view, Ratio> laws;  // ratios of the time of an evaluation
  std::array<Ratio, task_kinds> kinds;     // ratios of numbers of evaluations, weighted by the time of an evaluation
  for (auto const& [key, group] : groups_) {
    double const evaluation_s = group.likely.evaluation_s;
    if (evaluation_s <= 0.0) continue;  // begun without expect()
    for (auto* ratio : {&all, &laws[key.second]}) ratio->add(group.measured_s, group.evaluations * evaluation_s);
    kinds[static_cast<std::size_t>(key.first)].add(
        group.evaluations * evaluation_s,
        static_cast<double>(group.measured) * group.likely.evaluations * evaluation_s);
  }
  // Fast laws say little about slow ones, so a tenth of a task of every law counts as if it had cost what was guessed.
  constexpr double doubt = 0.1;
  for (auto const& [key, group] : groups_) {
    auto& ratio = kinds[static_cast<std::size_t>(key.first)];
    double const one_task = group.likely.evaluations * group.likely.evaluation_s;
    ratio.add(doubt * one_task, doubt * one_task);
  }
  std::map<Key, double> units;
  for (auto const& [key, group] : groups_)
    units[key] = group.measured > 0
                     ? group.measured_s / static_cast<double>(group.measured)
                     : group.likely.evaluations * kinds[static_cast<std::size_t>(key.first)].or_else(1.0) *
                           group.likely.evaluation_s * laws[key.second].or_else(all.or_else(1.0));
  // Without a measurement a task takes at least as long as the running one has taken so far.
  for (auto const& [id, task] : running_) {
    auto& unit = units.at({task.kind, task.law});
    if (groups_.at({task.kind, task.law}).measured == 0) unit = std::max(unit, now_s - task.since_s);
  }
  return units;
}

double Estimate::share(double now_s) const {
  std::scoped_lock const lock(mutex_);
  auto const unit = unit_s(now_s);
  double done = 0.0, all = 0.0;
  for (auto const& [key, group] : groups_) {
    double const before = group.measured_s + static_cast<double>(group.done_before) * unit.at(key);
    done += before;
    all += before + static_cast<double>(group.left) * unit.at(key);
  }
  for (auto const& [id, task] : running_) done += std::clamp(now_s - task.since_s, 0.0, unit.at({task.kind, task.law}));
  return all > 0.0 ? std::min(done / all, 1.0) : 0.0;
}

double Estimate::left_s(double now_s) const {
  std::scoped_lock const lock(mutex_);
  auto const unit = unit_s(now_s);
  double sum = 0.0;
  for (std::size_t kind = 0; kind < task_kinds; ++kind) {
    // A kind takes at least as long as its longest task, which one thread does alone.
    double work = 0.0, longest = 0.0;
    for (auto const& [key, group] : groups_) {
      if (static_cast<std::size_t>(key.first) != kind || group.left == 0) continue;
      work += static_cast<double>(group.left) * unit.at(key);
      longest = std::max(longest, unit.at(key));
    }
    for (auto const& [id, task] : running_)
      if (static_cast<std::size_t>(task.kind) == kind)
        work -= std::clamp(now_s - task.since_s, 0.0, unit.at({task.kind, task.law}));
    work = std::max(work, 0.0);
    sum += std::max(work / static_cast<double>(threads_), std::min(work, longest));
  }
  return sum;
}

void expect_all(Estimate& estimate, Contents const& contents) {
  auto const& settings = contents.settings;
  bool const genetic = settings.method == Method::genetic;
  constexpr double budget_s = 2e-3, steps = 600.0;
  auto const cost = fit::measured_cost(budget_s, settings.laws.size());
  auto const count_of = [](auto const& items, std::string_view law) {
    return static_cast<std::size_t>(std::ranges::count(items, law, [](auto const& item) { return item.law; }));
  };
  for (auto const& law : settings.laws) {
    TaskSize size;
    for (auto const& search : contents.searches) {
      if (search.law != law || !search.refusal.empty()) continue;
      size.steps += static_cast<double>(contents.devices[search.device].record.size());
      size.free = std::max(size.free, search.box.free_count());
      ++size.devices;
    }
    auto const devices = std::exchange(size.devices, 1) - 1;
    if (devices == 0) continue;
    size.steps /= static_cast<double>(devices);
    auto const step_s = [&](fit::Block block, std::size_t width) {
      return cost({laws::find_law(law).index, settings.integration, block}, steps) / static_cast<double>(width);
    };
    if (settings.analysis || !genetic) size.step_s = step_s(fit::Block::residuals, fit::residual_block);
    if (genetic) size.population_step_s = step_s(fit::Block::wide, fit::wide_block);
    if (genetic) size.in_populations = static_cast<double>(settings.genetic.population) * settings.genetic.generations;
    auto const expect = [&](TaskKind kind, std::size_t count, auto const& results) {
      auto const done = std::min(count, count_of(results, law));
      estimate.expect(kind, law, likely(kind, size), count - done, done);
    };
    expect(TaskKind::run, devices * static_cast<std::size_t>(settings.runs), contents.runs);
    if (!settings.analysis) continue;
    expect(TaskKind::device, devices, contents.device_analyses);
    if (devices < 2) continue;
    size.devices = devices;
    expect(TaskKind::lot, 1, contents.lot_analyses);
    size.devices = devices - 1;
    expect(TaskKind::left_out, devices, contents.left_out);
  }
}

double TimedTask::now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

TimedTask::TimedTask(Estimate* estimate, TaskKind kind, std::string_view law)
    : estimate_(estimate), kind_(kind), law_(law) {
  if (estimate_ != nullptr) id_ = estimate_->begin(kind, law, now_s());
}

TimedTask::~TimedTask() {
  if (estimate_ != nullptr) estimate_->give_up(id_);
}

void TimedTask::done(int evaluations, TaskDone const& task_done) {
  if (estimate_ == nullptr) return;
  auto* const estimate = std::exchange(estimate_, nullptr);
  try {
    double const seconds = estimate->end(id_, evaluations, now_s());
    if (task_done) task_done({kind_, std::string(law_), evaluations, seconds});
  } catch (std::bad_alloc const&) {  // the task is done, whether or not there is memory left to say so
  }
}

}  // namespace isolaw::campaign
