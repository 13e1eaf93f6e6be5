// Shares independent pieces of work among threads.
#pragma once

#include <cstddef>
#include <functional>

namespace isolaw::campaign {

// Calls work(i) for every i below `count` from up to `threads` threads, the caller's among them, and returns how many
// worked to the end. If the system refuses to start a thread, only half of the started ones get work, since the work
// needs the memory that the others would take. A thread that runs out of memory leaves, and the caller repeats its
// work(i) when the others are done. Any other exception, or too little memory for a single thread, ends all work and
// reaches the caller. Threads that have no work(i) left help with items that other calls of work offer
// (base/work_ahead.hpp).
std::size_t for_each_in_parallel(std::size_t count, std::size_t threads, std::function<void(std::size_t)> const& work);

}  // namespace isolaw::campaign
