#include "isolaw/opt/problem.hpp"

namespace isolaw::opt {

void DeviationProblem::residual_rows(Points const& points, std::size_t stride, std::span<double> rows) const {
  std::size_t const count = weights().size();
  std::vector<double> one_by_one(points.size() * count);
  residuals(points, one_by_one);
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < count; ++j) rows[j * stride + i] = one_by_one[i * count + j];
}

std::vector<double> DeviationProblem::on_outline(std::span<double const> weights) const {
  return {weights.begin(), weights.end()};
}

}  // namespace isolaw::opt
