#include "isolaw/campaign/profile.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "isolaw/base/processor_time.hpp"

namespace isolaw::campaign {

std::string_view name(Phase phase) {
  constexpr std::string_view names[]{"read", "search", "determination", "intervals", "lot", "left_out", "report"};
  return names[static_cast<std::size_t>(phase)];
}

void Profile::add(Phase phase, double cpu_s, fit::WorkCount const& work) {
  std::scoped_lock const lock(mutex_);
  auto& cost = costs_[static_cast<std::size_t>(phase)];
  cost.cpu_s += cpu_s;
  cost.work += work;
}

void Profile::count_evaluations(Phase phase, int evaluations) {
  std::scoped_lock const lock(mutex_);
  costs_[static_cast<std::size_t>(phase)].evaluations += static_cast<std::uint64_t>(std::max(evaluations, 0));
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

std::array<double, phases.size()> Profile::kernel_seconds(fit::BlockCost const& cost) const {
  // Measures each kind of block once, since it costs the same in all phases.
  fit::WorkCount all;
  for (auto const& phase : costs_) all += phase.work;
  fit::kernel_seconds(all, cost);
  std::array<double, phases.size()> seconds{};
  for (std::size_t i = 0; i < costs_.size(); ++i) seconds[i] = fit::kernel_seconds(costs_[i].work, cost);
  return seconds;
}

std::array<double, phases.size()> Profile::kernel_seconds() const {
  double cpu_s = 0.0;
  std::size_t kinds = 0;
  fit::WorkCount all;
  for (auto const& phase : costs_) {
    cpu_s += phase.cpu_s;
    all += phase.work;
  }
  all.for_each([&](auto const&, auto const&) { ++kinds; });
  return kernel_seconds(fit::measured_cost(std::min(0.02, 0.01 * cpu_s), kinds));
}

Meter::Meter(Profile* profile) : profile_(profile) {
  restart();
}

void Meter::restart() {
  if (profile_ == nullptr) return;
  fit::work_of_this_thread() = {};
  before_s_ = thread_time_s();
}

void Meter::lap(Phase phase) {
  if (profile_ == nullptr) return;
  double const now_s = thread_time_s(), since_s = std::exchange(before_s_, now_s);
  auto work = std::exchange(fit::work_of_this_thread(), {});
  try {
    std::scoped_lock const lock(mutex_);
    work += std::exchange(helped_, {});
    profile_->add(phase, now_s - since_s + std::exchange(helped_s_, 0.0), work);
  } catch (std::bad_alloc const&) {  // ignored: the measured work is done and must not be repeated for lack of memory
  }
}

namespace {

// The thread time at which this helping thread began its present item.
thread_local double help_began_s = 0.0;

}  // namespace

void Meter::help_begins() {
  if (profile_ == nullptr) return;
  fit::work_of_this_thread() = {};
  help_began_s = thread_time_s();
}

void Meter::help_ends() {
  if (profile_ == nullptr) return;
  double const helped_s = thread_time_s() - help_began_s;
  auto const work = std::exchange(fit::work_of_this_thread(), {});
  try {
    std::scoped_lock const lock(mutex_);
    helped_ += work;
    helped_s_ += helped_s;
  } catch (std::bad_alloc const&) {  // ignored, as in lap()
  }
}

void Meter::count_evaluations(Phase phase, int evaluations) const {
  if (profile_ != nullptr) profile_->count_evaluations(phase, evaluations);
}

}  // namespace isolaw::campaign
