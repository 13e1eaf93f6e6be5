// The nodes of the flow's table. They are not in the header, because every instruction set would then have its own copy
// of this code.
#include "isolaw/laws/flows/tabulated_flow.hpp"

#include <cmath>

namespace isolaw::laws::tabulated_flow_parts {
namespace {

// A point of a grading. A grading is a function u(w) that spaces the nodes: they lie at equal distances in w.
struct Point {
  double u, slope, log2_abs_u;  // u(w), its derivative du/dw, and log2 |u|
};

Point below_zero(double w) {  // |u| = e^w
  return {-std::exp(w), std::exp(w), w * num::log2_e};
}
Point below_one(double w) {  // u = 1 / (1 + e^-w)
  double const e = std::exp(-w), u = 1.0 / (1.0 + e);
  return {u, u * u * e, -std::log1p(e) * num::log2_e};
}
Point above_minus_one(double w) {  // u = -1 / (1 + e^-w)
  Point p = below_one(w);
  p.u = -p.u;
  return p;
}
Point above_one(double w) {  // u = 1 + e^w
  double const e = std::exp(w);
  return {1.0 + e, e, std::log1p(e) * num::log2_e};
}

// Writes the nodes grading(w), for w in equal steps from `first` to `last`, to `nodes` from index `at` on. Returns the
// index after the last one.
template <std::size_t Count, class Grading>
std::size_t append(Nodes<Count>& nodes, std::size_t at, Grading grading, double first, double last) {
  // (1 - 1/sqrt(5)) / 2: the first inner point of Lobatto's quadrature with four points on [0, 1].
  constexpr double inner = 0.27639320225002103;
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

}  // namespace

template <Reach reach>
auto Layout<reach>::nodes() -> Nodes<count> const& {
  static Nodes<count> const table = [] {
    Nodes<count> n;
    auto const unloading = falls ? below_zero : above_minus_one;
    append(n, append(n, 0, unloading, start_w, smallest_w), below_one, smallest_w, largest_w);
    if constexpr (falls) append(n, rising, above_one, reach_w, -largest_w);
    for (std::size_t i = 0; i + 1 < count; ++i) n.inverse_rise[i] = 1.0 / (n.key[i + 1] - n.key[i]);
    return n;
  }();
  return table;
}

template struct Layout<Reach::within_saturation>;
template struct Layout<Reach::beyond_saturation>;

}  // namespace isolaw::laws::tabulated_flow_parts
