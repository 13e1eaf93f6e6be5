// The contract between an optimiser and what it minimises: a box and the evaluation of a batch of points; what it
// finds.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "isolaw/num/row_kernels.hpp"

namespace isolaw::opt {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// A set of points of equal dimension, stored one after another: point i is values[i * dimension .. + dimension).
struct Points {
  std::size_t dimension = 0;
  std::vector<double> values;

  Points() = default;
  Points(std::size_t dimension_, std::size_t count) : dimension(dimension_), values(dimension_ * count) {}
  std::size_t size() const { return dimension == 0 ? 0 : values.size() / dimension; }
  std::span<double> operator[](std::size_t i) { return std::span(values).subspan(i * dimension, dimension); }
  std::span<double const> operator[](std::size_t i) const {
    return std::span(values).subspan(i * dimension, dimension);
  }
};

// Minimisation over the unit box [0, 1]^dimension; whoever states the problem maps the box to physical parameters,
// so that every algorithm sees the same scales. `evaluate` writes one value per point; +infinity marks a failed point.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual std::size_t dimension() const = 0;
  virtual void evaluate(Points const& points, std::span<double> values) const = 0;
};

// A problem whose value is a weighted sum of absolute residuals: sum of weights()[j] * |residual j|. What descends by
// the residuals needs one evaluation where a value alone needs many.
class DeviationProblem : public Problem {
 public:
  virtual std::span<double const> weights() const = 0;  // of each residual; 0 or more, with a sum of 1
  // Residuals of each point, one point after another. Not finite where a point failed.
  virtual void residuals(Points const& points, std::span<double> values) const = 0;
  // The same side by side: residual j of point i is rows[j * stride + i]; stride: num::padded(points.size()) or more.
  // What stands beside the last point is anything.
  virtual void residual_rows(Points const& points, std::size_t stride, std::span<double> rows) const;
  // The same problem by fewer residuals, good enough to find a valley by; null where there is none.
  virtual DeviationProblem const* outline() const { return nullptr; }
  // Weights of the outline's residuals that stand for these of all; for a problem that has an outline.
  virtual std::vector<double> on_outline(std::span<double const> weights) const;
};

// The best point found, and what it cost.
struct Found {
  std::vector<double> best;  // in the unit box; empty when no point was finite
  double best_value = std::numeric_limits<double>::infinity();
  int evaluations = 0;         // points that were computed
  int failed_evaluations = 0;  // of them, those whose value was not finite

  bool usable() const { return !best.empty(); }
};

// How a search ended. interrupted: best is the best so far. The others are said with the search that ends so.
enum class Outcome { confirmed, budget_spent, all_generations, stagnated, no_finite_value, interrupted };

struct SearchResult : Found {
  Outcome outcome = Outcome::no_finite_value;
  std::vector<double> history;  // best value after each generation or descent; never rises
};

}  // namespace isolaw::opt
