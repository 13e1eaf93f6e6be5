// Any law in two directions: springs around the circle, each with a history of its own.
// Source: multiple shear springs (Wada and Hirose 1989; Yamamoto et al. 2012 for isolators). Of N springs at angles pi
// i / N, each of force rf f(u rs / rf), rs = 2 / N keeps the stiffness of a push, rf = tan(pi / 2N) its strength. The
// knee between them is not kept: a law for this is fitted as it is wrapped (`along`). Velocities are scaled as
// displacements. Each spring keeps its own peak.
#pragma once

#include <array>
#include <vector>

#include "isolaw/laws/online.hpp"
#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::laws {

inline constexpr int usual_springs = 16;

// Of one spring: its force in that of the law, and its way in that of the device along it.
struct SpringShares {
  double force, way;  // rf, rs / rf
};
SpringShares spring_shares(int count);

class Springs {
 public:
  // `law`: virgin, in its own units, which displacements and forces here have too. At least two springs.
  explicit Springs(Online const& law, int count = usual_springs);

  struct Force {
    plane::Vector<double> force;
    std::array<std::array<double, 2>, 2> by_displacement, by_velocity;  // d force (row), of the step as computed
  };
  Force trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity);
  void commit();

 private:
  struct Spring {
    plane::Vector<double> direction;
    Online law;
  };
  std::vector<Spring> springs_;
  SpringShares share_;
};

}  // namespace isolaw::laws
