#include "isolaw/fit/objective.hpp"

#include <cmath>
#include <limits>

#include "isolaw/base/error.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::fit {
namespace {

std::vector<double> in_unit(std::vector<double> values, double unit) {
  for (double& v : values) v /= unit;
  return values;
}

// Weights of the trapezoidal rule over the true time stamps, divided by the duration.
std::vector<double> time_weights(std::vector<double> const& t) {
  std::vector<double> w(t.size(), 0.0);
  for (std::size_t i = 1; i < t.size(); ++i) {
    w[i - 1] += 0.5 * (t[i] - t[i - 1]);
    w[i] += 0.5 * (t[i] - t[i - 1]);
  }
  for (double& v : w) v /= t.back() - t.front();
  return w;
}

}  // namespace

LawOnRecord::LawOnRecord(laws::LawEntry const& law, data::FitRecord const& record, laws::Integration integration)
    : law_(&law), integration_(integration) {
  if (!law.info.traits.rate_independent && !record.has_time())
    throw Error({.where = "law " + std::string(law.info.id),
                 .found = "the record has no time channel, and this law depends on velocity",
                 .allowed = "rate-independent laws (bilinear, vaiana, bouc-wen, abe, abe-y0) without time",
                 .advice = "--dt SECONDS, the sampling interval of the test"});
  auto const& info = law.info;
  x_ = in_unit(record.disp_mm, info.length.in_record_units);
  v_ = in_unit(record.vel_mm_s, info.length.in_record_units);
  path_ = laws::make_path(x_, v_);
  measured_ = in_unit(record.force_kN, info.force.in_record_units);
  weight_ = time_weights(record.time_s);
  double const spread = num::population_std(measured_);
  for (double& w : weight_) w /= spread;
}

double LawOnRecord::misfit(std::vector<double> const& force) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < measured_.size(); ++i) sum += weight_[i] * std::abs(measured_[i] - force[i]);
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

double LawOnRecord::objective(std::span<double const> parameters, std::vector<double>& work) const {
  work.resize(measured_.size());
  law_->evaluate(parameters, path_, integration_, work);
  return misfit(work);
}

std::vector<double> LawOnRecord::force_kN(std::span<double const> parameters) const {
  std::vector<double> force(measured_.size());
  law_->evaluate(parameters, path_, integration_, force);
  for (double& f : force) f *= law_->info.force.in_record_units;
  return force;
}

double LawOnRecord::integration_shift(std::span<double const> parameters) const {
  if (!law_->info.traits.path_integrated) return 0.0;
  std::vector<double> force;
  double const here = objective(parameters, force);
  auto const fine = laws::make_path(x_, v_, shift_refinement);
  law_->evaluate(parameters, fine, laws::Integration::converged, force);
  return std::abs(misfit(force) - here);
}

void IdentificationProblem::evaluate(opt::Points const& points, std::span<double> values) const {
  std::vector<double> parameters(box_.parameters.size()), force;
  for (std::size_t i = 0; i < points.size(); ++i) {
    box_.expand(points[i], parameters);
    values[i] = model_.objective(parameters, force);
  }
}

}  // namespace isolaw::fit
