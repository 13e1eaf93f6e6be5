// Tests by simulation how often the confidence intervals of a property factor contain the true value, and compares the
// softening of a measured bearing with an independent program.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "isolaw/conditions/contrast.hpp"
#include "isolaw/conditions/curves.hpp"
#include "isolaw/data/properties/properties.hpp"
#include "isolaw/data/read.hpp"
#include "isolaw/num/random.hpp"

namespace isolaw::conditions {
namespace {

// Holds for each kind of interval the share of simulated lots in which the interval contains the true value.
struct Coverage {
  double mean = 0.0, device = 0.0, system = 0.0;
};

// Simulates lots of 28 devices. The logarithm of a device's true ratio is normally distributed about `ratio`, with the
// standard deviation `slope_std` times `ratio`. Every test has an error of standard deviation `test_std`. The first
// `tested` devices are tested once at reference and once at -20 C.
Coverage simulated(int tested, double slope_std, int lots) {
  constexpr double ratio = 0.27, test_std = 0.006;
  constexpr int installed = 28;
  Condition const warm{.temperature_C = 20.0}, cold{.temperature_C = -20.0};
  num::Draws random(num::Stream(20261129), 0, 0);
  Coverage share;
  for (int lot = 0; lot < lots; ++lot) {
    std::vector<Sample> at_reference, others;
    double sum = 0.0, last = 0.0;
    for (int i = 0; i < installed; ++i) {
      double const true_ln = ratio * (1.0 + slope_std * random.normal());
      double const here = test_std * random.normal(), there = true_ln + test_std * random.normal();
      sum += last = there - here;
      if (i >= tested) continue;
      auto const name = "P" + std::to_string(i);
      at_reference.push_back({.device = name, .condition = warm, .ln = here});
      others.push_back({.device = name, .condition = cold, .ln = there});
    }
    auto const factor = Response(Effect::temperature, at_reference, others, warm, {}).at(-20.0);
    auto const contains = [&](About about, double ln) {
      auto const found = interval(factor, about, installed).value();
      return std::log(found.low) <= ln && ln <= std::log(found.high) ? 1.0 / lots : 0.0;
    };
    share.mean += contains(About::mean, ratio);
    share.device += contains(About::device, last);  // a further device as it would be measured
    share.system += contains(About::system, sum / installed);
  }
  return share;
}

TEST(Interval, contains_its_value_in_19_lots_of_20) {
  for (int const tested : {2, 3, 6})
    for (double const slope_std : {0.0, 0.1}) {
      auto const share = simulated(tested, slope_std, 20'000);
      for (double const each : {share.mean, share.device, share.system})
        EXPECT_NEAR(each, 0.95, 0.01) << tested << " devices, slopes " << slope_std;
    }
}

// The expected numbers come from an independent program, which cut the same record at its downward zero crossings.
// Seven cycles do not determine where the softening ends, so the fitted exponent of K_eff is far below 1.
TEST(Softening, of_a_measured_bearing) {
  auto const file = std::filesystem::path(ISOLAW_DATA_DIR) / "hdrb-gallardo-device/cyclic-24-49-98pct.csv";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is not here";
  auto const properties = data::cyclic_properties(data::read_record(file, {.dt_s = 0.01}));
  std::vector<double> K_eff, energy;
  for (auto const* cycle : properties.counted())
    if (cycle->block == 3) {
      K_eff.push_back(cycle->K_eff_kN_per_mm);
      energy.push_back(cycle->energy_kN_mm);
    }
  ASSERT_EQ(K_eff.size(), 7u);
  EXPECT_NEAR(K_eff[0] / K_eff[2], 1.118749, 1e-4);
  EXPECT_NEAR(energy[0] / energy[2], 1.213928, 1e-4);
  EXPECT_NEAR(softening(K_eff).value().p, 0.353597, 1e-4);
  EXPECT_NEAR(softening(energy).value().p, 1.042393, 1e-4);
}

}  // namespace
}  // namespace isolaw::conditions
