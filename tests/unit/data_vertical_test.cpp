// Tests the vertical stiffness from compression tests that are made by formulas, and which compression tests are
// refused because isolaw would have to guess.
#include "isolaw/data/properties/vertical.hpp"

#include <cmath>
#include <functional>
#include <numbers>

#include "data_fixture.hpp"
#include "isolaw/data/signals/vertical_signals.hpp"
#include "refusal.hpp"
#include "signals.hpp"

namespace isolaw::data::testing {
namespace {

struct Press {
  std::function<double(double)> disp_of = [](double load) { return load / 1200.0; };
  int loadings = 3;
  double least_kN = 0.0, largest_kN = 1000.0;
  double hysteresis_mm = 0.0;  // additional displacement while unloading
  // Displacement by which the device has settled before the loading with this number.
  std::function<double(int)> settled = [](int) { return 0.0; };
  int samples = 200;  // number of samples of a loading and its unloading together
};

VerticalTest test_of(Press const& press) {
  VerticalTest test{.file = "v.csv", .sha256 = {}};
  for (int number = 1; number <= press.loadings; ++number)
    for (int i = 0; i < press.samples; ++i) {
      double const phase = 2.0 * std::numbers::pi * i / press.samples;
      double const load = press.least_kN + (press.largest_kN - press.least_kN) * 0.5 * (1.0 - std::cos(phase));
      double const back = phase > std::numbers::pi ? -press.hysteresis_mm * std::sin(phase) : 0.0;
      test.load_kN.push_back(load);
      test.disp_mm.push_back(press.disp_of(load) + back + press.settled(number));
    }
  return test;
}

std::string refusal(VerticalTest const& test) {
  return refusal_of([&] { vertical_stiffness(test); });
}

TEST(Vertical, OfALinearDeviceIsItsStiffness) {
  auto const found = vertical_stiffness(test_of({}));
  EXPECT_NEAR(found.K_v_kN_per_mm, 1200.0, 1e-6);
  EXPECT_EQ(found.loading, 3);
  EXPECT_NEAR(found.loads->low_kN, 300.0, 1e-9);
  EXPECT_NEAR(found.loads->high_kN, 1000.0, 2.0);  // the first sample within 0.2 % of the largest load
  EXPECT_EQ(found.loadings_kN_per_mm.size(), 3u);
  EXPECT_TRUE(found.reversed_signals.empty());
  EXPECT_TRUE(found.warnings.empty());
  EXPECT_EQ(found.description.find("dF_v/dd_v, 3rd loading of 3, from 300 to "), 0u) << found.description;
}

TEST(Vertical, OfAStiffeningDeviceIsTheSecantBetweenTheLoads) {
  auto const disp_of = [](double load) { return 0.004 * std::pow(load, 0.8); };
  auto test = test_of({.disp_of = disp_of, .samples = 20000});
  auto const usual = vertical_stiffness(test);
  auto const secant = [&](LoadRange const& range) {
    return (range.high_kN - range.low_kN) / (disp_of(range.high_kN) - disp_of(range.low_kN));
  };
  EXPECT_NEAR(usual.K_v_kN_per_mm, secant(*usual.loads), 1e-5 * usual.K_v_kN_per_mm);
  test.loads = LoadRange{500.0, 800.0};
  EXPECT_NEAR(vertical_stiffness(test).K_v_kN_per_mm, secant({500.0, 800.0}), 1e-5 * usual.K_v_kN_per_mm);
  EXPECT_GT(vertical_stiffness(test).K_v_kN_per_mm, 1.001 * secant({300.0, 700.0}));
}

TEST(Vertical, LeavesOutWhatUnloadsAndWhatSettles) {
  auto const test = test_of({.hysteresis_mm = 0.05, .settled = [](int number) { return number == 1 ? 0.0 : 0.1; }});
  EXPECT_NEAR(vertical_stiffness(test).K_v_kN_per_mm, 1200.0, 1e-6);
}

TEST(Vertical, TakesTheThirdLoadingOrTheLast) {
  // The device gets stiffer with each loading, so K_v tells which loading was used.
  auto const of = [](int loadings) {
    VerticalTest all{.file = "v.csv", .sha256 = {}};
    for (int number = 1; number <= loadings; ++number) {
      auto const one =
          test_of({.disp_of = [=](double load) { return load / (1000.0 + 100.0 * number); }, .loadings = 1});
      all.load_kN.insert(all.load_kN.end(), one.load_kN.begin(), one.load_kN.end());
      all.disp_mm.insert(all.disp_mm.end(), one.disp_mm.begin(), one.disp_mm.end());
    }
    return vertical_stiffness(all);
  };
  EXPECT_NEAR(of(5).K_v_kN_per_mm, 1300.0, 1e-6);
  EXPECT_EQ(of(5).loading, 3);
  EXPECT_NEAR(of(5).loadings_kN_per_mm[4], 1500.0, 1e-6);
  EXPECT_NEAR(of(2).K_v_kN_per_mm, 1200.0, 1e-6);
  EXPECT_NEAR(of(1).K_v_kN_per_mm, 1100.0, 1e-6);
}

TEST(Vertical, ALoadingThatStaysFarBelowIsNone) {
  auto test = test_of({.loadings = 1, .largest_kN = 400.0});  // a preload to 40 % of the largest load
  auto const rest = test_of({});
  test.load_kN.insert(test.load_kN.end(), rest.load_kN.begin(), rest.load_kN.end());
  test.disp_mm.insert(test.disp_mm.end(), rest.disp_mm.begin(), rest.disp_mm.end());
  EXPECT_EQ(vertical_stiffness(test).loadings_kN_per_mm.size(), 3u);
}

TEST(Vertical, SignsOfBothSignalsDoNotCount) {
  for (double const load_sign : {1.0, -1.0})
    for (double const disp_sign : {1.0, -1.0}) {
      auto test = test_of({});
      for (double& load : test.load_kN) load *= load_sign;
      for (double& d : test.disp_mm) d *= disp_sign;
      auto const found = vertical_stiffness(test);
      EXPECT_NEAR(found.K_v_kN_per_mm, 1200.0, 1e-6);
      EXPECT_EQ(found.reversed_signals.size(), (load_sign < 0.0 ? 1u : 0u) + (disp_sign < 0.0 ? 1u : 0u));
    }
}

TEST(Vertical, NeitherNoiseNorAHeldLoadMovesIt) {
  // The load stays at 1000 kN for as long as the loading took, while the rubber creeps by a tenth of its displacement.
  // The second test adds noise of 0.1 % to both channels.
  VerticalTest test{.file = "v.csv", .sha256 = {}};
  for (int i = 0; i <= 1000; ++i) {
    test.load_kN.push_back(i);
    test.disp_mm.push_back(i / 1200.0);
  }
  for (int i = 1; i <= 1000; ++i) {
    test.load_kN.push_back(1000.0);
    test.disp_mm.push_back((1000.0 + 0.1 * i) / 1200.0);
  }
  EXPECT_NEAR(vertical_stiffness(test).K_v_kN_per_mm, 1200.0, 1e-6);
  auto noisy = test_of({});
  for (std::size_t i = 0; i < noisy.load_kN.size(); ++i) {
    noisy.load_kN[i] += std::sin(12.9898 * static_cast<double>(i));
    noisy.disp_mm[i] += 0.001 * std::sin(78.233 * static_cast<double>(i));
  }
  EXPECT_NEAR(vertical_stiffness(noisy).K_v_kN_per_mm, 1200.0, 0.01 * 1200.0);
  EXPECT_EQ(vertical_stiffness(noisy).loadings_kN_per_mm.size(), 3u);
}

// The largest noisy load lies above the true largest load, and noisy samples cross a load too early. Without averaging,
// noise of 1 % would make K_v 2 to 7 % too large. The mean error must stay below 0.6 %.
TEST(Vertical, NoiseMakesNoDeviceStiffer) {
  Drawn drawn(7);
  for (int const samples : {200, 1000, 6000})
    for (double const noise : {0.001, 0.003, 0.01}) {
      double sum = 0.0;
      int const tests = samples > 1000 ? 20 : 60;
      for (int k = 0; k < tests; ++k) {
        auto test = test_of({.samples = samples});
        for (double& load : test.load_kN) load += noise * 1000.0 * drawn.normal();
        for (double& disp : test.disp_mm) disp += noise * 1000.0 / 1200.0 * drawn.normal();
        sum += vertical_stiffness(test).K_v_kN_per_mm / 1200.0 - 1.0;
      }
      EXPECT_LT(std::abs(sum / tests), 0.006) << samples << " samples a loading, noise " << noise;
    }
}

// Returns a random compression test of a device that stiffens, settles and creeps. The loadings rise and fall as
// triangles or cosines and may be held at their ends. Friction, noise and a coarse converter are drawn too.
VerticalTest drawn_test(Drawn& drawn) {
  int const samples = static_cast<int>(drawn.on_logs(20.0, 2000.0)), loadings = drawn.whole(1, 5);
  bool const triangle = drawn.chance(0.5), lifts_off = drawn.chance(0.2), friction = drawn.chance(0.3);
  int const held = drawn.chance(0.4) ? static_cast<int>(drawn.between(0.05, 1.0) * samples) : 0;
  int const held_low = drawn.chance(0.3) ? static_cast<int>(drawn.between(0.05, 0.5) * samples) : 0;
  double const creep = drawn.between(0.0, 0.15), power = drawn.between(0.6, 1.0), settles = drawn.between(0.0, 0.3);
  double const hysteresis = drawn.between(0.0, 0.15), least = drawn.chance(0.5) ? 0.0 : drawn.between(0.0, 0.3);
  double const noise = drawn.chance(0.5) ? 0.0 : drawn.on_logs(1e-4, 1e-2);
  double const steps = drawn.chance(0.5) ? 0.0 : drawn.on_logs(1e-5, 5e-3);
  double const slips = friction ? drawn.between(0.0, 0.03) : 0.0;
  VerticalTest test{.file = "v.csv", .sha256 = {}};
  double crept = 0.0;
  auto const put = [&](double load, double disp) {
    auto const recorded = [&](double value) {
      value += noise * drawn.normal();
      return steps > 0.0 ? steps * std::round(value / steps) : value;
    };
    test.load_kN.push_back(1000.0 * recorded(load));
    test.disp_mm.push_back(2.0 * recorded(disp));
  };
  for (int number = 1; number <= loadings; ++number) {
    for (int i = 0; i < samples; ++i) {
      double const phase = static_cast<double>(i) / samples;
      double const start = number == 1 ? settles * phase : settles;
      double const shape =
          triangle ? 1.0 - std::abs(2.0 * phase - 1.0) : 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * phase));
      double const load = least + (1.0 - least) * shape;
      bool const back = phase > 0.5;
      double const loop = back ? hysteresis * 4.0 * shape * (1.0 - shape) : 0.0;
      put(back ? std::max(0.0, load - slips) : load, 0.7 * std::pow(load, power) + loop + start + crept);
      if (i == samples / 2)
        for (int k = 1; k <= held; ++k) {
          crept += creep / held * std::exp(-3.0 * k / held);
          put(load, 0.7 * std::pow(load, power) + start + crept);
        }
    }
    for (int k = 1; k <= held_low; ++k)
      put(least, 0.7 * std::pow(least, power) + settles + crept -
                     (lifts_off && least == 0.0 ? 0.3 * std::sin(3.14159 * k / held_low) : 0.0));
  }
  return test;
}

