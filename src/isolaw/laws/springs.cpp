#include "isolaw/laws/springs.hpp"

#include <cmath>
#include <numbers>

namespace isolaw::laws {

Springs::Springs(Online const& law, int count)
    : force_share_(std::tan(0.5 * std::numbers::pi / count)), way_share_(2.0 / count / force_share_) {
  springs_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    double const angle = std::numbers::pi * i / count;
    springs_.push_back({{std::cos(angle), std::sin(angle)}, law});
  }
}

Springs::Force Springs::trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity) {
  Force sum{};
  for (auto& [n, law] : springs_) {
    auto const of = law.trial(way_share_ * plane::dot(displacement, n), way_share_ * plane::dot(velocity, n));
    sum.force = sum.force + (force_share_ * of.force) * n;
    double const along[] = {n.x, n.y};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        double const both = force_share_ * way_share_ * along[i] * along[k];
        sum.by_displacement[i][k] += both * of.by_x;
        sum.by_velocity[i][k] += both * of.by_v;
      }
  }
  return sum;
}

void Springs::commit() {
  for (auto& spring : springs_) spring.law.commit();
}

}  // namespace isolaw::laws
