#include "isolaw/study/adequacy.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {

// Objectives differ in their third digit, so they keep one decimal.
std::string miss_text(LawResult const& law) {
  return fmt::format("misses the measured force by {} % of its standard deviation on average",
                     with_decimals(100.0 * *law.objective.mean, 1));
}

std::string inadequacy(LawResult const& law) {
  std::vector<std::string> parts;
  if (law.objective.mean && !(*law.objective.mean <= adequate_objective)) parts.push_back(miss_text(law));
  auto const add = [&](std::optional<double> DeviceFit::*error, double most, std::string_view what) {
    // Relative to nothing an error says nothing.
    if (auto const mean = mean_magnitude(law, error); mean && std::isfinite(*mean) && *mean > most)
      parts.push_back(fmt::format("misses the {} by {}", what, percent(*mean / 100.0)));
  };
  add(&DeviceFit::K_eff_error_percent, adequate_K_eff_percent, "effective stiffness");
  add(&DeviceFit::energy_error_percent, adequate_energy_percent, "dissipated energy");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string Pinned::text() const {
  return fmt::format("{} of its {} parameters lie at a bound on half of the devices or more", count, calibrated);
}

Pinned pinned(LawResult const& law) {
  Pinned made;
  if (std::ranges::count_if(law.devices, [](auto const& fit) { return fit_status(fit) == "ok"; }) < 2) return made;
  auto const& parameters = parameters_of(law);
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    if (!parameters[n].free) continue;
    ++made.calibrated;
    std::size_t devices = 0, there = 0;
    for (auto const& fit : law.devices) {
      if (n >= fit.parameters.size() || fit_status(fit) != "ok") continue;
      ++devices;
      if (!fit.parameters[n].at_bound.empty()) ++there;
    }
    if (2 * there >= devices && there > 0) ++made.count;
  }
  return made;
}

}  // namespace isolaw::study
