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
    {"file", "", "", "file of its record", get<&ConditionsTest::file>},
    {"sha256", "", "", "SHA-256 of the file", get<&ConditionsTest::sha256>},
    {"order", "", "order", "place among the tests of the device", get<&ConditionsTest::order>},
    {"block", "", "block", "number of the block within the test", get<&ConditionsTest::block>},
    {"temperature_C", "C", "T", "temperature of the rubber, as stated",
     of_condition<&conditions::Condition::temperature_C>},
    {"temperature_of", "", "measured at",
     "where it was measured, as stated: `core`, `surface` or `chamber`; null if it is not stated",
     word<&ConditionsTest::temperature_of, ConditionsTest>},
    {"frequency_Hz", "Hz", "f", "frequency, as measured", of_condition<&conditions::Condition::frequency_Hz>},
    {"load_kN", "kN", "N", "mean vertical load: as measured, or as stated if the record has no channel for it",
     of_condition<&conditions::Condition::load_kN>},
    {"strain_percent", "%", "strain",
     "amplitude over the thickness of the rubber; the amplitude in mm if the reference states `disp-mm`",
     of_condition<&conditions::Condition::strain_percent>},
    {"aged_days", "d", "aged", "days in an oven before the test, as stated; null if it is not aged",
     of_ageing<&conditions::Ageing::days>},
    {"aged_at_C", "C", "at", "temperature of the oven, as stated", of_ageing<&conditions::Ageing::at_C>},
    {"rest_h", "h", "rest", "rest before the block: as stated, 0 within a test; null if it is not known",
     get<&ConditionsTest::rest_h>},
    {"history", "", "history",
     "what the device had gone through before the reference cycle: `virgin`, `first after rest`, `scragged` or `disturbed`",
     get<&ConditionsTest::history>},
    {"role", "", "role",
     "how the test is used: `reference`, `effect`, or why it shows no effect: `combined`, `another strain`, `no reference cycle`, `another history`, `no reference test`, `another compound or size`, `scaled specimen`",
     get<&ConditionsTest::role>},
    {"effect", "", "effect", "the effect that it shows", get<&ConditionsTest::effect>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff",
     "effective stiffness in the reference cycle, or its mean over the reference cycles",
     get<&ConditionsTest::K_eff_kN_per_mm>, significant(4)},
    {"damping_percent", "%", "damping", "equivalent viscous damping there", get<&ConditionsTest::damping_percent>,
     significant(4)},
    {"energy_kN_mm", "kN mm", "energy", "energy of the loop there", get<&ConditionsTest::energy_kN_mm>, significant(4)},
    {"Q_d_kN", "kN", "Q_d", "characteristic strength there", get<&ConditionsTest::Q_d_kN>, significant(4)},
    {"K_d_kN_per_mm", "kN/mm", "K_d", "stiffness after yield there", get<&ConditionsTest::K_d_kN_per_mm>,
     significant(4)},
    {"heating_K", "K", "heating", "the most by which this cycle can have warmed the rubber, as if no heat were lost",
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
    {"lambda", "-", "factor", "value under the condition over the value at reference",
     [](ConditionFactor const& of) { return of.is_covered() ? value_of(of.factor.lambda()) : Value(); }},
    {"status", "", "status", "how sure it is: a word of the table above",
     [](ConditionFactor const& of) { return value_of(of.factor.status); }},
    {"lack", "", "lack", "why it is not covered, such as `no-test` or `too-far`; null if it is",
     [](ConditionFactor const& of) { return value_of(of.factor.lack); }},
    {"devices", "", "devices", "number of devices that show it; 0 for the factor 1 of the reference itself",
     [](ConditionFactor const& of) { return value_of(of.factor.devices); }},
    {"line_error", "-", "error of the line", "error of the straight line between levels, in ln; 0 at a level",
     [](ConditionFactor const& of) { return value_of(of.factor.line_error); }},
    {"drift", "-", "drift", "change of a device between its reference tests, in ln",
     [](ConditionFactor const& of) { return value_of(of.factor.drift); }},
    {"mean", "-", "mean", "interval of 95 % of the mean factor", interval_of<conditions::About::mean>},
    {"device", "-", "one device", "interval of 95 % of one further device", interval_of<conditions::About::device>},
    {"system", "-", "installed", "interval of 95 % of the mean of all installed devices (`lot-size`)",
     interval_of<conditions::About::system>},
    {"prototypes", "-", "installed, prototypes",
     "the same, if more devices were tested than the lot has, so that they cannot be some of it",
     interval_of<conditions::About::prototypes>},
};

