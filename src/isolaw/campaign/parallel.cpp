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

namespace isolaw::campaign {

std::size_t for_each_in_parallel(std::size_t count, std::size_t threads, std::function<void(std::size_t)> const& work) {
  threads = std::clamp<std::size_t>(threads, 1, std::max<std::size_t>(count, 1));
  std::atomic<std::size_t> next = 0;
  std::mutex one_at_a_time;
  std::exception_ptr failure;
  std::vector<std::size_t> left;
  left.reserve(threads);
  auto const work_along = [&] {
    for (auto i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (std::bad_alloc const&) {
        std::scoped_lock const lock(one_at_a_time);
        left.push_back(i);
        return;
      } catch (...) {
        next = count;
        std::scoped_lock const lock(one_at_a_time);
        if (!failure) failure = std::current_exception();
      }
    }
  };
  std::size_t helpers = 0;
  {
    std::latch counted(1);
    std::vector<std::jthread> crew;
    crew.reserve(threads - 1);
    try {
      for (std::size_t id = 0; id + 1 < threads; ++id)
        crew.emplace_back([&, id] {
          counted.wait();
          if (id < helpers) work_along();
        });
      helpers = crew.size();
    } catch (std::system_error const&) {
      helpers = crew.size() / 2;
    } catch (std::bad_alloc const&) {
      helpers = crew.size() / 2;
    }
    counted.count_down();
    while (crew.size() > helpers) crew.pop_back();
    work_along();
  }
  if (failure) std::rethrow_exception(failure);
  for (auto const i : left) work(i);
  for (auto i = next++; i < count; i = next++) work(i);
  return helpers + 1 - std::min(helpers, left.size());
}

}  // namespace isolaw::campaign
