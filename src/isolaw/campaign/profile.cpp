#include "isolaw/campaign/profile.hpp"

#include <algorithm>
#include <utility>

#include "isolaw/base/processor_time.hpp"
#include "isolaw/fit/kernel_time.hpp"

namespace isolaw::campaign {
namespace {

// Times [s] at which the calling thread began the work that it has not assigned to a phase yet.
thread_local double cpu_began_s = 0.0, began_s = 0.0;

// Returns the calling thread's work since cpu_began_s and began_s. Time in the laws' code is measured only as elapsed
// time, which also passes while other threads use the processor. Its share of the elapsed time is therefore applied to
// the processor time.
PhaseCost take_work() {
  double const cpu_s = thread_time_s() - cpu_began_s, elapsed_s = processor_time_s(CLOCK_MONOTONIC) - began_s;
  double const kernel_s = elapsed_s > 0.0 ? fit::kernel_time_s * std::min(1.0, cpu_s / elapsed_s) : 0.0;
  Meter::restart();
  return {.cpu_s = cpu_s, .kernel_s = kernel_s};
}

}  // namespace

std::string_view name(Phase phase) {
  constexpr std::string_view names[]{"read",          "search", "determination", "intervals",
                                     "larger_swings", "lot",    "left_out",      "report"};
  return names[static_cast<std::size_t>(phase)];
}

PhaseCost& PhaseCost::operator+=(PhaseCost const& other) {
  cpu_s += other.cpu_s;
  kernel_s += other.kernel_s;
  wall_s += other.wall_s;
  evaluations += other.evaluations;
  return *this;
}

void Profile::add(Phase phase, PhaseCost const& cost) {
  std::scoped_lock const lock(mutex_);
  costs_[static_cast<std::size_t>(phase)] += cost;
}

void Profile::mark(std::initializer_list<Phase> ended) {
  std::scoped_lock const lock(mutex_);
  auto const now = Clock::now();
  double const wall_s = std::chrono::duration<double>(now - std::exchange(last_mark_, now)).count();
  auto const spent = [&](Phase phase) {
    auto const i = static_cast<std::size_t>(phase);
    return costs_[i].cpu_s - cpu_at_mark_[i];
  };
  double all = 0.0;
  for (auto const phase : ended) all += spent(phase);
  for (auto const phase : ended)
    costs_[static_cast<std::size_t>(phase)].wall_s +=
        wall_s * (all > 0.0 ? spent(phase) / all : 1.0 / static_cast<double>(ended.size()));
  for (std::size_t i = 0; i < costs_.size(); ++i) cpu_at_mark_[i] = costs_[i].cpu_s;
}

Meter::Meter(Profile* profile) : profile_(profile) {
  restart();
}

void Meter::restart() {
  fit::kernel_time_s = 0.0;
  cpu_began_s = thread_time_s();
  began_s = processor_time_s(CLOCK_MONOTONIC);
}

void Meter::lap(Phase phase) {
  if (profile_ == nullptr) return;
  auto work = take_work();
  std::scoped_lock const lock(mutex_);
  work += std::exchange(helped_, {});
  profile_->add(phase, work);
}

void Meter::help_ends() {
  auto const work = take_work();
  std::scoped_lock const lock(mutex_);
  helped_ += work;
}

void Meter::count_evaluations(Phase phase, int evaluations) const {
  if (profile_ != nullptr) profile_->add(phase, {.evaluations = static_cast<std::uint64_t>(std::max(evaluations, 0))});
}

}  // namespace isolaw::campaign
