// The history of a device before each cycle of its tests. Rubber with fillers loses stiffness when it is stretched
// farther than before, and recovers some of it at rest. Therefore the values of two cycles may be compared only if the
// cycles have the same history.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "isolaw/conditions/condition.hpp"
#include "isolaw/rules/rule_set.hpp"

namespace isolaw::conditions {

inline constexpr std::size_t quantities = 5;  // number of properties of a cycle: rules::measured_quantities()

struct CycleValues {
  int number = 0;                              // number of the cycle within its block, from 1
  std::array<double, quantities> values = {};  // kN/mm, %, kN mm, kN, kN/mm; 0 or less: the cycle has no such value

  // The natural logarithm of a value; empty if the cycle has no such value.
  std::optional<double> ln(rules::Quantity quantity) const;
};

// The counted cycles of one block of one test.
struct Block {
  std::string device, test;
  int order = 0;   // place of the test in the sequence of its device's tests
  int number = 0;  // number of the block within the test
  Condition condition = {};
  std::optional<double> rest_h = {};  // time at rest since the previous motion; 0 within a test; empty if not known
  std::vector<CycleValues> cycles = {};

  CycleValues const* find(int cycle) const;
};

enum class History { virgin, first_after_rest, scragged, disturbed };
std::string_view name(History history);

// The history of cycle `number` in a block with the strain `strain_percent`. `largest_before_percent` is the largest
// strain of the device's earlier blocks (0 for the first block). The first of these that applies:
//   disturbed         an earlier block had a larger strain; or the cycle is the first or second, and the largest
//                     earlier strain was smaller than this one but above a quarter of it
//   scragged          the third cycle or a later one; or the same strain was reached less than an hour before
//   first after rest  the same strain was reached before, and a rest of an hour or more, or an unknown one, followed
//   virgin            no earlier block went beyond a quarter of this strain
History history(double strain_percent, double largest_before_percent, int number, std::optional<double> rest_h,
                Tolerance const& tolerance);

// For each block of one device, the largest strain of the blocks before it, in percent. `blocks` are in the order in
// which they were tested. A block without a known strain is ignored.
std::vector<double> largest_before(std::span<Block const> blocks);

// An upper bound of the temperature rise in one cycle, in kelvin: the energy of the loop divided by the heat capacity
// of the rubber, as if no heat were lost.
double heating_K(double energy_kN_mm, double capacity_MJ_per_m3K, double rubber_area_mm2, double rubber_thickness_mm);

// The time in hours that rubber takes to come to the temperature of the air around it: 3 H^2 / (pi^2 k), with the
// diffusivity k = 0.09 mm2/s (not verified) and the total thickness H.
double warming_h(double rubber_thickness_mm);

}  // namespace isolaw::conditions
