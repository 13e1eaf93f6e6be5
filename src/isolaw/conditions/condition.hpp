// The conditions of a test (temperature, frequency, vertical load, strain, ageing), and whether two tests agree in
// them. Everything in this module works on plain values; it reads no file and prints nothing.
#pragma once

#include <optional>
#include <vector>

#include "isolaw/rules/effects.hpp"

namespace isolaw::conditions {

struct Ageing {  // kept in an oven before the test
  double days = 0.0, at_C = 0.0;
};

struct Condition {
  std::optional<double> temperature_C = {}, frequency_Hz = {}, load_kN = {}, strain_percent = {};
  std::optional<Ageing> ageing = {};  // empty: not aged
};

// Two values of a condition within these limits are the same. Percentages are of the value compared with.
struct Tolerance {
  double temperature_C = 2.0, frequency_percent = 10.0, load_percent = 10.0, strain_percent = 5.0;
};

using rules::Effect;

// Whether `value` is `reference` within the tolerance. A value that is not known agrees only with another such value.
bool agrees(std::optional<double> value, std::optional<double> reference, double percent);
bool agrees(Ageing const& ageing, Ageing const& reference);  // days within 1 %, temperatures within 2 degrees
// Whether two tests agree in the condition that belongs to the effect, one of the first four.
bool agree_in(Effect effect, Condition const& test, Condition const& reference, Tolerance const& tolerance);

// In which conditions a test differs from the reference: in none, it is a reference test; in one, it shows this effect;
// in two or more, it shows none.
std::vector<Effect> differences(Condition const& test, Condition const& reference, Tolerance const& tolerance);

}  // namespace isolaw::conditions
