// Answers two questions before a law is compared with others: does it describe the tested devices at all, and would its
// parameters still agree between the devices if the search box were wider? docs/decision.md has the reasons.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// A law is adequate if it exceeds none of these limits. They apply to means over the devices: the mean objective, and
// the mean magnitudes of the errors of K_eff and energy in the cycle where law and test are compared (normally the
// reported one).
inline constexpr double adequate_objective = 0.3;
inline constexpr double adequate_K_eff_percent = 15.0, adequate_energy_percent = 30.0;
// The errors by which the law exceeds these limits (FindingKind::law_inadequate); nullopt for an adequate law, and for
// a law that was not identified.
std::optional<Finding> inadequacy(LawResult const& law);
inline bool is_adequate(LawResult const& law) {
  return !inadequacy(law);
}

// `calibrated` is the number of free parameters. `count` is the number of free parameters that lie at a bound on at
// least half of the devices. Such a parameter agrees between the devices only because of the search box. With fewer
// than two fitted devices there are no values to compare, and both numbers are 0.
struct Pinned {
  std::size_t count = 0, calibrated = 0;
  bool decides() const { return 3 * count >= calibrated && count > 0; }  // true: the search box decides this law's beta
  Finding finding(std::string const& law) const;                         // says that the box decides beta (held_by_box)
};
Pinned pinned(LawResult const& law);

}  // namespace isolaw::study
