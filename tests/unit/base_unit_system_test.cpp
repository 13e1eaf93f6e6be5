// Tests how reports convert values to the units that a reader chose.
#include "isolaw/base/unit_system.hpp"

#include <gtest/gtest.h>

namespace isolaw {
namespace {

UnitSystem const& si = find_unit_system("N-m");
UnitSystem const& imperial = find_unit_system("kip-in");

// 1 in = 25.4 mm and 1 lbf = 4.4482216152605 N, both by definition.
TEST(ShownUnit, ConvertsForcesLengthsAndTheirProducts) {
  struct Case {
    char const *stored, *shown;
    double factor;
  };
  for (auto const& [stored, shown, factor] : {Case{"mm", "in", 1.0 / 25.4},
                                              {"kN", "kip", 1.0 / 4.4482216152605},
                                              {"kN/mm", "kip/in", 25.4 / 4.4482216152605},
                                              {"kN mm", "kip-in", 1.0 / (25.4 * 4.4482216152605)},
                                              {"kN m", "kip-in", 1000.0 / (25.4 * 4.4482216152605)},
                                              {"mm^2", "in^2", 1.0 / (25.4 * 25.4)},
                                              {"mm/s", "in/s", 1.0 / 25.4},
                                              {"mm/s^2", "in/s^2", 1.0 / 25.4},
                                              {"MPa", "ksi", 0.145037737730209}}) {
    auto const found = shown_unit(stored, imperial);
    EXPECT_EQ(found.unit, shown) << stored;
    EXPECT_NEAR(found.factor / factor, 1.0, 1e-12) << stored;
  }
  EXPECT_EQ(shown_unit("kN/mm", si).unit, "N/m");
  EXPECT_NEAR(shown_unit("kN/mm", si).factor, 1e6, 1e-6);
  EXPECT_EQ(shown_unit("kN m", si).unit, "N m");
  EXPECT_NEAR(shown_unit("kN m", si).factor, 1e3, 1e-9);
  EXPECT_EQ(shown_unit("MPa", si).unit, "MPa");
}

TEST(ShownUnit, LeavesTheUnitsOfRecordsAndOtherQuantities) {
  for (auto const* unit : {"kN/mm", "MPa", "mm"}) {
    EXPECT_EQ(shown_unit(unit, record_units).unit, unit);
    EXPECT_EQ(shown_unit(unit, record_units).factor, 1.0);
  }
  for (auto const* unit : {"%", "Hz", "s", "-", "", "mrad", "g"}) {
    EXPECT_EQ(shown_unit(unit, imperial).unit, unit);
    EXPECT_EQ(shown_unit(unit, imperial).factor, 1.0) << unit;
  }
}

TEST(ShownUnit, KeepsThePrecisionOfDecimals) {
  EXPECT_EQ(shown_unit("mm", si).decimals(1), 4);        // 0.1 mm is 0.0001 m
  EXPECT_EQ(shown_unit("kN", si).decimals(1), 0);        // 0.1 kN is 100 N
  EXPECT_EQ(shown_unit("mm", imperial).decimals(1), 2);  // 0.1 mm is 0.004 in
  EXPECT_EQ(shown_unit("%", imperial).decimals(1), 1);
}

TEST(ShownUnit, NamesOfNumbersFollow) {
  EXPECT_EQ(unit_of_name("K_eff_kN_per_mm"), "kN/mm");
  EXPECT_EQ(unit_of_name("v_max_mm_s"), "mm/s");
  EXPECT_EQ(unit_of_name("damping_percent"), "");
  EXPECT_EQ(name_in("K_eff_kN_per_mm", imperial), "K_eff_kip_per_in");
  EXPECT_EQ(name_in("energy_kNm", si), "energy_N_m");
  EXPECT_EQ(name_in("isolator_mm", record_units), "isolator_mm");
  EXPECT_EQ(name_in("damping_percent", imperial), "damping_percent");
}

TEST(UnitSystems, RefuseUnknownNames) {
  try {
    find_unit_system("lb-ft", "--report-units");
    FAIL();
  } catch (Error const& error) {
    EXPECT_EQ(error.complaints().front().where, "--report-units");
    EXPECT_EQ(error.complaints().front().allowed, "kN-mm, N-m, kip-in");
  }
}

}  // namespace
}  // namespace isolaw
