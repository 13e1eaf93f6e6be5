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
  std::vector<double> y_mm_s2 = {};  // empty: no motion along y
  std::vector<Finding> notes = {};   // how the motion was changed when it was read
};

struct Options {
  double longest_step_s = 0.005;
  double rest_s = 0.0;                             // time to continue after the motion
  bool histories = false, bearing_forces = false;  // bearing_forces needs histories
  Vector pulled_to = {0.0, 0.0};                   // before the motion the base is pulled to here [mm] and released
  int most_halvings = 10;                          // how often one step may be halved
  std::function<bool()> interrupted = {};  // asked during a run; if it returns true, the run throws InterruptedRun
};
struct InterruptedRun {};

enum class Outcome { completed, not_converged, not_finite };
std::string_view name(Outcome outcome);

struct History {
  std::vector<double> time_s;
  std::vector<std::array<double, 3>> base;        // mm, mm, rad, relative to the ground
  std::vector<std::array<double, 3>> velocity;    // mm/s, mm/s, rad/s
  std::vector<std::array<double, 2>> shear_kN;    // sum over the bearings
  std::vector<std::vector<double>> bearing_kN;    // [sample][2 * bearings], x, y of each; empty without bearing_forces
  std::vector<std::vector<double>> acceleration;  // [sample][2 * (1 + floors)], absolute, mm/s2, x, y of each diaphragm
};

struct Response {
  Outcome outcome = Outcome::completed;
  std::string why;                                                          // why the run did not complete
  std::vector<double> measured;                                             // measures in the order of Layout
  double step_s = 0.0;                                                      // integration step
  std::size_t steps = 0, iterations = 0, first_tangents = 0, halvings = 0;  // first_tangents: steps by tangents at rest
  History history;

  double of(Measure which) const { return measured[static_cast<std::size_t>(which)]; }
};

// Points in plan, in the axes of the structure.
struct Plan {
  std::vector<Point> bearings;
  std::vector<Point> corners = {};  // corners of the slab; if empty, of the rectangle around the bearings
};

// A structure and its plan. The object owns the arrays that arrays() points to.
class Model {
 public:
  Model(Structure structure, Plan plan);
  Structure const& structure() const { return structure_; }
  Plan const& plan() const { return plan_; }
  Layout layout() const { return {structure_.floors(), plan_.bearings.size()}; }
  StructureArrays arrays() const;
  std::vector<double> shares(double dt) const;  // [mode] ModeStep::share for steps of length dt
  Matrix3 condensed_mass(double dt) const;      // M - sum over the modes of share participation participation^T
  // Stiffness of all bearings against the base's motion at its centre of mass, from each bearing's 2 x 2 by rows.
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
// The bearings start in their present state and keep the state at the end of the run.
Response integrate(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings, Motion const& motion,
                   Options const& options = {});
// For Ground::asked: calls the Options::interrupted to which `interrupted` points.
bool asks(void const* interrupted);
// Explicit integration of one building in plain doubles, without history: the reference for lanes.hpp's vector code.
Response integrate_explicitly(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings,
                              Motion const& motion, Options const& options = {});
// Estimates the error of each measure of `coarse` that is due to its step. `fine` is the same run with half the step.
// The method is of second order, so halving the step divides the error by four. The error of `coarse` is therefore four
// thirds of the difference between the two runs.
std::vector<double> richardson(Response const& coarse, Response const& fine);

}  // namespace isolaw::building
