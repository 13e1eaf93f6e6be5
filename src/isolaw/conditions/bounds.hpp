// The law of a device under the conditions that make its properties largest or smallest: the law at reference, with its
// elastic part times a and its hysteretic part times b (laws::LawEntry::with_factors). a and b are chosen so that K_eff
// and the energy of the reference cycle become the wanted multiples of their values at reference.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "isolaw/laws/catalogue.hpp"

namespace isolaw::conditions {

// A sine from rest, as in the reference tests. The law's K_eff and energy are means over the cycles from first_cycle to
// last_cycle, counted from 1.
struct ReferenceBlock {
  double amplitude_mm = 0.0, frequency_Hz = 0.0;
  int first_cycle = 3, last_cycle = 3;
};

struct Loop {
  double K_eff_kN_per_mm = 0.0, energy_kN_mm = 0.0;
};
// The K_eff and energy that each part of a force contributes.
struct LoopParts {
  Loop elastic, hysteretic;
};

// Simulates the block with 400 samples a cycle. The result is not finite if a force of the law is not.
Loop loop_of(laws::LawEntry const& law, std::span<double const> parameters, ReferenceBlock const& block);
struct CycleCurve {
  std::vector<double> disp_mm, force_kN;
};
// The first of the block's reference cycles, for drawing.
CycleCurve cycle_of(laws::LawEntry const& law, std::span<double const> parameters, ReferenceBlock const& block);
// For each part of the force: the loop with this part doubled minus the loop as it is.
LoopParts parts_of(laws::LawEntry const& law, std::span<double const> parameters, ReferenceBlock const& block);

struct LoopFactors {
  double a = 1.0, b = 1.0;
};
// The factors a and b with which the sum of the two parts becomes `target`. They are not finite if the loops of the
// parts are proportional to one another.
LoopFactors factors_for(LoopParts const& parts, Loop const& target);

// Why a bound law multiplies all forces by one factor, instead of the parts by a and b.
enum class OneFactor {
  inseparable,   // the law has no parameters that change one part of the force alone
  not_positive,  // a or b would not be above 0
  limits,        // the parameters would leave their limits
  not_reached,   // K_eff or energy would be farther than 0.5 % from its target, since the parts act on each other
};
std::string_view name(OneFactor why);

struct BoundLaw {
  LoopFactors factors = {};
  std::vector<double> parameters = {};  // in the law's order and units
  Loop target = {}, reached = {};
  // Set if one factor on all forces takes the place of a and b. It gives K_eff its target and leaves the damping as it
  // is; the energy then differs from its target by energy_off_percent.
  std::optional<OneFactor> one_factor = {};
  double energy_off_percent = 0.0;
};

// Makes the law whose K_eff and energy are C_K and C_E times those at reference; both factors are above 0. nullopt if
// the given law has no finite force in the block, or if its K_eff or energy there is not above 0.
std::optional<BoundLaw> bound_law(laws::LawEntry const& law, std::span<double const> parameters,
                                  ReferenceBlock const& block, double C_K, double C_E);

}  // namespace isolaw::conditions
