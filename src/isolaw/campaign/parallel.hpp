// Independent pieces of work shared among threads.
#pragma once

#include <cstddef>
#include <functional>

namespace isolaw::campaign {

// Calls work(i) for every i below `count`, from up to `threads` threads, this one among them. Where the system refuses
// a thread, half of those it gave do the work, since what the others took is needed for the work itself; one that runs
// out of memory leaves, and its turn is taken when the others have ended. Returns how many worked to the end. Any other
// exception, or too little memory for a single thread, ends all of it and is thrown here. Threads without a piece of
// their own help with what the others' work offers (base/ahead.hpp).
std::size_t for_each_in_parallel(std::size_t count, std::size_t threads, std::function<void(std::size_t)> const& work);

}  // namespace isolaw::campaign
