#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "isolaw/fit/objective.hpp"
#include "isolaw/num/random.hpp"
#include "laws/motion.hpp"

namespace isolaw::law_tests {

// Returns the number of parameter sets that a test draws: the environment variable ISOLAW_DRAWS, or else `by_default`.
inline std::uint32_t draws(std::uint32_t by_default) {
  char const* const text = std::getenv("ISOLAW_DRAWS");
  return text == nullptr ? by_default : static_cast<std::uint32_t>(std::strtoul(text, nullptr, 10));
}

// Returns a record whose loop is an ellipse: the device is a linear spring beside a viscous damper, which has the force
// `strength_kN` at the largest velocity.
inline data::FitRecord record_of(Motion const& motion, double interval_s, double stiffness_kN_mm, double strength_kN) {
  data::FitRecord record;
  double const fastest = largest_magnitude(motion.velocity_mm_s);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    double const x = motion.disp_mm[i], v = motion.velocity_mm_s[i];
    record.time_s.push_back(interval_s * static_cast<double>(i));
    record.disp_mm.push_back(x);
    record.vel_mm_s.push_back(v);
    record.force_kN.push_back(stiffness_kN_mm * x + strength_kN * v / fastest);
  }
  return record;
}

// Returns the random parameter set number `index`. Each free parameter is uniform in its interval of the box, on its
// own scale (linear or logarithmic).
inline std::vector<double> candidate_in(fit::SearchBox const& box, std::uint32_t index) {
  num::Draws draws(num::Stream(20250110), 0, index);
  std::vector<double> point(box.free_count()), values(box.parameters.size());
  for (double& u : point) u = draws.uniform();
  box.expand(point, values);
  return values;
}

// Returns the force that a law gives for a motion in mm and mm/s, in the law's unit of force.
inline std::vector<double> forces(laws::LawEntry const& law, std::span<double const> parameters, Motion const& motion,
                                  laws::Integration integration, int refinement = 1) {
  double const unit = 1.0 / law.info.length.in_record_units;
  auto const x = scaled(motion, unit, unit);
  std::vector<double> force(motion.size());
  law.evaluate(parameters, laws::make_path(x.disp_mm, x.velocity_mm_s, refinement), integration, force);
  return force;
}

inline std::string describe(laws::LawEntry const& law, std::span<double const> values) {
  std::string text(law.info.id);
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("{} {} = {}", i == 0 ? ":" : ",", law.parameters[i].name, values[i]);
  return text;
}

inline std::vector<std::string> law_ids() {
  std::vector<std::string> ids;
  for (auto const& law : laws::catalogue()) ids.emplace_back(law.info.id);
  return ids;
}

struct ByLaw {
  template <class Info>
  std::string operator()(Info const& info) const {
    std::string name = info.param;
    std::ranges::replace(name, '-', '_');
    return name;
  }
};

}  // namespace isolaw::law_tests
