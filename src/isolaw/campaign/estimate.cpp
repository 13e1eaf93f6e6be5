#include "isolaw/campaign/estimate.hpp"

#include <algorithm>

#include "isolaw/campaign/part_assignment.hpp"

namespace isolaw::campaign {

Estimate::Estimate(Contents const& contents) : contents_(contents), tasks_(contents.settings.laws.size()) {
  auto const& settings = contents.settings;
  bool const genetic = settings.method == Method::genetic;
  // The time [s] of one evaluation, per sample and unit of LawInfo::step_cost. The law itself takes 1e-11 s of it;
  // descents run more code around the law.
  constexpr double population_s = 1.5e-11, descent_s = 3.5e-11;
  // How often a task of each kind evaluates the law on each record, divided by the square of the number of free
  // parameters. Each value lies between the counts for the example lot and for a measured bearing.
  constexpr double of_run = 100.0, of_device = 230.0, of_lot = 58.0, of_left_out = 4.5;
  double const run_s =
      genetic ? population_s * settings.genetic.population * settings.genetic.generations : descent_s * of_run;
  for (std::size_t i = 0; i < tasks_.size(); ++i) {
    auto const& law = settings.laws[i];
    double runs = 0.0, descents = 0.0;  // costs of all devices together
    std::size_t devices = 0, counting = 0;
    for (auto const& search : contents.searches) {
      if (search.law != law || !search.refusal.empty()) continue;
      auto const free = static_cast<double>(std::max<std::size_t>(search.box.free_count(), 1));
      auto const cost = static_cast<double>(relative_cost(contents, search));
      runs += cost;
      descents += genetic ? cost * free * free : cost;
      ++devices;
      if (contents.devices[search.device].counts()) ++counting;
    }
    if (devices == 0) continue;
    auto const count = static_cast<double>(devices);
    auto const set = [&](TaskKind kind, double each_s, std::size_t all, auto const& stored) {
      auto const there =
          static_cast<std::size_t>(std::ranges::count_if(stored, [&](auto const& item) { return item.law == law; }));
      tasks(kind, law) = {each_s, all - std::min(all, there)};
      before_s_ += each_s * static_cast<double>(std::min(all, there));
    };
    set(TaskKind::run, run_s * runs / count, devices * static_cast<std::size_t>(settings.runs), contents.runs);
    if (!settings.analysis) continue;
    descents *= descent_s;
    set(TaskKind::device, (of_device + (genetic ? of_run : 0.0)) * descents / count, devices, contents.device_analyses);
    if (counting < 2) continue;
    set(TaskKind::lot, of_lot * descents, 1, contents.lot_analyses);
    set(TaskKind::left_out, of_left_out * descents * (count - 1.0) / count, counting, contents.left_out);
  }
}

Estimate::Tasks& Estimate::tasks(TaskKind kind, std::string_view law) {
  auto const& laws = contents_.settings.laws;
  return tasks_[static_cast<std::size_t>(std::ranges::find(laws, law) - laws.begin())][static_cast<std::size_t>(kind)];
}

void Estimate::expect_none(TaskKind kind) {
  for (auto& kinds : tasks_) kinds[static_cast<std::size_t>(kind)].remaining = 0;
}

void Estimate::done(TaskKind kind, std::string_view law) {
  auto& group = tasks(kind, law);
  if (group.remaining > 0) --group.remaining;
  done_s_ += group.each_s;
}

double Estimate::work_left_s(TaskKind kind) const {
  double sum_s = 0.0;
  for (auto const& kinds : tasks_) {
    auto const& group = kinds[static_cast<std::size_t>(kind)];
    sum_s += group.each_s * static_cast<double>(group.remaining);
  }
  return sum_s;
}

double Estimate::all_left_s() const {
  double sum_s = 0.0;
  for (auto const kind : task_kinds) sum_s += work_left_s(kind);
  return sum_s;
}

double Estimate::share() const {
  double const there_s = before_s_ + done_s_, all_s = there_s + all_left_s();
  return all_s > 0.0 ? there_s / all_s : 0.0;
}

double Estimate::left_s() const {
  double const elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
  return done_s_ > 0.0 ? elapsed_s * all_left_s() / done_s_ : all_left_s();
}

}  // namespace isolaw::campaign
