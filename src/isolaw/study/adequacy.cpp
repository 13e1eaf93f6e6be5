#include "isolaw/study/adequacy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "isolaw/study/findings.hpp"

namespace isolaw::study {

std::optional<Finding> inadequacy(LawResult const& law) {
  Finding finding{.kind = FindingKind::law_inadequate, .law = law.id};
  if (law.objective.mean && !(*law.objective.mean <= adequate_objective))
    finding.numbers.push_back({"misfit", *law.objective.mean});
  auto const add = [&](std::optional<double> DeviceFit::*error, double most, std::string name) {
    // Where the measured value is zero, the relative error is infinite. It cannot be judged and is left out.
    if (auto const mean = mean_magnitude(law, error); mean && std::isfinite(*mean) && *mean > most)
      finding.numbers.push_back({std::move(name), *mean});
  };
  add(&DeviceFit::K_eff_error_percent, adequate_K_eff_percent, "K_eff_error_percent");
  add(&DeviceFit::energy_error_percent, adequate_energy_percent, "energy_error_percent");
  return finding.numbers.empty() ? std::nullopt : std::optional(std::move(finding));
}

Finding Pinned::finding(std::string const& law) const {
  return {.kind = FindingKind::held_by_box,
          .law = law,
          .numbers = {{"count", static_cast<double>(count)}, {"calibrated", static_cast<double>(calibrated)}}};
}

Pinned pinned(LawResult const& law) {
  Pinned result;
  auto fits = law.counting();
  if (std::ranges::count_if(fits, [](auto const& fit) { return fit_status(fit) == "ok"; }) < 2) return result;
  auto const& parameters = parameters_of(law);
  for (std::size_t n = 0; n < parameters.size(); ++n) {
    if (!parameters[n].free) continue;
    ++result.calibrated;
    std::size_t devices = 0, held = 0;
    for (auto const& fit : fits) {
      if (n >= fit.parameters.size() || fit_status(fit) != "ok") continue;
      ++devices;
      if (fit.parameters[n].at_bound != fit::AtBound::no) ++held;
    }
    if (2 * held >= devices && held > 0) ++result.count;
  }
  return result;
}

}  // namespace isolaw::study
