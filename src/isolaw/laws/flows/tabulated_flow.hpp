// The exact flow of the hysteretic laws between two reversals, from a table. It is used for parameters outside the
// range of the polynomials of saturating_flow.hpp. That file gives the equation and the rejected alternatives. The
// curve u(t) is tabulated once per parameter set, which costs about 500 evaluations of a power; each sample then costs
// a lookup, however large its step. Nodes come closer together, geometrically, towards u = 0, where u^n is not smooth
// for n < 1, and towards saturation on both sides. Times between nodes come from four-point Lobatto quadrature; u(t)
// within a cell is the quintic with the value, slope and curvature of both ends.
// Largest error in u over n in [0.01, 3]: below 1e-5 for kappa in [-1/2, 3]; below 1e-5 / (2 (1 + kappa)) down to kappa
// = -0.99, where the equation itself magnifies errors near u = -1 (tests/verification).
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "isolaw/laws/law.hpp"

namespace isolaw::laws {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
// Whether |u| can exceed 1, as it does where the saturation value itself shrinks (abe).
enum class Reach { within_saturation, beyond_saturation };
// [end]

namespace tabulated_flow_parts {

// Fixed nodes, and the quadrature of the cell between each node and the next. `key` ascends with time along the curve.
// It is u itself on the rising piece, and falling_origin - u on the piece that falls to saturation from above, so that
// one search serves both pieces.
template <std::size_t Count>
struct Nodes {
  std::array<double, Count> key{};
  std::array<double, Count> inverse_abs_u{};
  std::array<double, Count> log2_abs_u{};
  std::array<double, Count - 1> inverse_rise{};  // for each cell 1 / (key of its second node - key of its first)
  // The time over a cell, the integral of |du| / |du/dt|, is a sum over the four points of Lobatto's quadrature, of
  // which the first and the last are the nodes.
  struct Cell {
    std::array<double, 2> log2_abs_u{};  // log2 |u| at the two inner points
    std::array<double, 4> weight{};      // the |du| that each of the four points stands for, in ascending order
  };
  std::array<Cell, Count - 1> cells{};
};

// The nodes lie at equal distances, `spacing`, on the axis of a variable w. The functions u(w) of tabulated_flow.cpp
// (the gradings, such as |u| = e^w) convert w to u, so that the nodes come closer together near 0 and near saturation.
// The limits of w below are the ends of the table.
inline constexpr double spacing = 1.0 / 3.0;
inline constexpr double smallest_w = -12.0;  // |u| = 6e-6; between -6e-6 and 6e-6 the curve is taken as a straight line
inline constexpr double largest_w = 16.0;    // |1 - u| = 1e-7; closer to saturation u is taken as constant
inline constexpr double unloading_w = 14.0;  // |1 + u| = 8e-7 at the first node with Reach::within_saturation
// If u may exceed 1, |u| is 55 at the first node, and du/dt is taken as constant beyond it.
inline constexpr double reach_w = 4.0;
// On the falling piece, the key falling_origin - u is 4.4 to 59, above all keys of the rising one.
inline constexpr double falling_origin = 60.0;
// Keeps a saturated u in the last cell of its piece; rounding would otherwise move it to the next.
inline constexpr double just_below_one = 1.0 - 1e-15;

constexpr std::size_t node_count(double first, double last) {
  double const width = last > first ? last - first : first - last;
  return static_cast<std::size_t>(width / spacing + 0.5) + 1;
}

// The nodes go from u = -1 up to saturation. If u may exceed 1, they go from -55 up to saturation, and from 55 down to
// saturation. With Reach::within_saturation they come closer together towards -1 too, where the rate 1 + kappa |u|^n
// nearly vanishes for kappa close to -1.
template <Reach reach>
struct Layout {
  static constexpr bool falls = reach == Reach::beyond_saturation;
  static constexpr double start_w = falls ? reach_w : unloading_w;
  static constexpr std::size_t negative = node_count(start_w, smallest_w);
  static constexpr std::size_t rising = negative + node_count(smallest_w, largest_w);
  static constexpr std::size_t count = rising + (falls ? node_count(reach_w, -largest_w) : 0);

