// Gallardo: an elastic part that softens with the travel on each side of x = 0, and Bouc-Wen's hysteresis, in which
// each turning point sets the strength of the branch that begins there.
// Source: Gallardo, de la Llera, Restrepo and Chen 2023, with the authors' programs; docs/laws.md. The source's strain
// is x over the height of the rubber; this file divides x by 100 mm, and uy is a displacement. Units kN, mm. Step:
// exact. The softening of the elastic part depends on the displacement alone (Memory). The hysteretic variable z
// follows one equation in unloading (z dx < 0) and another in loading (z dx > 0). In unloading it is divided by one
// strength for all branches, in loading by the strength of its branch. The quotient then follows one curve
// (saturating_flow.hpp) that does not depend on the turning points.
#pragma once

#include "isolaw/laws/flows/flow.hpp"
#include "isolaw/laws/law.hpp"
#include "isolaw/laws/memory/softening.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"
#include "isolaw/laws/parts/reference.hpp"

namespace isolaw::laws {

// The coefficient c with which c (x/100 mm)^power equals the record's stiffness times x at its largest displacement x.
template <int power>
double coefficient_at_reference(RecordScales const& s) {
  return s.stiffness * reference_mm * std::pow(reference_mm / s.disp, power - 1);
}

// The rate f for which f (x/100 mm)^p is 1 at the largest displacement, if p has its usual value of 1/2.
inline double rate_at_reference(RecordScales const& s) {
  return std::sqrt(reference_mm / s.disp);
}

struct Gallardo {
  static constexpr LawInfo info{
      .id = "gallardo",
      .name = "Gallardo",
      .title = "Gallardo, softening elastic part and hysteresis",
      .source = "Gallardo, de la Llera, Restrepo and Chen 2023, Eqs. of the shear model, with the authors' programs",
      .force = kN,
      .length = mm,
      .traits = {.rate_independent = true, .remembers = true, .exact_flow = true},
      .formula =
          "F = k1 (km a1 g - k2 a2 g^3 + k3 a3 g^5) + fy z,   g = x/100\n"
          "k1 = exp(-fs1 G^ps1),   k2 = exp(-fs2 G^ps2),   k3 = exp(-fs3 G^ps3),   km = exp(-fm C^pm)\n"
          "G, C of the side of x: dG = |dg|/2 outwards and 4 |dg| back, never beyond the largest |g| there; dC = |dg| back\n"
          "uy dz/dx = 1 - |z|^n (B s + 1 - B - phi (1 + s)),   s = sgn(z dx)\n"
          "phi = phimax (1 - exp(-pphi |xt - uy| / uy)) from where z passes 0, xt the last turn before; 0 until then",
      .note =
          "Made for high damping rubber bearings. If pm is below 1, the softening by C^pm has an infinite slope when the device first comes back from a peak on a new side. Noise in a hold there may move the force visibly, unless the dead band keeps the noise out. The forces of the published programs depend on the step, by 0.1 % of the peak force with a hundred steps from one turn to the next; this law is their limit for small steps. One of the programs has the opposite sign of a2. The term |xt - uy| is as published. Because of it a mirrored motion gives another force, above all after turns within a few yield displacements. a2, fs2, ps2 and B are fixed unless you free them. On a record that softens as a power of its amplitude, a1 and fs1 grow together as ps1 falls, until the search box stops them. Beyond the tests the force of the first push to a new amplitude grows with x^5. Fitted to a bearing that was tested to 152 mm and 264 kN, the law gives 665 kN at twice and 3900 kN at five times that displacement; in later cycles it gives 463 and 817 kN.",
      .step_cost = 451};

  template <class T>
  struct Params {
    T a1, a2, a3, fs1, ps1, fs2, ps2, fs3, ps3, fm, pm, uy, fy, B, n, phimax, pphi;
  };

