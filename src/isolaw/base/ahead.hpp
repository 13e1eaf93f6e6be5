// A list of work items that one thread needs in order. Idle threads compute later items ahead of it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace isolaw {

class WorkAhead;

// Notified before and after each item that a helping thread computes, on that thread. It covers all work that is
// offered during its life by the thread that created it, and by helpers while they work for that thread.
class HelpListener {
 public:
  HelpListener();
  virtual ~HelpListener();
  HelpListener(HelpListener const&) = delete;
  HelpListener& operator=(HelpListener const&) = delete;
  virtual void help_begins() = 0;
  virtual void help_ends() = 0;

 private:
  HelpListener* before_;
};

// Threads that help one another: each WorkAhead that a member creates (see Membership) is offered to the others.
class WorkerGroup {
 public:
  static WorkerGroup* current();  // the calling thread's group, or null
  // Computes offered items or sleeps until finished() is true, which is called with the group's mutex held.
  void help_until(std::function<bool()> const& finished);
  void changed();  // to be called after a change of anything that finished() looks at

 private:
  friend class WorkAhead;
  void offer(WorkAhead& work);
  void withdraw(WorkAhead& work);

  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<WorkAhead*> offered_;
};

class Membership {
 public:
  explicit Membership(WorkerGroup& crew);
  ~Membership();
  Membership(Membership const&) = delete;
  Membership& operator=(Membership const&) = delete;

 private:
  WorkerGroup* before_;
};

// Items 0 to count - 1 of a piece of work. Several threads may call `work`, at most once for each item and also for
// items that nobody needs; no item's result may depend on another. Without a group items are computed when needed.
class WorkAhead {
 public:
  WorkAhead(std::size_t count, std::function<void(std::size_t)> work);
  ~WorkAhead();  // begins no further item, and waits for those that helpers are computing
  WorkAhead(WorkAhead const&) = delete;
  WorkAhead& operator=(WorkAhead const&) = delete;
  void need(std::size_t i);  // returns when item `i` is done; throws what its work threw

 private:
  friend class WorkerGroup;
  enum class State : unsigned char { open, taken, done };
  bool has_open() const { return next_open_ < states_.size(); }
  bool do_one();  // returns false if no item is open
  void perform(std::size_t i);

  std::function<void(std::size_t)> work_;
  std::vector<std::atomic<State>> states_;
  std::vector<std::exception_ptr> failures_;
  std::atomic<std::size_t> next_open_ = 0;
  std::size_t helpers_ = 0;  // guarded by the group's mutex
  WorkerGroup* crew_;
  HelpListener* watch_;
};

}  // namespace isolaw
