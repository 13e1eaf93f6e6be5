// The explicit integration of a building, and the code that it shares with the implicit one (integrate.cpp): the modes
// of the superstructure over one step, and the results that are measured during a run. The scalar T is double, or a
// batch that computes one building in each lane, each with its own bearings drawn from the lot. This file is compiled
// for several instruction sets. It uses plain arrays and no containers: the linker keeps one copy of each function of a
// container, and this copy may use instructions that the processor lacks.
//
// Both integrations are Newmark's method with gamma = 1/2 (Newmark 1959). The modes move with average acceleration
// (beta = 1/4) in both. The base moves with average acceleration in the implicit integration, and by central
// differences (beta = 0) in explicit_run(), which takes the bearings' forces at the displacement at the end of the
// step. The modes' accelerations at the end of a step depend linearly on the base's acceleration, so they enter its
// equation as a constant 3 x 3 matrix. Without damping, explicit_run() is stable for dt^2 K < 4 m, with K the stiffness
// of the bearings and m the mass of the base slab, however stiff the superstructure is (Hughes and Liu 1978). The exact
// response of the modes to a base acceleration that is linear over the step would be unstable: with 95 % of the mass
// above the base and a mode with a period of 3 or 4 steps, the solution would grow 2.5-fold in each step.
#pragma once

#include <cstddef>

#include "isolaw/num/scalar.hpp"

// Marks functions whose type does not contain T. They must be inlined, since the linker could otherwise take a copy
// that was compiled for another instruction set.
#define ISOLAW_AWAY __attribute__((always_inline))

