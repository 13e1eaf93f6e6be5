// A bearing with any law, as integrators use it: force and tangents at the end of a straight step. Units kN, mm, s.
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
  // The force after a straight step of duration dt from the last committed place to `to`, with `velocity` at `to`.
  virtual BearingForce trial(Vector const& to, Vector const& velocity, double dt) = 0;
  virtual void commit() = 0;
  virtual std::unique_ptr<Bearing> copy() const = 0;
};

// How a law of one direction is used in the plane (laws/plane/in_plane.hpp).
enum class Coupling {
  coupled,  // the law's own two-dimensional form, with the same parameters
  springs,  // a set of springs around the circle, each with the law
  separate  // the law once along x and once along y, independently: exact for motions along x or y alone, and also
            // taken for laws whose force is not the same in both directions
};
// Coupling::coupled if the law has a two-dimensional form with these parameters, else Coupling::springs.
Coupling coupling_of(std::string_view law, std::span<double const> parameters);
// Makes a virgin bearing at rest. `dead_band_mm` and `parts`, the integration steps of a trial, are those of
// laws::Online; coupled forms have neither. Throws Error for an unknown law, a wrong coupling or a wrong number of
// parameters.
std::unique_ptr<Bearing> make_bearing(std::string_view law, std::span<double const> parameters, Coupling coupling,
                                      double dead_band_mm = 0.0, int parts = 1);

}  // namespace isolaw::building
