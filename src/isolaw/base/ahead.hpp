// Work that one thread takes in order, and that others with nothing else to do take ahead of it.
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

class Ahead;

// Is told of help, on the thread that gives it, before and after each item; while it lives, of whatever its thread, and
// who helps it, offers.
class HelpWatch {
 public:
  HelpWatch();
  virtual ~HelpWatch();
  HelpWatch(HelpWatch const&) = delete;
  HelpWatch& operator=(HelpWatch const&) = delete;
  virtual void help_begins() = 0;
  virtual void help_ends() = 0;

 private:
  HelpWatch* before_;
};

// Threads that help one another. Who is a member (see Membership) offers its work to all others.
class Crew {
 public:
  // Of the calling thread; null where it is no member of any.
  static Crew* current();

  // Helps with what is offered until `finished` says that nothing more will be. It is asked again at every change.
  void help_until(std::function<bool()> const& finished);
  void changed();  // of what `finished` asks for

 private:
  friend class Ahead;
  void offer(Ahead& work);
  void withdraw(Ahead& work);

  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<Ahead*> offered_;
};

// Makes the calling thread a member, as long as this lives.
class Membership {
 public:
  explicit Membership(Crew& crew);
  ~Membership();
  Membership(Membership const&) = delete;
  Membership& operator=(Membership const&) = delete;

 private:
  Crew* before_;
};

// Items 0 to count - 1 of a piece of work. `work` may be called from several threads, once for an item, and for items
// that are never needed; what it makes of one item must not depend on any other. Without a crew nothing is done ahead.
class Ahead {
 public:
  Ahead(std::size_t count, std::function<void(std::size_t)> work);
  ~Ahead();  // what is not needed is not begun; waits for what is under way
  Ahead(Ahead const&) = delete;
  Ahead& operator=(Ahead const&) = delete;

  // Item `i` is done when this returns. Throws what its work threw.
  void need(std::size_t i);

 private:
  friend class Crew;
  enum class State : unsigned char { open, taken, done };
  bool has_open() const { return next_open_ < states_.size(); }
  bool do_one();  // false where no item is open
  void perform(std::size_t i);

  std::function<void(std::size_t)> work_;
  std::vector<std::atomic<State>> states_;
  std::vector<std::exception_ptr> failures_;
  std::atomic<std::size_t> next_open_ = 0;
  std::size_t helpers_ = 0;  // guarded by the crew's mutex
  Crew* crew_;
  HelpWatch* watch_;
};

}  // namespace isolaw
