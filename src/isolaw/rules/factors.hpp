// Property modification factors lambda: the largest and the smallest value of a property, each divided by a reference
// value. combine() multiplies the factors of ageing and environment, of the test (from cycle to cycle) and of the
// manufacturer's specification (from device to device) as ASCE/SEI 7, chapter 17, does. Other standards use the same
// formulas with other numbers, which the rule set holds. The scatter of single devices is kept apart from that of the
// isolation system. The system is the sum of its devices and scatters less; bounds of the system that are taken from
// the scatter of single devices would be several times too wide.
#pragma once

#include <optional>

#include "isolaw/rules/measured.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::rules {

struct FactorPair {
  double min = 1.0, max = 1.0;
};

// lambda_test of one device: the largest and the smallest of the values P_1 to P_n in its counted cycles (data/cycles),
// each divided by mean(P_1..P_3). If a property falls from cycle to cycle, these are P_1 and P_n, as in ASCE/SEI 7. If
// it does not, P_1 and P_n would miss larger or smaller values. Among equal cycles, the first counts as the largest and
// the last as the smallest. test_factors() is nullopt without the first three cycles, or if a value is not positive.
struct TestFactors {
  double min = 1.0, max = 1.0;
  int min_cycle = 0, max_cycle = 0;

  FactorPair pair() const { return {.min = min, .max = max}; }
};
std::optional<TestFactors> test_factors(Quantity quantity, BlockValues const& block);

struct CombinedFactors {
  double min = 1.0, max = 1.0;
  bool max_is_default = false, min_is_default = false;  // true if the rule's max_not_below or min_not_above was taken
};

// max = (1 + f (environment.max - 1)) test.max spec.max, at least max_not_below; min = (1 - f (1 - environment.min))
// test.min spec.min, at most min_not_above; f is the rule's system factor.
CombinedFactors combine(FactorRule const& rule, FactorPair const& environment, FactorPair const& test,
                        FactorPair const& spec);
// Half width of the 95 % interval (1.960 standard deviations) of the mean over all `installed` devices, in percent of
// that mean, if the lot's mean and its coefficient of variation `cov_percent` are taken as known. A mean of N
// independent devices scatters by CoV/sqrt(N): half width 2.6 % for N = 28 and CoV 7 %. If n of them are `tested`, only
// the others are unknown. The factor of a finite population, sqrt((N - n)/(N - 1)), gives 2.3 % for n = 6 and 0 if all
// are tested.
double system_half_width_percent(double cov_percent, int installed, int tested);
// Half width of the 95 % interval of the mean over all `installed` devices about the mean of the `tested` ones, if mean
// and CoV are only estimates: t(0.975, n-1) CoV sqrt(1/n - 1/N) (Cochran 1977, 2.8). It is 6.5 % for N = 28, n = 6 and
// a CoV of 7 %. NaN for fewer than two tested devices.
double prediction_half_width_percent(double cov_percent, int installed, int tested);

}  // namespace isolaw::rules
