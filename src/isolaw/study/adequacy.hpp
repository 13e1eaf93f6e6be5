// Whether a law describes the tested devices at all, and whether its parameters agree between them by themselves: what
// a law must be before it is compared with others. docs/decision.md has the reasons.
#pragma once

#include <cstddef>
#include <string>

#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Means over the devices: of the objective, and of the magnitudes of the errors on the compared cycle.
inline constexpr double adequate_objective = 0.3;
inline constexpr double adequate_K_eff_percent = 15.0, adequate_energy_percent = 30.0;

// "misses the measured force by 7.9 % of its standard deviation on average", of a law that was identified.
std::string miss_text(LawResult const& law);

// Why the law does not describe the devices, as the end of a sentence about it; empty where it does.
std::string inadequacy(LawResult const& law);

// Parameters that lie at a bound on half of the devices or more agree because the box does. One device agrees with
// itself whatever the box is: it has none.
struct Pinned {
  std::size_t count = 0, calibrated = 0;
  bool decides() const { return 3 * count >= calibrated && count > 0; }  // a third of them: the law is not robust
  std::string text() const;  // "2 of its 5 parameters lie at a bound on half of the devices or more"
};
Pinned pinned(LawResult const& law);

}  // namespace isolaw::study
