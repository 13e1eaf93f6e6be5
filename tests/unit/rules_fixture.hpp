// Makes devices whose values can be worked out by hand, and rule sets written as text.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/rules/lot_view.hpp"
#include "refusal.hpp"

namespace isolaw::rules::testing {

// Returns a cycle of ±100 mm and ±120 kN, so K_eff is 1.2 kN/mm. Its energy is that of 15 % damping. `force_factor`
// multiplies the forces.
inline data::Cycle cycle(int number, double force_factor = 1.0) {
  double const energy = 0.15 * 2.0 * 3.14159265358979323846 * 1.2 * 1e4;  // xi 2 pi K D^2
  data::Cycle cycle;
  cycle.number = number;
  cycle.d_plus_mm = 100.0;
  cycle.d_minus_mm = -100.0;
  cycle.F_plus_kN = 120.0 * force_factor;
  cycle.F_minus_kN = -120.0 * force_factor;
  cycle.K_eff_kN_per_mm = 1.2 * force_factor;
  cycle.damping_percent = 15.0;
  cycle.energy_kN_mm = energy * force_factor;
  cycle.Q_d_kN = 30.0 * force_factor;
  cycle.K_d_kN_per_mm = 0.9 * force_factor;
  return cycle;
}

// Returns cycles 1 to `count` at 0.5 Hz. The forces of the third cycle are multiplied by `third`.
inline BlockValues block(double third = 1.0, int count = 3) {
  BlockValues values{.number = 1,
                     .amplitude_mm = 100.0,
                     .frequency_Hz = 0.5,
                     .shear_strain_percent = 100.0,
                     .load_mean_kN = {},
                     .cycles = {}};
  for (int n = 1; n <= count; ++n) values.cycles.push_back(cycle(n, n == 3 ? third : 1.0));
  return values;
}

inline std::string const head = R"(id = "contract"
title = "Contract"
edition = "1"
source = "hand-written"
verified_by = "the test"
[formulas]
stiffness = "peak_to_peak"
damping = "peak_to_peak"
[cycles]
one = 3
)";

inline RuleSet rules_of(std::string_view tail) {
  return read_rule_text(head + std::string(tail), "rules.toml");
}

inline Assessment const& find(std::vector<Assessment> const& all, std::string_view quantity) {
  for (auto const& one : all)
    if (one.quantity == quantity) return one;
  ADD_FAILURE() << "no line of " << quantity;
  static Assessment const none;
  return none;
}

inline void expect_parts(std::string const& said, std::vector<std::string> const& parts) {
  for (auto const& part : parts)
    EXPECT_NE(said.find(part), std::string::npos) << "'" << part << "' is missing in: " << said;
}

}  // namespace isolaw::rules::testing
