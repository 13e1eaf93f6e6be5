// The exact flow of the hysteretic laws between two reversals.
//
// Bouc-Wen's z and Abe's F2, divided by their saturation value and taken positive in the direction of motion, obey one
// autonomous equation in dimensionless travel t:
//     du/dt = 1 - u^n            for u >= 0  (from both sides towards saturation, u = 1)
//     du/dt = 1 + kappa |u|^n    for u <  0  (unloading, u rises to 0)
// Every device history between reversals is a piece of one curve u(t), so it is tabulated once per candidate and each
// sample costs a lookup, however large the step: no step size, no stability limit, no power per sample.
//
// Nodes are graded geometrically towards u = 0, where u^n is not smooth for n < 1, and towards saturation on both sides;
// times between nodes by four-point Lobatto quadrature, u(t) within a cell by the quintic that takes value, slope and
// curvature at both ends.
// Largest error in u over n in [0.01, 3]: below 1e-5 for kappa in [-1/2, 3]; below 1e-5 / (2 (1 + kappa)) down to
// kappa = -0.99, where the equation itself magnifies what happens near u = -1 (tests/verification).
// The table costs about 500 powers.
// Rejected: Runge-Kutta with sub-steps (32 per sample still leave 3.8 % in the objective of abe near its optimum), and an
// exponential step with frozen exponent (first order where n < 1 and u crosses 0).
#pragma once

#include <cmath>
#include <limits>
#include <utility>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

// Whether |u| can exceed 1, as it does where the saturation value itself shrinks (abe).
enum class Reach { within_saturation, beyond_saturation };

namespace flow_parts {

// Fixed nodes and what the quadrature of each cell needs. `key` ascends with time along the curve: it is u itself on
// the rising piece, and falling_origin - u on the piece that falls to saturation from above, so that one search serves
// both.
template <std::size_t Count>
struct Nodes {
  std::array<double, Count> key{};
  std::array<double, Count> inverse_abs_u{};
  std::array<double, Count> log2_abs_u{};
  std::array<double, Count - 1> inverse_rise{};  // 1 / (key[i+1] - key[i])
  struct Cell {
    std::array<double, 2> log2_abs_u{};  // at the two inner Lobatto points
    std::array<double, 4> weight{};      // |du| of the four points, in order
  };
  std::array<Cell, Count - 1> cells{};
};

struct Point {
  double u, slope, log2_abs_u;  // slope: du/dw of the grading
};

inline constexpr double inverse_ln2 = 1.44269504088896340736;
inline constexpr double spacing = 1.0 / 3.0;  // of w, in all gradings
inline constexpr double smallest_w = -12.0;   // |u| = 6e-6: between -6e-6 and 6e-6 the curve is a straight line
inline constexpr double largest_w = 16.0;     // |1 - u| = 1e-7: closer to saturation u stays there
inline constexpr double unloading_w = 14.0;   // |1 + u| = 8e-7: where unloading starts within saturation
inline constexpr double reach_w = 4.0;        // |u| = 55: beyond, the rate is frozen at its value there
inline constexpr double falling_origin =
    60.0;  // keys of the falling piece, 4.4 to 59, lie above those of the rising one

inline Point below_zero(double w) {  // |u| = e^w
  return {-std::exp(w), std::exp(w), w * inverse_ln2};
}
inline Point below_one(double w) {  // u = 1 / (1 + e^-w)
  double const e = std::exp(-w), u = 1.0 / (1.0 + e);
  return {u, u * u * e, -std::log1p(e) * inverse_ln2};
}
inline Point above_minus_one(double w) {  // u = -1 / (1 + e^-w)
  Point p = below_one(w);
  p.u = -p.u;
  return p;
}
inline Point above_one(double w) {  // u = 1 + e^w
  double const e = std::exp(w);
  return {1.0 + e, e, std::log1p(e) * inverse_ln2};
}

// Appends the nodes of one grading, w from `first` to `last` (either way), to `nodes` from index `at` on.
template <std::size_t Count, class Grading>
std::size_t append(Nodes<Count>& nodes, std::size_t at, Grading grading, double first, double last) {
  constexpr double inner = 0.27639320225002103;  // (1 - 1/sqrt(5)) / 2
  int const cells = static_cast<int>(std::lround(std::abs(last - first) / spacing));
  for (int i = 0; i <= cells; ++i, ++at) {
    double const w = first + (last - first) * i / cells;
    Point const node = grading(w);
    nodes.key[at] = node.u > 1.0 ? falling_origin - node.u : node.u;
    nodes.inverse_abs_u[at] = 1.0 / std::abs(node.u);
    nodes.log2_abs_u[at] = node.log2_abs_u;
    if (i == cells) continue;
    double const h = (last - first) / cells;
    Point const a = grading(w + inner * h), b = grading(w + (1.0 - inner) * h), end = grading(w + h);
    nodes.cells[at] = {.log2_abs_u = {a.log2_abs_u, b.log2_abs_u},
                       .weight = {spacing / 12.0 * node.slope, spacing * 5.0 / 12.0 * a.slope,
                                  spacing * 5.0 / 12.0 * b.slope, spacing / 12.0 * end.slope}};
  }
  return at;
}

// Keeps what is saturated inside the last cell of its piece, where rounding would take it to the next.
inline constexpr double just_below_one = 1.0 - 1e-15;

constexpr std::size_t node_count(double first, double last) {
  double const width = last > first ? last - first : first - last;
  return static_cast<std::size_t>(width / spacing + 0.5) + 1;
}

// The nodes of a reach: from -1 (or -55) through 0 up to saturation, then, beyond saturation, from 55 down to it.
// Within saturation they are graded towards -1 as well, where the rate 1 + kappa |u|^n nearly vanishes for kappa close
// to -1.
template <Reach reach>
struct Layout {
  static constexpr bool falls = reach == Reach::beyond_saturation;
  static constexpr double start_w = falls ? reach_w : unloading_w;
  static constexpr std::size_t negative = node_count(start_w, smallest_w);
  static constexpr std::size_t rising = negative + node_count(smallest_w, largest_w);
  static constexpr std::size_t count = rising + (falls ? node_count(reach_w, -largest_w) : 0);