inline constexpr Result<DesignBound> bound_law_results[]{
    {"K_eff_factor", "-", "factor on K_eff", "factor on K_eff in the reference cycle: that of `bounds`",
     get<&DesignBound::C_K>},
    {"energy_factor", "-", "factor on energy", "factor on the energy there", get<&DesignBound::C_E>},
    {"status", "", "status", "how sure these two factors are: the weaker word", get<&DesignBound::status>},
    {"share_shown", "-", "share from tests", "the smaller `share_shown` of the two", get<&DesignBound::share_shown>},
    {"elastic_factor", "-", "a", "factor a on the elastic part of the force",
     get<&DesignBound::law, &conditions::BoundLaw::factors, &conditions::PartFactors::a>},
    {"hysteretic_factor", "-", "b", "factor b on the hysteretic or viscous part",
     get<&DesignBound::law, &conditions::BoundLaw::factors, &conditions::PartFactors::b>},
    {"one_factor", "", "one factor because",
     "why the whole force has one factor: `inseparable` (no parameters change one part alone), `not-positive`, `limits` or `not-reached` (by 0.5 %); null if it has two",
     get<&DesignBound::law, &conditions::BoundLaw::one_factor>},
    {"energy_off_percent", "%", "energy off", "by how much the energy then differs from `energy_factor`",
     get<&DesignBound::law, &conditions::BoundLaw::energy_off_percent>},
    {"K_eff_kN_per_mm", "kN/mm", "K_eff", "effective stiffness of the bound law in the reference cycle",
     get<&DesignBound::law, &conditions::BoundLaw::reached, &conditions::Loop::K_eff_kN_per_mm>, significant(4)},
    {"energy_kN_mm", "kN mm", "energy", "energy of its loop there",
     get<&DesignBound::law, &conditions::BoundLaw::reached, &conditions::Loop::energy_kN_mm>, significant(4)},
};

// The unit of the condition that belongs to an effect; empty for ageing and history, whose levels are no number.
constexpr std::string_view unit_of(conditions::Effect effect) {
  using conditions::Effect;
  return effect == Effect::temperature ? "C" : effect == Effect::rate ? "Hz" : effect == Effect::load ? "kN" : "";
}

inline constexpr Result<LevelRow> conditions_level_results[]{
    {"quantity", "", "property", "the property", get<&LevelRow::quantity>},
    {"effect", "", "effect", "the effect", get<&LevelRow::effect>},
    {"level", "", "level", "the tested condition as text", get<&LevelRow::level>},
    {"at", own_unit, "at", "the condition; null for ageing and history",
     [](LevelRow const& row) { return unit_of(row.effect).empty() ? Value() : value_of(row.factor.at); }},
    {"unit", "", "unit", "unit of `at`", [](LevelRow const& row) { return value_of(unit_of(row.effect)); }},
    {"aged_days", "d", "aged", "days in an oven before the test; null for other effects than ageing",
     [](LevelRow const& row) { return row.ageing ? value_of(row.ageing->days) : Value(); }},
    {"aged_at_C", "C", "at", "temperature of the oven",
     [](LevelRow const& row) { return row.ageing ? value_of(row.ageing->at_C) : Value(); }},
};

