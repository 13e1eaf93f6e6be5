// Whether a law describes the tested devices at all, and whether its parameters agree between them by themselves: both
// are asked before laws are compared. docs/decision.md has the reasons.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Means over the devices: of the objective, and of the magnitudes of the errors on the compared cycle.
inline constexpr double adequate_objective = 0.3;
inline constexpr double adequate_K_eff_percent = 15.0, adequate_energy_percent = 30.0;

// By what the law does not describe the devices (FindingKind::law_inadequate); nullopt where it does, and for a law
// that was not identified.
std::optional<Finding> inadequacy(LawResult const& law);
inline bool is_adequate(LawResult const& law) {
  return !inadequacy(law);
}

// Parameters that lie at a bound on half of the devices or more agree because the search box makes them agree. A single
// device agrees with itself whatever the box is, so it has none.
struct Pinned {
  std::size_t count = 0, calibrated = 0;
  bool decides() const { return 3 * count >= calibrated && count > 0; }  // a third of them: the law is not robust
  Finding finding(std::string const& law) const;                         // FindingKind::held_by_box
};
Pinned pinned(LawResult const& law);

}  // namespace isolaw::study