  static Nodes<count> const& nodes() {
    static Nodes<count> const made = [] {
      Nodes<count> n;
      auto const unloading = falls ? below_zero : above_minus_one;
      append(n, append(n, 0, unloading, start_w, smallest_w), below_one, smallest_w, largest_w);
      if constexpr (falls) append(n, rising, above_one, reach_w, -largest_w);
      for (std::size_t i = 0; i + 1 < count; ++i) n.inverse_rise[i] = 1.0 / (n.key[i + 1] - n.key[i]);
      return n;
    }();
    return made;
  }
};

}  // namespace flow_parts

template <class T, Reach reach = Reach::within_saturation>
class SaturatingFlow {
  using Layout = flow_parts::Layout<reach>;
  static constexpr std::size_t count = Layout::count;

 public:
  SaturatingFlow() = default;
  // n > 0; kappa > -1. Anything else gives values that are not finite.
  SaturatingFlow(T const& exponent, T const& unloading);

  // The place of u on the curve, as a time, and the value at a time: value_at(time_at(u) + travel) is u a travel later.
  // The two are inverse within rounding, so that repeated conversion does not drift.
  T time_at(T const& u) const { return time_of(place_of(u)); }
  T value_at(T const& time) const {
    Place const place = place_at(time);
    return value_of_key(value(place.c, place.s) + first_rate_ * min(time, T(0.0)));
  }

  // u after the given travel, also from beyond saturation, and the rates du/dt before and after.
  struct Advance {
    T u, rate0, rate1;
  };
  Advance advance(T const& u, T const& travel) const {
    Place const start = place_of(u);
    T time = time_of(start) + travel;
    // Whoever rises stays below saturation, and must not run on into the falling piece of the table.
    if constexpr (Layout::falls)
      time = select(u > T(1.0), time, min(time, time_[Layout::rising - 1] * T(flow_parts::just_below_one)));
    Place const end = place_at(time);
    T const sign = select(u > T(1.0), T(-1.0), T(1.0));
    return {value_of_key(value(end.c, end.s) + first_rate_ * min(time, T(0.0))), sign * rate_at(start),
            sign * rate_at(end)};
  }

