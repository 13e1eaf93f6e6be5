// The interface of a problem that optimisers minimise, and the result of a search.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "isolaw/num/row_kernels.hpp"

namespace isolaw::opt {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Points of equal dimension, stored one after another: coordinate k of point i is values[i * dimension + k].
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

// Minimisation over the unit box [0, 1]^dimension. The problem maps the box to its physical parameters, so that all
// algorithms see the same scales. evaluate() writes a value for each point, +infinity if it cannot be computed.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual std::size_t dimension() const = 0;
  virtual void evaluate(Points const& points, std::span<double> values) const = 0;
};

// A problem whose value is the sum of weights()[j] * |residual j|. Knowing the residuals saves most evaluations.
class DeviationProblem : public Problem {
 public:
  virtual std::span<double const> weights() const = 0;  // one weight for each residual, >= 0, with sum 1
  // Writes residual j of point i to values[i * weights().size() + j]; not finite if it cannot be computed.
  virtual void residuals(Points const& points, std::span<double> values) const = 0;
  // Writes the residuals side by side: residual j of point i is rows[j * stride + i]. `stride` is at least
  // num::padded(points.size()); columns after the last point may hold any numbers.
  virtual void residual_rows(Points const& points, std::size_t stride, std::span<double> rows) const;
  // A problem with fewer residuals and nearly the same minima, which is cheaper to search; null if there is none.
  virtual DeviationProblem const* outline() const { return nullptr; }
  // Converts weights of all residuals to weights of the residuals of outline(). A residual that the outline leaves out
  // gives its weight to the two kept residuals beside it. May be called only if there is an outline.
  virtual std::vector<double> on_outline(std::span<double const> weights) const;
};

struct BestPoint {
  std::vector<double> best;  // in the unit box; empty if no point had a finite value
  double best_value = std::numeric_limits<double>::infinity();
  int evaluations = 0;         // number of points computed
  int failed_evaluations = 0;  // number of points without a finite value

  bool usable() const { return !best.empty(); }
};

// How a search ended; genetic.hpp and multistart.hpp explain it. After `interrupted`, `best` is the best point so far.
enum class Outcome { confirmed, budget_spent, all_generations, stagnated, no_finite_value, interrupted };

struct SearchResult : BestPoint {
  Outcome outcome = Outcome::no_finite_value;
  std::vector<double> history;  // best value after each generation or descent; never rises
};

}  // namespace isolaw::opt
