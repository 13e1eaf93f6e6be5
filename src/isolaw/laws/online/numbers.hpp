// Dual is the type of number for a motion that is not known ahead. The lines between [export] and [end] are part of
// every exported file, so they are C++17 and need nothing but the standard library (programs/header_parts.hpp).
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

// The formatter is off, since it would spread each operation over several lines.
// clang-format off
// [export]
// A number with its derivatives by the displacement and the velocity of the trial. They give every law its consistent
// tangent.
struct Dual {
  double v = 0.0, by_x = 0.0, by_v = 0.0;

  Dual() = default;
  Dual(double value) : v(value) {}
  Dual(double value, double dx, double dv) : v(value), by_x(dx), by_v(dv) {}
};
inline Dual chain(Dual const& a, double value, double slope) { return {value, slope * a.by_x, slope * a.by_v}; }
inline Dual operator-(Dual const& a) { return {-a.v, -a.by_x, -a.by_v}; }
inline Dual operator+(Dual const& a, Dual const& b) { return {a.v + b.v, a.by_x + b.by_x, a.by_v + b.by_v}; }
inline Dual operator-(Dual const& a, Dual const& b) { return {a.v - b.v, a.by_x - b.by_x, a.by_v - b.by_v}; }
inline Dual operator*(Dual const& a, Dual const& b) {
  return {a.v * b.v, a.by_x * b.v + a.v * b.by_x, a.by_v * b.v + a.v * b.by_v};
}
inline Dual operator*(double a, Dual const& b) { return {a * b.v, a * b.by_x, a * b.by_v}; }
inline Dual operator*(Dual const& a, double b) { return b * a; }
inline Dual operator/(Dual const& a, Dual const& b) {
  double const q = a.v / b.v;
  return {q, (a.by_x - q * b.by_x) / b.v, (a.by_v - q * b.by_v) / b.v};
}
inline Dual& operator+=(Dual& a, Dual const& b) { return a = a + b; }
inline bool operator<(Dual const& a, Dual const& b) { return a.v < b.v; }
inline bool operator>(Dual const& a, Dual const& b) { return a.v > b.v; }
inline bool operator==(Dual const& a, Dual const& b) { return a.v == b.v; }
inline Dual abs(Dual const& a) { return a.v < 0.0 ? -a : a; }
// If both arguments are equal, min and max return the first one, with its derivatives.
inline Dual min(Dual const& a, Dual const& b) { return b < a ? b : a; }
inline Dual max(Dual const& a, Dual const& b) { return a < b ? b : a; }
inline Dual select(bool condition, Dual const& a, Dual const& b) { return condition ? a : b; }
inline Dual exp(Dual const& a) {
  double const e = std::exp(a.v);
  return chain(a, e, e);
}
inline Dual log(Dual const& a) { return chain(a, std::log(a.v), 1.0 / a.v); }
inline Dual exp2(Dual const& a) {
  double const e = std::exp2(a.v);
  return chain(a, e, 0.69314718055994530942 * e);
}
inline Dual log2(Dual const& a) { return chain(a, std::log2(a.v), 1.44269504088896340736 / a.v); }
inline Dual sqrt(Dual const& a) {
  double const root = std::sqrt(a.v);
  return chain(a, root, root > 0.0 ? 0.5 / root : 0.0);
}

inline Dual erf(Dual const& a) { return chain(a, std::erf(a.v), 1.1283791670955126 * std::exp(-a.v * a.v)); }
inline Dual power(Dual const& x, Dual const& exponent) { return exp2(exponent * log2(max(x, smallest_power_base))); }
// 1 / cosh^2(u), from exp(-2 |u|), which cannot overflow.
inline Dual sech_squared(Dual const& u) {
  Dual const e = exp(-2.0 * abs(u));
  return 4.0 * e / ((1.0 + e) * (1.0 + e));
}

// The number 0 with `slope` as its derivative by `variable`, for a term that is 0 here and still counts in the tangent.
inline Dual slope_alone(Dual const& variable, Dual const& slope) { return chain(variable, 0.0, slope.v); }

// `part` is a term of `result`. Limits the size of its slope by displacement to the size of `steepest`, and changes the
// slope of `result` accordingly.
template <class Part, class Steepest>
inline void limit_slope(Dual& result, Part&& part, Steepest&& steepest) {
  double const slope = Dual(part()).by_x, most = std::abs(Dual(steepest()).v);
  result.by_x += slope > most ? most - slope : slope < -most ? -most - slope : 0.0;
}
// `power` is size^exponent. If the exponent is just above 1, the slope is 0 at size 0 but close to 1 at any visible
// size. A size below 1e-6 therefore gets the slope of the secant from 0 to 1e-6.
template <class Exponent>
inline void use_secant_near_zero(Dual& power, Dual const& size, Exponent&& exponent) {
  if (size.v < 1e-6) power.by_x = size.by_x * std::pow(1e-6, Dual(exponent()).v - 1.0);
}
// Returns `value`, with slope() as its derivative by x.
template <class Slope>
inline Dual through(Dual const& x, double value, Slope&& slope) { return chain(x, value, slope()); }

// Whether a peak grows. The answer is true also for a trial that ends exactly at the peak: its tangent must include the
// growth that a further motion brings.
inline bool grows(Dual const& growth) { return growth.v > 0.0 || growth.by_x != 0.0; }
inline bool reaches(Dual const& size, Dual const& peak) { return size.v >= peak.v && size.v > 0.0; }
// The tangent needs all derivatives, so a trial counts as a motion, and its values as changed, even at rest.
inline bool may_move(Dual const&) { return true; }
inline bool changes(Dual const&, Dual const&) { return true; }
inline double value_of(Dual const& a) { return a.v; }

// One step of a trial, in the law's units: displacement and velocity before and after, the change of displacement, its
// size, and the largest |displacement| up to the start and up to the end of the step.
template <>
struct StepOf<Dual> {
  Dual x0, x1, v0, v1, dx, length;
  double direction = 0.0;  // direction of the step, +1 or -1
  bool reversal = false;   // whether `direction` is opposite to that of the step before
  Dual peak0, peak1;
};
// A trial at rest needs a tangent too, so every trial counts as a motion.
inline bool moves(StepOf<Dual> const&) { return true; }
inline Dual log2_abs_x1(StepOf<Dual> const& step) { return log2(max(abs(step.x1), smallest_power_base)); }

// Calls act() with each number of a state; every part of the state lists its members. Derivatives are removed, because
// a committed state has none.
template <class Act>
class Members {
 public:
  explicit Members(Act act) : act_(act) {}
  template <class... Parts>
  void operator()(Parts&... parts) {
    (one(parts), ...);
  }
  // Whether every number that was read as the length of a list, or as true or false, was a valid one.
  bool sound() const { return sound_; }

 private:
  void one(double& x) { act_(x); }
  void one(Dual& x) {
    double value = x.v;
    act_(value);
    x = value;
  }
  void one(bool& x) {
    double value = x ? 1.0 : 0.0;
    act_(value);
    sound_ = sound_ && (value == 0.0 || value == 1.0);
    x = value == 1.0;
  }
  template <class Part>
  void one(std::vector<Part>& list) {
    double count = static_cast<double>(list.size());
    act_(count);
    sound_ = sound_ && count >= 0.0 && count <= 1e6 && count == std::floor(count);
    if (!sound_) return;
    list.resize(static_cast<std::size_t>(count));
    for (Part& part : list) one(part);
  }
  template <class Part>
  void one(Part& part) {
    part.members(*this);
  }

  Act act_;
  bool sound_ = true;
};
// [end]
// clang-format on

}  // namespace isolaw::laws
