#include "isolaw/building/integrate.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "isolaw/base/error.hpp"

namespace isolaw::building {
namespace {

Vector3 as_vector(double const (&from)[3]) {
  return {from[0], from[1], from[2]};
}

class ImplicitRun {
 public:
  ImplicitRun(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings, Motion const& motion,
              Options const& options)
      : model_(model),
        arrays_(model.arrays()),
        bearings_(bearings),
        options_(options),
        steps_(steps_of(motion, options.longest_step_s, options.rest_s)),
        ground_{.x = motion.x_mm_s2.data(),
                .y = motion.y_mm_s2.empty() ? nullptr : motion.y_mm_s2.data(),
                .samples = motion.x_mm_s2.size(),
                .parts = steps_.parts,
                .steps = steps_.count},
        memory_(run_scalars(arrays_.modes, model.layout())),
        forces_(bearings.size()) {
    start_run(run_, arrays_, memory_.data());
    prepare(steps_.dt);
  }

  Response operator()() {
    out_.step_s = steps_.dt;
    release();
    keep_history(0.0);
    double g0[2], g1[2];
    ground_.at(0, g0);
    for (std::size_t n = 0; n < steps_.count && out_.outcome == Outcome::completed; ++n) {
      if (options_.interrupted && options_.interrupted()) throw InterruptedRun();
      ground_.at(n + 1, g1);
      advance(static_cast<double>(n) * steps_.dt, steps_.dt, g0, g1, 0);
      keep_history(static_cast<double>(n + 1) * steps_.dt);
      g0[0] = g1[0], g0[1] = g1[1];
    }
    finish_run(run_, arrays_);
    out_.measured.assign(run_.measured, run_.measured + model_.layout().count());
    return std::move(out_);
  }

 private:
  void prepare(double dt) {
    if (dt == prepared_) return;
    prepared_ = dt;
    shares_ = model_.shares(dt);
    condensed_ = model_.condensed_mass(dt);
  }

  void release() {
    first_ = total(run_.u, run_.v, 0.0).stiffness;
    run_.u[0] = options_.pulled_to.x;
    run_.u[1] = options_.pulled_to.y;
    Vector3 const force = total(run_.u, run_.v, 0.0).force;
    for (std::size_t j = 0; j < bearings_.size(); ++j) {
      bearings_[j]->commit();
      double const* point = arrays_.bearing_at + 2 * j;
      double x, y;
      at_point(run_.u, point, x, y);
      run_.d[2 * j] = x, run_.d[2 * j + 1] = y;
      run_.force[2 * j] = forces_[j].x, run_.force[2 * j + 1] = forces_[j].y;
    }
    Vector3 const A = -model_.structure().base_mass().inverse() * force;
    for (Eigen::Index i = 0; i < 3; ++i) run_.A[i] = A(i), run_.f[i] = force(i);
    for (std::size_t k = 0; k < arrays_.modes; ++k)
      for (std::size_t i = 0; i < 3; ++i) run_.qa[k] -= arrays_.participation[3 * k + i] * run_.A[i];
  }

  struct Total {
    Vector3 force;
    Matrix3 stiffness, damping;
  };
  // Computes trials of all bearings at the end of a step and sums forces and tangents about the base's centre of mass.
  Total total(double const (&u)[3], double const (&v)[3], double dt) {
    Total sum{Vector3::Zero(), Matrix3::Zero(), Matrix3::Zero()};
    for (std::size_t j = 0; j < bearings_.size(); ++j) {
      double const* point = arrays_.bearing_at + 2 * j;
      Vector to, velocity;
      at_point(u, point, to.x, to.y);
      at_point(v, point, velocity.x, velocity.y);
      auto const force = bearings_[j]->trial(to, velocity, dt);
      forces_[j] = force.force;
      Eigen::Matrix<double, 2, 3> T;
      T << 1.0, 0.0, -point[1], 0.0, 1.0, point[0];
      sum.force += T.transpose() * Eigen::Vector2d(force.force.x, force.force.y);
      Eigen::Matrix2d K, C;
      K << force.by_displacement[0][0], force.by_displacement[0][1], force.by_displacement[1][0],
          force.by_displacement[1][1];
      C << force.by_velocity[0][0], force.by_velocity[0][1], force.by_velocity[1][0], force.by_velocity[1][1];
      sum.stiffness += T.transpose() * K * T;
      sum.damping += T.transpose() * C * T;
    }
    return sum;
  }

