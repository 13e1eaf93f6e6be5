// Parts that the laws `abe` and `abe-y0` share: the parameters, the elastic forces F1 and F3, and the length of a
// motion in multiples of the yield displacement Ut. abe.hpp gives the equations and their source.
#pragma once

#include <cmath>

#include "isolaw/laws/law.hpp"
#include "isolaw/laws/parts/canonical.hpp"
#include "isolaw/laws/parts/limits.hpp"

namespace isolaw::laws {

namespace abe_parts {

inline constexpr ParameterInfo K1_info =
    parameter("K1", "kN/mm", "initial elastic stiffness", any_value, Interval{5.0, 10.0}, {0.5, 20.0, stiffness});
inline constexpr ParameterInfo alpha_info =
    parameter("alpha", "mm", "peak displacement over which the elastic stiffness decays", not_negative,
              Interval{0.0, 10.0}, {0.001, 1.0, disp}, Scale::logarithmic);
inline constexpr ParameterInfo beta_info = parameter("beta", "1", "share of the elastic stiffness that remains",
                                                     any_value, Interval{0.01, 1.0}, {0.01, 1.0, one});
inline constexpr ParameterInfo a_info = parameter("a", "kN", "force of the rounded step at zero displacement",
                                                  any_value, Interval{0.5, 1.0}, {0.0, 0.2, force});
inline constexpr ParameterInfo b_info =
    parameter("b", "1/mm", "rate at which the rounded step grows with displacement", not_negative, Interval{5.0, 10.0},
              {2.0, 2000.0, per_disp}, Scale::logarithmic);
inline constexpr ParameterInfo n_info =
    parameter("n", "1", "sharpness of yielding", positive, Interval{0.01, 0.5}, {0.01, 1.0, one});
inline constexpr ParameterInfo Y0_info =
    parameter("Y0", "kN", "yield force", positive, Interval{10.0, 70.0}, {0.02, 0.8, force});
inline constexpr ParameterInfo Uh_info =
    parameter("Uh", "mm", "displacement at which hardening begins", positive, Interval{50.0, 150.0}, {0.2, 4.0, disp})
        .in_paper("X_h");
inline constexpr ParameterInfo U0_info =
    parameter("U0", "mm", "yield displacement", positive, Interval{2.0, 6.0}, {0.005, 0.3, disp}, Scale::logarithmic)
        .in_paper("X_0");
inline constexpr ParameterInfo Us_info =
    parameter("Us", "mm", "peak displacement over which the yield displacement grows", positive, Interval{5.0, 50.0},
              {0.01, 3.0, disp}, Scale::logarithmic)
        .in_paper("X_s");
inline constexpr ParameterInfo K2_info =
    parameter("K2", "kN/mm", "hardening stiffness", any_value, Interval{0.01, 0.5}, {0.0, 1.2, stiffness});
inline constexpr ParameterInfo r_info =
    parameter("r", "1", "exponent of the hardening force", not_negative, Interval{0.01, 0.2}, {0.01, 2.0, one});

inline constexpr NoForm beyond_programs{"yield force and displacement, which change with the peak so far"};

// `isolaw export` copies the lines up to [end] to C++ files, in this namespace (programs/header_parts.cpp):
// [export namespace abe_parts]
template <class T>
struct Constants {
  T log2_Uh, inverse_U0, Us_over_U0;
};
template <class T, class Params>
inline Constants<T> constants(Params const& p) {
  return {log2(p.Uh), T(1.0) / p.U0, p.Us / p.U0};
}

// The quantities that change only when the peak displacement grows.
template <class N>
struct Softened {
  N K1_now = N(0.0);      // elastic stiffness: K1 as softened by the peak so far [kN/mm], softened_K1()
  N inverse_Ut = N(0.0);  // 1 / yield displacement Ut, which grows with the peak [1/mm]
  template <class Each>
  void members(Each& each) {
    each(K1_now, inverse_Ut);
  }
};
// K1 [beta + (1 - beta) exp(-peak / alpha)]. With alpha = 0 the first motion removes the whole softening part.
template <class T, class N, class Params>
inline N softened_K1(Params const& p, N const& peak) {
  N const left = select(p.alpha <= T(0.0), select(peak > N(0.0), N(0.0), N(1.0)),
                        exp(-peak / max(p.alpha, T(smallest_power_base))));
  return p.K1 * (p.beta + (T(1.0) - p.beta) * left);
}
template <class T, class X, class N, class Params>
inline void follow_peak(Params const& p, Constants<T> const& c, Softened<N>& softened, X const& peak) {
  N const Umax(peak);
  softened.K1_now = softened_K1<T, N>(p, Umax);
  softened.inverse_Ut = c.inverse_U0 / (T(1.0) + Umax / p.Us);
}

// The integral of |dx| / Ut over a straight piece of the path. `softened` holds the values at the start of the piece;
// the yield displacement Ut grows only where the path goes beyond the earlier peak.
template <class T, class X, class N, class Params>
inline N travel(Params const& p, Constants<T> const& c, Softened<N> const& softened, X const& length, X const& peak0,
                X const& peak1) {
  X const growth = peak1 - peak0;
  N travelled = rounded(softened.inverse_Ut * N(length - growth));
  if (grows(growth)) {
    constexpr double ln2 = 0.69314718055994530942;
    travelled += c.Us_over_U0 * T(ln2) * log2((p.Us + N(peak1)) / (p.Us + N(peak0)));
  }
  return travelled;
}

// The elastic forces F1 + F3 at the end of the step. The caller must have called follow_peak for the peak at that end.
template <class T, class X, class N, class Params>
inline N elastic_force(Params const& p, Constants<T> const& c, Softened<N> const& softened, StepOf<X> const& step) {
  if (step.x1 == 0.0) return slope_alone(step.x1, softened.K1_now + p.a * p.b + select(p.r > T(0.0), T(0.0), p.K2));
  N const x(step.x1), sign(step.x1 > 0.0 ? 1.0 : -1.0);
  N const F1 = rounded(softened.K1_now * x) + p.a * sign * (T(1.0) - exp(-p.b * abs(x)));
  N const F3 = p.K2 * x * exp2(p.r * (N(log2_abs_x1(step)) - c.log2_Uh));
  return F1 + F3;
}
// [end]

// The quantities in dF2/dx, Eq. (18), that depend on the point of the path.
template <class T>
struct Point {
  T Yt, per_Yt, inverse_Ut;
};
template <class T>
T hysteretic_slope(T const& F2, Point<T> const& at, T const& n, T const& direction) {
  T const ratio = power(abs(F2 * at.per_Yt), n);
  return at.Yt * at.inverse_Ut * (T(1.0) - select(direction * F2 < T(0.0), -ratio, ratio));
}

// 1 / Ut where the path is at x; Ut is the yield displacement. `softened` holds the values for peak0, the earlier peak.
template <class T, class Params>
T inverse_Ut_at(Params const& p, Constants<T> const& c, Softened<T> const& softened, double x, double peak0) {
  return std::abs(x) <= peak0 ? softened.inverse_Ut : c.inverse_U0 / (T(1.0) + T(std::abs(x)) / p.Us);
}

}  // namespace abe_parts

}  // namespace isolaw::laws