inline constexpr Result<AtReferenceRow> at_reference_results[]{
    {"device", "", "device", "name of the device", get<&AtReferenceRow::device>},
    {"test", "", "test", "name of its acceptance test", get<&AtReferenceRow::test>},
    {"block", "", "block", "number of the block within the test", get<&AtReferenceRow::block>},
    {"temperature_C", "C", "T", "temperature of the rubber, as stated",
     of_condition<&conditions::Condition::temperature_C>},
    {"frequency_Hz", "Hz", "f", "frequency, as measured", of_condition<&conditions::Condition::frequency_Hz>},
    {"load_kN", "kN", "N", "mean vertical load, as measured or stated", of_condition<&conditions::Condition::load_kN>},
    {"aged_days", "d", "aged", "days in an oven before the test, as stated; null if it is not aged",
     of_ageing<&conditions::Ageing::days>},
    {"aged_at_C", "C", "at", "temperature of the oven, as stated", of_ageing<&conditions::Ageing::at_C>},
    {"quantity", "", "property", "`K_eff`, `energy` or `damping`",
     [](AtReferenceRow const& row) { return value_of(rules::name(row.quantity)); }},
    {"unit", "", "unit", "unit of the values",
     [](AtReferenceRow const& row) { return value_of(rules::unit(row.quantity)); }},
    {"measured", "", "measured", "the value as measured", get<&AtReferenceRow::measured>, significant(4)},
    {"at_reference", "", "at reference", "the measured value divided by all factors; null: see `obstacle`",
     get<&AtReferenceRow::at_reference>, significant(4)},
    {"low", "", "low", "lower end of the 95 % interval for this device; null if one of the factors has none",
     [](AtReferenceRow const& row) { return row.interval ? value_of(row.interval->low) : Value(); }, significant(4)},
    {"high", "", "high", "its upper end",
     [](AtReferenceRow const& row) { return row.interval ? value_of(row.interval->high) : Value(); }, significant(4)},
    {"obstacle", "", "no value because of",
     "why `at_reference` is null: an effect whose factor is neither shown nor interpolated, or the role in `tests[]` of a test that no reference test is comparable with",
     [](AtReferenceRow const& row) {
       return row.obstacle                 ? value_of(name(*row.obstacle))
              : row.not_comparable.empty() ? Value()
                                           : value_of(row.not_comparable);
     }},
};

inline constexpr Result<ConvertingFactor> converting_factor_results[]{
    {"effect", "", "effect", "the condition in which the test differs from the reference",
     get<&ConvertingFactor::effect>},
    {"lambda", "", "factor", "the factor at the condition of the test; null if it is not covered",
     [](ConvertingFactor const& row) {
       return row.factor.status == conditions::Status::not_covered ? Value() : value_of(row.factor.lambda());
     },
     significant(4)},
    {"status", "", "status", "how sure the factor is",
     [](ConvertingFactor const& row) { return value_of(row.factor.status); }},
    {"devices", "", "devices", "number of devices that show it",
     [](ConvertingFactor const& row) { return value_of(row.factor.devices); }},
    {"records", "", "records", "SHA-256 of the records that show it", get<&ConvertingFactor::records>},
};

inline constexpr Result<conditions::PlannedTest> planned_test_results[]{
    {"device", "", "device", "name of the device; `new 1`, `new 2` for devices that were never tested",
     get<&conditions::PlannedTest::device>},
    {"is_new", "", "", "true if the device is not one of the lot", get<&conditions::PlannedTest::is_new>},
    {"effect", "", "effect", "the effect that the test helps to show", get<&conditions::PlannedTest::effect>},
    {"is_reference", "", "", "true if it is a reference test that the device lacks",
     get<&conditions::PlannedTest::is_reference>},
    {"temperature_C", "C", "T", "temperature of the rubber", of_condition<&conditions::Condition::temperature_C>},
    {"frequency_Hz", "Hz", "f", "frequency", of_condition<&conditions::Condition::frequency_Hz>},
    {"load_kN", "kN", "N", "mean vertical load", of_condition<&conditions::Condition::load_kN>},
    {"strain_percent", "%", "strain",
     "amplitude over the thickness of the rubber; the amplitude in mm if the reference states `disp-mm`",
     of_condition<&conditions::Condition::strain_percent>},
    {"aged_days", "d", "aged", "days in an oven before the test, in total; null if it is not aged",
     of_ageing<&conditions::Ageing::days>},
    {"aged_at_C", "C", "at", "temperature of the oven", of_ageing<&conditions::Ageing::at_C>},
    {"rest_h", "h", "rest", "rest before the test; null: any", get<&conditions::PlannedTest::rest_h>},
    {"cycles", "", "cycles", "number of cycles, at least", get<&conditions::PlannedTest::cycles>},
    {"status", "", "now", "how sure the factor is at this end of the design range now",
     get<&conditions::PlannedTest::before>},
    {"devices", "", "devices", "number of devices behind `status`", get<&conditions::PlannedTest::devices_before>},
    {"status_after", "", "after", "how sure the factor is after this test and those before it",
     get<&conditions::PlannedTest::after>},
    {"devices_after", "", "devices after", "number of devices behind `status_after`",
     get<&conditions::PlannedTest::devices_after>},
};

}  // namespace isolaw::study