  void advance(double time, double dt, double const (&g0)[2], double const (&g1)[2], int halvings) {
    if (step(dt, g0, g1)) return;
    if (out_.outcome != Outcome::completed) return;
    if (halvings == options_.most_halvings) {
      out_.outcome = Outcome::not_converged;
      out_.stop_reason = fmt::format("no equilibrium at {:.4f} s, in steps of {:.3g} s", time, dt);
      return;
    }
    ++out_.halvings;
    double const half[2]{0.5 * (g0[0] + g1[0]), 0.5 * (g0[1] + g1[1])};
    advance(time, 0.5 * dt, g0, half, halvings + 1);
    if (out_.outcome == Outcome::completed) advance(time + 0.5 * dt, 0.5 * dt, half, g1, halvings + 1);
  }

  // Shortens a step along the vector `way`. Returns the share of its length at which the work of the residual along
  // `way` is at most half as large as at the start, where the residual is `start`. If some 40 trials find no such
  // share, returns the last one tried. `at(share)` computes the residual there and leaves the bearings' trial forces at
  // that share. Its last call is for the share that is returned.
  template <class At>
  static double share_along(Vector3 const& way, Vector3 const& start, At const& at) {
    double const enough = 0.5 * std::abs(way.dot(start));
    double low = 0.0, of_low = way.dot(start), high = 0.0, of_high = 0.0, share = 1.0;
    constexpr int most = 40;
    for (int i = 0;; ++i) {
      double const work = way.dot(at(share));
      if (!(std::abs(work) > enough) || i == most) return share;
      (work < 0.0 ? low : high) = share;
      (work < 0.0 ? of_low : of_high) = work;
      // The next share lies between `low` and `high`, but not near them, so that this interval shrinks by at least a
      // tenth each time.
      share = high == 0.0 ? 2.0 * share
                          : low + (high - low) * std::clamp(of_low / (of_low - of_high), i % 2 == 0 ? 0.1 : 0.5, 0.9);
    }
  }