TEST(VerticalSignals, ATrueTestIsLeftAlone) {
  Drawn drawn(11);
  int found = 0;
  std::string said;
  for (int k = 0; k < 2000; ++k) {
    auto const test = drawn_test(drawn);
    auto const faults = vertical_faults(test.disp_mm, test.load_kN);
    if (faults.empty()) continue;
    ++found;
    said += std::to_string(k) + " of " + std::to_string(test.load_kN.size()) + ": " + faults.front().channel + "\n";
  }
  EXPECT_EQ(found, 0) << said;
}

std::string after(VerticalTest test, std::function<void(VerticalTest&)> const& disturb) {
  disturb(test);
  return refusal(test);
}

TEST(VerticalSignals, OneThatCannotBeTrueGivesNoStiffness) {
  Drawn drawn(12);
  for (double const noise : {0.0, 0.001, 0.005}) {
    auto test = test_of({.hysteresis_mm = 0.05});
    for (double& load : test.load_kN) load += noise * 1000.0 * drawn.normal();
    for (double& disp : test.disp_mm) disp += noise * 1000.0 / 1200.0 * drawn.normal();
    EXPECT_EQ(refusal(test), "") << noise;
    auto const expect = [&](std::string const& word, std::string const& channel,
                            std::function<void(VerticalTest&)> const& disturb) {
      auto const said = after(test, disturb);
      EXPECT_NE(said.find(word), std::string::npos) << word << ", noise " << noise << ": " << said;
      EXPECT_NE(said.find("v.csv: vertical " + channel), std::string::npos) << said;
    };
    expect("is disturbed by spikes at sample 431", "load", [](auto& t) { t.load_kN[430] += 2000.0; });
    expect("is disturbed by spikes at sample 451", "displacement", [](auto& t) { t.disp_mm[450] -= 0.3; });
    // The converter clips the load after the noise is added, so the plateau has no noise.
    expect("is clipped at 800 kN, from sample", "load", [](auto& t) {
      for (double& load : t.load_kN) load = std::min(load, 800.0);
    });
    expect("is clipped at 0.6 mm, from sample", "displacement", [](auto& t) {
      for (double& disp : t.disp_mm) disp = std::min(disp, 0.6);
    });
    expect("is stuck at ", "displacement", [](auto& t) {
      for (std::size_t i = 430; i < 470; ++i) t.disp_mm[i] = t.disp_mm[429];
    });
    expect("is stuck at ", "load", [](auto& t) {
      for (std::size_t i = 430; i < 470; ++i) t.load_kN[i] = t.load_kN[429];
    });
    expect("is interrupted at 0 kN, from sample 451", "load", [](auto& t) {
      for (std::size_t i = 450; i < 456; ++i) t.load_kN[i] = 0.0;
    });
    // A clipped load must be found with reversed signs too.
    expect("is clipped at 800 kN, from sample", "load", [](auto& t) {
      for (double& load : t.load_kN) load = -std::min(load, 800.0);
      for (double& disp : t.disp_mm) disp = -disp;
    });
  }
}

