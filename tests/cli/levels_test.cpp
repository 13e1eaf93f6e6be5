// Inspects one test with several amplitudes, frequencies and vertical loads. inspect must list K_eff and damping of
// each block. The device has constant stiffness K and friction Q, so K_eff is K + Q/D at the amplitude D.
#include <numbers>

#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class Levels : public InFreshDirectory {
 protected:
  static constexpr double stiffness = 0.5, strength = 20.0, yield = 2.0;
  static constexpr std::array amplitudes{50.0, 100.0, 150.0};
  static constexpr std::array frequencies{0.1, 0.5};

  // Returns a test of six blocks with three cycles each, at three amplitudes and two frequencies. The vertical load is
  // 1000 kN at 0.1 Hz and 1500 kN at 0.5 Hz. Friction is a tenth larger at 0.1 Hz than at 0.5 Hz.
  static std::string test_in_steps() {
    std::string text = "time [s],displacement [mm],force [kN],vertical load [kN]\n";
    double t = 0.0, z = 0.0, before = 0.0;
    for (double const amplitude : amplitudes)
      for (double const frequency : frequencies)
        for (int i = 0; i < 3 * 200; ++i, t += 1.0 / (200.0 * frequency)) {
          double const x = amplitude * std::sin(2.0 * std::numbers::pi * i / 200.0);
          z = std::clamp(z + (x - before) / yield, -1.0, 1.0);
          before = x;
          text += fmt::format("{:.5f},{:.5f},{:.5f},{}\n", t, x, stiffness * x + friction(frequency) * z,
                              frequency < 0.3 ? 1000 : 1500);
        }
    return text;
  }
  static double friction(double frequency) { return frequency < 0.3 ? 1.1 * strength : strength; }
  static double K_eff(double amplitude, double frequency) { return stiffness + friction(frequency) / amplitude; }
  static double number(Json const& level, char const* key) { return level[key].get<double>(); }
};

TEST_F(Levels, of_a_test_in_steps_stand_beside_one_another) {
  write("d.csv", test_in_steps());
  write("lot.toml", "[[device]]\nname = \"d\"\nfile = \"d.csv\"\nrubber-thickness-mm = 200.0\n");
  auto const o = isolaw({"inspect", "lot.toml", "--design", "disp=100", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  auto const found = json("O/inspection.json");
  auto const& levels = found["levels"];
  ASSERT_EQ(levels.size(), 6u) << levels.dump();
  auto const counting = found["counting_block"].get<std::size_t>();
  double const reference = number(levels[counting - 1], "K_eff_kN_per_mm");
  EXPECT_NEAR(number(levels[counting - 1], "amplitude_mm"), 100.0, 0.1);
  std::size_t i = 0;
  for (double const amplitude : amplitudes)
    for (double const frequency : frequencies) {
      auto const& level = levels[i++];
      EXPECT_EQ(level["block"], i);
      EXPECT_EQ(level["reference"], i == counting);
      EXPECT_NEAR(number(level, "amplitude_mm"), amplitude, 0.05);
      EXPECT_NEAR(number(level, "strain_percent"), amplitude / 2.0, 0.05);
      EXPECT_NEAR(number(level, "frequency_Hz"), frequency, 0.01 * frequency);
      // isolaw cuts the cycle between two samples, so a few samples have the load of the neighbouring block.
      EXPECT_NEAR(number(level, "N_mean_kN"), frequency < 0.3 ? 1000.0 : 1500.0, 5.0);
      EXPECT_NEAR(number(level, "K_eff_kN_per_mm"), K_eff(amplitude, frequency), 1e-3);
      EXPECT_NEAR(number(level, "K_eff_ratio"), K_eff(amplitude, frequency) / reference, 2e-3);
      EXPECT_EQ(level["cycle"], 3);
    }
  EXPECT_NEAR(number(levels[counting - 1], "damping_ratio"), 1.0, 1e-12);
  for (auto const* key : {"K_1_kN_per_mm", "K_d_kN_per_mm", "D_y_mm", "F_y_kN"})
    EXPECT_EQ(levels[0][key], found["blocks"][0]["cycles"][2][key]) << key;
  auto const table = read("O/tables/levels.csv");
  EXPECT_EQ(count_of("\nd,", table), 6u) << table;
  EXPECT_TRUE(contains(table, "device,block,amplitude [mm],strain [%],frequency [Hz],N mean [kN],cycle,K_eff [kN/mm]"))
      << table;
}

// Each amplitude is tested at two frequencies. The skeleton curve must take the earlier of the two blocks.
TEST_F(Levels, have_a_skeleton_of_first_and_third_cycles) {
  write("d.csv", test_in_steps());
  auto const o = isolaw({"inspect", "d.csv", "--details", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  auto const found = json("O/inspection.json");
  auto const& skeleton = found["skeleton"];
  ASSERT_EQ(skeleton.size(), 6u) << skeleton.dump();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(skeleton[i]["cycle"], i < 3 ? 1 : 3);
    EXPECT_EQ(skeleton[i]["block"], 2 * (i % 3) + 1);
    EXPECT_NEAR(number(skeleton[i], "d_plus_mm"), amplitudes[i % 3], 0.05);
    EXPECT_NEAR(number(skeleton[i], "F_minus_kN"), -amplitudes[i % 3] * K_eff(amplitudes[i % 3], 0.1), 0.05);
  }
  auto const& last = found["blocks"][5]["cycles"][2];
  EXPECT_NEAR(number(last, "K_eff_in_block"), 1.0, 1e-3);
  EXPECT_NEAR(number(last, "K_eff_in_test"), K_eff(150.0, 0.5) / K_eff(50.0, 0.1), 2e-3);
  for (auto const* text : {"Skeleton curve: peaks of cycles 1 and 3 of each amplitude",
                           "Bilinear loop of the same peaks", "From cycle to cycle of block 6", "residual +"})
    EXPECT_TRUE(contains(o.out, text)) << o;
  EXPECT_FALSE(contains(isolaw({"inspect", "d.csv"}).out, "Skeleton"));
}

TEST_F(Levels, of_one_block_are_one) {
  write("d.csv", csv(record()));
  ASSERT_EQ(isolaw({"inspect", "d.csv", "--out", "O"}).code, 0);
  auto const found = json("O/inspection.json")["levels"];
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0]["K_eff_ratio"], 1.0);
  EXPECT_TRUE(found[0]["N_mean_kN"].is_null());
}

}  // namespace
}  // namespace isolaw::cli_test