 private:
  // Value, slope and curvature of the key over time at a node.
  struct Motion {
    T rate, curvature;
  };
  static Motion motion_at(std::size_t i, T const& n, T const& kappa);
  static T duration_of(std::size_t cell, T const& n, T const& kappa, T const& rate0, T const& rate1);
  void fit_cell(std::size_t i, T const& duration, Motion const& a, Motion const& b);

  // A point of the curve: its cell, where in the cell, and the cell's polynomial.
  using Index = decltype(cell_of(std::declval<std::array<T, count> const&>(), std::declval<T const&>()));
  struct Place {
    Index cell;
    T s;
    std::array<T, 6> c;
    T before;  // time before the first node, 0 from there on
  };
  Place place_of(T const& u) const;
  Place place_at(T const& time) const;
  T time_of(Place const& place) const {
    return at(time_, place.cell) + place.s * at(duration_, place.cell) + place.before;
  }
  // Of the key.
  T rate_at(Place const& place) const { return slope(place.c, place.s) * at(inverse_duration_, place.cell); }
  static T value_of_key(T const& key) {
    if constexpr (Layout::falls) return select(key > T(1.0), T(flow_parts::falling_origin) - key, key);
    return key;
  }

  std::array<T, 6> coefficients(Index const& cell) const {
    return {at(coefficient_[0], cell), at(coefficient_[1], cell), at(coefficient_[2], cell),
            at(coefficient_[3], cell), at(coefficient_[4], cell), at(coefficient_[5], cell)};
  }
  static T value(std::array<T, 6> const& c, T const& s) {
    return c[0] + s * (c[1] + s * (c[2] + s * (c[3] + s * (c[4] + s * c[5]))));
  }
  static T slope(std::array<T, 6> const& c, T const& s) {
    return c[1] + s * (T(2.0) * c[2] + s * (T(3.0) * c[3] + s * (T(4.0) * c[4] + s * T(5.0) * c[5])));
  }
  static T within_cell(T const& s) { return max(T(0.0), min(s, T(1.0))); }

  // In a cell key = polynomial of s = (time - time_[i]) / duration.
  std::array<T, count> time_{};
  std::array<T, count - 1> duration_{}, inverse_duration_{};
  std::array<std::array<T, count - 1>, 6> coefficient_{};
  T first_rate_ = T(0.0);
};

template <class T, Reach reach>
SaturatingFlow<T, reach>::SaturatingFlow(T const& exponent, T const& unloading) {
  T const nan(std::numeric_limits<double>::quiet_NaN());
  T const n = select(exponent > T(0.0), exponent, nan), kappa = select(unloading > T(-1.0), unloading, nan);
  Motion before = motion_at(0, n, kappa);
  first_rate_ = before.rate;
  time_[0] = T(0.0);
  for (std::size_t i = 0; i + 1 < count; ++i) {
    Motion const after = motion_at(i + 1, n, kappa);
    T const duration = duration_of(i, n, kappa, before.rate, after.rate);
    time_[i + 1] = time_[i] + duration;
    fit_cell(i, duration, before, after);
    before = after;
  }
}

template <class T, Reach reach>
auto SaturatingFlow<T, reach>::motion_at(std::size_t i, T const& n, T const& kappa) -> Motion {
  auto const& nodes = Layout::nodes();
  T const one(1.0), power_n = exp2(n * T(nodes.log2_abs_u[i]));
  T const per_u = n * power_n * T(nodes.inverse_abs_u[i]);  // d(|u|^n) / d|u|
  if (i < Layout::negative) {
    T const rate = one + kappa * power_n;
    return {rate, -kappa * per_u * rate};
  }
  T const rate = i < Layout::rising ? one - power_n : power_n - one;
  return {rate, -per_u * rate};
}

