// Estimates how much of a campaign is done and how long the rest takes, from the cost of its finished tasks.
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

// A run of a search; the analysis of a law on a device; the fit of a law to the lot; that fit without one device. They
// are done in this order: a kind begins when the one before it is finished.
enum class TaskKind { run, device, lot, left_out };
inline constexpr std::size_t task_kinds = 4;
std::string_view name(TaskKind kind);

// The size of a task, from which its cost is guessed before one like it was measured.
struct TaskSize {
  double step_s = 0.0;             // time of one step of one candidate in a block for residuals
  double population_step_s = 0.0;  // the same in a block for populations
  double steps = 0.0;              // steps in the device's record, or the mean over devices
  std::size_t devices = 1;         // number of devices whose records the task computes
  std::size_t free = 0;            // number of free parameters
  double in_populations = 0.0;     // evaluations of a run of the genetic algorithm; 0 with Method::best
};

// The guessed cost of a task. Only its ratio to that of other tasks matters, since measurements correct it.
struct TaskLikelihood {
  double evaluations = 0.0, evaluation_s = 0.0;
};
TaskLikelihood likely(TaskKind kind, TaskSize const& size);

// Tasks of one kind and law cost about the same, so the mean of those measured counts. Before the first measurement the
// guess is corrected: the time of an evaluation by what tasks of other kinds took with this law, the number of
// evaluations by what tasks of this kind took with other laws. (Of a search it depends on the record; of an analysis it
// hardly varies.) Thread-safe.
class Estimate {
 public:
  explicit Estimate(std::size_t threads) : threads_(threads == 0 ? 1 : threads) {}

  // `left` tasks are to be done; an earlier process has done `done_before`.
  void expect(TaskKind kind, std::string_view law, TaskLikelihood const& each, std::size_t left,
              std::size_t done_before);
  // Corrects the number of tasks to be done once it is known for this kind; a law that is not named has none.
  void expect_left(TaskKind kind, std::map<std::string, std::size_t> const& by_law);

  // All times come from one clock, in s. begin() returns an id; a task that is given up stays among those to be done.
  std::size_t begin(TaskKind kind, std::string_view law, double now_s);
  double end(std::size_t task, int evaluations, double now_s);  // returns how long the task took
  void give_up(std::size_t task);

  double share(double now_s) const;   // the part of all work that is done, 0 to 1
  double left_s(double now_s) const;  // the time that the rest takes with all threads

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
  std::map<Key, double> unit_s(double now_s) const;  // the time of one task

  mutable std::mutex mutex_;
  std::size_t threads_;
  std::map<Key, Group> groups_;
  std::map<std::size_t, Running> running_;
  std::size_t next_ = 0;
};

// Registers all tasks of a campaign, those left and those done. Measures the laws' code for a few milliseconds.
void expect_all(Estimate& estimate, Contents const& contents);

struct TaskCost {
  TaskKind kind = TaskKind::run;
  std::string law;
  int evaluations = 0;
  double seconds = 0.0;
};
using TaskDone = std::function<void(TaskCost const&)>;

// Times one task for an estimate, which may be null. The task is given up unless done() is called.
class TimedTask {
 public:
  TimedTask(Estimate* estimate, TaskKind kind, std::string_view law);
  TimedTask(TimedTask const&) = delete;
  TimedTask& operator=(TimedTask const&) = delete;
  ~TimedTask();
  void done(int evaluations, TaskDone const& task_done);

  static double now_s();

 private:
  Estimate* estimate_;
  TaskKind kind_;
  std::string_view law_;
  std::size_t id_ = 0;
};

}  // namespace isolaw::campaign
