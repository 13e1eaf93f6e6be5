// The rows (results.hpp: name, unit and meaning) from which conditions.json and the tables print the results of `isolaw
// conditions`. A test compares docs/conditions.md with these rows.
#pragma once

#include "isolaw/study/conditions.hpp"
#include "isolaw/study/design_bounds.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::study {

template <auto member, class Row>
Value of_condition(Row const& row) {
  return value_of(row.condition.*member);
}
template <auto member, class Row>
Value of_ageing(Row const& row) {
  return row.condition.ageing ? value_of((*row.condition.ageing).*member) : Value();
}

inline constexpr Result<ConditionsTest> conditions_test_results[]{
    {"device", "", "device", "name of the device", get<&ConditionsTest::device>},
    {"test", "", "test", "name of the test", get<&ConditionsTest::test>},
    {"file", "", "", "file of the test's record", get<&ConditionsTest::file>},
    {"sha256", "", "", "SHA-256 hash of this record's file", get<&ConditionsTest::sha256>},
    {"order", "", "order", "place of the test among all tests of the device, 1 for the first",
     get<&ConditionsTest::order>},
    {"block", "", "block", "number of the block within the test", get<&ConditionsTest::block>},
    {"temperature_C", "C", "T", "temperature of the rubber, as stated",
     of_condition<&conditions::Condition::temperature_C>},
    {"temperature_of", "", "measured at",
     "where the temperature was measured, as stated: `core`, `surface` or `chamber`; null if it is not stated",
     word<&ConditionsTest::temperature_of, ConditionsTest>},
    {"frequency_Hz", "Hz", "f", "frequency, as measured", of_condition<&conditions::Condition::frequency_Hz>},
    {"load_kN", "kN", "N", "mean vertical load: as measured, or as stated if the record has no channel for it",
     of_condition<&conditions::Condition::load_kN>},
    {"strain_percent", "%", "strain",
     "amplitude over the thickness of the rubber; the amplitude in mm if the reference states `disp-mm`",
     of_condition<&conditions::Condition::strain_percent>},
    {"aged_days", "d", "aged", "days in an oven before the test, as stated; null if the device was not aged",
     of_ageing<&conditions::Ageing::days>},
    {"aged_at_C", "C", "at", "temperature of the oven in which the device was aged, as stated",
     of_ageing<&conditions::Ageing::at_C>},
    {"rest_h", "h", "rest",
     "rest before the block: as stated before the first block of a test, 0 between the blocks of a test; null if it is not known",
     get<&ConditionsTest::rest_h>},
    {"history", "", "history",
     "what the device had gone through before the reference cycle: `virgin`, `first after rest`, `scragged` or `disturbed`",
     get<&ConditionsTest::history>},
    {"role", "", "role",
     "how the test is used: `reference`, `effect`, or why it shows no effect: `combined`, `another strain`, `no reference cycle`, `another history`, `no reference test`, `another compound or size`, `scaled specimen`",
     get<&ConditionsTest::role>},
    {"effect", "", "effect", "the effect that the test shows, such as `temperature`", get<&ConditionsTest::effect>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff",
     "effective stiffness in the reference cycle, or its mean over the reference cycles",
     get<&ConditionsTest::K_eff_kN_per_mm>, significant(4)},
    {"damping_percent", "%", "damping",
     "equivalent viscous damping in the reference cycle, or its mean over the reference cycles",
     get<&ConditionsTest::damping_percent>, significant(4)},
    {"energy_kN_mm", "kN mm", "energy",
     "energy of the loop in the reference cycle, or its mean over the reference cycles",
     get<&ConditionsTest::energy_kN_mm>, significant(4)},
    {"Q_d_kN", "kN", "Q_d", "characteristic strength in the reference cycle, or its mean over the reference cycles",
     get<&ConditionsTest::Q_d_kN>, significant(4)},
    {"K_d_kN_per_mm", "kN/mm", "K_d",
     "stiffness after yield in the reference cycle, or its mean over the reference cycles",
     get<&ConditionsTest::K_d_kN_per_mm>, significant(4)},
    {"heating_K", "K", "heating",
     "largest temperature rise of the rubber that the reference cycle can have caused, as if no heat were lost",
     get<&ConditionsTest::heating_K>, significant(2)},
};

