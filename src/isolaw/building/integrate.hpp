// Implicit integration of a structure on its bearings under a ground motion, by constant average acceleration (Newmark
// 1959, gamma 1/2, beta 1/4). Newton's method finds the base's three displacements with the laws' tangents. If it
// fails, the step is repeated with the tangents at rest, and then with shortened steps of Newton's method. If all fail,
// the step is halved. Failure is an Outcome, not an exception.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/building/bearing.hpp"
#include "isolaw/building/stepping.hpp"
#include "isolaw/building/structure.hpp"

namespace isolaw::building {

// Ground accelerations at equal steps from time 0, linear between samples. After the last sample they fall to zero
// within one step.
struct Motion {
  std::string name;
  double step_s = 0.0;
  std::vector<double> x_mm_s2;
  std::vector<double> y_mm_s2 = {};  // empty if the ground moves along x alone
  std::vector<Finding> notes = {};   // what was changed in the motion when its file was read
};

struct Options {
  double longest_step_s = 0.005;
  double rest_s = 0.0;  // how long to integrate after the end of the ground motion
  // `histories`: whether Response::history is kept. `bearing_forces`: whether it includes History::bearing_kN.
  bool histories = false, bearing_forces = false;
  Vector pulled_to = {0.0, 0.0};  // displacement [mm] to which the base is pulled before the motion, then released
  int most_halvings = 10;         // how often a step that does not converge may be halved; after that the run fails
  std::function<bool()> interrupted = {};  // asked during a run; if it returns true, the run throws InterruptedRun
};
struct InterruptedRun {};

enum class Outcome { completed, not_converged, not_finite };
std::string_view name(Outcome outcome);

// The motion at each step. Displacements and velocities are those of the base's centre of mass relative to the ground.
struct History {
  std::vector<double> time_s;
  std::vector<std::array<double, 3>> base;      // displacement along x and y [mm], and rotation [rad]
  std::vector<std::array<double, 3>> velocity;  // along x and y [mm/s], and of rotation [rad/s]
  std::vector<std::array<double, 2>> shear_kN;  // sum of the bearings' forces along x and y
  // For each step the forces of all bearings, x and y of the first one, of the second one, ...; empty without
  // Options::bearing_forces.
  std::vector<std::vector<double>> bearing_kN;
  // For each step the absolute accelerations [mm/s2] of all diaphragms, x and y of the base, of the first floor, ...
  std::vector<std::vector<double>> acceleration;
};

struct Response {
  Outcome outcome = Outcome::completed;
  std::string stop_reason;       // why the run stopped early; empty if it was completed
  std::vector<double> measured;  // largest displacements, forces, energies, ... in the order that Layout describes
  double step_s = 0.0;           // integration step before any halving
  // Number of steps, of Newton's iterations, of steps that needed the tangents at rest, and of halvings of a step.
  std::size_t steps = 0, iterations = 0, first_tangents = 0, halvings = 0;
  History history;

  double value(Measure which) const { return measured[static_cast<std::size_t>(which)]; }
};

// Points in plan, in the axes of the structure.
struct Plan {
  std::vector<Point> bearings;
  std::vector<Point> corners = {};  // corners of the slab; if empty, those of the rectangle around the bearings count
};

// A structure and its plan. The object owns the arrays that arrays() points to.
class Model {
 public:
  Model(Structure structure, Plan plan);
  Structure const& structure() const { return structure_; }
  Plan const& plan() const { return plan_; }
  Layout layout() const { return {structure_.floors(), plan_.bearings.size()}; }
  StructureArrays arrays() const;
  // Returns ModeStep::share (stepping.hpp) of each mode for steps of dt [s].
  std::vector<double> shares(double dt) const;
  // The mass that resists an acceleration of the base during a step: M - sum over the modes of share * Gamma Gamma^T,
  // with M and Gamma of structure.hpp and share of shares(dt).
  Matrix3 condensed_mass(double dt) const;
  // The stiffness of all bearings together: the derivatives of their summed forces and moment (rows) with respect to
  // the base's displacements along x and y and its rotation (columns), all at the base's centre of mass. For each
  // bearing, `bearings` holds its 2 x 2 stiffness in x and y, row by row [kN/mm].
  Matrix3 stiffness(std::span<std::array<double, 4> const> bearings) const;

 private:
  Structure structure_;
  Plan plan_;
  std::vector<double> mass_, bearing_at_, corner_at_;
};

// The steps of an integration. Each step of the motion is cut into equal parts no longer than longest_step_s.
struct Steps {
  std::size_t parts = 1, count = 0;
  double dt = 0.0;
};
Steps steps_of(Motion const& motion, double longest_step_s, double rest_s);
// The bearings start in their present state and are left in the state that they reach at the end of the run.
Response integrate(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings, Motion const& motion,
                   Options const& options = {});
// A function for the member Ground::asked. It calls the Options::interrupted to which `interrupted` points.
bool asks(void const* interrupted);
// Explicit integration of one building in plain doubles, without history: the reference for lanes.hpp's vector code.
Response integrate_explicitly(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings,
                              Motion const& motion, Options const& options = {});
// Estimates the error of each measure of `coarse` that is due to its step. `fine` is the same run with half the step.
// The method is of second order, so halving the step divides the error by four. The error of `coarse` is therefore four
// thirds of the difference between the two runs.
std::vector<double> richardson(Response const& coarse, Response const& fine);

}  // namespace isolaw::building