  // Returns whether equilibrium was found. If not, the state of the run has not changed.
  bool step(double dt, double const (&g0)[2], double const (&g1)[2]) {
    prepare(dt);
    ModeStep const modes{.dt = dt, .share = shares_.data()};
    double u0[3], v0[3], a0[3], on_base[3];
    for (std::size_t i = 0; i < 3; ++i) {
      u0[i] = run_.u[i], v0[i] = run_.v[i];
      a0[i] = run_.A[i] - (i < 2 ? g0[i] : 0.0);
    }
    modes_freely(run_, arrays_, modes, on_base);
    Vector3 const ground(g1[0], g1[1], 0.0), speed = as_vector(v0), before = as_vector(a0);
    // The unknown is the part of the displacement that depends on the acceleration at the end of the step. The inertial
    // force is proportional to this part. If the whole displacement were the unknown, which can be ten thousand times
    // as large, its rounding would spoil the inertial force.
    Vector3 const steady = dt * speed + 0.25 * dt * dt * before;
    Vector3 const load = condensed_ * ground + as_vector(on_base);
    Matrix3 const inertia = condensed_ * (4.0 / (dt * dt));
    double const arm = model_.structure().frame().base.gyration_mm;
    auto const size = [&](Vector3 const& force) { return std::max(force.head<2>().norm(), std::abs(force(2)) / arm); };

    Vector3 const guess = 0.25 * dt * dt * before;
    Vector3 unknown = guess;
    Total now{};
    double last = std::numeric_limits<double>::infinity();
    bool found = false;
    // Computes the bearings' forces for the unknown `at` and returns the force that is then out of balance.
    auto const out_of_balance = [&](Vector3 const& at) -> Vector3 {
      double u[3], v[3];
      for (Eigen::Index k = 0; k < 3; ++k) {
        double const way = steady(k) + at(k);
        u[k] = u0[k] + way;
        v[k] = 2.0 / dt * way - v0[k];
      }
      now = total(u, v, dt);
      ++out_.iterations;
      return inertia * at + load + now.force;
    };
    auto const is_balanced = [&](Vector3 const& residual) {
      Vector3 const inertial = inertia * unknown;
      double const scale = std::max({size(inertial), size(load), size(now.force), 1e-12}), left = size(residual);
      // The forces count as balanced if the residual, divided by the largest force, is at most `all`. A quotient up to
      // `sufficient` is enough if the last iteration did not cut the residual to a tenth, since more iterations would
      // not help.
      constexpr double sufficient = 1e-10, all = 1e-14, slow = 0.1;
      bool const balanced = left <= all * scale || (left <= sufficient * scale && left > slow * last);
      last = left;
      return balanced;
    };
    constexpr int newton = 12, first_tangent = 60, searches = 60;
    for (int i = 0; i < newton + first_tangent && !found; ++i) {
      if (i == newton) {
        ++out_.first_tangents;
        unknown = guess;
      }
      Vector3 const residual = out_of_balance(unknown);
      if (!residual.allFinite()) break;
      found = is_balanced(residual);
      if (found) break;
      Matrix3 const tangent = i < newton ? Matrix3(now.stiffness + 2.0 / dt * now.damping) : first_;
      Vector3 const change = Matrix3(inertia + tangent).inverse() * residual;
      unknown -= change;
    }
    if (!found) {
      // Some forces become ever steeper as they approach a certain displacement, for example powers below 1 near zero.
      // Whole steps of Newton's method then leap over the equilibrium. So each step goes only so far that the work of
      // the residual along it falls to half. If the forces rise with the displacement, their potential is convex and
      // the shortened steps lead to its minimum, the equilibrium.
      unknown = guess;
      last = std::numeric_limits<double>::infinity();
      Vector3 residual = out_of_balance(unknown);
      for (int i = 0; i < searches && residual.allFinite(); ++i) {
        found = is_balanced(residual);
        if (found) break;
        Vector3 way = -Matrix3(inertia + now.stiffness + 2.0 / dt * now.damping).inverse() * residual;
        if (!(way.dot(residual) < 0.0)) way = -Matrix3(inertia + first_).inverse() * residual;
        unknown +=
            share_along(way, residual,
                        [&](double share) -> Vector3 { return residual = out_of_balance(unknown + share * way); }) *
            way;
      }
    }
    if (!found) return false;

    Vector3 const after = 4.0 / (dt * dt) * unknown;
    for (Eigen::Index i = 0; i < 3; ++i) {
      double const way = steady(i) + unknown(i);
      run_.u[i] = u0[i] + way;
      run_.v[i] = 2.0 / dt * way - v0[i];
      run_.A[i] = after(i) + ground(i);
      run_.f[i] = now.force(i);
    }
    double const p0x = momentum_x_, p0y = momentum_y_;
    modes_reach(run_, arrays_, modes);
    momentum_x_ = momentum(run_, arrays_, 0);
    momentum_y_ = momentum(run_, arrays_, 1);
    for (std::size_t j = 0; j < bearings_.size(); ++j) {
      bearings_[j]->commit();
      double x, y;
      at_point(run_.u, arrays_.bearing_at + 2 * j, x, y);
      measure_bearing(run_, arrays_, j, x, y, forces_[j].x, forces_[j].y);
    }
    measure_displacements(run_, arrays_, dt, u0, v0);
    measure(run_, arrays_, dt, u0, v0, g0, g1, p0x, p0y, momentum_x_, momentum_y_);
    ++out_.steps;
    return true;
  }