  template <class T>
  static constexpr auto rows = std::to_array<Row<T, Params<T>>>({
      {&Params<T>::a1, parameter("a1", "kN", "elastic force linear in x, at 100 mm", any_value, std::nullopt,
                                 {0.3, 15.0, coefficient_at_reference<1>}, Scale::logarithmic)},
      {&Params<T>::a2, parameter("a2", "kN", "elastic force cubic in x, at 100 mm; it is subtracted", any_value,
                                 std::nullopt, {0.0, 5.0, coefficient_at_reference<3>}, Scale::linear, 0.0)},
      {&Params<T>::a3, parameter("a3", "kN", "elastic force of the fifth power of x, at 100 mm", any_value,
                                 std::nullopt, {0.05, 500.0, coefficient_at_reference<5>}, Scale::logarithmic)},
      {&Params<T>::fs1, parameter("fs1", "1", "rate at which the whole elastic force softens with G", not_negative,
                                  std::nullopt, {0.05, 5.0, rate_at_reference}, Scale::logarithmic)},
      {&Params<T>::ps1, parameter("ps1", "1", "exponent of fs1's softening", positive, std::nullopt, {0.05, 1.5, one})},
      {&Params<T>::fs2, parameter("fs2", "1", "rate at which the cubic part softens further with G", not_negative,
                                  std::nullopt, {10.0, 40.0, rate_at_reference}, Scale::linear, 20.0)},
      {&Params<T>::ps2, parameter("ps2", "1", "exponent of fs2's softening", positive, std::nullopt, {0.1, 1.0, one},
                                  Scale::linear, 0.3)},
      {&Params<T>::fs3, parameter("fs3", "1", "rate at which the part of the fifth power softens further with G",
                                  not_negative, std::nullopt, {0.1, 10.0, rate_at_reference}, Scale::logarithmic)},
      {&Params<T>::ps3, parameter("ps3", "1", "exponent of fs3's softening", positive, std::nullopt, {0.05, 1.5, one})},
      {&Params<T>::fm, parameter("fm", "1", "rate at which the linear part softens with C", not_negative, std::nullopt,
                                 {0.005, 1.0, rate_at_reference}, Scale::logarithmic)},
      {&Params<T>::pm, parameter("pm", "1", "exponent of fm's softening", positive, std::nullopt, {0.05, 1.5, one})},
      {&Params<T>::uy,
       parameter("uy", "mm", "yield displacement", positive, std::nullopt, {0.002, 0.2, disp}, Scale::logarithmic)},
      {&Params<T>::fy,
       parameter("fy", "kN", "hysteretic force at z = 1", not_negative, std::nullopt, {0.05, 2.0, strength})},
      {&Params<T>::B,
       parameter("B", "1", "shape of the loop: if it is above 1/2, unloading is stiffer than the first loading",
                 positive, std::nullopt, {0.6, 1.0, one}, Scale::linear, 1.0)},
      {&Params<T>::n, parameter("n", "1", "sharpness of yielding", positive, std::nullopt, {0.15, 1.0, one})},
      {&Params<T>::phimax,
       parameter("phimax", "1", "largest temporary hardening", Interval{0.0, 0.49}, std::nullopt, {0.0, 0.3, one})},
      {&Params<T>::pphi,
       parameter("pphi", "1",
                 "rate at which the hardening grows with the displacement of the last turn, in yield displacements",
                 not_negative, std::nullopt, {0.001, 0.2, one}, Scale::logarithmic)},
  });

  // With B <= phimax, unloading from the strongest branch would come to rest before z passes 0.
  static constexpr std::array joint_limits{
      JointLimit<Params<double>>{"B > phimax", [](Params<double> const& p) { return p.B > p.phimax; }}};

  static Canonical canonical(Params<double> const&) {
    return NoForm{
        "elastic part that softens with the distance travelled, nor its strength that each turning point sets"};
  }
  static Params<double> with_factors(Params<double> p, double a, double b) {
    p.a1 *= a;
    p.a2 *= a;
    p.a3 *= a;
    p.fy *= b;
    return p;
  }