inline constexpr Result<ConditionsCycle> conditions_cycle_results[]{
    {"number", "", "cycle", "number of the cycle within its block", get<&ConditionsCycle::number>},
    {"history", "", "history", "what the device had gone through before this cycle", get<&ConditionsCycle::history>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff", "effective stiffness", get<&ConditionsCycle::K_eff_kN_per_mm>,
     significant(4)},
    {"damping_percent", "%", "damping", "equivalent viscous damping", get<&ConditionsCycle::damping_percent>,
     significant(4)},
    {"energy_kN_mm", "kN mm", "energy", "energy of the loop", get<&ConditionsCycle::energy_kN_mm>, significant(4)},
    {"Q_d_kN", "kN", "Q_d", "characteristic strength", get<&ConditionsCycle::Q_d_kN>, significant(4)},
    {"K_d_kN_per_mm", "kN/mm", "K_d", "stiffness after yield", get<&ConditionsCycle::K_d_kN_per_mm>, significant(4)},
};

// A factor and the number of installed devices. The interval of the factor depends on both.
struct ConditionFactor {
  conditions::Factor factor;
  std::optional<int> installed = {};

  bool is_covered() const { return factor.status != conditions::Status::not_covered; }
  // The tested devices are some of the installed ones or, if more were tested than are installed, prototypes.
  conditions::About of_installed() const {
    return installed && factor.devices > *installed ? conditions::About::prototypes : conditions::About::system;
  }
};

template <conditions::About about>
Value interval_of(ConditionFactor const& of) {
  bool const is_of_installed = about == conditions::About::system || about == conditions::About::prototypes;
  if (!of.is_covered() || (is_of_installed && (!of.installed || of.of_installed() != about))) return Ends{};
  auto const found = conditions::interval(of.factor, about, of.installed.value_or(0));
  return found ? Ends{found->low, found->high} : Ends{};
}

inline constexpr Result<ConditionFactor> conditions_factor_results[]{
    {"lambda", "-", "factor",
     "the factor: value of the property under the condition, divided by its value at reference",
     [](ConditionFactor const& of) { return of.is_covered() ? value_of(of.factor.lambda()) : Value(); }},
    {"status", "", "status", "how sure the factor is, in a word such as `shown`, `interpolated` or `not covered`",
     [](ConditionFactor const& of) { return value_of(of.factor.status); }},
    {"lack", "", "lack", "why no test covers the factor, such as `no-test` or `too-far`; null if tests cover it",
     [](ConditionFactor const& of) { return value_of(of.factor.lack); }},
    {"devices", "", "devices", "number of devices that show the factor; 0 for the factor 1 of the reference itself",
     [](ConditionFactor const& of) { return value_of(of.factor.devices); }},
    {"line_error", "-", "error of the line",
     "largest distance of a tested level from the straight line between its neighbours, in ln(factor); 0 for the factor of a level",
     [](ConditionFactor const& of) { return value_of(of.factor.line_error); }},
    {"drift", "-", "drift",
     "half the change of ln(property) from the first reference test of a device to its last; of all devices the one with the largest change counts",
     [](ConditionFactor const& of) { return value_of(of.factor.drift); }},
    {"mean", "-", "mean", "95 % interval of the mean factor", interval_of<conditions::About::mean>},
    {"device", "-", "one device", "95 % interval of the factor of one further device",
     interval_of<conditions::About::device>},
    {"system", "-", "installed", "95 % interval of the mean factor of all installed devices (`lot-size`)",
     interval_of<conditions::About::system>},
    {"prototypes", "-", "installed, prototypes",
     "as `system`, but for installed devices none of which was tested; it takes the place of `system` if more devices were tested than the lot has",
     interval_of<conditions::About::prototypes>},
};

