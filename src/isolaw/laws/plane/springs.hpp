// Makes a law of two directions from any law of one: springs around a circle, each with a history and a peak of its
// own. Source: multiple shear springs (Wada and Hirose 1989; Yamamoto et al. 2012 for isolators). N springs lie at the
// angles pi i / N. A spring with the displacement u has the force rf f(u rs / rf), where f is the law. rs = 2 / N keeps
// the stiffness along a straight push, and rf = tan(pi / 2N) keeps the strength. Between the elastic line and the
// strength the loop bends differently than that of f. A law that is used this way is therefore also fitted this way
// (fit/as_springs.hpp). Velocities are scaled like displacements.
#pragma once

#include <array>
#include <vector>

#include "isolaw/laws/online/online.hpp"
#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::laws {

inline constexpr int usual_springs = 16;

// The law of a spring gets `way` times the displacement of the device along the spring; the spring's force is `force`
// times that of the law.
struct SpringShares {
  double force, way;  // rf and rs / rf of the text above
};
SpringShares spring_shares(int count);

class Springs {
 public:
  // `law` is virgin; displacements, velocities and forces are in its units. `count` is at least 2.
  explicit Springs(Online const& law, int count = usual_springs);

  struct Force {
    plane::Vector<double> force;
    // Derivatives of the force by the displacement and by the velocity: rows are the x and y of the force, columns the
    // x and y of the displacement or velocity.
    std::array<std::array<double, 2>, 2> by_displacement, by_velocity;
  };
  Force trial(plane::Vector<double> const& displacement, plane::Vector<double> const& velocity);
  void commit();
  std::vector<double> state() const;  // Online::state() of each spring, one after another

 private:
  struct Spring {
    plane::Vector<double> direction;
    Online law;
  };
  std::vector<Spring> springs_;
  SpringShares share_;
};

}  // namespace isolaw::laws
