// Tests threads that work ahead on the items of a task. Each item must be done once and before it is needed, and a
// failure must reach the thread that needs the item.
#include "isolaw/base/work_ahead.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "isolaw/campaign/parallel.hpp"

namespace isolaw {
namespace {

TEST(WorkAhead, WithoutACrewNothingIsDoneThatIsNotNeeded) {
  std::vector<int> done(5, 0);
  {
    WorkAhead work(5, [&](std::size_t i) { ++done[i]; });
    work.need(1);
    work.need(0);
    work.need(1);
  }
  EXPECT_EQ(done, (std::vector{1, 1, 0, 0, 0}));
}

TEST(WorkAhead, WhatFailedIsToldToWhoNeedsIt) {
  WorkAhead work(2, [](std::size_t i) {
    if (i == 1) throw std::runtime_error("item 1");
  });
  work.need(0);
  EXPECT_THROW(work.need(1), std::runtime_error);
  EXPECT_THROW(work.need(1), std::runtime_error);
}

// Four threads have one task to share, so three of them can only help with items of this task.
TEST(WorkAhead, ThreadsWithoutATaskHelp) {
  std::atomic<int> at_once = 0, most = 0;
  std::vector<std::atomic<int>> done(64);
  campaign::for_each_in_parallel(1, 4, [&](std::size_t) {
    WorkAhead work(done.size(), [&](std::size_t i) {
      int const now = ++at_once;
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) continue;
      // Wait until another thread works on an item too. Give up after a while if the machine is too busy to start one.
      for (int waited = 0; most < 2 && waited < 5000; ++waited)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++done[i];
      --at_once;
    });
    for (std::size_t i = 0; i < done.size(); ++i) {
      work.need(i);
      EXPECT_EQ(done[i], 1);
    }
  });
  EXPECT_GE(most, 2);
  for (auto const& times : done) EXPECT_EQ(times, 1);
}

TEST(WorkAhead, WhatIsGivenUpIsNotBegunAndNothingIsLeftRunning) {
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::atomic<int> running = 0;
    campaign::for_each_in_parallel(3, 4, [&](std::size_t) {
      std::vector<int> room(100, 0);
      {
        WorkAhead work(room.size(), [&](std::size_t i) {
          ++running;
          ++room[i];
          --running;
        });
        work.need(0);
      }
      EXPECT_LE(std::accumulate(room.begin(), room.end(), 0), 100);
    });
    EXPECT_EQ(running, 0);
  }
}

TEST(WorkAhead, WorkInsideWorkEnds) {
  std::atomic<int> sum = 0;
  campaign::for_each_in_parallel(2, 3, [&](std::size_t) {
    WorkAhead outer(6, [&](std::size_t) {
      WorkAhead inner(7, [&](std::size_t) { ++sum; });
      for (std::size_t i = 0; i < 7; ++i) inner.need(i);
    });
    for (std::size_t i = 0; i < 6; ++i) outer.need(i);
  });
  EXPECT_EQ(sum, 2 * 6 * 7);
}

}  // namespace
}  // namespace isolaw
