// Compares the conditions under which the devices of a lot were tested. Statistics and a verdict of the lot hold for
// one condition only.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/base/finding.hpp"
#include "isolaw/study/summary.hpp"

namespace isolaw::study {

// Compares the temperature, frequency, vertical load and amplitude of the blocks that are assessed, the largest
// amplitude before each of them, and the number of earlier cycles that are as large. The allowed difference between
// devices is the first of these that is known:
// 1. the rule set's tolerance between tests that count as one condition;
// 2. twice the rule set's tolerance from the design, since each of two devices may differ from the design by it;
// 3. the tolerance stated in the lot file or the command (campaign::Alike);
// 4. isolaw's own tolerance (also in campaign::Alike).
// For each condition that differs by more, the finding has the smallest and largest value and the allowed difference.
// It also says where the tolerances come from. nullopt if no condition differs by more.
std::optional<Finding> conditions_differ(Summary const& summary);

// The usual amplitude of a lot's tests. Outliers are sought only among devices tested at this amplitude, because the
// properties of a bearing change with amplitude: another amplitude would make a sound device an outlier. It is the
// median or, for an even number of devices, the smaller of the two middle values, so some device was tested at it.
struct UsualAmplitude {
  // allowed_percent: how far two amplitudes may differ, in percent of the larger one (the rule of conditions_differ()).
  double mm = 0.0, allowed_percent = 0.0;

  bool has(double amplitude_mm) const;
};
UsualAmplitude usual_amplitude(std::vector<double> amplitudes_mm, rules::RuleSet const& rules,
                               campaign::Alike const& alike);

// Makes the verdicts on the lot itself (sample size, means) "not assessed", because its devices were tested under
// different conditions.
void withhold_lot_verdicts(LotAcceptance& acceptance);

}  // namespace isolaw::study
