// Tests a law on a device that has several tests. The law starts at rest in each test, and its objective for the device
// is the mean of its objectives for the tests.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "isolaw/data/cycles/swings.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::fit {
namespace {

// Returns cycles of this amplitude, with an elliptic loop of force.
data::FitRecord cycles(double amplitude_mm, int count) {
  data::FitRecord record;
  for (int i = 0; i <= 100 * count; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / 100.0;
    record.time_s.push_back(0.02 * i);
    record.disp_mm.push_back(amplitude_mm * std::sin(phase));
    record.vel_mm_s.push_back(amplitude_mm * std::numbers::pi * std::cos(phase));
    record.force_kN.push_back(amplitude_mm * (0.8 * std::sin(phase) + 0.2 * std::cos(phase)));
  }
  record.weights = data::sample_weights(record.disp_mm, record.time_s, data::Weighting::swing);
  return record;
}

data::FitRecord one_after_another(data::FitRecord const& first, data::FitRecord const& second) {
  data::FitRecord both = first;
  both.starts = {0, first.size()};
  double const later = first.time_s.back() + 0.02;
  for (double const t : second.time_s) both.time_s.push_back(later + t);
  for (auto const channel : {&data::FitRecord::disp_mm, &data::FitRecord::vel_mm_s, &data::FitRecord::force_kN,
                             &data::FitRecord::scored, &data::FitRecord::weights})
    std::ranges::copy(second.*channel, std::back_inserter(both.*channel));
  return both;
}

struct Device {
  data::FitRecord small = cycles(50.0, 2), large = cycles(100.0, 3), both = one_after_another(small, large);
};

// Returns twenty parameter sets that lie between 0.4 and 0.59 of each interval of the law's box.
std::vector<std::vector<double>> candidates(laws::LawEntry const& law, data::FitRecord const& record) {
  auto const box = make_box(law, BoxKind::scaled, scales_of(record, law.info), {});
  std::vector<std::vector<double>> all(20, std::vector<double>(law.parameters.size()));
  for (std::size_t i = 0; i < all.size(); ++i)
    box.expand(std::vector<double>(box.free_count(), 0.4 + 0.01 * static_cast<double>(i)), all[i]);
  return all;
}

class EveryLaw : public ::testing::TestWithParam<std::size_t> {};

TEST_P(EveryLaw, HasTheMeanObjectiveOfTheTests) {
  auto const& law = laws::catalogue()[GetParam()];
  Device const device;
  auto const model_of = [&](data::FitRecord const& record) {
    return LawOnRecord(law, record, laws::Integration::converged, laws::TurningPoints::interpolated);
  };
  auto const both = model_of(device.both), small = model_of(device.small), large = model_of(device.large);
  auto const all = candidates(law, device.both);
  auto const write = [&](std::size_t i, std::span<double> values) { std::ranges::copy(all[i], values.begin()); };
  std::vector<double> blocks(all.size()), rows(num::padded(all.size()) * both.samples()), work;
  both.objectives(all.size(), write, blocks);
  both.residual_rows(all.size(), write, num::padded(all.size()), rows);
  for (std::size_t i = 0; i < all.size(); ++i) {
    double const mean = (small.objective(all[i], work) + large.objective(all[i], work)) / 2.0;
    if (!std::isfinite(mean)) continue;
    EXPECT_NEAR(both.objective(all[i], work), mean, 1e-10 * mean);
    EXPECT_NEAR(blocks[i], mean, 1e-9 * mean);
    double sum = 0.0;
    for (std::size_t j = 0; j < both.samples(); ++j)
      sum += both.residual_weights()[j] * std::abs(rows[j * num::padded(all.size()) + i]);
    EXPECT_NEAR(sum, mean, 1e-9 * mean);
    EXPECT_NEAR(both.integration_shift(all[i]),
                std::abs((small.integration_shift(all[i]) + large.integration_shift(all[i])) / 2.0), 1e-3 * mean);
  }
}

TEST_P(EveryLaw, StartsAtRestInEachTest) {
  auto const& law = laws::catalogue()[GetParam()];
  Device const device;
  auto const parameters = candidates(law, device.both).front();
  auto const force = LawOnMotion(law, device.both, laws::Integration::converged).force_kN(parameters);
  auto const alone = LawOnMotion(law, device.large, laws::Integration::converged).force_kN(parameters);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    if (!std::isfinite(alone[i])) continue;
    EXPECT_NEAR(force[device.small.size() + i], alone[i], 1e-9 * std::max(1.0, std::abs(alone[i]))) << i;
  }
}

TEST_P(EveryLaw, OutlineKeepsTheTestsApart) {
  auto const& law = laws::catalogue()[GetParam()];
  Device const device;
  LawOnRecord const model(law, device.both, laws::Integration::converged);
  auto const outline = model.outline();
  ASSERT_TRUE(outline);
  auto const shares = outline->residual_weights();
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
  auto const small = LawOnRecord(law, device.small, laws::Integration::converged).outline();
  auto const large = LawOnRecord(law, device.large, laws::Integration::converged).outline();
  ASSERT_TRUE(small && large);
  std::vector<double> work;
  for (auto const& parameters : candidates(law, device.both)) {
    double const mean = (small->objective(parameters, work) + large->objective(parameters, work)) / 2.0;
    if (std::isfinite(mean)) {
      EXPECT_NEAR(outline->objective(parameters, work), mean, 1e-9 * mean);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(SeveralTests, EveryLaw, ::testing::Range<std::size_t>(0, laws::catalogue().size()),
                         [](auto const& test) {
                           std::string id(laws::catalogue()[test.param].info.id);
                           std::ranges::replace(id, '-', '_');
                           return id;
                         });

// No sample of the first test is scored, so the objective must be that of the second test alone.
TEST(SeveralTests, ATestWithoutScoredSamplesTakesNoPart) {
  Device device;
  device.small.scored.assign(device.small.size(), 0.0);
  device.large.scored.assign(device.large.size(), 1.0);
  auto const both = one_after_another(device.small, device.large);
  auto const& law = laws::find_law("bilinear");
  std::vector<double> const parameters{1.5, 0.5, 30.0};
  std::vector<double> work;
  double const alone = LawOnRecord(law, device.large, laws::Integration::converged).objective(parameters, work);
  LawOnRecord const model(law, both, laws::Integration::converged);
  EXPECT_NEAR(model.objective(parameters, work), alone, 1e-12);
  auto const force = model.force_kN(parameters);
  EXPECT_NEAR(objective_on(both, force, both.scored), alone, 1e-12);
  EXPECT_EQ(model.spreads_kN().size(), both.size());
}

}  // namespace
}  // namespace isolaw::fit
