// Masing's rules: every branch is the skeleton at twice its size, from the turning point that the branch began at. The
// displacement alone decides which point that is (Memory).
// Source: Masing 1926; docs/laws.md.
#pragma once

#include <vector>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

template <class T>
class MasingBranches {
 public:
  MasingBranches() = default;
  explicit MasingBranches(Path const& path) : turned_(path.deepest, T(0.0)) {}

  // The force at the end of a step. skeleton(x) is the odd curve from the origin. Must be called at every step.
  template <class Skeleton>
  T force(Step const& step, Memory const& memory, Skeleton&& skeleton) {
    if (memory.kept != Memory::none) turned_[memory.kept] = force_;
    force_ = memory.branch == Memory::none
                 ? skeleton(step.x1)
                 : turned_[memory.branch] + T(2.0) * skeleton(0.5 * (step.x1 - memory.branch_x));
    return force_;
  }

 private:
  T force_ = T(0.0);
  std::vector<T> turned_;  // force at the turning points
};

}  // namespace isolaw::laws
