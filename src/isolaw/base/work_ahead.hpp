// Lets idle threads compute in advance what another thread will need: work items that it takes one after another.
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

// Tells a thread when other threads compute items of its WorkAheads. A helping thread calls help_begins() before each
// such item and help_ends() after it. A listener covers every WorkAhead that its thread makes while the listener
// exists, and those that a helping thread makes within such an item.
class HelpListener {
 public:
  HelpListener();
  virtual ~HelpListener();
  HelpListener(HelpListener const&) = delete;
  HelpListener& operator=(HelpListener const&) = delete;
  virtual void help_begins() = 0;
  virtual void help_ends() = 0;

 private:
  HelpListener* previous_;
};

// Threads that help one another. A thread joins by a Membership; the others may then compute items of its WorkAheads.
class WorkerGroup {
 public:
  static WorkerGroup* current();  // the calling thread's group, or null
  // Computes offered items, or sleeps, until finished() is true. Calls finished() with the mutex held.
  void help_until(std::function<bool()> const& finished);
  void changed();  // must be called after a change of anything that finished() reads

 private:
  friend class WorkAhead;
  void offer(WorkAhead& work);
  void withdraw(WorkAhead& work);

  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<WorkAhead*> offered_;
};

// While a Membership exists, the thread that made it belongs to the group.
class Membership {
 public:
  explicit Membership(WorkerGroup& group);
  ~Membership();
  Membership(Membership const&) = delete;
  Membership& operator=(Membership const&) = delete;

 private:
  WorkerGroup* previous_;
};

// A piece of work with the items 0 to count - 1, which must not depend on each other. The thread that made it asks for
// items with need(). Other threads of the group compute items in advance, even items that nobody asks for later. `work`
// is called at most once for each item: need() computes an item itself only if no other thread has begun it.
class WorkAhead {
 public:
  WorkAhead(std::size_t count, std::function<void(std::size_t)> work);
  ~WorkAhead();  // begins no further item, and waits for helpers that compute one
  WorkAhead(WorkAhead const&) = delete;
  WorkAhead& operator=(WorkAhead const&) = delete;
  void need(std::size_t i);  // returns when item `i` is done; throws what `work` threw for it

 private:
  friend class WorkerGroup;
  enum class State : unsigned char { open, taken, done };
  bool has_open() const { return next_open_ < states_.size(); }
  bool do_one();  // computes one item; returns false if every item is taken
  void perform(std::size_t i);

  std::function<void(std::size_t)> work_;
  std::vector<std::atomic<State>> states_;
  std::vector<std::exception_ptr> failures_;
  std::atomic<std::size_t> next_open_ = 0;
  std::size_t helpers_ = 0;  // guarded by the group's mutex
  WorkerGroup* group_;
  HelpListener* listener_;
};

}  // namespace isolaw