  // `isolaw export` copies the lines up to [end] to C++ files, in the struct named below (programs/header_parts.cpp):
  // [export struct Gallardo]
  // On one side of x = 0 the elastic force is km linear g - cubic g^3 + quintic g^5, with g = x / 100 mm.
  template <class N>
  struct Side {
    N linear = N(0.0), cubic = N(0.0), quintic = N(0.0), km = N(1.0);
    template <class Each>
    void members(Each& each) {
      each(linear, cubic, quintic, km);
    }
  };
  template <class N>
  struct State {
    Side<N> sides[2];
    N z = N(0.0);
    // The strength (see strength_at) of the branch that z was on at the last turn of the motion, and of the branch that
    // z is on once it has passed 0 after that turn.
    N strength_at_turn = N(1.0), strength_past_zero = N(1.0);
    // The travel [yield displacements uy] at the last turn and at present, counted from the place at which z passes 0.
    // It is negative before this place.
    N travel_at_turn = N(0.0), travel = N(0.0);
    double turn_x = 0.0;  // displacement of the last turn
    template <class Each>
    void members(Each& each) {
      each(sides[0], sides[1], z, strength_at_turn, strength_past_zero, travel_at_turn, travel, turn_x);
    }
  };
  template <class X>
  using Memory = Remembered<X, Softening<X>>;
  // z, taken positive in the direction of motion, is `strongest` times the u of `flow` until z passes 0. From there on
  // it is State::strength_past_zero times u.
  template <class T, class X>
  struct Constants {
    T per_uy;     // 1 / uy
    T strongest;  // the largest strength that a branch can have; it belongs to phi = phimax
    Flow<T, X, Reach::within_saturation> flow;
    T zero;  // the t at which the curve u(t) of `flow` passes u = 0
  };
  template <class T, class X>
  static Constants<T, X> constants(Params<T> const& p) {
    Constants<T, X> c;
    c.per_uy = T(1.0) / p.uy;
    c.strongest = strength_at(p, p.phimax);
    // In unloading, uy dz/dx = 1 + (2 B - 1) |z|^n = 1 + (2 B - 1) strongest^n |u|^n, where u = z / strongest and
    // strongest^n = 1 / (1 - 2 phimax).
    c.flow.fit(p.n, (T(2.0) * p.B - T(1.0)) / (T(1.0) - T(2.0) * p.phimax));
    c.zero = c.flow.time_at(T(0.0));
    return c;
  }

  template <class T, class X, class N>
  static void start(Params<T> const& p, Constants<T, X> const&, State<N>& state, StepOf<X> const&) {
    for (Side<N>& side : state.sides) {
      side.linear = p.a1;
      side.cubic = p.a2;
      side.quintic = p.a3;
    }
  }

  template <class T, class X, class N, class PathMemory>
  static N step(Params<T> const& p, Constants<T, X> const& c, State<N>& state, StepOf<X> const& step,
                PathMemory const& memory) {
    if (memory.turns) turn(p, c, state, value_of(step.x0), memory.direction);
    N const direction(memory.direction);
    state.travel = state.travel_at_turn + N(memory.direction * (step.x1 - state.turn_x)) * c.per_uy;
    N const scale = select(state.travel > N(0.0), state.strength_past_zero, N(c.strongest));
    state.z = direction * scale * c.flow.value_at(c.zero + state.travel / scale);
    return rounded(p.fy * state.z) + elastic(p, state.sides[memory.side], step.x1, memory);
  }

  // The strength of a branch: the z at which its dz/dx is 0.
  template <class T>
  static T strength_at(Params<T> const& p, T const& phi) {
    return exp2(-log2(T(1.0) - T(2.0) * phi) / p.n);
  }

  // Must be called when the motion turns at x and goes on in `direction`. Sets the strength by which z is divided after
  // it passes 0, and the place on the curve of `flow` from which z goes on.
  template <class T, class X, class N>
  static void turn(Params<T> const& p, Constants<T, X> const& c, State<N>& state, double x, double direction) {
    N const none(0.0), z = N(direction) * state.z;
    state.strength_at_turn = select(state.travel > none, state.strength_past_zero, state.strength_at_turn);
    T const phi = p.phimax * (T(1.0) - exp(-p.pphi * abs(T(x) - p.uy) * c.per_uy));
    // If the motion turns back before z has passed 0, z returns to the branch that it left.
    state.strength_past_zero = select(z > none, state.strength_at_turn, N(strength_at(p, phi)));
    N const scale = select(z > none, state.strength_at_turn, N(c.strongest));
    state.travel_at_turn = scale * (c.flow.time_at(z / scale) - c.zero);
    state.turn_x = x;
  }

  template <class T, class X, class N, class PathMemory>
  static N elastic(Params<T> const& p, Side<N>& side, X const& x, PathMemory const& memory) {
    constexpr double log2_reference = 6.64385618977472470;  // log2 of reference_mm, 100 mm
    if (memory.softens) {
      N const G(memory.log2_softening - log2_reference);
      T const rate(-log2_e);
      N const all = rate * p.fs1 * exp2(p.ps1 * G);
      side.linear = p.a1 * exp2(all);
      side.cubic = p.a2 * exp2(all + rate * p.fs2 * exp2(p.ps2 * G));
      side.quintic = p.a3 * exp2(all + rate * p.fs3 * exp2(p.ps3 * G));
    }
    if (memory.returns) side.km = exp(-p.fm * exp2(p.pm * N(memory.log2_way_back - log2_reference)));
    X const g = x / reference_mm, g2 = g * g;
    return N(g) * (rounded(side.km * side.linear) + N(g2) * (N(g2) * side.quintic - side.cubic));
  }
  // [end]
};

}  // namespace isolaw::laws
