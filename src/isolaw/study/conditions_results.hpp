// The rows that conditions.json takes from the results of `isolaw conditions`: name, unit and meaning. A test compares
// docs/conditions.md with these rows.
#pragma once

#include "isolaw/study/conditions.hpp"
#include "isolaw/study/results.hpp"

namespace isolaw::study {

template <auto member>
Value of_condition(ConditionsTest const& test) {
  return value_of(test.condition.*member);
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
     [](ConditionsTest const& test) {
       return test.condition.ageing ? value_of(test.condition.ageing->days) : Value();
     }},
    {"aged_at_C", "C", "at", "temperature of the oven, as stated",
     [](ConditionsTest const& test) {
       return test.condition.ageing ? value_of(test.condition.ageing->at_C) : Value();
     }},
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

}  // namespace isolaw::study
