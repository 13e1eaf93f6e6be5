// Tests search problems that are made from other search problems: with other weights, with one coordinate fixed, and
// over several records at once.
#include "isolaw/analysis/problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "twins.hpp"

namespace isolaw::analysis {
namespace {

// Residual j is x_j - j / 10 for j < dimension; the last residual is the sum of the others. If x_0 > 0.9, the first
// residual is NaN and the objective therefore infinite.
class Plain final : public opt::DeviationProblem {
 public:
  explicit Plain(std::size_t dimension) : dimension_(dimension) {
    double const count = static_cast<double>(dimension + 1);
    weights_.assign(dimension + 1, 1.0 / count);
  }
  std::size_t dimension() const override { return dimension_; }
  std::span<double const> weights() const override { return weights_; }
  void evaluate(opt::Points const& points, std::span<double> values) const override {
    std::vector<double> r(points.size() * weights_.size());
    residuals(points, r);
    for (std::size_t i = 0; i < points.size(); ++i) {
      values[i] = 0.0;
      for (std::size_t j = 0; j < weights_.size(); ++j) values[i] += weights_[j] * std::abs(r[i * weights_.size() + j]);
      if (!std::isfinite(values[i])) values[i] = std::numeric_limits<double>::infinity();
    }
  }
  void residuals(opt::Points const& points, std::span<double> values) const override {
    for (std::size_t i = 0; i < points.size(); ++i) {
      auto const x = points[i];
      auto const r = values.subspan(i * weights_.size(), weights_.size());
      r[dimension_] = 0.0;
      for (std::size_t j = 0; j < dimension_; ++j) r[dimension_] += r[j] = x[j] - 0.1 * static_cast<double>(j);
      if (x[0] > 0.9) r[0] = std::nan("");
    }
  }

 private:
  std::size_t dimension_;
  std::vector<double> weights_;
};

opt::Points points(std::size_t dimension, std::vector<double> values) {
  opt::Points candidates;
  candidates.dimension = dimension;
  candidates.values = std::move(values);
  return candidates;
}

std::vector<double> values_of(opt::Problem const& problem, opt::Points const& at) {
  std::vector<double> values(at.size());
  problem.evaluate(at, values);
  return values;
}
std::vector<double> residuals_of(opt::DeviationProblem const& problem, opt::Points const& at) {
  std::vector<double> residuals(at.size() * problem.weights().size());
  problem.residuals(at, residuals);
  return residuals;
}

TEST(ReweightedProblem, HasTheResidualsAndTheNewWeights) {
  Plain const base(2);
  ReweightedProblem const other(base, {0.5, 0.0, 0.5});
  EXPECT_EQ(other.dimension(), 2u);
  EXPECT_EQ(std::vector(other.weights().begin(), other.weights().end()), (std::vector{0.5, 0.0, 0.5}));
  auto const at = points(2, {0.3, 0.5, 0.0, 0.0});
  EXPECT_EQ(residuals_of(other, at), residuals_of(base, at));
  auto const values = values_of(other, at);
  EXPECT_NEAR(values[0], 0.5 * 0.3 + 0.5 * 0.7, 1e-15);
  EXPECT_NEAR(values[1], 0.5 * 0.1, 1e-15);
}

TEST(ReweightedProblem, APointWithoutAForceIsInfinite) {
  Plain const base(2);
  ReweightedProblem const other(base, {0.5, 0.0, 0.5});
  EXPECT_EQ(values_of(other, points(2, {0.95, 0.5}))[0], std::numeric_limits<double>::infinity());
}

TEST(HeldCoordinateProblem, TheCoordinateStaysWhereverItStands) {
  Plain const base(3);
  for (std::size_t k = 0; k < 3; ++k) {
    HeldCoordinateProblem const held(base, k, 0.25);
    EXPECT_EQ(held.dimension(), 2u);
    EXPECT_EQ(held.weights().size(), base.weights().size());
    auto all = std::vector{0.6, 0.7};
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(k), 0.25);
    EXPECT_EQ(residuals_of(held, points(2, {0.6, 0.7})), residuals_of(base, points(3, all)));
    auto const two = values_of(held, points(2, {0.1, 0.2, 0.6, 0.7}));
    EXPECT_EQ(two[1], values_of(base, points(3, all))[0]);
    EXPECT_NE(two[0], two[1]);
  }
}

// `residual_rows` must return the same residuals as `residuals`, but with the points side by side in each row.
void expect_the_same_side_by_side(opt::DeviationProblem const& problem, opt::Points const& at) {
  std::size_t const samples = problem.weights().size(), stride = num::padded(at.size());
  auto const expected = residuals_of(problem, at);
  std::vector<double> rows(stride * samples);
  problem.residual_rows(at, stride, rows);
  for (std::size_t i = 0; i < at.size(); ++i)
    for (std::size_t j = 0; j < samples; ++j) EXPECT_EQ(rows[j * stride + i], expected[i * samples + j]);
}

TEST(HeldCoordinateProblem, ResidualsSideBySide) {
  Plain const base(3);
  expect_the_same_side_by_side(base, points(3, {0.1, 0.2, 0.3, 0.6, 0.7, 0.8}));
  expect_the_same_side_by_side(HeldCoordinateProblem(base, 1, 0.25), points(2, {0.1, 0.2, 0.6, 0.7}));
}

// The outline, a coarser problem for the first steps of a search, must have nearly the objective of the problem itself.
void expect_an_outline_of_it(opt::DeviationProblem const& problem, opt::Points const& at) {
  auto const* outline = problem.outline();
  ASSERT_NE(outline, nullptr);
  EXPECT_EQ(outline->dimension(), problem.dimension());
  EXPECT_LT(outline->weights().size(), problem.weights().size() / 2);
  auto const on_outline = problem.on_outline(problem.weights());
  ASSERT_EQ(on_outline.size(), outline->weights().size());
  for (std::size_t j = 0; j < on_outline.size(); ++j) EXPECT_NEAR(on_outline[j], outline->weights()[j], 1e-15);
  double const whole = values_of(problem, at)[0];
  EXPECT_NEAR(values_of(*outline, at)[0], whole, 0.03 * whole);
}

TEST(Outline, OfWhatIsMadeOfOthers) {
  auto const twin = twins::twin_in_box("bilinear", twins::growing_cycles(3, 300));
  fit::LawOnRecord const model(*twin.law, twin.record, laws::Integration::converged);
  fit::IdentificationProblem const problem(model, twin.box);
  auto const at = points(3, {0.3, 0.4, 0.6});
  expect_an_outline_of_it(problem, at);
  // These weights make the first half of the record count twice and the second half not at all.
  std::vector<double> weights(problem.weights().begin(), problem.weights().end());
  double sum = 0.0;
  for (std::size_t j = 0; j < weights.size(); ++j) sum += weights[j] *= j < weights.size() / 2 ? 2.0 : 0.0;
  for (double& weight : weights) weight /= sum;
  ReweightedProblem const reweighted(problem, weights);
  expect_an_outline_of_it(reweighted, at);
  HeldCoordinateProblem const held(problem, 1, 0.4);
  expect_an_outline_of_it(held, points(2, {0.3, 0.6}));
  expect_an_outline_of_it(HeldCoordinateProblem(reweighted, 1, 0.4), points(2, {0.3, 0.6}));
  fit::LawOnRecord const* const models[]{&model, &model, &model};
  SeveralRecordsProblem const joint(models, twin.box, std::vector{0.5, 0.0, 0.5});
  expect_an_outline_of_it(joint, at);
  expect_the_same_side_by_side(joint, points(3, {0.3, 0.4, 0.6, 0.1, 0.2, 0.9}));
}

class JointProblem : public testing::Test {
 protected:
  JointProblem() {
    for (double const amplitude : {1.0, 0.6}) {
      auto motion = twins::growing_cycles(2, amplitude == 1.0 ? 40 : 60);
      for (double& x : motion.disp_mm) x *= amplitude;
      twins_.push_back(twins::twin_in_box("bilinear", motion));
      twins_.back().box = twins_.front().box;
    }
    for (auto const& twin : twins_) models_.emplace_back(*twin.law, twin.record, laws::Integration::converged);
    for (auto const& model : models_) pointers_.push_back(&model);
  }
  fit::SearchBox const& box() const { return twins_.front().box; }