  static Nodes<count> const& nodes();  // the nodes are computed at the first call
};
extern template struct Layout<Reach::within_saturation>;
extern template struct Layout<Reach::beyond_saturation>;

}  // namespace tabulated_flow_parts

template <class T, Reach reach = Reach::within_saturation>
class TabulatedFlow {
  using Layout = tabulated_flow_parts::Layout<reach>;
  static constexpr std::size_t count = Layout::count;

 public:
  // Fills the table in place, because it is large. Results are finite only for n > 0 and kappa > -1.
  void tabulate(T const& exponent, T const& unloading);
  // Work as in SaturatingFlow, except that times count from the first node.
  T time_at(T const& u) const { return place_of(u).time(); }
  T value_at(T const& time) const { return value_of_key(place_at(time).key() + first_rate_ * min(time, T(0.0))); }

  // The members of SaturatingFlow::Advance without the ratio of the rates.
  struct Advance {
    T u, rate0, rate1;
  };
  Advance advance(T const& u, T const& travel) const {
    Place const start = place_of(u);
    T time = start.time() + travel;
    // A rising u stays below saturation: its time must not run on into the falling piece of the table.
    if constexpr (Layout::falls)
      time = select(u > T(1.0), time, min(time, time_[Layout::rising - 1] * T(tabulated_flow_parts::just_below_one)));
    Place const end = place_at(time);
    T const sign = select(u > T(1.0), T(-1.0), T(1.0));
    return {value_of_key(end.key() + first_rate_ * min(time, T(0.0))), sign * start.rate(), sign * end.rate()};
  }

 private:
  // The first and second derivative of the key by time at a node.
  struct Motion {
    T rate, curvature;
  };
  static Motion motion_at(std::size_t i, T const& n, T const& kappa);
  static T duration_of(std::size_t cell, T const& n, T const& kappa, T const& rate0, T const& rate1);
  void fit_cell(std::size_t i, T const& duration, Motion const& a, Motion const& b);

  // Within a cell the key is a polynomial of the time since the cell's begin. A row of the table holds these members in
  // this order.
  struct Cell {
    T begin, duration;
    std::array<T, 6> c;

    explicit Cell(std::array<T, 8> const& v) : begin(v[0]), duration(v[1]), c{v[2], v[3], v[4], v[5], v[6], v[7]} {}
    T value(T const& t) const { return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5])))); }
    T rate(T const& t) const {
      return c[1] + t * (T(2.0) * c[2] + t * (T(3.0) * c[3] + t * (T(4.0) * c[4] + t * T(5.0) * c[5])));
    }
    T inside(T const& t) const { return max(T(0.0), min(t, duration)); }
  };
  // A point of the curve.
  struct Place {
    Cell cell;  // the cell in which it lies
    T t;        // the time since the begin of this cell
    T before;   // for a point before the first node: the time from that node to it, which is negative; else 0

    T time() const { return cell.begin + t + before; }
    T key() const { return cell.value(t); }
    T rate() const { return cell.rate(t); }  // derivative of the key by time
  };
  Place place_of(T const& u) const;
  Place place_at(T const& time) const;
  static T value_of_key(T const& key) {
    if constexpr (Layout::falls) return select(key > T(1.0), T(tabulated_flow_parts::falling_origin) - key, key);
    return key;
  }

  std::array<T, count> time_;  // the time at which the curve passes each node
  num::Rows8<T, count - 1> cells_;
  T first_rate_;
};

