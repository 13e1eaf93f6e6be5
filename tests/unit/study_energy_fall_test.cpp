// Tests by how much the energy of a device's loops falls from cycle to cycle, and how much of this fall a law
// reproduces.
#include "isolaw/study/energy_fall.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace isolaw::study {
namespace {

constexpr int per_cycle = 100;

// Returns elliptic loops in which the energy of cycle k, counted from 0, is proportional to factor(k).
template <class Factor>
data::FitRecord ellipses(int cycles, Factor const& factor) {
  data::FitRecord record;
  for (int i = 0; i <= cycles * per_cycle; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / per_cycle;
    record.time_s.push_back(0.02 * i);
    record.disp_mm.push_back(100.0 * std::sin(phase));
    record.force_kN.push_back(60.0 * std::sin(phase) + 25.0 * factor(i / per_cycle) * std::cos(phase));
  }
  return record;
}

std::optional<EnergyFall> fall_of(data::FitRecord const& record, std::vector<double> const& force_kN) {
  auto const properties = data::cyclic_properties({record.disp_mm, record.force_kN, record.time_s, {}});
  return energy_fall(properties, record, force_kN);
}

double worn(int cycle) {
  return std::pow(0.98, cycle);
}

TEST(EnergyFall, IsThatFromTheThirdCycleToTheLast) {
  auto const record = ellipses(25, worn);
  auto const same = fall_of(record, record.force_kN);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->first_cycle, 3);
  EXPECT_EQ(same->last_cycle, 25);
  EXPECT_NEAR(same->measured_percent, 100.0 * (1.0 - std::pow(0.98, 22)), 0.1);
  EXPECT_NEAR(same->percent, same->measured_percent, 1e-9);
  EXPECT_TRUE(follows(*same));
  auto const constant = fall_of(record, ellipses(25, [](int) { return 0.8; }).force_kN);
  ASSERT_TRUE(constant);
  EXPECT_NEAR(constant->percent, 0.0, 1e-6);
  EXPECT_FALSE(follows(*constant));
}

TEST(EnergyFall, IsNoneWhereADeviceKeepsItsEnergyOrLosesItAtOnce) {
  auto const none = [](data::FitRecord const& record) { return !fall_of(record, record.force_kN); };
  EXPECT_TRUE(none(ellipses(25, [](int) { return 1.0; })));
  // The energy falls once, after the second cycle (scragging).
  EXPECT_TRUE(none(ellipses(25, [](int k) { return k < 2 ? 1.4 : 1.0; })));
  // The energy falls in the first cycles and then stays (scragging).
  EXPECT_TRUE(none(ellipses(25, [](int k) { return 1.0 + 0.5 * std::exp(-k); })));
  EXPECT_TRUE(none(ellipses(25, [](int k) { return k < 24 ? 1.0 : 0.8; })));  // only the last cycle differs
  EXPECT_TRUE(none(ellipses(5, worn)));                                       // the record has too few cycles
}

}  // namespace
}  // namespace isolaw::study