  void keep_history(double time) {
    if (!options_.histories) return;
    auto& h = out_.history;
    h.time_s.push_back(time);
    h.base.push_back({run_.u[0], run_.u[1], run_.u[2]});
    h.velocity.push_back({run_.v[0], run_.v[1], run_.v[2]});
    h.shear_kN.push_back({run_.f[0], run_.f[1]});
    if (options_.bearing_forces) h.bearing_kN.emplace_back(run_.force, run_.force + 2 * arrays_.bearings);
    std::vector<double> a(2 * (arrays_.floors + 1));
    for (std::size_t floor = 0; floor <= arrays_.floors; ++floor) {
      double x, y;
      acceleration_of(run_, arrays_, floor, x, y);
      a[2 * floor] = x, a[2 * floor + 1] = y;
    }
    h.acceleration.push_back(std::move(a));
  }

  Model const& model_;
  StructureArrays arrays_;
  std::span<std::unique_ptr<Bearing> const> bearings_;
  Options const& options_;
  Steps steps_;
  Ground ground_;
  std::vector<double> memory_, shares_;
  std::vector<Vector> forces_;
  Run<double> run_{};
  Matrix3 condensed_ = Matrix3::Zero(), first_ = Matrix3::Zero();
  double prepared_ = 0.0, momentum_x_ = 0.0, momentum_y_ = 0.0;
  Response out_;
};

}  // namespace

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::completed:
      return "completed";
    case Outcome::not_converged:
      return "not converged";
    case Outcome::not_finite:
      return "not finite";
  }
  return "";
}

Model::Model(Structure structure, Plan plan) : structure_(std::move(structure)), plan_(std::move(plan)) {
  if (plan_.bearings.empty())
    throw Error({.where = "bearings", .found = "none", .allowed = "one or more, with their places in plan"});
  if (plan_.corners.empty()) {
    auto const [left, right] = std::ranges::minmax(plan_.bearings, {}, &Point::x_mm);
    auto const [low, high] = std::ranges::minmax(plan_.bearings, {}, &Point::y_mm);
    for (double const x : {left.x_mm, right.x_mm})
      for (double const y : {low.y_mm, high.y_mm}) plan_.corners.push_back({x, y});
  }
  auto const centre = structure_.frame().base.centre;
  auto const relative = [&](std::vector<Point> const& points, std::vector<double>& to) {
    for (auto const& p : points) {
      to.push_back(p.x_mm - centre.x_mm);
      to.push_back(p.y_mm - centre.y_mm);
    }
  };
  relative(plan_.bearings, bearing_at_);
  relative(plan_.corners, corner_at_);
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j) mass_.push_back(structure_.mass()(i, j));
}

StructureArrays Model::arrays() const {
  return {.modes = structure_.modes(),
          .floors = structure_.floors(),
          .bearings = plan_.bearings.size(),
          .corners = plan_.corners.size(),
          .mass = mass_.data(),
          .frequency = structure_.frequency_rad_s().data(),
          .damping = structure_.damping().data(),
          .participation = structure_.participation().data(),
          .shape = structure_.shape().data(),
          .rigid = structure_.rigid().data(),
          .deformation = structure_.deformation().data(),
          .shear = structure_.shear().data(),
          .bearing_at = bearing_at_.data(),
          .corner_at = corner_at_.data()};
}

std::vector<double> Model::shares(double dt) const {
  std::vector<double> share;
  for (std::size_t k = 0; k < structure_.modes(); ++k) {
    double const w = structure_.frequency_rad_s()[k] * dt;
    share.push_back(1.0 / (1.0 + structure_.damping()[k] * w + 0.25 * w * w));
  }
  return share;
}

