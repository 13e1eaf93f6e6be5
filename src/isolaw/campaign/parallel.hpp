// Shares independent pieces of work among threads.
#pragma once

#include <cstddef>
#include <functional>

namespace isolaw::campaign {

// Calls work(i) for every i below `count` from up to `threads` threads, the caller's among them. Returns how many of
// them worked to the end.
// If the system refuses to start a thread, only half of the threads started so far get work, so that memory is left for
// this work. If work(i) runs out of memory, its thread stops, and the caller's thread repeats work(i) when the others
// have finished. If the repetition fails too, or if work(i) throws anything else, no further work begins and the caller
// gets the exception. When no i is left for a thread, it helps the other threads, if their work(i) offers items of work
// to others (base/work_ahead.hpp).
std::size_t for_each_in_parallel(std::size_t count, std::size_t threads, std::function<void(std::size_t)> const& work);

}  // namespace isolaw::campaign