template <class T, Reach reach>
T SaturatingFlow<T, reach>::duration_of(std::size_t i, T const& n, T const& kappa, T const& rate0, T const& rate1) {
  auto const& nodes = Layout::nodes();
  T const one(1.0);
  if (i + 1 == Layout::rising) return one;  // between the pieces; never entered
  if (i + 1 == Layout::negative) {
    // Through zero: the mean of |u|^n over each half is 1 / (n + 1) of its value at the node.
    T const mean0 = one - (one - rate0) / (n + one), mean1 = one - (one - rate1) / (n + one);
    return T(-nodes.key[i]) / mean0 + T(nodes.key[i + 1]) / mean1;
  }
  auto const& cell = nodes.cells[i];
  auto const inner_rate = [&](std::size_t k) {
    T const power_n = exp2(n * T(cell.log2_abs_u[k]));
    return i < Layout::negative ? one + kappa * power_n : i < Layout::rising ? one - power_n : power_n - one;
  };
  return T(cell.weight[0]) / rate0 + T(cell.weight[1]) / inner_rate(0) + T(cell.weight[2]) / inner_rate(1) +
         T(cell.weight[3]) / rate1;
}

template <class T, Reach reach>
void SaturatingFlow<T, reach>::fit_cell(std::size_t i, T const& h, Motion const& a, Motion const& b) {
  auto const& nodes = Layout::nodes();
  T const rise(nodes.key[i + 1] - nodes.key[i]);
  duration_[i] = h;
  inverse_duration_[i] = T(1.0) / h;
  coefficient_[0][i] = T(nodes.key[i]);
  bool const straight = i + 1 == Layout::negative || i + 1 == Layout::rising;
  if (straight) {
    coefficient_[1][i] = rise;
    for (std::size_t k = 2; k < 6; ++k) coefficient_[k][i] = T(0.0);
    return;
  }
  // Quintic Hermite.
  T const d0 = h * a.rate, d1 = h * b.rate, c0 = h * h * a.curvature, c1 = h * h * b.curvature;
  coefficient_[1][i] = d0;
  coefficient_[2][i] = T(0.5) * c0;
  coefficient_[3][i] = T(10.0) * rise - T(6.0) * d0 - T(4.0) * d1 - T(1.5) * c0 + T(0.5) * c1;
  coefficient_[4][i] = T(-15.0) * rise + T(8.0) * d0 + T(7.0) * d1 + T(1.5) * c0 - c1;
  coefficient_[5][i] = T(6.0) * rise - T(3.0) * (d0 + d1) - T(0.5) * (c0 - c1);
}

template <class T, Reach reach>
auto SaturatingFlow<T, reach>::place_at(T const& time) const -> Place {
  auto const cell = cell_of(time_, time);
  return {cell, within_cell((time - at(time_, cell)) * at(inverse_duration_, cell)), coefficients(cell), T(0.0)};
}

template <class T, Reach reach>
auto SaturatingFlow<T, reach>::place_of(T const& u) const -> Place {
  auto const& nodes = Layout::nodes();
  T const lowest(nodes.key.front());
  T key = u;
  // Above the reach the falling piece starts at its first node: there the rate hardly changes over a step.
  if constexpr (Layout::falls)
    key = select(u > T(1.0), max(T(flow_parts::falling_origin) - u, T(nodes.key[Layout::rising])),
                 min(u, T(nodes.key[Layout::rising - 1] * flow_parts::just_below_one)));
  T const last(Layout::falls ? nodes.key.back() : nodes.key[Layout::rising - 1]);
  T const inside = min(max(key, lowest), last);
  auto const cell = cell_of(nodes.key, inside);
  auto const c = coefficients(cell);
  // First guess: the cubic Hermite polynomial of the inverse function; then Newton.
  T const one(1.0), inverse_rise(at(nodes.inverse_rise, cell)), rise = one / inverse_rise;
  T const r = (inside - c[0]) * inverse_rise, m0 = rise / c[1], m1 = rise / slope(c, one);
  T s = within_cell(r * (m0 * (one - r) * (one - r) + r * (T(3.0) - T(2.0) * r - m1 * (one - r))));
  for (int i = 0; i < 2; ++i) s = within_cell(s - (value(c, s) - inside) / slope(c, s));
  return {cell, s, c, min(key - lowest, T(0.0)) / first_rate_};
}

}  // namespace isolaw::laws
