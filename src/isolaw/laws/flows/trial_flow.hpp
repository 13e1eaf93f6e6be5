// The exact flow of the hysteretic laws between two reversals (saturating_flow.hpp), for a motion that is not known
// ahead. It comes from a table, because a trial takes half as long with a table as with the polynomials of that file.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "isolaw/laws/flows/tabulated_flow.hpp"
#include "isolaw/laws/online/numbers.hpp"

namespace isolaw::laws::online {

// `isolaw export` copies the lines up to [end] to C++ files (programs/header_parts.cpp):
// [export]
// The exact curve u(t) of a hysteretic variable between two reversals, tabulated once. The travel t is called time:
//     du/dt = 1 - |u|^n for u >= 0, 1 + kappa |u|^n for u < 0
// Nodes come closer together, geometrically, towards 0 and towards saturation. Lobatto quadrature gives the times
// between nodes, and quintics give the values. If `beyond` is true, u may start above 1 and falls to 1.
template <Reach reach>
class Flow {
  static constexpr bool beyond = reach == Reach::beyond_saturation;

 public:
  // The largest u below saturation, u = 1, whose time is in the table (the node at w = largest_w).
  static constexpr double end_of_curve = 0.9999998874648379;

  void fit(double n, double kappa) {
    n_ = n;
    kappa_ = kappa;
    make_nodes();
    tabulate();
  }

  template <class Value>
  Value time_at(Value const& u) const {
    return place_of(u).time();
  }
  template <class Value>
  Value value_at(Value const& time) const {
    return value_of_key(place_at(time).key() + first_rate_ * min(time, Value(0.0)));
  }
  struct Advance {
    Dual u, rate0, rate1, ratio;
  };
  Advance advance(Dual const& u, Dual const& travel) const {
    auto const start = place_of(u);
    Dual time = start.time() + travel;
    if (beyond && !(u > Dual(1.0))) time = min(time, Dual(time_[rising_ - 1] * just_below_one));
    auto const end = place_at(time);
    Dual const sign = u > Dual(1.0) ? -1.0 : 1.0;
    Dual const rate0 = sign * start.rate(), rate1 = sign * end.rate();
    return {value_of_key(end.key() + first_rate_ * min(time, Dual(0.0))), rate0, rate1,
            max(0.0, min(rate1 / rate0, 1.0))};
  }

 private:
  static constexpr double spacing = 1.0 / 12.0, smallest_w = -12.0, largest_w = 16.0, unloading_w = 14.0, reach_w = 4.0;
  static constexpr double falling_origin = 60.0, just_below_one = 1.0 - 1e-15;
  static constexpr double log2_e = 1.44269504088896340736;

  struct Point {
    double u, slope, log2_abs_u;
  };
  struct Lobatto {
    double log2_abs_u[2], weight[4];
  };
  struct Cell {
    double begin, duration, c[6];
  };
  template <class Value>
  struct Place {
    Cell const* cell;
    Value t, before;

    Value time() const { return Value(cell->begin) + t + before; }
    Value key() const { return value(t); }
    Value rate() const { return slope(t); }
    Value value(Value const& s) const {
      auto const* c = cell->c;
      return Value(c[0]) +
             s * (Value(c[1]) + s * (Value(c[2]) + s * (Value(c[3]) + s * (Value(c[4]) + s * Value(c[5])))));
    }
    Value slope(Value const& s) const {
      auto const* c = cell->c;
      return Value(c[1]) +
             s * (Value(2.0 * c[2]) + s * (Value(3.0 * c[3]) + s * (Value(4.0 * c[4]) + s * Value(5.0 * c[5]))));
    }
    Value inside(Value const& s) const { return max(Value(0.0), min(s, Value(cell->duration))); }
  };

  static double plain(double x) { return x; }
  static double plain(Dual const& x) { return x.v; }

  static Point below_zero(double w) { return {-std::exp(w), std::exp(w), w * log2_e}; }
  static Point below_one(double w) {
    double const e = std::exp(-w), u = 1.0 / (1.0 + e);
    return {u, u * u * e, -std::log1p(e) * log2_e};
  }
  static Point above_minus_one(double w) {
    Point p = below_one(w);
    p.u = -p.u;
    return p;
  }
  static Point above_one(double w) {
    double const e = std::exp(w);
    return {1.0 + e, e, std::log1p(e) * log2_e};
  }

  template <class Grading>
  void append(Grading grading, double first, double last) {
    double const inner = 0.27639320225002103;
    int const cells = static_cast<int>(std::lround(std::abs(last - first) / spacing));
    for (int i = 0; i <= cells; ++i) {
      double const w = first + (last - first) * i / cells, h = (last - first) / cells;
      Point const node = grading(w);
      key_.push_back(node.u > 1.0 ? falling_origin - node.u : node.u);
      abs_u_.push_back(std::abs(node.u));
      log2_abs_u_.push_back(node.log2_abs_u);
      Point const a = grading(w + inner * h), b = grading(w + (1.0 - inner) * h), end = grading(w + h);
      lobatto_.push_back({{a.log2_abs_u, b.log2_abs_u},
                          {spacing / 12.0 * node.slope, spacing * 5.0 / 12.0 * a.slope, spacing * 5.0 / 12.0 * b.slope,
                           spacing / 12.0 * end.slope}});
    }
  }

