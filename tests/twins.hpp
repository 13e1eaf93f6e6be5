// Makes twins of devices. A twin is a record that a law computed from known parameters, so a test knows the parameters
// that a fit should find. Tests may add noise to the record.
#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/hash.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"
#include "isolaw/num/statistics.hpp"

namespace isolaw::twins {

// Returns `cycles` cycles at 0.5 Hz whose amplitude grows in equal steps to 150 mm. The force is an elliptic loop, from
// which the search box is scaled; twin_of() replaces it with the force of the law.
inline data::FitRecord growing_cycles(int cycles, int samples_per_cycle) {
  data::FitRecord record;
  constexpr double omega = std::numbers::pi;
  for (int i = 0; i <= cycles * samples_per_cycle; ++i) {
    double const t = 2.0 * i / samples_per_cycle;
    double const amplitude_mm = 150.0 / cycles * (1 + std::min(i / samples_per_cycle, cycles - 1));
    record.time_s.push_back(t);
    record.disp_mm.push_back(amplitude_mm * std::sin(omega * t));
    record.vel_mm_s.push_back(amplitude_mm * omega * std::cos(omega * t));
    record.force_kN.push_back(0.7 * record.disp_mm.back() + 25.0 * std::cos(omega * t));
  }
  return record;
}

struct Twin {
  laws::LawEntry const* law = nullptr;
  fit::SearchBox box;
  std::vector<double> truth;
  data::FitRecord record;  // without noise
};

inline std::vector<double> force_of(laws::LawEntry const& law, data::FitRecord const& motion,
                                    std::vector<double> const& parameters) {
  return fit::LawOnRecord(law, motion, laws::Integration::converged).force_kN(parameters);
}

inline Twin twin_of(laws::LawEntry const& law, data::FitRecord motion, fit::SearchBox box, std::vector<double> truth) {
  motion.force_kN = force_of(law, motion, truth);
  return {.law = &law, .box = std::move(box), .truth = std::move(truth), .record = std::move(motion)};
}

// Restricts parameters whose box spans both signs to the sign and size that they have for real devices. The true
// parameters are drawn from these narrower boxes.
inline std::vector<fit::Override> usual(std::string_view id) {
  std::vector<fit::Override> overrides;
  if (id == "bouc-wen") overrides.push_back(fit::parse_override("bouc-wen.gamma=0.0003:0.4"));
  if (id == "vaiana")
    for (auto const* text : {"vaiana.beta1+=0.01:10000", "vaiana.beta1-=-10000:-0.01"})
      overrides.push_back(fit::parse_override(text));
  return overrides;
}

// Returns values at which a test may fix parameters that cycles of a bearing do not determine. Searching these
// parameters would take minutes.
inline std::vector<std::string> held(std::string_view id) {
  if (id == "bwbn")
    return {"n=1", "gamma=0.01", "zs=0.3", "p=0.001", "psi=10", "dpsi=0", "dnu=0.000001", "deta=0.000001"};
  return {};
}

// Makes a twin whose true parameters are drawn from the middle of the box that is scaled from the record, between 0.3
// and 0.7 of each interval. Parameters are drawn up to 100 times, until their objective is finite.
inline Twin twin_in_box(std::string_view id, data::FitRecord motion, std::vector<fit::Override> const& overrides = {}) {
  auto const& law = laws::find_law(id);
  auto box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(motion, law.info), overrides);
  auto narrower = usual(id);
  narrower.insert(narrower.end(), overrides.begin(), overrides.end());
  auto middle = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(motion, law.info), narrower);
  for (auto const& change : usual(id))
    middle.parameters[law.index_of(change.parameter)].scale = laws::Scale::logarithmic;
  fit::LawOnRecord const scale(law, motion, laws::Integration::converged);
  num::Stream const stream(stable_hash(id));
  std::vector<double> truth(box.parameters.size()), point(box.free_count()), work;
  for (std::uint32_t i = 0; i < 100; ++i) {
    num::Draws draws(stream, 0, i);
    for (double& u : point) u = 0.3 + 0.4 * draws.uniform();
    middle.expand(point, truth);
    if (std::isfinite(scale.objective(truth, work))) break;
  }
  return twin_of(law, std::move(motion), std::move(box), truth);
}

// Normally distributed noise. `share` is the standard deviation of the noise divided by that of the force;
// `correlation` is the correlation between the noise of neighbouring samples.
struct Noise {
  double share = 0.01;
  double correlation = 0.0;
};

inline data::FitRecord with_noise(data::FitRecord record, Noise const& noise, num::Draws& draws) {
  double const spread = noise.share * num::population_std(record.force_kN);
  double const fresh = std::sqrt(1.0 - noise.correlation * noise.correlation);
  double error = draws.normal();
  for (double& force : record.force_kN) {
    force += spread * error;
    error = noise.correlation * error + fresh * draws.normal();
  }
  return record;
}

// Returns the error divided by the true value, or by the width of the box if the true value is zero.
inline double relative_error(fit::SearchParameter const& parameter, double value, double truth) {
  double const size = truth != 0.0 ? std::abs(truth) : parameter.upper - parameter.lower;
  return std::abs(value - truth) / size;
}

}  // namespace isolaw::twins