template <class T, Reach reach>
void TabulatedFlow<T, reach>::tabulate(T const& exponent, T const& unloading) {
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
auto TabulatedFlow<T, reach>::motion_at(std::size_t i, T const& n, T const& kappa) -> Motion {
  auto const& nodes = Layout::nodes();
  T const one(1.0), power_n = exp2(n * T(nodes.log2_abs_u[i]));
  T const per_u = n * power_n * T(nodes.inverse_abs_u[i]);  // derivative of |u|^n by |u|
  if (i < Layout::negative) {
    T const rate = one + kappa * power_n;
    return {rate, -kappa * per_u * rate};
  }
  T const rate = i < Layout::rising ? one - power_n : power_n - one;
  return {rate, -per_u * rate};
}

template <class T, Reach reach>
T TabulatedFlow<T, reach>::duration_of(std::size_t i, T const& n, T const& kappa, T const& rate0, T const& rate1) {
  auto const& nodes = Layout::nodes();
  T const one(1.0);
  // The cell between the last node of the rising piece and the first of the falling one is no part of the curve, and no
  // look-up ends in it. Its duration may therefore be any number above 0.
  if (i + 1 == Layout::rising) return one;
  if (i + 1 == Layout::negative) {
    // The cell through 0: the mean of |u|^n over each half is 1 / (n + 1) of its value at the node.
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
void TabulatedFlow<T, reach>::fit_cell(std::size_t i, T const& h, Motion const& a, Motion const& b) {
  auto const& nodes = Layout::nodes();
  T const zero(0.0), begin = time_[i], key(nodes.key[i]), rise(nodes.key[i + 1] - nodes.key[i]);
  T const per_h = T(1.0) / h, mean = rise * per_h;
  bool const straight = i + 1 == Layout::negative || i + 1 == Layout::rising;
  if (straight) {
    cells_.set(i, {begin, h, key, mean, zero, zero, zero, zero});
    return;
  }
  // The quintic Hermite polynomial needs the rate and the curvature at both ends. d0 and d1 are these rates minus the
  // mean rate of the cell.
  T const d0 = a.rate - mean, d1 = b.rate - mean, c0 = a.curvature * h, c1 = b.curvature * h;
  T const third = T(-6.0) * d0 - T(4.0) * d1 - T(1.5) * c0 + T(0.5) * c1;
  T const fourth = T(8.0) * d0 + T(7.0) * d1 + T(1.5) * c0 - c1;
  T const fifth = T(-3.0) * (d0 + d1) - T(0.5) * (c0 - c1);
  T const per_h2 = per_h * per_h;
  cells_.set(i, {begin, h, key, a.rate, T(0.5) * a.curvature, third * per_h2, fourth * per_h2 * per_h,
                 fifth * per_h2 * per_h2});
}

template <class T, Reach reach>
auto TabulatedFlow<T, reach>::place_at(T const& time) const -> Place {
  Cell const cell(cells_.get(cell_of(time_, time)));
  return {cell, cell.inside(time - cell.begin), T(0.0)};
}

template <class T, Reach reach>
auto TabulatedFlow<T, reach>::place_of(T const& u) const -> Place {
  auto const& nodes = Layout::nodes();
  T const lowest(nodes.key.front());
  T key = u;
  // A u above 55, the table's largest, starts from the node at 55, because the rate hardly changes over a step there.
  if constexpr (Layout::falls)
    key = select(u > T(1.0), max(T(tabulated_flow_parts::falling_origin) - u, T(nodes.key[Layout::rising])),
                 min(u, T(nodes.key[Layout::rising - 1] * tabulated_flow_parts::just_below_one)));
  T const last(Layout::falls ? nodes.key.back() : nodes.key[Layout::rising - 1]);
  T const inside = min(max(key, lowest), last);
  auto const index = cell_of(nodes.key, inside);
  Cell const cell(cells_.get(index));
  // The cubic Hermite polynomial of the inverse function gives a guess, which Newton's method improves.
  T const one(1.0), inverse_rise(at(nodes.inverse_rise, index)), rise = one / inverse_rise;
  T const r = (inside - cell.c[0]) * inverse_rise, left = one - r;
  T const m0 = rise / cell.c[1], m1 = rise / cell.rate(cell.duration);
  T t = cell.inside(r * (m0 * left * left + r * (cell.duration * (T(3.0) - T(2.0) * r) - m1 * left)));
  for (int i = 0; i < 2; ++i) t = cell.inside(t - (cell.value(t) - inside) / cell.rate(t));
  return {cell, t, min(key - lowest, T(0.0)) / first_rate_};
}

}  // namespace isolaw::laws
