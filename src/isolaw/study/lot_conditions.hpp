// Compares the conditions under which the devices of a lot were tested. Statistics and a verdict of the lot hold for
// one condition only.
#pragma once

#include <optional>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Compares temperature, frequency, vertical load and amplitude of the cycles that count, and the largest amplitude
// before them. Devices may differ by twice the rule set's tolerance, since each may differ from the design by the
// tolerance. If the set has none, they may differ by 10 % in frequency and load and by 5 % in amplitude; in
// temperature always by 2 °C. The finding has the smallest and largest value of each condition that differs by more.
// nullopt if none does.
std::optional<Finding> conditions_differ(Summary const& summary);

// Makes the verdicts on the lot itself (sample size, means) "not assessed", as its devices' conditions differ.
void withhold_lot_verdicts(LotAcceptance& acceptance);

}  // namespace isolaw::study
