#include "isolaw/laws/plane/springs.hpp"

#include <cmath>
#include <numbers>

namespace isolaw::laws {

SpringShares spring_shares(int count) {
  double const force = std::tan(0.5 * std::numbers::pi / count);
  return {.force = force, .way = 2.0 / count / force};
}

Springs::Springs(Online const& law, int count) : share_(spring_shares(count)) {
  springs_.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    double const angle = std::numbers::pi * i / count;
    springs_.push_back({{std::cos(angle), std::sin(angle)}, law});
  }
}

Springs::Force Springs::trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity) {
  Force sum{};
  for (auto& [n, law] : springs_) {
    auto const spring_force = law.trial(share_.way * plane::dot(displacement, n), share_.way * plane::dot(velocity, n));
    sum.force = sum.force + (share_.force * spring_force.force) * n;
    double const along[] = {n.x, n.y};
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        double const both = share_.force * share_.way * along[i] * along[k];
        sum.by_displacement[i][k] += both * spring_force.by_x;
        sum.by_velocity[i][k] += both * spring_force.by_v;
      }
  }
  return sum;
}

void Springs::commit() {
  for (auto& spring : springs_) spring.law.commit();
}

std::vector<double> Springs::state() const {
  std::vector<double> all;
  for (auto const& spring : springs_) {
    auto const one = spring.law.state();
    all.insert(all.end(), one.begin(), one.end());
  }
  return all;
}

}  // namespace isolaw::laws
