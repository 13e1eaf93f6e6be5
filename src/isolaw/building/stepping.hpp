// What both integrators of a building share, templated on the scalar (double, or a batch with one draw in a lane): the
// modes of the superstructure over one step, and what is measured of a run. Plain arrays alone: this is compiled once
// per instruction set too (fit/kernels.cpp says what that asks for).
//
// Both are Newmark's method with gamma = 1/2 (Newmark 1959): the modes by average acceleration (beta = 1/4), the base
// by average acceleration where its force is found by iteration (integrate.cpp), by central differences (beta = 0)
// where it is that of the displacement reached (explicit_run below). The modes of the next instant are linear in the
// base's acceleration there, so that they leave a constant matrix of three rows in the base's equation. Undamped,
// central differences beside average acceleration are stable for dt^2 K < 4 m with K the bearings' stiffness and m the
// base slab's mass, however stiff the superstructure (Hughes and Liu 1978 for such partitions). The exact response of
// the modes to a base acceleration that varies linearly over the step is not: with 95 % of the mass above and a period
// of three or four steps it grows by a factor of 2.5 a step.
#pragma once

#include <cstddef>

#include "isolaw/num/scalar.hpp"

// Every function that is not made of T must disappear into its caller (num/batch.hpp says why).
#define ISOLAW_AWAY __attribute__((always_inline))

