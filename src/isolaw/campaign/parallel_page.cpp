// Implements parallel.hpp for a browser, where the program has one thread. Other web workers compute other parts.
#include "isolaw/campaign/parallel.hpp"

namespace isolaw::campaign {

std::size_t for_each_in_parallel(std::size_t count, std::size_t, std::function<void(std::size_t)> const& work) {
  for (std::size_t i = 0; i < count; ++i) work(i);
  return 1;
}

}  // namespace isolaw::campaign
