// The response of a structure on its bearings to a motion of the ground, by steps of constant average acceleration
// (Newmark 1959, 1/2 and 1/4) condensed to the base, whose three unknowns Newton's method finds with the laws'
// tangents. Where it does not, the laws' first tangents take over; then the step is halved. A run that still does not
// converge is a recorded outcome.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/building/bearing.hpp"
#include "isolaw/building/stepping.hpp"
#include "isolaw/building/structure.hpp"

namespace isolaw::building {

// Accelerations of the ground at equal steps, the first at time 0; linear between them, zeros after.
struct Motion {
  std::string name;
  double step_s = 0.0;
  std::vector<double> x_mm_s2;
  std::vector<double> y_mm_s2 = {};  // empty: one component
};

struct Options {
  double longest_step_s = 0.005;
  double rest_s = 0.0;                             // zeros after the motion
  bool histories = false, bearing_forces = false;  // the latter with the former
  Vector pulled_to = {0.0, 0.0};                   // released from rest there, along a straight way
  int most_halvings = 10;
};

enum class Outcome { completed, not_converged, not_finite };
std::string_view name(Outcome outcome);

struct History {
  std::vector<double> time_s;
  std::vector<std::array<double, 3>> base;      // mm, mm, rad, relative to the ground
  std::vector<std::array<double, 3>> velocity;  // of the same
  std::vector<std::array<double, 2>> shear_kN;  // of all bearings
  std::vector<std::vector<double>> bearing_kN;  // where asked for, x and y of each: [sample][2 bearings]
  std::vector<std::vector<double>>
      acceleration;  // in space, of every diaphragm x and y, mm/s2: [sample][2 (1 + floors)]
};

struct Response {
  Outcome outcome = Outcome::completed;
  std::string why;               // it did not complete
  std::vector<double> measured;  // Layout's
  double step_s = 0.0;           // of the integration
  std::size_t steps = 0, iterations = 0, first_tangents = 0, halvings = 0;
  History history;

  double of(Measure which) const { return measured[static_cast<std::size_t>(which)]; }
};

// Bearings in plan, relative to the axes of the structure's plan.
struct Plan {
  std::vector<Point> bearings;
  std::vector<Point> corners = {};  // empty: of the rectangle around the bearings
};

// A structure and its plan as the integrators read them; holds what the skeleton points to.
class Model {
 public:
  Model(Structure structure, Plan plan);
  Structure const& structure() const { return structure_; }
  Plan const& plan() const { return plan_; }
  Layout layout() const { return {structure_.floors(), plan_.bearings.size()}; }
  StructureArrays skeleton() const;
  // Of every mode for a step of this length, and M - sum share participation participation^T.
  std::vector<double> shares(double dt) const;
  Matrix3 condensed_mass(double dt) const;
  // Of forces in plan at the bearings: sum T_j^T k_j T_j about the base's centre of mass; k_j 2 x 2 by rows.
  Matrix3 stiffness(std::span<std::array<double, 4> const> bearings) const;

 private:
  Structure structure_;
  Plan plan_;
  std::vector<double> mass_, bearing_at_, corner_at_;
};

// The steps of a motion: of its own cut into equal parts no longer than `longest`.
struct Steps {
  std::size_t parts = 1, count = 0;
  double dt = 0.0;
};
Steps steps_of(Motion const& motion, double longest_step_s, double rest_s);

// The bearings start as they are and end as the run leaves them.
Response integrate(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings, Motion const& motion,
                   Options const& options = {});

// The explicit path, scalar: what the lanes compute, one draw (lanes.hpp).
Response integrate_explicitly(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings,
                              Motion const& motion, Options const& options = {});

// What a run at this step misses, from another at twice as many: a third of the difference of every measure.
std::vector<double> richardson(Response const& coarse, Response const& fine);

}  // namespace isolaw::building
