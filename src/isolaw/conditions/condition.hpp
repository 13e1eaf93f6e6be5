// The conditions of a test (temperature, frequency, vertical load, strain, ageing), and whether two tests agree in
// them. Everything in this module works on plain values; it reads no file and prints nothing.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/rules/effects.hpp"

namespace isolaw::conditions {

struct Ageing {  // the device was kept in an oven of `at_C` for `days` before the test
  double days = 0.0, at_C = 0.0;
};

struct Condition {
  std::optional<double> temperature_C = {}, frequency_Hz = {}, load_kN = {}, strain_percent = {};
  std::optional<Ageing> ageing = {};  // empty: not aged
};

// Two values of a condition that differ by no more than this count as equal. Percentages relate to the reference value.
struct Tolerance {
  double temperature_C = 2.0, frequency_percent = 10.0, load_percent = 10.0, strain_percent = 5.0;
};

using rules::Effect;

// Whether `value` equals `reference` within the tolerance. An unknown value agrees only with an unknown value.
bool agrees(std::optional<double> value, std::optional<double> reference, double percent);
bool agrees(Ageing const& ageing, Ageing const& reference);  // days within 1 %, temperatures within 2 degrees
// Whether two tests agree in the condition that belongs to the effect: temperature, rate, load or ageing.
bool agree_in(Effect effect, Condition const& test, Condition const& reference, Tolerance const& tolerance);

// The effects in whose conditions a test differs from the reference. If there is none, the test is a reference test. If
// there is one, the test shows this effect. With two or more, it shows no single effect.
std::vector<Effect> differences(Condition const& test, Condition const& reference, Tolerance const& tolerance);

}  // namespace isolaw::conditions
