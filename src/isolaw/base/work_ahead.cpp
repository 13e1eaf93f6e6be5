#include "isolaw/base/work_ahead.hpp"

#include <algorithm>
#include <utility>

namespace isolaw {
namespace {

thread_local WorkerGroup* group_of_thread = nullptr;
thread_local HelpListener* listener_of_thread = nullptr;

}  // namespace

HelpListener::HelpListener() : previous_(std::exchange(listener_of_thread, this)) {}
HelpListener::~HelpListener() {
  listener_of_thread = previous_;
}

WorkerGroup* WorkerGroup::current() {
  return group_of_thread;
}

Membership::Membership(WorkerGroup& group) : previous_(std::exchange(group_of_thread, &group)) {}
Membership::~Membership() {
  group_of_thread = previous_;
}

void WorkerGroup::offer(WorkAhead& work) {
  {
    std::scoped_lock const lock(mutex_);
    offered_.push_back(&work);
  }
  news_.notify_all();
}

void WorkerGroup::withdraw(WorkAhead& work) {
  std::unique_lock lock(mutex_);
  std::erase(offered_, &work);
  news_.wait(lock, [&] { return work.helpers_ == 0; });
}

void WorkerGroup::changed() {
  // A waiting thread holds the mutex while it tests finished() and until it sleeps. Taking the mutex here ensures that
  // such a thread has either seen the change or already sleeps and will be woken.
  { std::scoped_lock const lock(mutex_); }
  news_.notify_all();
}

void WorkerGroup::help_until(std::function<bool()> const& finished) {
  std::unique_lock lock(mutex_);
  while (!finished()) {
    auto const found = std::ranges::find_if(offered_, [](WorkAhead const* work) { return work->has_open(); });
    if (found == offered_.end()) {
      news_.wait(lock);
      continue;
    }
    WorkAhead& work = **found;
    ++work.helpers_;
    lock.unlock();
    auto* const before = std::exchange(listener_of_thread, work.listener_);
    if (work.listener_ != nullptr) work.listener_->help_begins();
    work.do_one();
    if (work.listener_ != nullptr) work.listener_->help_ends();
    listener_of_thread = before;
    lock.lock();
    if (--work.helpers_ == 0) news_.notify_all();
  }
}

WorkAhead::WorkAhead(std::size_t count, std::function<void(std::size_t)> work)
    : work_(std::move(work)),
      states_(count),
      failures_(count),
      group_(WorkerGroup::current()),
      listener_(listener_of_thread) {
  if (group_ != nullptr && count > 1) group_->offer(*this);
}

WorkAhead::~WorkAhead() {
  next_open_ = states_.size();
  if (group_ != nullptr && states_.size() > 1) group_->withdraw(*this);
}

void WorkAhead::perform(std::size_t i) {
  try {
    work_(i);
  } catch (...) {
    failures_[i] = std::current_exception();
  }
  states_[i] = State::done;
  states_[i].notify_all();
}

bool WorkAhead::do_one() {
  for (auto i = next_open_++; i < states_.size(); i = next_open_++) {
    auto expected = State::open;
    if (!states_[i].compare_exchange_strong(expected, State::taken)) continue;
    perform(i);
    return true;
  }
  next_open_ = states_.size();
  return false;
}

void WorkAhead::need(std::size_t i) {
  auto expected = State::open;
  if (states_[i].compare_exchange_strong(expected, State::taken)) {
    perform(i);
  } else {
    while (states_[i] != State::done && do_one()) continue;
    states_[i].wait(State::taken);
  }
  if (failures_[i]) std::rethrow_exception(failures_[i]);
}

}  // namespace isolaw
