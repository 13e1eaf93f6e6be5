// How much of a campaign is done, and how long the rest takes: from what its tasks have cost so far.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>

#include "isolaw/campaign/contents.hpp"

namespace isolaw::campaign {

// One run of a search; what one device's test determines of a law, and its intervals; one law for the lot; that law
// without one of the devices. In this order, each after all of the one before.
enum class TaskKind { run, device, lot, left_out };
inline constexpr std::size_t task_kinds = 4;
std::string_view name(TaskKind kind);

// What a task computes, before any was measured.
struct TaskSize {
  double step_s = 0.0;             // one step of one candidate in blocks for residuals
  double population_step_s = 0.0;  // and in those of populations
  double steps = 0.0;              // of the device's record, or of a device's on the average
  std::size_t devices = 1;         // that the task computes
  std::size_t free = 0;            // parameters
  double in_populations = 0.0;     // evaluations of a run of the genetic algorithm; 0: of `best`
};

// What a task costs in all likelihood; in proportion alone, since what is measured corrects it.
struct TaskLikelihood {
  double evaluations = 0.0, evaluation_s = 0.0;
};
TaskLikelihood likely(TaskKind kind, TaskSize const& size);

// Tasks of one kind and law cost about the same. What has been measured counts. What has not been is taken from its
// likely cost, corrected by how long an evaluation of the law took in tasks of other kinds, and by how many evaluations
// tasks of this kind took of other laws: a search takes as many as its record asks for, what follows hardly more or
// fewer. Thread-safe.
class Estimate {
 public:
  explicit Estimate(std::size_t threads) : threads_(threads == 0 ? 1 : threads) {}

  // So many tasks are to be done, and so many of an earlier process are done already.
  void expect(TaskKind kind, std::string_view law, TaskLikelihood const& each, std::size_t left,
              std::size_t done_before);
  // Of a kind whose tasks are known by now.
  void expect_left(TaskKind kind, std::map<std::string, std::size_t> const& by_law);

  // Times are of one clock [s]. A task that began and was given up is not missed.
  std::size_t begin(TaskKind kind, std::string_view law, double now_s);
  double end(std::size_t task, int evaluations, double now_s);  // what it took
  void give_up(std::size_t task);

  double share(double now_s) const;   // of all work, 0 to 1
  double left_s(double now_s) const;  // time, with all threads at work

 private:
  struct Group {
    std::size_t left = 0, done_before = 0, measured = 0;
    TaskLikelihood likely = {};
    double measured_s = 0.0, evaluations = 0.0;
  };
  struct Running {
    TaskKind kind;
    std::string law;
    double since_s;
  };
  using Key = std::pair<TaskKind, std::string>;
  std::map<Key, double> unit_s(double now_s) const;  // of one task

  mutable std::mutex mutex_;
  std::size_t threads_;
  std::map<Key, Group> groups_;
  std::map<std::size_t, Running> running_;
  std::size_t next_ = 0;
};

// What every task of a campaign is expected to cost, and what is done of it. Measures for a few milliseconds.
void expect_all(Estimate& estimate, Contents const& contents);

struct TaskCost {
  TaskKind kind = TaskKind::run;
  std::string law;
  int evaluations = 0;
  double seconds = 0.0;
};
using TaskDone = std::function<void(TaskCost const&)>;

// One task, given up unless it is said to be done. Of an estimate that may not be there.
class TimedTask {
 public:
  TimedTask(Estimate* estimate, TaskKind kind, std::string_view law);
  TimedTask(TimedTask const&) = delete;
  TimedTask& operator=(TimedTask const&) = delete;
  ~TimedTask();
  void done(int evaluations, TaskDone const& told);

  static double now_s();

 private:
  Estimate* estimate_;
  TaskKind kind_;
  std::string_view law_;
  std::size_t id_ = 0;
};

}  // namespace isolaw::campaign
