#include "isolaw/conditions/at_reference.hpp"

#include <cmath>

namespace isolaw::conditions {

AtReference at_reference(double ln_measured, std::span<Part const> factors) {
  double ln = ln_measured, squares = 0.0;
  bool has_interval = true;
  for (auto const& [effect, group, factor] : factors) {
    if (factor.status != Status::shown && factor.status != Status::interpolated) return {.obstacle = effect};
    ln -= factor.ln;
    auto const half = half_width(factor, About::device);
    has_interval = has_interval && half;
    squares += half.value_or(0.0) * half.value_or(0.0);
  }
  return {.ln = ln, .half_width = has_interval ? std::optional(std::sqrt(squares)) : std::nullopt};
}

}  // namespace isolaw::conditions
