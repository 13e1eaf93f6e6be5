// Property modification factors lambda: what the properties of a lot may be, as multiples of their design value, and
// how the factors of ageing and environment, of the test and of the supply combine (ASCE/SEI 7, chapter 17; the
// combination of other standards is the same with other numbers, which the rule set holds).
//
// The scatter between devices and that of the whole isolation system are kept apart: the system is the sum of its
// devices, and sums scatter less. Taking the spread of single devices for the system overstates its bounds manyfold.
#pragma once

#include <optional>

#include "isolaw/rules/measured.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::rules {

struct FactorPair {
  double min = 1.0, max = 1.0;
};

// lambda_test of one device: the largest and the smallest of its counted cycles over mean(P_1..P_3). Where a property
// falls from cycle to cycle these are P_1 and P_n, as ASCE/SEI 7 has it; where it does not, the first or the last alone
// would leave out what was measured. Of equal cycles the first is the largest and the last the smallest. nullopt
// without the first three cycles or where a value is no positive number.
struct TestFactors {
  double min = 1.0, max = 1.0;
  int min_cycle = 0, max_cycle = 0;

  FactorPair pair() const { return {.min = min, .max = max}; }
};
std::optional<TestFactors> test_factors(Quantity quantity, BlockValues const& block);

struct CombinedFactors {
  double min = 1.0, max = 1.0;
  bool max_is_default = false, min_is_default = false;  // the rule's least upper or largest lower factor took over
};

// max = (1 + f (environment.max - 1)) test.max spec.max, not below max_not_below; min = (1 - f (1 - environment.min))
// test.min spec.min, not above min_not_above; f the rule's system factor.
CombinedFactors combine(FactorRule const& rule, FactorPair const& environment, FactorPair const& test,
                        FactorPair const& spec);

// Half widths in percent of the mean, two-sided 95 % of the normal distribution (1.960 standard deviations), for a
// known coefficient of variation `cov_percent` between devices.
//   The mean over all `installed` devices: the mean of N independent ones scatters by CoV/sqrt(N). N = 28, CoV 7 %:
//   2.6 %. Where `tested` of them were measured, only the others are still unknown, which the factor of a finite
//   population, sqrt((N - n)/(N - 1)), takes into account: 2.3 % with 6 tested, nothing with all.
//   The mean and the CoV count as known; prediction_half_width_percent() does without that.
double system_half_width_percent(double cov_percent, int installed, int tested);
//   The same about the mean of the `tested` devices, whose own mean and CoV are estimates: t(0.975, n - 1) CoV
//   sqrt(1/n - 1/N), the prediction of a finite population's mean (Cochran 1977, 2.8). N = 28, n = 6, CoV 7 %: 6.5 %.
//   NaN for fewer than two tested.
double prediction_half_width_percent(double cov_percent, int installed, int tested);

}  // namespace isolaw::rules
