// A device must not count in statistics over devices if its record was made from the record of another device.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "campaign_fixture.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/check.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/study/build_summary.hpp"
#include "isolaw/study/draws.hpp"
#include "isolaw/study/findings.hpp"
#include "isolaw/study/typical_device.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::campaign {
namespace {

class LotWithCopy : public testing::Folder {
 protected:
  // Calibrates nine devices with noise and `copies` copies of D3, whose forces are multiplied by 1.02.
  Contents calibrated(int copies) const {
    std::vector<NamedRecord> records;
    for (unsigned d = 1; d <= 9; ++d) {
      std::mt19937 random(d);
      std::normal_distribution<double> normal;
      data::TestRecord record;
      record.file = fmt::format("D{}.csv", d);
      double const stiffness = 0.9 + 0.02 * normal(random);
      for (int i = 0; i <= 300; ++i) {
        double const phase = 2.0 * std::numbers::pi * i / 100.0;
        record.time_s.push_back(0.02 * i);
        record.disp_mm.push_back(100.0 * std::sin(phase) + 0.03 * normal(random));
        record.force_kN.push_back(stiffness * (80.0 * std::sin(phase) + 30.0 * std::cos(phase)) + 0.2 * normal(random));
      }
      record.sha256 = record.file;
      records.push_back({.name = fmt::format("D{}", d), .record = std::move(record)});
    }
    for (int i = 0; i < copies; ++i) {
      auto copy = records[2];
      copy.name = fmt::format("X{}", i + 1);
      copy.record.sha256 = copy.name;
      for (auto& force : copy.record.force_kN) force *= 1.02;
      records.push_back(std::move(copy));
    }
    Settings settings;
    settings.laws = parse_laws("bilinear");
    settings.runs = 2;
    settings.replicates = 0;
    auto contents = prepare(std::move(records), settings, "lot");
    auto const file = folder / fmt::format("{}.sqlite", copies);
    Store::create(file, contents);
    EXPECT_TRUE(run(contents, file, {.jobs = 2, .progress = {}, .interrupted = {}}));
    EXPECT_TRUE(contents.complete());
    EXPECT_EQ(contents.analyses(), contents.expected_analyses());
    EXPECT_EQ(check(file).faults, std::vector<std::string>{});
    return Store::read(file);
  }
};

TEST_F(LotWithCopy, HasTheStatisticsOfTheOtherNineDevices) {
  auto const nine = calibrated(0), ten = calibrated(1);
  EXPECT_TRUE(std::ranges::all_of(nine.devices, &Device::counts));
  ASSERT_EQ(ten.devices.size(), 10u);
  EXPECT_EQ(ten.devices.back().copy_of, "D3");
  EXPECT_EQ(ten.expected_analyses(), nine.expected_analyses() + 1);
  auto const of_nine = study::build_summary(nine), of_ten = study::build_summary(ten);
  auto const &expected = of_nine.laws.front(), &law = of_ten.laws.front();
  EXPECT_EQ(law.objective.mean, expected.objective.mean);
  EXPECT_EQ(law.objective.std, expected.objective.std);
  EXPECT_EQ(law.objective.best, expected.objective.best);
  EXPECT_EQ(law.beta, expected.beta);
  EXPECT_EQ(law.objective_converged, expected.objective_converged);
  EXPECT_EQ(law.beta_converged, expected.beta_converged);
  EXPECT_EQ(law.loo_objective, expected.loo_objective);
  EXPECT_EQ(law.loo_worst, expected.loo_worst);
  ASSERT_TRUE(law.lot && expected.lot);
  EXPECT_EQ(law.lot->parameters, expected.lot->parameters);
  EXPECT_EQ(law.lot->worst_parameters, expected.lot->worst_parameters);
  ASSERT_TRUE(law.population && expected.population);
  EXPECT_EQ(law.population->devices, 9u);
  EXPECT_EQ(law.population->mean, expected.population->mean);
  EXPECT_EQ(law.population->covariance, expected.population->covariance);
  EXPECT_EQ(study::draw_devices(ten, of_ten, "bilinear", 20, 1, "sample").values,
            study::draw_devices(nine, of_nine, "bilinear", 20, 1, "sample").values);
  EXPECT_EQ(study::mean_magnitude(law, &study::DeviceFit::K_eff_error_percent),
            study::mean_magnitude(expected, &study::DeviceFit::K_eff_error_percent));
  for (std::size_t n = 0; n < expected.devices.front().parameters.size(); ++n)
    EXPECT_EQ(study::largest_difference(law, n), study::largest_difference(expected, n));
  EXPECT_EQ(study::typical_device(of_ten), study::typical_device(of_nine));
  for (std::size_t q = 0; q < of_nine.acceptance.lot.quantities.size(); ++q) {
    EXPECT_EQ(of_ten.acceptance.lot.quantities[q].mean, of_nine.acceptance.lot.quantities[q].mean);
    EXPECT_EQ(of_ten.acceptance.lot.quantities[q].tolerance_factor,
              of_nine.acceptance.lot.quantities[q].tolerance_factor);
  }
  // The law must be fitted to the copy too, and a warning must say that the statistics leave the copy out.
  auto const& copy = law.devices.back();
  EXPECT_FALSE(copy.counts);
  EXPECT_TRUE(copy.optimum);
  EXPECT_FALSE(copy.lot_objective);
  auto const warnings = study::findings(of_ten).warnings;
  auto const said = std::ranges::find(warnings, FindingKind::same_record, &Finding::kind);
  ASSERT_NE(said, warnings.end());
  EXPECT_EQ(wording::sentence(*said),
            "D3 and X1 hold the same record, scaled, shifted, sampled anew or with noise added: it counts as one "
            "device. Means, spreads, draws and bounds leave out X1.");
}

}  // namespace
}  // namespace isolaw::campaign