TEST(Vertical, ARangeThatTheMachineMissesByLittleIsHeld) {
  auto test = test_of({.least_kN = 705.0, .largest_kN = 1295.0});
  test.loads = LoadRange{700.0, 1300.0};
  auto const found = vertical_stiffness(test);
  EXPECT_NEAR(found.K_v_kN_per_mm, 1200.0, 1e-6);
  EXPECT_NEAR(found.loads->low_kN, 705.0, 1e-9);
}

TEST(Vertical, RefusesARangeThatNoLoadingHolds) {
  auto test = test_of({.least_kN = 700.0, .largest_kN = 1300.0});
  auto const said = refusal(test);
  EXPECT_NE(said.find("v.csv: the loading goes from 700 to 1300 kN, K_v is asked for between 390 and 1300 kN"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find("loads = \"700:1300\""), std::string::npos) << said;
  test.loads = LoadRange{700.0, 1500.0};
  EXPECT_NE(refusal(test), "");
  test.loads = LoadRange{700.0, 1300.0};
  EXPECT_EQ(refusal(test), "");
}

TEST(Vertical, RefusesWhatIsNoCompressionTest) {
  EXPECT_NE(refusal({.file = "v.csv", .sha256 = {}}), "");
  auto test = test_of({});
  std::ranges::fill(test.load_kN, 500.0);
  EXPECT_NE(refusal(test).find("the vertical load does not rise"), std::string::npos) << refusal(test);
  test = test_of({});
  std::ranges::fill(test.disp_mm, 1.0);
  EXPECT_NE(refusal(test).find("a displacement that grows with the load"), std::string::npos) << refusal(test);
}

TEST(Vertical, WarnsOfAStiffnessThatNoDeviceHas) {
  auto const soft = test_of({.disp_of = [](double load) { return load / 0.7; }});
  auto const found = vertical_stiffness(soft);
  ASSERT_EQ(found.warnings.size(), 1u);
  EXPECT_TRUE(says(found.warnings, "no isolator has a vertical stiffness of"));
}

TEST(Vertical, MayBeStatedAlone) {
  auto const found = vertical_stiffness({.file = {}, .sha256 = {}, .stated_kN_per_mm = 1234.0});
  EXPECT_EQ(found.K_v_kN_per_mm, 1234.0);
  EXPECT_EQ(found.description, "as the laboratory states it");
  EXPECT_FALSE(found.loads);
}

TEST(Loads, AreReadFromText) {
  EXPECT_EQ(parse_loads(" 300 : 1000.5 "), (LoadRange{300.0, 1000.5}));
  EXPECT_EQ(parse_loads(loads_text({0.0, 1e6})), (LoadRange{0.0, 1e6}));
  for (auto const* text : {"", "300", "300:", ":300", "300:200", "300:300", "-1:5", "a:b", "1:inf", "nan:1"})
    EXPECT_THROW(parse_loads(text), Error) << text;
}

using VerticalFiles = Files;

TEST_F(VerticalFiles, AreReadByTheNamesOfEitherMachine) {
  std::string const rows = "\n0;0.0;10\n1;0.1;110\n2;0.2;210\n3;0.3;310\n";
  for (auto const* head : {"Time [s];Vertical displacement [mm];Vertical load [kN]",
                           "Time [s];Displacement [mm];Load [kN]", "Time [s];Axial Displacement [mm];Axial Force [kN]",
                           "Zeit [s];Vertikalverschiebung [mm];Vertikalkraft [kN]", "t [s];d [mm];F [kN]"}) {
    auto const test = read_vertical(write(head + rows), {}, {});
    EXPECT_EQ(test.disp_mm, (std::vector{0.0, 0.1, 0.2, 0.3})) << head;
    EXPECT_EQ(test.load_kN, (std::vector{10.0, 110.0, 210.0, 310.0})) << head;
    EXPECT_EQ(test.sha256.size(), 64u);
  }
}

TEST_F(VerticalFiles, OfARigThatShearsTooAreOfTheVerticalOnes) {
  auto const test = read_vertical(write("Time [s];Displacement [mm];Force [kN];Vertical displacement [mm];Vertical "
                                        "force [kN]\n0;5;1;0.0;10\n0;6;2;0.1;110\n0;7;3;0.2;210\n"),
                                  {}, {});  // a compression test needs no time
  EXPECT_EQ(test.disp_mm, (std::vector{0.0, 0.1, 0.2}));
  EXPECT_EQ(test.load_kN, (std::vector{10.0, 110.0, 210.0}));
}

TEST_F(VerticalFiles, AreRefusedWithWhatALotFileTakes) {
  auto const said = refusal_of([&] { read_vertical(write("a;b\n0.0;10\n0.1;110\n0.2;210\n"), {}, {}); });
  EXPECT_NE(said.find("no column is recognised as the vertical displacement"), std::string::npos) << said;
  EXPECT_NE(said.find("no column is recognised as the vertical load"), std::string::npos) << said;
  EXPECT_NE(said.find("as keys of the device's table 'vertical' in a lot file"), std::string::npos) << said;
  ReadOptions told;
  told.columns = {{Channel::disp, "a"}, {Channel::load, "b"}};
  told.units = {{Channel::disp, "mm"}, {Channel::load, "MN"}};
  EXPECT_EQ(read_vertical(write("a;b\n0.0;1\n0.1;2\n0.2;3\n"), told, {}).load_kN, (std::vector{1e3, 2e3, 3e3}));
}

}  // namespace
}  // namespace isolaw::data::testing
