// A bearing as integrators see it, for any law: force and tangents at the end of a straight step. Units kN, mm, s.
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
  // The force after a straight step of duration dt from the last committed place to `to`, with `velocity` at its end.
  virtual BearingForce trial(Vector const& to, Vector const& velocity, double dt) = 0;
  virtual void commit() = 0;
  virtual std::unique_ptr<Bearing> copy() const = 0;
};

// How a law of one direction is used in the plane (laws/plane/in_plane.hpp).
enum class Coupling {
  coupled,  // a law of the plane with the same parameters
  springs,  // springs around the circle, for any law
  separate  // the law once along x and once along y, independent: exact for motions along x or y alone
};
// coupled if the law with these parameters has a coupled form, else springs.
Coupling coupling_of(std::string_view law, std::span<double const> parameters);
// Makes a virgin bearing at rest. Throws Error for an unknown law, a form it lacks, or a wrong number of parameters.
std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling coupling);

}  // namespace isolaw::building
