// Compares the conditions under which the devices of a lot were tested. Statistics and a verdict of the lot hold for
// one condition only.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Compares temperature, frequency, vertical load and amplitude of the cycles that count, the largest amplitude before
// them, and the number of cycles before them of at least their amplitude. Devices may differ by what the rule set says
// of tests of one condition; else by twice its tolerance from the design, since each device may differ from the design
// by the tolerance; else by what the lot file or the command says (campaign::Alike); else by isolaw's own tolerances
// (also there). The finding has the smallest, the largest and the allowed difference of each condition that differs by
// more, and says where the tolerances come from. nullopt if none does.
std::optional<Finding> conditions_differ(Summary const& summary);

// Measured values of tests at another amplitude would make a device an outlier for a reason that is not its own, so
// outliers are sought only among the devices of the usual amplitude. This is the median or, of an even number, the
// smaller of the two middle ones, since it must be that of a device.
struct UsualAmplitude {
  double mm = 0.0, allowed_percent = 0.0;  // of the larger of two amplitudes, as conditions_differ() allows

  bool has(double amplitude_mm) const;
};
UsualAmplitude usual_amplitude(std::vector<double> amplitudes_mm, rules::RuleSet const& rules,
                               campaign::Alike const& alike);

// Makes the verdicts on the lot itself (sample size, means) "not assessed", as its devices' conditions differ.
void withhold_lot_verdicts(LotAcceptance& acceptance);

}  // namespace isolaw::study
