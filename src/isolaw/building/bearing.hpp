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

// How a law of one direction goes into the plane.
enum class Coupling {
  coupled,   // the law of the plane that takes the same parameters; refused where there is none
  separate,  // one for each direction, which know nothing of one another: for motions along x or y alone
};

// At rest at its place. Throws Error: a law that is not there, values of another number, a law without a coupled form.
std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling coupling);

// Whether the law has a coupled form.
bool has_coupled_form(std::string_view law);

}  // namespace isolaw::building