  std::vector<twins::Twin> twins_;
  std::vector<fit::LawOnRecord> models_;
  std::vector<fit::LawOnRecord const*> pointers_;
};

TEST_F(JointProblem, IsTheWeightedMeanOfTheObjectives) {
  std::vector const shares{0.3, 0.7};
  SeveralRecordsProblem const joint(pointers_, box(), shares);
  EXPECT_EQ(joint.dimension(), 3u);
  EXPECT_EQ(joint.weights().size(), models_[0].samples() + models_[1].samples());
  EXPECT_NEAR(std::accumulate(joint.weights().begin(), joint.weights().end(), 0.0), 1.0, 1e-12);
  auto const at = points(3, {0.5, 0.5, 0.5, 0.2, 0.9, 0.4});
  auto const values = values_of(joint, at);
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> parameters(3), work;
    box().expand(at[i], parameters);
    double const mean = 0.3 * models_[0].objective(parameters, work) + 0.7 * models_[1].objective(parameters, work);
    EXPECT_GT(mean, 1e-2);
    EXPECT_NEAR(values[i], mean, 1e-10 * mean);
  }
}

TEST_F(JointProblem, ResidualsOfARecordLieTogetherPointAfterPoint) {
  SeveralRecordsProblem const joint(pointers_, box(), std::vector{0.5, 0.5});
  auto const at = points(3, {0.5, 0.5, 0.5, 0.2, 0.9, 0.4});
  auto const both = residuals_of(joint, at);
  for (std::size_t d = 0; d < 2; ++d) {
    auto const one = residuals_of(fit::IdentificationProblem(models_[d], box()), at);
    for (std::size_t i = 0; i < 2; ++i)
      for (std::size_t j = 0; j < models_[d].samples(); ++j)
        ASSERT_EQ(both[i * joint.weights().size() + (d == 0 ? 0 : models_[0].samples()) + j],
                  one[i * models_[d].samples() + j]);
  }
}

TEST_F(JointProblem, ARecordWithoutAShareIsNotComputed) {
  pointers_[0] = nullptr;
  SeveralRecordsProblem const joint(pointers_, box(), std::vector{0.0, 1.0});
  EXPECT_EQ(joint.weights().size(), models_[1].samples());
  auto const at = points(3, {0.2, 0.9, 0.4});
  EXPECT_EQ(residuals_of(joint, at), residuals_of(fit::IdentificationProblem(models_[1], box()), at));
}

}  // namespace
}  // namespace isolaw::analysis