inline constexpr Result<DesignBound> bound_law_results[]{
    {"K_eff_factor", "-", "factor on K_eff",
     "factor by which the K_eff of the fitted law in the reference cycle is multiplied, from `bounds`",
     get<&DesignBound::C_K>},
    {"energy_factor", "-", "factor on energy",
     "factor by which the energy of the fitted law in the reference cycle is multiplied, from `bounds`",
     get<&DesignBound::C_E>},
    {"status", "", "status",
     "how sure `K_eff_factor` and `energy_factor` are: the weaker of the words that `bounds` has for K_eff and for energy",
     get<&DesignBound::status>},
    {"share_shown", "-", "share from tests",
     "the share of the bound that tests show: the smaller of the values that `bounds` has for K_eff and for energy",
     get<&DesignBound::share_shown>},
    {"elastic_factor", "-", "a", "factor a on the elastic part of the force, which grows with displacement",
     get<&DesignBound::law, &conditions::BoundLaw::factors, &conditions::LoopFactors::a>},
    {"hysteretic_factor", "-", "b", "factor b on the hysteretic or viscous part of the force",
     get<&DesignBound::law, &conditions::BoundLaw::factors, &conditions::LoopFactors::b>},
    {"one_factor", "", "one factor because",
     "why the whole force has one factor: `inseparable` (no parameters change one part alone), `not-positive` (a or b), `limits` (a parameter would leave them) or `not-reached` (K_eff or energy is missed by more than 0.5 %); null if each of the two parts has its own",
     get<&DesignBound::law, &conditions::BoundLaw::one_factor>},
    {"energy_off_percent", "%", "energy off",
     "if the whole force has one factor: how far the energy then is from the one that `energy_factor` asks for",
     get<&DesignBound::law, &conditions::BoundLaw::energy_off_percent>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff", "effective stiffness of the bound law in the reference cycle",
     get<&DesignBound::law, &conditions::BoundLaw::reached, &conditions::Loop::K_eff_kN_per_mm>, significant(4)},
    {"energy_kN_mm", "kN mm", "energy", "energy of the bound law's loop in the reference cycle",
     get<&DesignBound::law, &conditions::BoundLaw::reached, &conditions::Loop::energy_kN_mm>, significant(4)},
};

// The unit of the condition that belongs to an effect; empty for ageing and history, whose levels are no number.
constexpr std::string_view unit_of(conditions::Effect effect) {
  using conditions::Effect;
  return effect == Effect::temperature ? "C" : effect == Effect::rate ? "Hz" : effect == Effect::load ? "kN" : "";
}

inline constexpr Result<LevelRow> conditions_level_results[]{
    {"quantity", "", "property", "the property that changes, such as `K_eff`", get<&LevelRow::quantity>},
    {"effect", "", "effect", "the effect, such as `temperature`", get<&LevelRow::effect>},
    {"level", "", "level", "the tested condition as text, such as `-20 C`", get<&LevelRow::level>},
    {"at", own_unit, "at", "the tested condition as a number; null for ageing and history",
     [](LevelRow const& row) { return unit_of(row.effect).empty() ? Value() : value_of(row.factor.at); }},
    {"unit", "", "unit", "unit of `at`", [](LevelRow const& row) { return value_of(unit_of(row.effect)); }},
    {"aged_days", "d", "aged", "days in an oven before the test; null for other effects than ageing",
     [](LevelRow const& row) { return row.ageing ? value_of(row.ageing->days) : Value(); }},
    {"aged_at_C", "C", "at", "temperature of the oven in which the device was aged",
     [](LevelRow const& row) { return row.ageing ? value_of(row.ageing->at_C) : Value(); }},
};

inline constexpr Result<AtReferenceRow> at_reference_results[]{
    {"device", "", "device", "name of the device", get<&AtReferenceRow::device>},
    {"test", "", "test", "name of the device's acceptance test", get<&AtReferenceRow::test>},
    {"block", "", "block", "number of the block within the test", get<&AtReferenceRow::block>},
    {"temperature_C", "C", "T", "temperature of the rubber, as stated",
     of_condition<&conditions::Condition::temperature_C>},
    {"frequency_Hz", "Hz", "f", "frequency, as measured", of_condition<&conditions::Condition::frequency_Hz>},
    {"load_kN", "kN", "N", "mean vertical load, as measured or stated", of_condition<&conditions::Condition::load_kN>},
    {"aged_days", "d", "aged", "days in an oven before the test, as stated; null if the device was not aged",
     of_ageing<&conditions::Ageing::days>},
    {"aged_at_C", "C", "at", "temperature of the oven in which the device was aged, as stated",
     of_ageing<&conditions::Ageing::at_C>},
    {"quantity", "", "property", "the property: `K_eff`, `energy` or `damping`",
     [](AtReferenceRow const& row) { return value_of(rules::name(row.quantity)); }},
    {"unit", "", "unit", "unit of `measured`, `at_reference`, `low` and `high`",
     [](AtReferenceRow const& row) { return value_of(rules::unit(row.quantity)); }},
    {"measured", "", "measured", "the value as measured", get<&AtReferenceRow::measured>, significant(4)},
    {"at_reference", "", "at reference",
     "the value converted to reference conditions: the measured value divided by all factors; null for the reason in `obstacle`",
     get<&AtReferenceRow::at_reference>, significant(4)},
    {"low", "", "low", "lower end of the 95 % interval for this device; null if one of the factors has none",
     [](AtReferenceRow const& row) { return row.interval ? value_of(row.interval->low) : Value(); }, significant(4)},
    {"high", "", "high", "upper end of the 95 % interval for this device; null if one of the factors has none",
     [](AtReferenceRow const& row) { return row.interval ? value_of(row.interval->high) : Value(); }, significant(4)},
    {"obstacle", "", "no value because of",
     "why `at_reference` is null: the effect whose factor is neither shown nor interpolated or, if no reference test can be compared with this test, the `role` that the test has in `tests[]`",
     [](AtReferenceRow const& row) {
       return row.obstacle                 ? value_of(name(*row.obstacle))
              : row.not_comparable.empty() ? Value()
                                           : value_of(row.not_comparable);
     }},
};

