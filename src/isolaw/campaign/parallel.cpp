#include "isolaw/campaign/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

#include "isolaw/base/work_ahead.hpp"

namespace isolaw::campaign {

std::size_t for_each_in_parallel(std::size_t count, std::size_t threads, std::function<void(std::size_t)> const& work) {
  if (count == 0) return 1;
  threads = std::max<std::size_t>(threads, 1);
  std::atomic<std::size_t> next = 0, busy = 0;
  WorkerGroup group;
  std::mutex one_at_a_time;
  std::exception_ptr failure;
  std::vector<std::size_t> left;
  left.reserve(threads);
  auto const work_through = [&] {  // returns false if memory ran out
    for (auto i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (std::bad_alloc const&) {
        std::scoped_lock const lock(one_at_a_time);
        left.push_back(i);
        return false;
      } catch (...) {
        next = count;
        std::scoped_lock const lock(one_at_a_time);
        if (!failure) failure = std::current_exception();
      }
    }
    return true;
  };
  auto const work_along = [&] {
    Membership const member(group);
    bool const stays = work_through();
    --busy;
    group.changed();
    if (stays) group.help_until([&] { return busy == 0; });
  };
  std::size_t helpers = 0;
  {
    std::latch counted(1);
    std::vector<std::jthread> started;
    started.reserve(threads - 1);
    try {
      for (std::size_t id = 0; id + 1 < threads; ++id)
        started.emplace_back([&, id] {
          counted.wait();
          if (id < helpers) work_along();
        });
      helpers = started.size();
    } catch (std::system_error const&) {
      helpers = started.size() / 2;
    } catch (std::bad_alloc const&) {
      helpers = started.size() / 2;
    }
    busy = helpers + 1;
    counted.count_down();
    while (started.size() > helpers) started.pop_back();
    work_along();
  }
  if (failure) std::rethrow_exception(failure);
  for (auto const i : left) work(i);
  for (auto i = next++; i < count; i = next++) work(i);
  return helpers + 1 - std::min(helpers, left.size());
}

}  // namespace isolaw::campaign
