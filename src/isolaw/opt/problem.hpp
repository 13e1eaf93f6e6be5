// The contract between an optimiser and the problem it minimises, and the result of a search.
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

// Minimisation over the unit box [0, 1]^dimension. The problem maps the box to its physical parameters, so that every
// algorithm sees the same scales. evaluate() writes one value per point; +infinity marks a failed point.
class Problem {
 public:
  virtual ~Problem() = default;
  virtual std::size_t dimension() const = 0;
  virtual void evaluate(Points const& points, std::span<double> values) const = 0;
};

// The value is sum of weights()[j] * |residual j|. A search that sees the residuals needs far fewer evaluations.
class DeviationProblem : public Problem {
 public:
  virtual std::span<double const> weights() const = 0;  // one for each residual, >= 0; their sum is 1
  // Residual j of point i is values[i * weights().size() + j]. Not finite if the point failed.
  virtual void residuals(Points const& points, std::span<double> values) const = 0;
  // The same with the points side by side: residual j of point i is rows[j * stride + i]. The stride is at least
  // num::padded(points.size()); columns beyond the last point may hold any numbers.
  virtual void residual_rows(Points const& points, std::size_t stride, std::span<double> rows) const;
  // The same problem with fewer residuals, good enough to find the right valley; null if there is no such problem.
  virtual DeviationProblem const* outline() const { return nullptr; }
  // Spreads weights of all residuals over the residuals of the outline. For a problem that has an outline.
  virtual std::vector<double> on_outline(std::span<double const> weights) const;
};

struct Found {
  std::vector<double> best;  // in the unit box; empty when no point was finite
  double best_value = std::numeric_limits<double>::infinity();
  int evaluations = 0;         // points that were computed
  int failed_evaluations = 0;  // how many of them had no finite value

  bool usable() const { return !best.empty(); }
};

// How a search ended; see genetic.hpp and multistart.hpp. After `interrupted`, `best` is the best point so far.
enum class Outcome { confirmed, budget_spent, all_generations, stagnated, no_finite_value, interrupted };

struct SearchResult : Found {
  Outcome outcome = Outcome::no_finite_value;
  std::vector<double> history;  // best value after each generation or descent; never rises
};

}  // namespace isolaw::opt
