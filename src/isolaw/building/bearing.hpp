// A bearing as the implicit integrator sees it: whatever its law, the force at the end of a straight step in plan, with
// its tangents. Units kN, mm, s.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::building {

using Vector = laws::plane::Vector<double>;

struct BearingForce {
  Vector force;
  double by_displacement[2][2] = {};  // d force (row) / d displacement (column)
  double by_velocity[2][2] = {};
};

class Bearing {
 public:
  virtual ~Bearing() = default;
  // At the end of a straight step from the place last committed, `velocity` there, `dt` long.
  virtual BearingForce trial(Vector const& to, Vector const& velocity, double dt) = 0;
  // Takes the last trial.
  virtual void commit() = 0;
  // As it is now, with its history.
  virtual std::unique_ptr<Bearing> copy() const = 0;
};

// How a law of one direction goes into the plane (laws/in_plane.hpp).
enum class Coupling {
  coupled,  // the law of the plane that takes the same parameters
  springs,  // any law, as springs around the circle
  separate  // one for each direction, which know nothing of one another: exact for motions along x or y alone
};
// coupled where the law with these parameters has such a form, else springs.
Coupling coupling_of(std::string_view law, std::span<double const> parameters);

// At rest at its place. Throws Error: a law that is not there, values of another number, no such form.
std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling coupling);

}  // namespace isolaw::building
