#include "isolaw/study/adequacy.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "isolaw/study/findings.hpp"
#include "isolaw/study/spoken.hpp"

namespace isolaw::study {

std::string inadequacy(LawResult const& law) {
  std::vector<std::string> parts;
  if (law.objective.mean && !(*law.objective.mean <= adequate_objective))
    parts.push_back(fmt::format("misses the measured force by {} of its standard deviation on average",
                                percent(*law.objective.mean)));
  auto const add = [&](std::optional<double> DeviceFit::*error, double most, std::string_view what) {
    // Relative to nothing an error says nothing.
    if (auto const mean = mean_magnitude(law, error); mean && std::isfinite(*mean) && *mean > most)
      parts.push_back(fmt::format("misses the {} by {}", what, percent(*mean / 100.0)));
  };
  add(&DeviceFit::K_eff_error_percent, adequate_K_eff_percent, "effective stiffness");
  add(&DeviceFit::energy_error_percent, adequate_energy_percent, "dissipated energy");
  return fmt::format("{}", fmt::join(parts, ", "));
}

Pinned pinned(LawResult const& law) {
  Pinned made;
  auto const& parameters = parameters_of(law);
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    if (!parameters[n].free) continue;
    ++made.calibrated;
    std::size_t devices = 0, there = 0;
    for (auto const& fit : law.devices) {
      if (n >= fit.parameters.size()) continue;
      ++devices;
      if (!fit.parameters[n].at_bound.empty()) ++there;
    }
    if (2 * there >= devices && there > 0) ++made.count;
  }
  return made;
}

}  // namespace isolaw::study
