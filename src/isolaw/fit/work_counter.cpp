#include "isolaw/fit/work_counter.hpp"

namespace isolaw::fit {

WorkCount& work_of_this_thread() {
  thread_local WorkCount work;
  return work;
}

}  // namespace isolaw::fit
