// Two questions before a law is compared with others: does it describe the tested devices at all, and do its parameters
// agree between the devices without the help of the search box? docs/decision.md has the reasons.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Limits of an adequate law: means over the devices of the objective and of the errors on the compared cycle.
inline constexpr double adequate_objective = 0.3;
inline constexpr double adequate_K_eff_percent = 15.0, adequate_energy_percent = 30.0;
// The errors by which the law exceeds these limits (FindingKind::law_inadequate); nullopt for an adequate law, and for
// a law that was not identified.
std::optional<Finding> inadequacy(LawResult const& law);
inline bool is_adequate(LawResult const& law) {
  return !inadequacy(law);
}

// Counts the calibrated parameters that lie at a bound on at least half of the devices: they agree only because of the
// search box. With one device both counts are 0, since a single device agrees with itself whatever the box is.
struct Pinned {
  std::size_t count = 0, calibrated = 0;
  bool decides() const { return 3 * count >= calibrated && count > 0; }  // from a third on, the law is not robust
  Finding finding(std::string const& law) const;                         // FindingKind::held_by_box
};
Pinned pinned(LawResult const& law);

}  // namespace isolaw::study
