#include "isolaw/fit/as_springs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "isolaw/fit/objective.hpp"
#include "isolaw/laws/plane/springs.hpp"
#include "isolaw/opt/multistart.hpp"

namespace isolaw::fit {
namespace {

// One spring, or two at mirrored angles. In the direction of the test their force is `force` times that of `law`.
struct Share {
  LawOnMotion law;
  double force;
};

// Equal springs, each with the law, at equal angles around a circle, on one device's record. They move along spring 0.
class SpringsOnRecord {
 public:
  SpringsOnRecord(laws::LawEntry const& law, data::FitRecord const& record, int refinement)
      : model_(law, record, laws::Integration::converged, laws::TurningPoints::as_sampled, refinement),
        measured_(record.force_kN),
        spreads_(model_.spreads_kN()) {
    constexpr int count = laws::usual_springs;
    auto const [force_share, way_share] = laws::spring_shares(count);
    for (int i = 0; i < count; ++i) {
      double const along = std::cos(std::numbers::pi * i / count);
      if (2 * i == count) continue;  // this spring is at right angles to the motion, so it neither moves nor pulls
      // For an odd law (its force changes sign with the motion), springs i and count - i give the same force in the
      // direction of the test. Spring i counts twice, and spring count - i is left out.
      bool const mirrored = law.info.traits.odd && i > 0;
      if (mirrored && 2 * i > count) break;
      auto motion = record;
      for (double& x : motion.disp_mm) x *= way_share * along;
      for (double& v : motion.vel_mm_s) v *= way_share * along;
      shares_.push_back(
          {LawOnMotion(law, motion, laws::Integration::converged, laws::TurningPoints::as_sampled, refinement),
           force_share * along * (mirrored ? 2.0 : 1.0)});
    }
  }

  std::size_t size() const { return measured_.size(); }
  std::span<double const> weights() const { return model_.residual_weights(); }
  // The objective of the law along one direction, without springs.
  double objective_of_law(std::span<double const> parameters) const {
    std::vector<double> work;
    return model_.objective(parameters, work);
  }
  void residuals_of(std::span<double const> parameters, std::span<double> found) const {
    std::vector<double> one(size());
    std::ranges::copy(measured_, found.begin());
    for (auto const& [law, force] : shares_) {
      law.force_kN(parameters, one);
      for (std::size_t j = 0; j < size(); ++j) found[j] -= force * one[j];
    }
    for (std::size_t j = 0; j < size(); ++j) found[j] /= spreads_[j];
  }

 private:
  LawOnRecord model_;
  std::vector<Share> shares_;
  std::vector<double> measured_, spreads_;
};

// Finds the springs' parameters that minimise the mean of the objective over all records.
class SpringsProblem final : public opt::DeviationProblem {
 public:
  SpringsProblem(laws::LawEntry const& law, std::span<data::FitRecord const* const> records, SearchBox const& box,
                 int refinement)
      : box_(box), parameters_(law.parameters.size()) {
    auto const count = static_cast<double>(records.size());
    for (auto const* record : records) {
      auto const& springs = records_.emplace_back(law, *record, refinement);
      size_ += springs.size();
      for (double const weight : springs.weights()) weights_.push_back(weight / count);
    }
  }

  std::size_t dimension() const override { return box_.free_count(); }
  std::span<double const> weights() const override { return weights_; }
  void evaluate(opt::Points const& points, std::span<double> values) const override {
    std::vector<double> found(size_);
    for (std::size_t i = 0; i < points.size(); ++i) {
      residuals_at(points[i], found);
      values[i] = weighted_sum(found);
    }
  }
  void residuals(opt::Points const& points, std::span<double> values) const override {
    for (std::size_t i = 0; i < points.size(); ++i) residuals_at(points[i], values.subspan(i * size_, size_));
  }
  double objective_of_law(std::span<double const> parameters) const {
    double mean = 0.0;
    for (auto const& record : records_)
      mean += record.objective_of_law(parameters) / static_cast<double>(records_.size());
    return mean;
  }
  double objective(std::span<double const> parameters) const {
    std::vector<double> found(size_);
    residuals_of(parameters, found);
    return weighted_sum(found);
  }

 private:
  double weighted_sum(std::span<double const> residuals) const {
    double sum = 0.0;
    for (std::size_t j = 0; j < size_; ++j) sum += weights()[j] * std::abs(residuals[j]);
    return std::isfinite(sum) ? sum : opt::infinity;
  }
  void residuals_at(std::span<double const> point, std::span<double> found) const {
    std::vector<double> parameters(parameters_);
    box_.expand(point, parameters);
    residuals_of(parameters, found);
  }
  void residuals_of(std::span<double const> parameters, std::span<double> found) const {
    for (auto const& record : records_) {
      record.residuals_of(parameters, found.first(record.size()));
      found = found.subspan(record.size());
    }
  }

  SearchBox const& box_;
  std::vector<SpringsOnRecord> records_;
  std::size_t size_ = 0, parameters_;
  std::vector<double> weights_;
};

}  // namespace

SpringsFit fitted_as_springs(laws::LawEntry const& law, std::span<data::FitRecord const* const> records,
                             SearchBox const& box, std::vector<double> parameters, int refinement) {
  SpringsProblem const springs(law, records, box, refinement);
  SpringsFit result{
      .parameters = {}, .law = springs.objective_of_law(parameters), .given = springs.objective(parameters)};
  result.fitted = result.given;
  result.parameters = std::move(parameters);
  if (box.free_count() == 0) return result;
  auto const found = opt::descend(springs, box.contract(result.parameters));
  if (!found.usable() || found.best_value >= result.given) return result;
  box.expand(found.best, result.parameters);
  result.fitted = found.best_value;
  return result;
}

SpringsFit fitted_as_springs(laws::LawEntry const& law, data::FitRecord const& record, SearchBox const& box,
                             std::vector<double> parameters, int refinement) {
  data::FitRecord const* const one[]{&record};
  return fitted_as_springs(law, one, box, std::move(parameters), refinement);
}

}  // namespace isolaw::fit