namespace isolaw::building {

// A structure on its bearings as arrays (Structure says what they hold); places relative to the base's centre of mass.
struct StructureArrays {
  std::size_t modes = 0, floors = 0, bearings = 0, corners = 0;
  double const *mass = nullptr, *frequency = nullptr, *damping = nullptr, *participation = nullptr, *shape = nullptr,
               *rigid = nullptr, *deformation = nullptr, *shear = nullptr;
  double const *bearing_at = nullptr, *corner_at = nullptr;  // [..][2], mm
};

// What is measured, in this order: these, then of every diaphragm from the base its acceleration, of every storey its
// shear and its drift, of every bearing its displacement and its energy.
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

// How the modes go over a step of this length: mode k has q''_1 = share_k (free part - participation_k . A_1).
struct ModeStep {
  double dt = 0.0;
  double const* share = nullptr;  // [mode]
};

// Everything that changes over a run. The arrays are the caller's.
template <class T>
struct Run {
  T u[3], v[3], A[3];          // of the base: relative to the ground, and the acceleration in space
  T f[3];                      // of the bearings on the base, at its centre of mass
  T *q, *qv, *qa, *free_part;  // [mode]
  T *d, *force;                // [bearing][2]: displacement and force
  T* measured;                 // [Layout::count()]; peaks as squares until finish()
  T damped_rate;               // power of the damping at the last instant
};
// Scalars that a run needs beside itself.
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

// The free part of every mode at the end of the step, and what all of them do to the base there.
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

// The modes at the end of the step, the base's acceleration there being run.A.
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

// The largest square of a length over a step: at its end, or of the cubic through both ends where it turns between
// them. `rate`: its derivative by time.
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

// The motion of a point of the base.
template <class T>
inline void at_point(T const (&base)[3], double const* at, T& x, T& y) {
  x = base[0] + T(-at[1]) * base[2];
  y = base[1] + T(at[0]) * base[2];
}

// In space, of a diaphragm's centre of mass, the base being the first.
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

// Takes one step's end: `u0`, `v0` and `f0` are of its start, ground accelerations of both ends;
// momenta as momentum() gives them.
template <class T>
inline void measure(Run<T>& run, StructureArrays const& s, double dt, T const (&u0)[3], T const (&v0)[3],
                    double const (&ground0)[2], double const (&ground1)[2], T const& momentum0_x, T const& momentum0_y,
                    T const& momentum1_x, T const& momentum1_y) {
  using num::abs;
  using num::max;
  Layout const layout{s.floors, s.bearings};
  auto const keep = [&](std::size_t place, T const& value)
                        ISOLAW_AWAY { run.measured[place] = max(run.measured[place], value); };
  auto const of = [](Measure which) ISOLAW_AWAY { return static_cast<std::size_t>(which); };

  for (std::size_t c = 0; c <= s.corners; ++c) {
    double const origin[2]{0.0, 0.0};
    double const* at = c < s.corners ? s.corner_at + 2 * c : origin;
    T x0, y0, x1, y1, vx0, vy0, vx1, vy1;
    at_point(u0, at, x0, y0);
    at_point(run.u, at, x1, y1);
    at_point(v0, at, vx0, vy0);
    at_point(run.v, at, vx1, vy1);
    keep(of(c < s.corners ? Measure::corner : Measure::centre),
         largest_within<T>(x0 * x0 + y0 * y0, T(2.0) * (x0 * vx0 + y0 * vy0), x1 * x1 + y1 * y1,
                           T(2.0) * (x1 * vx1 + y1 * vy1), dt));
  }
  keep(of(Measure::rotation), abs(run.u[2]));
  keep(of(Measure::shear), run.f[0] * run.f[0] + run.f[1] * run.f[1]);

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

  // Powers at both ends by the trapezium, but the ground's acceleration times the momentum, both linear over the step,
  // exactly.
  auto const power = [&](double g0, double g1, T const& p0, T const& p1)
                         ISOLAW_AWAY { return T(-dt / 6.0) * (T(2.0 * g0 + g1) * p0 + T(g0 + 2.0 * g1) * p1); };
  run.measured[of(Measure::input)] +=
      power(ground0[0], ground1[0], momentum0_x, momentum1_x) + power(ground0[1], ground1[1], momentum0_y, momentum1_y);
  T rate(0.0);
  for (std::size_t k = 0; k < s.modes; ++k) rate += T(2.0 * s.damping[k] * s.frequency[k]) * run.qv[k] * run.qv[k];
  run.measured[of(Measure::damped)] += T(0.5 * dt) * (run.damped_rate + rate);
  run.damped_rate = rate;
}

// Takes the force of bearing j at its new place, the base's motion being given at both ends of the step.
template <class T>
inline void measure_bearing(Run<T>& run, StructureArrays const& s, std::size_t j, T const& x, T const& y, T const& fx,
                            T const& fy) {
  Layout const layout{s.floors, s.bearings};
  T *d = run.d + 2 * j, *f = run.force + 2 * j;
  run.measured[layout.energy(j)] += T(0.5) * ((f[0] + fx) * (x - d[0]) + (f[1] + fy) * (y - d[1]));
  d[0] = x, d[1] = y, f[0] = fx, f[1] = fy;
}

// The displacement of every bearing over the step; after the velocity at its end is known.
template <class T>
inline void measure_displacements(Run<T>& run, StructureArrays const& s, double dt, T const (&u0)[3],
                                  T const (&v0)[3]) {
  using num::max;
  Layout const layout{s.floors, s.bearings};
  for (std::size_t j = 0; j < s.bearings; ++j) {
    double const* at = s.bearing_at + 2 * j;
    T x0, y0, vx0, vy0, vx1, vy1;
    at_point(u0, at, x0, y0);
    at_point(v0, at, vx0, vy0);
    at_point(run.v, at, vx1, vy1);
    T const x1 = run.d[2 * j], y1 = run.d[2 * j + 1];
    T& kept = run.measured[layout.displacement(j)];
    kept = max(kept, largest_within<T>(x0 * x0 + y0 * y0, T(2.0) * (x0 * vx0 + y0 * vy0), x1 * x1 + y1 * y1,
                                       T(2.0) * (x1 * vx1 + y1 * vy1), dt));
  }
}

// Momentum of all along x or y (i), relative to the ground.
template <class T>
inline T momentum(Run<T> const& run, StructureArrays const& s, std::size_t i) {
  T made(0.0);
  for (std::size_t j = 0; j < 3; ++j)
    if (double const m = s.mass[3 * i + j]; m != 0.0) made += T(m) * run.v[j];
  for (std::size_t k = 0; k < s.modes; ++k)
    if (double const c = s.participation[3 * k + i]; c != 0.0) made += T(c) * run.qv[k];
  return made;
}

// Lengths from their squares, and the balance: what is left of the input that is neither moving, strained, damped nor
// taken by the bearings, over the larger of the input and what they took.
template <class T>
inline void finish_run(Run<T>& run, StructureArrays const& s) {
  using num::abs;
  using num::max;
  using num::sqrt;
  Layout const layout{s.floors, s.bearings};
  auto const at = [&](Measure which) ISOLAW_AWAY -> T& { return run.measured[static_cast<std::size_t>(which)]; };
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
    at(Measure::hysteretic) += run.measured[layout.energy(j)];
    at(Measure::isolator) = max(at(Measure::isolator), run.measured[layout.displacement(j)]);
  }
  at(Measure::end) = run.u[0] * run.u[0] + run.u[1] * run.u[1];
  T const left = at(Measure::input) - held - at(Measure::damped) - at(Measure::hysteretic);
  T const size = max(abs(at(Measure::input)), abs(at(Measure::hysteretic)));
  at(Measure::balance) = left / max(size, T(1e-290));
  for (auto const which : {Measure::isolator, Measure::centre, Measure::corner, Measure::end, Measure::shear})
    at(which) = sqrt(at(which));
  for (std::size_t i = layout.acceleration(0); i < layout.energy(0); ++i) run.measured[i] = sqrt(run.measured[i]);
}

