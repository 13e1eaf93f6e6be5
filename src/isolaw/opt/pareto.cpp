#include "isolaw/opt/pareto.hpp"

#include <cassert>
#include <cmath>
#include <cstddef>

namespace isolaw::opt {

// Compares all pairs, which is fast enough for a few laws.
std::vector<bool> non_dominated(std::span<double const> a, std::span<double const> b) {
  assert(a.size() == b.size());
  auto const usable = [&](std::size_t i) { return std::isfinite(a[i]) && std::isfinite(b[i]); };
  auto const dominates = [&](std::size_t i, std::size_t j) {
    return a[i] <= a[j] && b[i] <= b[j] && (a[i] < a[j] || b[i] < b[j]);
  };
  std::vector<bool> on_front(a.size());
  for (std::size_t j = 0; j < a.size(); ++j) {
    on_front[j] = usable(j);
    for (std::size_t i = 0; i < a.size() && on_front[j]; ++i)
      if (usable(i) && dominates(i, j)) on_front[j] = false;
  }
  return on_front;
}

}  // namespace isolaw::opt
