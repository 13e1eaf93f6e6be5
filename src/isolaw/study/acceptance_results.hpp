// The rows (results.hpp) from which inspection.json, the page's data, tests.csv, lot.csv and lambda.csv print the
// assessments of the devices and the lot. A test compares docs/inspection-json.md with these rows.
#pragma once

#include "isolaw/study/acceptance.hpp"
#include "isolaw/study/results.hpp"
#include "isolaw/study/verdict.hpp"

namespace isolaw::study {

struct AssessmentOf {
  rules::Assessment const& assessment;
  std::optional<int> block;
};

template <auto member>
Value of_assessment(AssessmentOf const& row) {
  return get<member>(row.assessment);
}

inline constexpr Result<AssessmentOf> assessment_results[]{
    {"quantity", "", "quantity", "what was assessed, such as `\"K_eff, positive side\"`",
     of_assessment<&rules::Assessment::quantity>},
    {"property", "", "", "the property whose value was assessed", of_assessment<&rules::Assessment::property>},
    {"subject", "", "",
     "what is compared with the limit: the property of one `\"device\"`, its change over `\"cycles\"` or vertical `\"loads\"`, its mean over the `\"lot\"`, or the size of the `\"sample\"`",
     of_assessment<&rules::Assessment::subject>},
    {"side", "", "", "the side of the loop from which the value is: `\"both\"`, `\"positive\"` or `\"negative\"`",
     of_assessment<&rules::Assessment::side>},
    {"block", "", "block", "number of the block from which the value is", get<&AssessmentOf::block>},
    {"clause", "", "clause", "clause of the rule set's text", of_assessment<&rules::Assessment::clause>},
    {"formula", "", "formula",
     "the formula and the cycles from which the value is computed, such as `\"F+/d+, cycle 3\"`",
     of_assessment<&rules::Assessment::formula>},
    {"value", own_unit, "value", "measured value", of_assessment<&rules::Assessment::value>},
    {"unit", "", "unit", "unit of `value` and `nominal`", of_assessment<&rules::Assessment::unit>},
    {"nominal", own_unit, "design value", "design value", of_assessment<&rules::Assessment::nominal>},
    {"deviation_percent", "%", "deviation", "deviation of `value` from `nominal`",
     of_assessment<&rules::Assessment::deviation_percent>},
    {"deviation", "", "",
     "`deviation_percent` as reports print it, with enough decimals to show on which side of the limit it lies",
     of_assessment<&rules::Assessment::deviation>},
    {"limit", "", "limit", "limit in words; empty if there is none", of_assessment<&rules::Assessment::limit>},
    {"lower_percent", "%", "", "smallest `deviation_percent` that the limit allows",
     of_assessment<&rules::Assessment::lower_percent>},
    {"upper_percent", "%", "", "largest `deviation_percent` that the limit allows",
     of_assessment<&rules::Assessment::upper_percent>},
    {"verdict", "", "verdict",
     "result of the comparison; only a verified rule set gives pass or fail ([rules](rules.md))",
     of_assessment<&rules::Assessment::verdict>},
    {"reason", "", "reason", "why there is neither pass nor fail; empty otherwise",
     of_assessment<&rules::Assessment::reason>},
};

inline constexpr Result<rules::LotQuantity> quantity_results[]{
    {"quantity", "", "quantity", "property to which the statistics belong", get<&rules::LotQuantity::quantity>},
    {"unit", "", "unit", "unit of the values of this property", get<&rules::LotQuantity::unit>},
    {"n", "", "with a value", "number of devices with a value", get<&rules::LotQuantity::count>},
    {"without", "", "", "devices without a value", get<&rules::LotQuantity::devices_without_value>},
    {"mean", own_unit, "mean", "mean over the devices with a value", get<&rules::LotQuantity::mean>},
    {"sd", own_unit, "std", "standard deviation over the devices (divisor n - 1)", get<&rules::LotQuantity::std>},
    {"cov_percent", "%", "CoV", "coefficient of variation: `sd` divided by `mean`",
     get<&rules::LotQuantity::cov_percent>},
    {"min", own_unit, "min", "smallest value", get<&rules::LotQuantity::min>},
    {"min_device", "", "min device", "the device with the smallest value; empty if there is none",
     get<&rules::LotQuantity::min_device>},
    {"max", own_unit, "max", "largest value", get<&rules::LotQuantity::max>},
    {"max_device", "", "max device", "the device with the largest value; empty if there is none",
     get<&rules::LotQuantity::max_device>},
    {"nominal", own_unit, "design value", "design value", get<&rules::LotQuantity::nominal>},
    {"deviation_of_mean_percent", "%", "deviation of the mean", "deviation of `mean` from the design value",
     get<&rules::LotQuantity::mean_deviation_percent>},
    {"worst_deviation_percent", "%", "worst deviation",
     "deviation of a device from the design value: that of the device farthest from it",
     get<&rules::LotQuantity::worst_deviation_percent>},
    {"worst_device", "", "worst device", "the device that is farthest from the design value; empty if there is none",
     get<&rules::LotQuantity::worst_device>},
    {"fractile_5", own_unit, "5 % fractile", "mean minus 1.645 standard deviations",
     get<&rules::LotQuantity::fractile_5>},
    {"fractile_95", own_unit, "95 % fractile", "mean plus 1.645 standard deviations",
     get<&rules::LotQuantity::fractile_95>},
    {"tolerance_k", "", "tolerance factor k 95/95",
     "tolerance factor k: with 95 % confidence, mean ± k standard deviations holds 95 % of all devices",
     get<&rules::LotQuantity::tolerance_factor>},
    {"tolerance_lower", own_unit, "tolerance low", "mean minus k standard deviations",
     get<&rules::LotQuantity::tolerance_low>},
    {"tolerance_upper", own_unit, "tolerance high", "mean plus k standard deviations",
     get<&rules::LotQuantity::tolerance_high>},
    {"no_lower_bound", "", "no lower bound",
     "why `fractile_5` or `tolerance_lower` is missing (it would not be above zero); empty otherwise",
     get<&rules::LotQuantity::no_lower>},
    {"lambda_test", "", "",
     "`min`, `max`: smallest and largest lambda_test of any device; `min_cycle`, `min_device`, `max_cycle`, `max_device`: the cycle and the device in which it was measured",
     nested<rules::LotQuantity>},
    {"limit_individual", "", "limit of a device",
     "the limit of the rule set for every single device, in words; empty if there is none",
     get<&rules::LotQuantity::limit_individual>},
    {"lower_percent", "%", "", "smallest deviation from `nominal` that the limit for single devices allows",
     get<&rules::LotQuantity::lower_percent>},
    {"upper_percent", "%", "", "largest deviation from `nominal` that the limit for single devices allows",
     get<&rules::LotQuantity::upper_percent>},
    {"mean_limits", "", "", "the assessments of the mean of the lot", nested<rules::LotQuantity>},
    {"outlier_note", "", "", "why no outliers are named, or which devices are not compared; empty otherwise",
     get<&rules::LotQuantity::outlier_note>},
};

template <auto member>
Value of_test(rules::LotQuantity const& quantity) {
  return quantity.test_factors ? get<member>(*quantity.test_factors) : Value();
}

inline constexpr Result<rules::LotQuantity> test_factor_results[]{
    {"min", "", "lambda_test min", "smallest lambda_test of any device", of_test<&rules::TestFactors::min>},
    {"min_cycle", "", "min cycle", "cycle in which the smallest was measured", of_test<&rules::TestFactors::min_cycle>},
    {"min_device", "", "", "device on which the smallest was measured", get<&rules::LotQuantity::test_min_device>},
    {"max", "", "lambda_test max", "largest lambda_test of any device", of_test<&rules::TestFactors::max>},
    {"max_cycle", "", "max cycle", "cycle in which the largest was measured", of_test<&rules::TestFactors::max_cycle>},
    {"max_device", "", "", "device on which the largest was measured", get<&rules::LotQuantity::test_max_device>},
};

inline constexpr Result<OverallVerdict> verdict_results[]{
    {"word", "", "verdict", "`\"PASS\"`, `\"FAIL\"` or `\"INCOMPLETE\"`", word<&OverallVerdict::word>},
    {"as_corrected", "", "",
     "true: the verdict is PASS only with corrections made by hand; reports then print \"PASS as corrected\"",
     get<&OverallVerdict::as_corrected>},
    {"sentence", "", "", "the reasons of the verdict, or why there is none", get<&OverallVerdict::sentence>},
    {"failing", "", "",
     "what fails, each with its `device` (null: the lot itself) and a `remark`, which says what fails",
     nested<OverallVerdict>},
    {"not_assessed", "", "", "each `device` without a verdict and a `remark`, which says why there is none",
     nested<OverallVerdict>},
    {"requirements", "", "",
     "each requirement of the rule set once: its `name` and its `verdict`, which is a pass if every device passes on every side",
     nested<OverallVerdict>},
    {"mark", "", "", "words printed across a certificate that does not prove a pass", word<&OverallVerdict::mark>},
    {"mark_is_red", "", "", "true: the mark is red, because tests fail or are incomplete; false: it is grey",
     get<&OverallVerdict::is_red>},
};
inline constexpr Result<DeviceRemark> remark_results[]{
    {"device", "", "", "", word<&DeviceRemark::device>},
    {"remark", "", "", "", get<&DeviceRemark::remark>},
};
inline constexpr Result<Requirement> requirement_results[]{
    {"name", "", "", "", get<&Requirement::name>},
    {"verdict", "", "", "", get<&Requirement::verdict>},
};

struct OutlierOf {
  rules::LotQuantity const& quantity;
  rules::Outlier const& outlier;
};

inline constexpr Result<OutlierOf> lot_outlier_results[]{
    {"device", "", "device", "name of the device", [](OutlierOf const& row) { return value_of(row.outlier.device); }},
    {"quantity", "", "quantity", "the property by which the device stands apart",
     [](OutlierOf const& row) { return value_of(row.quantity.quantity); }},
    {"value", own_unit, "value", "value of the property on this device",
     [](OutlierOf const& row) { return value_of(row.outlier.value); }},
    {"unit", "", "unit", "unit of `value`", [](OutlierOf const& row) { return value_of(row.quantity.unit); }},
    {"why", "", "why", "why the device counts as an outlier, in words",
     [](OutlierOf const& row) { return value_of(row.outlier.reason); }},
};

struct FactorOf {
  rules::LotQuantity const& quantity;
  rules::Bound const& bound;
};

template <auto... members>
Value of_bound(FactorOf const& row) {
  return get<members...>(row.bound);
}
template <auto member>
Value of_quantity(FactorOf const& row) {
  return get<member>(row.quantity);
}

inline constexpr Result<FactorOf> factor_results[]{
    {"property", "", "property", "property to which the factors belong", of_quantity<&rules::LotQuantity::quantity>},
    {"source", "", "source",
     "where the factors come from: `\"contract band\"`, `\"observed\"`, `\"statistical, each device\"`, `\"statistical, system\"`, `\"statistical, system predicted\"`",
     of_bound<&rules::Bound::source>},
    {"spread", "", "",
     "what the bounds hold for: `\"device\"`, each single device; `\"system\"`, the mean of all devices of a building; `\"contract\"`, whatever the contract says",
     of_bound<&rules::Bound::scope>},
    {"spec_min", "", "lambda_spec min", "smallest factor for the supply alone (lambda_spec)",
     of_bound<&rules::Bound::spec, &rules::FactorPair::min>},
    {"spec_max", "", "lambda_spec max", "largest factor for the supply alone (lambda_spec)",
     of_bound<&rules::Bound::spec, &rules::FactorPair::max>},
    {"lambda_min", "", "lambda min", "smallest factor for supply, test history, ageing and environment together",
     of_bound<&rules::Bound::combined, &rules::CombinedFactors::min>},
    {"lambda_max", "", "lambda max", "largest factor for supply, test history, ageing and environment together",
     of_bound<&rules::Bound::combined, &rules::CombinedFactors::max>},
    {"lower", own_unit, "lower bound",
     "lower bound of the property: `lambda_min` times the design value or, if there is none, times the mean of the lot",
     of_bound<&rules::Bound::lower>},
    {"upper", own_unit, "upper bound",
     "upper bound of the property: `lambda_max` times the design value or, if there is none, times the mean of the lot",
     of_bound<&rules::Bound::upper>},
    {"unit", "", "unit", "unit of `lower` and `upper`", of_quantity<&rules::LotQuantity::unit>},
    {"note", "", "note", "what these factors hold for", of_bound<&rules::Bound::note>},
    {"no_lower_bound", "", "no lower bound", "why there is no lower bound; empty otherwise",
     of_bound<&rules::Bound::no_lower>},
};

}  // namespace isolaw::study
