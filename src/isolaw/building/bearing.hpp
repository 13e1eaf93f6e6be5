// A bearing with any law. It gives an integrator the force and its derivatives after a step in which the bearing moves
// along a straight line. Units kN, mm, s.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "isolaw/laws/plane/vector.hpp"

namespace isolaw::building {

using Vector = laws::plane::Vector<double>;

struct BearingForce {
  Vector force;
  // Derivatives of the force (rows: x and y) with respect to the displacement and to the velocity (columns: x and y).
  double by_displacement[2][2] = {};
  double by_velocity[2][2] = {};
};

class Bearing {
 public:
  virtual ~Bearing() = default;
  // The force after a step of duration dt along a straight line to the displacement `to`, with `velocity` at its end.
  // The step begins where commit() was last called, so an integrator may try several steps before it commits one.
  virtual BearingForce trial(Vector const& to, Vector const& velocity, double dt) = 0;
  virtual void commit() = 0;
  virtual std::unique_ptr<Bearing> copy() const = 0;
};

// How a law of one direction is used in the plane (laws/plane/in_plane.hpp).
enum class Coupling {
  coupled,  // the law's own two-dimensional form, with the same parameters
  springs,  // springs at equal angles around a circle, each of which follows the law
  separate  // the law once along x and once along y, independently. This is exact for motions along x or y alone, and
            // also used for laws whose force differs between the two sides (laws::springs_follow)
};
// Coupling::coupled if the law has a two-dimensional form with these parameters, else Coupling::springs.
Coupling coupling_of(std::string_view law, std::span<double const> parameters);
// Makes a virgin bearing at rest. laws::Online explains `dead_band_mm` and `parts`, the number of integration steps in
// a trial; bearings with Coupling::coupled use neither. Throws Error for an unknown law, a wrong coupling or a wrong
// number of parameters.
std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling coupling,
                                      double dead_band_mm = 0.0, int parts = 1);

}  // namespace isolaw::building