// Ground accelerations at equal steps, linear between them, and zeros after.
struct Ground {
  double const *x = nullptr, *y = nullptr;  // mm/s2; y may be missing
  std::size_t samples = 0;
  std::size_t parts = 1;  // steps in an interval of the samples
  std::size_t steps = 0;  // of the run

  ISOLAW_AWAY void at(std::size_t step, double (&out)[2]) const {
    std::size_t const i = step / parts, part = step % parts;
    out[0] = between(x, i, part);
    out[1] = y == nullptr ? 0.0 : between(y, i, part);
  }

 private:
  ISOLAW_AWAY double between(double const* values, std::size_t i, std::size_t part) const {
    double const w = static_cast<double>(part) / static_cast<double>(parts);
    double const a = i < samples ? values[i] : 0.0, b = i + 1 < samples ? values[i + 1] : 0.0;
    // The last sample stays until the next would come: it falls to zero over one interval.
    return part == 0 ? a : a + w * (b - a);
  }
};

// The explicit path. `inverse`: of the base's constant matrix M - sum share participation participation^T, [3][3].
// force_of(j, x, y, fx, fy, vx, vy, dt): of bearing j at its new displacement, with a velocity that is good to the
// second order; it keeps the bearing's state.
template <class T, class Force>
inline void explicit_run(Run<T>& run, StructureArrays const& s, ModeStep const& step, double const* inverse,
                         Ground const& ground, Force const& force_of) {
  double const dt = step.dt;
  double g0[2], g1[2];
  ground.at(0, g0);
  // At rest with no force, the whole has no acceleration in space until the ground has moved away under it.
  T p0x(0.0), p0y(0.0);
  for (std::size_t n = 0; n < ground.steps; ++n) {
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
      double const* at = s.bearing_at + 2 * j;
      T x, y, vx, vy, fx, fy;
      at_point(run.u, at, x, y);
      at_point(speed, at, vx, vy);
      force_of(j, x, y, vx, vy, fx, fy);
      measure_bearing(run, s, j, x, y, fx, fy);
      run.f[0] += fx;
      run.f[1] += fy;
      run.f[2] += T(-at[1]) * fx + T(at[0]) * fy;
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