namespace isolaw::building {

// A structure and its bearings as plain arrays. See the functions of the same names in class Structure for their
// contents and dimensions.
struct StructureArrays {
  std::size_t modes = 0, floors = 0, bearings = 0, corners = 0;
  double const *mass = nullptr, *frequency = nullptr, *damping = nullptr, *participation = nullptr, *shape = nullptr,
               *rigid = nullptr, *deformation = nullptr, *shear = nullptr;
  // x and y of each bearing, and of each corner of the slab [mm], from the base's centre of mass.
  double const *bearing_at = nullptr, *corner_at = nullptr;
};

// The array of a run's measures begins with these ten (quantities.cpp says what they mean). Then follow the
// accelerations of all diaphragms from the base up, the shears of all storeys, the drifts of all storeys, the
// displacements of all bearings, and the work on each bearing. Units kN, mm, s, rad.
enum class Measure : std::size_t { isolator, centre, corner, rotation, end, shear, input, hysteretic, damped, balance };
inline constexpr std::size_t measures_of_all = 10;

struct Layout {
  std::size_t floors = 0, bearings = 0;
  ISOLAW_AWAY constexpr std::size_t acceleration(std::size_t diaphragm) const { return measures_of_all + diaphragm; }
  ISOLAW_AWAY constexpr std::size_t storey_shear(std::size_t storey) const {
    return measures_of_all + 1 + floors + storey;
  }
  ISOLAW_AWAY constexpr std::size_t drift(std::size_t storey) const {
    return measures_of_all + 1 + 2 * floors + storey;
  }
  ISOLAW_AWAY constexpr std::size_t displacement(std::size_t bearing) const {
    return measures_of_all + 1 + 3 * floors + bearing;
  }
  ISOLAW_AWAY constexpr std::size_t energy(std::size_t bearing) const { return displacement(bearing) + bearings; }
  ISOLAW_AWAY constexpr std::size_t count() const { return measures_of_all + 1 + 3 * floors + 2 * bearings; }
};

// A step of length dt. At its end mode k has the acceleration q'' = share_k (free_part_k - participation_k . Run::A).
struct ModeStep {
  double dt = 0.0;
  double const* share = nullptr;  // share_k for each mode k
};

// The state and the measures of a run. The caller owns the arrays.
template <class T>
struct Run {
  T u[3], v[3], A[3];          // base: displacement and velocity relative to the ground, absolute acceleration
  T f[3];                      // bearings' forces summed at the base's centre of mass, positive along displacement
  T *q, *qv, *qa, *free_part;  // of each mode: amplitude q, its velocity and acceleration, and free_part of ModeStep
  T *d, *force;                // of each bearing: x and y of its displacement, and of its force
  T* measured;                 // the measures in the order of Layout; squares of lengths until finish_run()
  T damped_rate;               // power that the modes' damping dissipates at the present instant
};
ISOLAW_AWAY constexpr std::size_t run_scalars(std::size_t modes, Layout const& layout) {
  return 4 * modes + 4 * layout.bearings + layout.count();
}

template <class T>
inline void start_run(Run<T>& run, StructureArrays const& s, T* memory) {
  Layout const layout{s.floors, s.bearings};
  for (std::size_t i = 0; i < run_scalars(s.modes, layout); ++i) memory[i] = T(0.0);
  for (std::size_t i = 0; i < 3; ++i) run.u[i] = run.v[i] = run.A[i] = run.f[i] = T(0.0);
  run.q = memory;
  run.qv = run.q + s.modes;
  run.qa = run.qv + s.modes;
  run.free_part = run.qa + s.modes;
  run.d = run.free_part + s.modes;
  run.force = run.d + 2 * s.bearings;
  run.measured = run.force + 2 * s.bearings;
  run.damped_rate = T(0.0);
}

// Computes free_part of every mode (see ModeStep), and the force of the modes on a base that does not accelerate.
template <class T>
inline void modes_freely(Run<T>& run, StructureArrays const& s, ModeStep const& step, T (&on_base)[3]) {
  for (std::size_t i = 0; i < 3; ++i) on_base[i] = T(0.0);
  double const dt = step.dt;
  for (std::size_t k = 0; k < s.modes; ++k) {
    double const w = s.frequency[k];
    T const speed = run.qv[k] + T(0.5 * dt) * run.qa[k];
    T const place = run.q[k] + T(dt) * run.qv[k] + T(0.25 * dt * dt) * run.qa[k];
    run.free_part[k] = -(T(2.0 * s.damping[k] * w) * speed + T(w * w) * place);
    for (std::size_t i = 0; i < 3; ++i)
      if (double const c = s.participation[3 * k + i] * step.share[k]; c != 0.0) on_base[i] += T(c) * run.free_part[k];
  }
}

template <class T>
inline void modes_reach(Run<T>& run, StructureArrays const& s, ModeStep const& step) {
  double const dt = step.dt;
  for (std::size_t k = 0; k < s.modes; ++k) {
    T drive = run.free_part[k];
    for (std::size_t i = 0; i < 3; ++i)
      if (double const c = s.participation[3 * k + i]; c != 0.0) drive += T(-c) * run.A[i];
    T const before = run.qa[k], after = T(step.share[k]) * drive;
    run.q[k] += T(dt) * run.qv[k] + T(0.25 * dt * dt) * (before + after);
    run.qv[k] += T(0.5 * dt) * (before + after);
    run.qa[k] = after;
  }
}

// Returns the largest value that a squared length has within a step. It is the value at the end or, if larger, the
// maximum inside the step of the cubic with these values and rates (derivatives by time) at both ends.
template <class T>
inline T largest_within(T const& square0, T const& rate0, T const& square1, T const& rate1, double dt) {
  using num::max;
  using num::select;
  T const fall = max(rate0 - rate1, T(1e-290));
  T const t = rate0 / fall, rest = T(1.0) - t;
  T const between = rest * rest * ((T(1.0) + T(2.0) * t) * square0 + T(dt) * t * rate0) +
                    t * t * ((T(3.0) - T(2.0) * t) * square1 - T(dt) * rest * rate1);
  T const turned = select(rate1 < T(0.0), max(between, square1), square1);
  return select(rate0 > T(0.0), turned, square1);
}

template <class T>
inline void at_point(T const (&base)[3], double const* point, T& x, T& y) {
  x = base[0] + T(-point[1]) * base[2];
  y = base[1] + T(point[0]) * base[2];
}

// Absolute acceleration of a diaphragm's centre of mass. Diaphragm 0 is the base.
template <class T>
inline void acceleration_of(Run<T> const& run, StructureArrays const& s, std::size_t diaphragm, T& x, T& y) {
  x = run.A[0], y = run.A[1];
  if (diaphragm == 0) return;
  auto const add = [&](std::size_t i, T& a) ISOLAW_AWAY {
    double const* rigid = s.rigid + 9 * (diaphragm - 1) + 3 * i;
    double const* shape = s.shape + (3 * (diaphragm - 1) + i) * s.modes;
    if (rigid[2] != 0.0) a += T(rigid[2]) * run.A[2];
    for (std::size_t k = 0; k < s.modes; ++k)
      if (shape[k] != 0.0) a += T(shape[k]) * run.qa[k];
  };
  add(0, x);
  add(1, y);
}

// Adds a step to the measures. Suffixes 0 and 1 mean the step's start and end. `run` must be at the end of the step.
// The momenta are those that momentum() returns.
template <class T>
inline void measure(Run<T>& run, StructureArrays const& s, double dt, T const (&u0)[3], T const (&v0)[3],
                    double const (&ground0)[2], double const (&ground1)[2], T const& momentum0_x, T const& momentum0_y,
                    T const& momentum1_x, T const& momentum1_y) {
  using num::abs;
  using num::max;
  Layout const layout{s.floors, s.bearings};
  auto const keep = [&](std::size_t place, T const& value)
                        ISOLAW_AWAY { run.measured[place] = max(run.measured[place], value); };
  auto const index_of = [](Measure which) ISOLAW_AWAY { return static_cast<std::size_t>(which); };

  for (std::size_t c = 0; c <= s.corners; ++c) {
    double const origin[2]{0.0, 0.0};
    double const* point = c < s.corners ? s.corner_at + 2 * c : origin;
    T x0, y0, x1, y1, vx0, vy0, vx1, vy1;
    at_point(u0, point, x0, y0);
    at_point(run.u, point, x1, y1);
    at_point(v0, point, vx0, vy0);
    at_point(run.v, point, vx1, vy1);
    keep(index_of(c < s.corners ? Measure::corner : Measure::centre),
         largest_within<T>(x0 * x0 + y0 * y0, T(2.0) * (x0 * vx0 + y0 * vy0), x1 * x1 + y1 * y1,
                           T(2.0) * (x1 * vx1 + y1 * vy1), dt));
  }
  keep(index_of(Measure::rotation), abs(run.u[2]));
  keep(index_of(Measure::shear), run.f[0] * run.f[0] + run.f[1] * run.f[1]);

  for (std::size_t floor = 0; floor <= s.floors; ++floor) {
    T x, y;
    acceleration_of(run, s, floor, x, y);
    keep(layout.acceleration(floor), x * x + y * y);
  }
  for (std::size_t storey = 0; storey < s.floors; ++storey) {
    T drift[2] = {T(0.0), T(0.0)}, shear[2] = {T(0.0), T(0.0)};
    for (std::size_t i = 0; i < 2; ++i) {
      double const* of_drift = s.deformation + (3 * storey + i) * s.modes;
      double const* of_shear = s.shear + (3 * storey + i) * s.modes;
      for (std::size_t k = 0; k < s.modes; ++k) {
        if (of_drift[k] != 0.0) drift[i] += T(of_drift[k]) * run.q[k];
        if (of_shear[k] != 0.0) shear[i] += T(of_shear[k]) * run.q[k];
      }
    }
    keep(layout.drift(storey), drift[0] * drift[0] + drift[1] * drift[1]);
    keep(layout.storey_shear(storey), shear[0] * shear[0] + shear[1] * shear[1]);
  }

  // Input energy of the step, exact if the ground acceleration and the momentum are linear over the step.
  auto const power = [&](double g0, double g1, T const& p0, T const& p1)
                         ISOLAW_AWAY { return T(-dt / 6.0) * (T(2.0 * g0 + g1) * p0 + T(g0 + 2.0 * g1) * p1); };
  run.measured[index_of(Measure::input)] +=
      power(ground0[0], ground1[0], momentum0_x, momentum1_x) + power(ground0[1], ground1[1], momentum0_y, momentum1_y);
  T rate(0.0);
  for (std::size_t k = 0; k < s.modes; ++k) rate += T(2.0 * s.damping[k] * s.frequency[k]) * run.qv[k] * run.qv[k];
  run.measured[index_of(Measure::damped)] += T(0.5 * dt) * (run.damped_rate + rate);
  run.damped_rate = rate;
}

// Adds the work of a step on bearing j, by the trapezium rule, and keeps the bearing's new displacement and force.
template <class T>
inline void measure_bearing(Run<T>& run, StructureArrays const& s, std::size_t j, T const& x, T const& y, T const& fx,
                            T const& fy) {
  Layout const layout{s.floors, s.bearings};
  T *d = run.d + 2 * j, *f = run.force + 2 * j;
  run.measured[layout.energy(j)] += T(0.5) * ((f[0] + fx) * (x - d[0]) + (f[1] + fy) * (y - d[1]));
  d[0] = x, d[1] = y, f[0] = fx, f[1] = fy;
}

// Updates the largest displacement of every bearing. `run` must be at the end of the step.
template <class T>
inline void measure_displacements(Run<T>& run, StructureArrays const& s, double dt, T const (&u0)[3],
                                  T const (&v0)[3]) {
  using num::max;
  Layout const layout{s.floors, s.bearings};
  for (std::size_t j = 0; j < s.bearings; ++j) {
    double const* point = s.bearing_at + 2 * j;
    T x0, y0, vx0, vy0, vx1, vy1;
    at_point(u0, point, x0, y0);
    at_point(v0, point, vx0, vy0);
    at_point(run.v, point, vx1, vy1);
    T const x1 = run.d[2 * j], y1 = run.d[2 * j + 1];
    T& kept = run.measured[layout.displacement(j)];
    kept = max(kept, largest_within<T>(x0 * x0 + y0 * y0, T(2.0) * (x0 * vx0 + y0 * vy0), x1 * x1 + y1 * y1,
                                       T(2.0) * (x1 * vx1 + y1 * vy1), dt));
  }
}

// Momentum of the whole building along x or y (i = 0, 1), relative to the ground.
template <class T>
inline T momentum(Run<T> const& run, StructureArrays const& s, std::size_t i) {
  T sum(0.0);
  for (std::size_t j = 0; j < 3; ++j)
    if (double const m = s.mass[3 * i + j]; m != 0.0) sum += T(m) * run.v[j];
  for (std::size_t k = 0; k < s.modes; ++k)
    if (double const c = s.participation[3 * k + i]; c != 0.0) sum += T(c) * run.qv[k];
  return sum;
}

// Takes the roots of the measures that are kept as squares, and computes the error of the energy balance. This error is
// the input energy minus the kinetic, strain and damped energies and the bearings' work, divided by the larger of the
// input energy and the bearings' work. An exact integration gives 0.
template <class T>
inline void finish_run(Run<T>& run, StructureArrays const& s) {
  using num::abs;
  using num::max;
  using num::sqrt;
  Layout const layout{s.floors, s.bearings};
  auto const value = [&](Measure which) ISOLAW_AWAY -> T& { return run.measured[static_cast<std::size_t>(which)]; };
  T held(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      if (double const m = s.mass[3 * i + j]; m != 0.0) held += T(0.5 * m) * run.v[i] * run.v[j];
    for (std::size_t k = 0; k < s.modes; ++k)
      if (double const c = s.participation[3 * k + i]; c != 0.0) held += T(c) * run.v[i] * run.qv[k];
  }
  for (std::size_t k = 0; k < s.modes; ++k) {
    T const w(s.frequency[k]);
    held += T(0.5) * (run.qv[k] * run.qv[k] + w * w * run.q[k] * run.q[k]);
  }
  for (std::size_t j = 0; j < s.bearings; ++j) {
    value(Measure::hysteretic) += run.measured[layout.energy(j)];
    value(Measure::isolator) = max(value(Measure::isolator), run.measured[layout.displacement(j)]);
  }
  value(Measure::end) = run.u[0] * run.u[0] + run.u[1] * run.u[1];
  T const left = value(Measure::input) - held - value(Measure::damped) - value(Measure::hysteretic);
  T const size = max(abs(value(Measure::input)), abs(value(Measure::hysteretic)));
  value(Measure::balance) = left / max(size, T(1e-290));
  for (auto const which : {Measure::isolator, Measure::centre, Measure::corner, Measure::end, Measure::shear})
    value(which) = sqrt(value(which));
  for (std::size_t i = layout.acceleration(0); i < layout.energy(0); ++i) run.measured[i] = sqrt(run.measured[i]);
}

// Ground accelerations at equal steps, linear between samples. After the last sample they fall to zero in one interval.
struct Ground {
  double const *x = nullptr, *y = nullptr;  // accelerations along x and y [mm/s2]; y is nullptr without motion along y
  std::size_t samples = 0;
  std::size_t parts = 1;  // integration steps between two samples
  std::size_t steps = 0;  // integration steps of the run
  // If `asked` is set, it is called now and then with `interruption`. The run ends early if it returns true.
  bool (*asked)(void const*) = nullptr;
  void const* interruption = nullptr;

