// Estimates which share of a campaign is done and how long the rest takes, from the laws' step costs, the records and
// the numbers of free parameters.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <vector>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

// run: one search; device: the analysis of a law on one device; lot: the fit of a law to the whole lot; left_out: the
// fit of a law to the lot without one device.
enum class TaskKind { run, device, lot, left_out };
inline constexpr std::array task_kinds{TaskKind::run, TaskKind::device, TaskKind::lot, TaskKind::left_out};

class Estimate {  // not thread-safe; `contents` must outlive it
 public:
  explicit Estimate(Contents const& contents);  // expects every run and analysis that `contents` lacks

  void expect_none(TaskKind kind);  // forgets all tasks of this kind; later calls of expect() add new ones
  void expect(TaskKind kind, std::string_view law) { ++tasks(kind, law).remaining; }
  void done(TaskKind kind, std::string_view law);

  double work_left_s(TaskKind kind) const;  // processor time on the machine where the costs of the laws were measured
  double share() const;                     // share of all work that is done, 0 to 1, including work stored earlier
  double left_s() const;                    // seconds until the end at the mean rate of work since construction

 private:
  struct Tasks {
    double each_s = 0.0;
    std::size_t remaining = 0;
  };
  Tasks& tasks(TaskKind kind, std::string_view law);
  double all_left_s() const;

  using Clock = std::chrono::steady_clock;
  Contents const& contents_;
  std::vector<std::array<Tasks, task_kinds.size()>> tasks_;  // [index in settings.laws][kind]
  double before_s_ = 0.0, done_s_ = 0.0;
  Clock::time_point start_ = Clock::now();
};

}  // namespace isolaw::campaign