inline constexpr Result<ConvertingFactor> converting_factor_results[]{
    {"effect", "", "effect", "the condition in which the test differs from the reference",
     get<&ConvertingFactor::effect>},
    {"lambda", "", "factor", "the factor at the condition of the test; null if no test covers the factor",
     [](ConvertingFactor const& row) {
       return row.factor.status == conditions::Status::not_covered ? Value() : value_of(row.factor.lambda());
     },
     significant(4)},
    {"status", "", "status", "how sure the factor is",
     [](ConvertingFactor const& row) { return value_of(row.factor.status); }},
    {"devices", "", "devices", "number of devices that show the factor",
     [](ConvertingFactor const& row) { return value_of(row.factor.devices); }},
    {"records", "", "records", "SHA-256 hashes of the records that show the factor", get<&ConvertingFactor::records>},
};

inline constexpr Result<conditions::PlannedTest> planned_test_results[]{
    {"device", "", "device", "name of the device; `new 1`, `new 2` for devices that were never tested",
     get<&conditions::PlannedTest::device>},
    {"is_new", "", "", "true if the device is not one of the lot", get<&conditions::PlannedTest::is_new>},
    {"effect", "", "effect", "the effect that the test helps to show", get<&conditions::PlannedTest::effect>},
    {"is_reference", "", "", "true if the proposed test is a reference test, which the device lacks",
     get<&conditions::PlannedTest::is_reference>},
    {"temperature_C", "C", "T", "temperature of the rubber", of_condition<&conditions::Condition::temperature_C>},
    {"frequency_Hz", "Hz", "f", "frequency", of_condition<&conditions::Condition::frequency_Hz>},
    {"load_kN", "kN", "N", "mean vertical load", of_condition<&conditions::Condition::load_kN>},
    {"strain_percent", "%", "strain",
     "amplitude over the thickness of the rubber; the amplitude in mm if the reference states `disp-mm`",
     of_condition<&conditions::Condition::strain_percent>},
    {"aged_days", "d", "aged", "days in an oven before the test, in total; null if the device is not to be aged",
     of_ageing<&conditions::Ageing::days>},
    {"aged_at_C", "C", "at", "temperature of the oven in which the device is to be aged",
     of_ageing<&conditions::Ageing::at_C>},
    {"rest_h", "h", "rest", "rest before the test; null if any rest will do", get<&conditions::PlannedTest::rest_h>},
    {"cycles", "", "cycles", "smallest number of cycles that the test must have",
     get<&conditions::PlannedTest::cycles>},
    {"status", "", "now", "how sure the factor at this end of the design range is now",
     get<&conditions::PlannedTest::before>},
    {"devices", "", "devices", "number of devices that show the factor now",
     get<&conditions::PlannedTest::devices_before>},
    {"status_after", "", "after", "how sure the factor is after this test and the tests before it in the plan",
     get<&conditions::PlannedTest::after>},
    {"devices_after", "", "devices after", "number of devices that show the factor after these tests",
     get<&conditions::PlannedTest::devices_after>},
};

}  // namespace isolaw::study