Matrix3 Model::condensed_mass(double dt) const {
  Matrix3 mass = structure_.mass();
  auto const share = shares(dt);
  for (std::size_t k = 0; k < share.size(); ++k) {
    Eigen::Map<Vector3 const> const gamma(structure_.participation().data() + 3 * k);
    mass -= share[k] * gamma * gamma.transpose();
  }
  return mass;
}

Matrix3 Model::stiffness(std::span<std::array<double, 4> const> bearings) const {
  Matrix3 sum = Matrix3::Zero();
  for (std::size_t j = 0; j < bearings.size(); ++j) {
    double const* point = bearing_at_.data() + 2 * j;
    Eigen::Matrix<double, 2, 3> T;
    T << 1.0, 0.0, -point[1], 0.0, 1.0, point[0];
    Eigen::Matrix2d K;
    K << bearings[j][0], bearings[j][1], bearings[j][2], bearings[j][3];
    sum += T.transpose() * K * T;
  }
  return sum;
}

Steps steps_of(Motion const& motion, double longest_step_s, double rest_s) {
  // Without the 1e-6, a motion's step that exceeds the longest step by a rounding error would be cut in two.
  auto const parts = static_cast<std::size_t>(std::max(1.0, std::ceil(motion.step_s / longest_step_s - 1e-6)));
  Steps steps{.parts = parts, .dt = motion.step_s / static_cast<double>(parts)};
  auto const samples = motion.x_mm_s2.size() + static_cast<std::size_t>(std::llround(rest_s / motion.step_s));
  steps.count = (samples - 1) * parts;
  return steps;
}

Response integrate(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings, Motion const& motion,
                   Options const& options) {
  return ImplicitRun(model, bearings, motion, options)();
}

bool asks(void const* interrupted) {
  return (*static_cast<std::function<bool()> const*>(interrupted))();
}

Response integrate_explicitly(Model const& model, std::span<std::unique_ptr<Bearing> const> bearings,
                              Motion const& motion, Options const& options) {
  auto const arrays = model.arrays();
  auto const steps = steps_of(motion, options.longest_step_s, options.rest_s);
  std::vector<double> memory(run_scalars(arrays.modes, model.layout()));
  Run<double> run{};
  start_run(run, arrays, memory.data());
  auto const share = model.shares(steps.dt);
  Matrix3 const inverse = model.condensed_mass(steps.dt).inverse();
  double rows[9];
  for (Eigen::Index i = 0; i < 9; ++i) rows[i] = inverse(i / 3, i % 3);
  Ground const ground{.x = motion.x_mm_s2.data(),
                      .y = motion.y_mm_s2.empty() ? nullptr : motion.y_mm_s2.data(),
                      .samples = motion.x_mm_s2.size(),
                      .parts = steps.parts,
                      .steps = steps.count,
                      .asked = options.interrupted ? asks : nullptr,
                      .interruption = &options.interrupted};
  explicit_run(run, arrays, {.dt = steps.dt, .share = share.data()}, rows, ground,
               [&](std::size_t j, double x, double y, double vx, double vy, double& fx, double& fy) {
                 auto const trial = bearings[j]->trial({x, y}, {vx, vy}, steps.dt);
                 bearings[j]->commit();
                 fx = trial.force.x, fy = trial.force.y;
               });
  if (options.interrupted && options.interrupted()) throw InterruptedRun();
  Response out;
  out.step_s = steps.dt;
  out.steps = steps.count;
  out.measured.assign(run.measured, run.measured + model.layout().count());
  if (std::ranges::any_of(out.measured, [](double x) { return !std::isfinite(x); })) {
    out.outcome = Outcome::not_finite;
    out.stop_reason = "a force or a displacement that is no number";
  }
  return out;
}

std::vector<double> richardson(Response const& coarse, Response const& fine) {
  std::vector<double> error;
  for (std::size_t i = 0; i < std::min(coarse.measured.size(), fine.measured.size()); ++i)
    error.push_back(std::abs(coarse.measured[i] - fine.measured[i]) * 4.0 / 3.0);
  return error;
}

}  // namespace isolaw::building