  ISOLAW_AWAY void at(std::size_t step, double (&out)[2]) const {
    std::size_t const i = step / parts, part = step % parts;
    out[0] = between(x, i, part);
    out[1] = y == nullptr ? 0.0 : between(y, i, part);
  }

 private:
  ISOLAW_AWAY double between(double const* values, std::size_t i, std::size_t part) const {
    double const w = static_cast<double>(part) / static_cast<double>(parts);
    double const a = i < samples ? values[i] : 0.0, b = i + 1 < samples ? values[i + 1] : 0.0;
    return part == 0 ? a : a + w * (b - a);
  }
};

// Explicit integration of a building. `inverse` [3][3] is the inverse of Model::condensed_mass().
// force_of(j, x, y, vx, vy, fx, fy) is called once per step for each bearing j, in order. It moves the bearing to its
// displacement (x, y) at the end of the step, sets its force (fx, fy) [kN] at the end, positive along the displacement,
// and advances its state. (vx, vy) is extrapolated from the start of the step, v + dt a, with an error of order dt^2.
template <class T, class Force>
inline void explicit_run(Run<T>& run, StructureArrays const& s, ModeStep const& step, double const* inverse,
                         Ground const& ground, Force const& force_of) {
  double const dt = step.dt;
  double g0[2], g1[2];
  ground.at(0, g0);
  // The building starts at rest and without forces in its bearings, so momentum and absolute accelerations are zero.
  T p0x(0.0), p0y(0.0);
  for (std::size_t n = 0; n < ground.steps; ++n) {
    constexpr std::size_t now_and_then = 4096;
    if (n % now_and_then == now_and_then - 1 && ground.asked != nullptr && ground.asked(ground.interruption)) return;
    ground.at(n + 1, g1);
    T u0[3], v0[3], a0[3], on_base[3];
    for (std::size_t i = 0; i < 3; ++i) {
      u0[i] = run.u[i], v0[i] = run.v[i];
      a0[i] = i < 2 ? run.A[i] + T(-g0[i]) : run.A[i];
      run.u[i] += T(dt) * v0[i] + T(0.5 * dt * dt) * a0[i];
    }
    T speed[3];
    for (std::size_t i = 0; i < 3; ++i) speed[i] = v0[i] + T(dt) * a0[i], run.f[i] = T(0.0);
    for (std::size_t j = 0; j < s.bearings; ++j) {
      double const* point = s.bearing_at + 2 * j;
      T x, y, vx, vy, fx, fy;
      at_point(run.u, point, x, y);
      at_point(speed, point, vx, vy);
      force_of(j, x, y, vx, vy, fx, fy);
      measure_bearing(run, s, j, x, y, fx, fy);
      run.f[0] += fx;
      run.f[1] += fy;
      run.f[2] += T(-point[1]) * fx + T(point[0]) * fy;
    }
    modes_freely(run, s, step, on_base);
    for (std::size_t i = 0; i < 3; ++i) on_base[i] += run.f[i];
    for (std::size_t i = 0; i < 3; ++i) {
      run.A[i] = T(0.0);
      for (std::size_t j = 0; j < 3; ++j)
        if (double const c = inverse[3 * i + j]; c != 0.0) run.A[i] += T(-c) * on_base[j];
    }
    modes_reach(run, s, step);
    for (std::size_t i = 0; i < 3; ++i) {
      T const a1 = i < 2 ? run.A[i] + T(-g1[i]) : run.A[i];
      run.v[i] += T(0.5 * dt) * (a0[i] + a1);
    }
    T const p1x = momentum(run, s, 0), p1y = momentum(run, s, 1);
    measure_displacements(run, s, dt, u0, v0);
    measure(run, s, dt, u0, v0, g0, g1, p0x, p0y, p1x, p1y);
    p0x = p1x, p0y = p1y;
    g0[0] = g1[0], g0[1] = g1[1];
  }
  finish_run(run, s);
}

}  // namespace isolaw::building
