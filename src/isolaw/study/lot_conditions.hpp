// Compares the conditions under which the devices of a lot were tested. Statistics and a verdict of the lot hold for
// one condition only.
#pragma once

#include <optional>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Compares temperature, frequency, vertical load and amplitude of the cycles that count, and the largest amplitude
// before them. Devices may differ by what the rule set says of tests of one condition; else by twice its tolerance from
// the design, since each device may differ from the design by the tolerance; else by what the lot file or the command
// says (campaign::Alike); else by 2 °C, 10 % of frequency and load, and 5 % of amplitude. The finding has the smallest,
// the largest and the allowed difference of each condition that differs by more, and says where the tolerances come
// from. nullopt if none does.
std::optional<Finding> conditions_differ(Summary const& summary);

// Makes the verdicts on the lot itself (sample size, means) "not assessed", as its devices' conditions differ.
void withhold_lot_verdicts(LotAcceptance& acceptance);

}  // namespace isolaw::study