  void make_nodes() {
    if (beyond)
      append(below_zero, reach_w, smallest_w);
    else
      append(above_minus_one, unloading_w, smallest_w);
    negative_ = key_.size();
    append(below_one, smallest_w, largest_w);
    rising_ = key_.size();
    if (beyond) append(above_one, reach_w, -largest_w);
  }

  double rate_of(std::size_t i, double power_n) const {
    return i < negative_ ? 1.0 + kappa_ * power_n : i < rising_ ? 1.0 - power_n : power_n - 1.0;
  }

  void tabulate() {
    auto const count = key_.size();
    std::vector<double> rate(count), curvature(count);
    for (std::size_t i = 0; i < count; ++i) {
      double const power_n = std::exp2(n_ * log2_abs_u_[i]), per_u = n_ * power_n / abs_u_[i];
      rate[i] = rate_of(i, power_n);
      curvature[i] = (i < negative_ ? -kappa_ : -1.0) * per_u * rate[i];
    }
    first_rate_ = rate[0];
    time_.assign(1, 0.0);
    for (std::size_t i = 0; i + 1 < count; ++i) {
      bool const between = i + 1 == rising_, through_zero = i + 1 == negative_;
      double h = 1.0;
      if (through_zero) {
        h = -key_[i] / (1.0 - (1.0 - rate[i]) / (n_ + 1.0)) + key_[i + 1] / (1.0 - (1.0 - rate[i + 1]) / (n_ + 1.0));
      } else if (!between) {
        auto const& q = lobatto_[i];
        h = q.weight[0] / rate[i] + q.weight[3] / rate[i + 1];
        for (int k = 0; k < 2; ++k) h += q.weight[k + 1] / rate_of(i, std::exp2(n_ * q.log2_abs_u[k]));
      }
      double const begin = time_.back(), mean = (key_[i + 1] - key_[i]) / h;
      time_.push_back(begin + h);
      if (between || through_zero) {
        cells_.push_back({begin, h, {key_[i], mean, 0.0, 0.0, 0.0, 0.0}});
        continue;
      }
      double const d0 = rate[i] - mean, d1 = rate[i + 1] - mean, c0 = curvature[i] * h, c1 = curvature[i + 1] * h;
      cells_.push_back({begin,
                        h,
                        {key_[i], rate[i], 0.5 * curvature[i], (-6.0 * d0 - 4.0 * d1 - 1.5 * c0 + 0.5 * c1) / (h * h),
                         (8.0 * d0 + 7.0 * d1 + 1.5 * c0 - c1) / (h * h * h),
                         (-3.0 * (d0 + d1) - 0.5 * (c0 - c1)) / (h * h * h * h)}});
    }
  }

  static std::size_t cell_of(std::vector<double> const& nodes, double x) {
    auto const above = std::upper_bound(nodes.begin(), nodes.end(), x) - nodes.begin();
    auto const last = static_cast<std::ptrdiff_t>(nodes.size()) - 2;
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, std::min(above - 1, last)));
  }

  template <class Value>
  Place<Value> place_at(Value const& time) const {
    Place<Value> made{&cells_[cell_of(time_, plain(time))], Value(0.0), Value(0.0)};
    made.t = made.inside(time - Value(made.cell->begin));
    return made;
  }

  template <class Value>
  Place<Value> place_of(Value const& u) const {
    double const lowest = key_.front();
    Value key = u;
    if (beyond)
      key = u > Value(1.0) ? max(Value(falling_origin) - u, Value(key_[rising_]))
                           : min(u, Value(key_[rising_ - 1] * just_below_one));
    Value const inside = min(max(key, Value(lowest)), Value(beyond ? key_.back() : key_[rising_ - 1]));
    auto const index = cell_of(key_, plain(inside));
    Place<Value> made{&cells_[index], Value(0.0), Value(0.0)};
    auto const* c = made.cell->c;
    double const rise = key_[index + 1] - key_[index], m0 = rise / c[1];
    double const m1 = rise / plain(made.slope(Value(made.cell->duration)));
    Value const r = (inside - Value(c[0])) / Value(rise), left = Value(1.0) - r;
    made.t = made.inside(r * (Value(m0) * left * left +
                              r * (Value(made.cell->duration) * (Value(3.0) - Value(2.0) * r) - Value(m1) * left)));
    for (int i = 0; i < 2; ++i) made.t = made.inside(made.t - (made.value(made.t) - inside) / made.slope(made.t));
    made.before = min(key - Value(lowest), Value(0.0)) / Value(first_rate_);
    return made;
  }

  template <class Value>
  Value value_of_key(Value const& key) const {
    return beyond && key > Value(1.0) ? Value(falling_origin) - key : key;
  }

  double n_ = 0.0, kappa_ = 0.0, first_rate_ = 0.0;
  std::size_t negative_ = 0, rising_ = 0;
  std::vector<double> key_, abs_u_, log2_abs_u_, time_;
  std::vector<Lobatto> lobatto_;
  std::vector<Cell> cells_;
};
// [end]

}  // namespace isolaw::laws::online
