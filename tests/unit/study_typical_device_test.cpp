// Tests which device is taken as the one that best represents its lot.
#include "isolaw/study/typical_device.hpp"

#include <gtest/gtest.h>

#include "unit/study_fixture.hpp"

namespace isolaw::study {
namespace {

TEST(TypicalDevice, IsNearestToTheMeanOfTheLot) {
  auto summary = fixture::lot(3);
  EXPECT_EQ(typical_device(summary), 1u);  // the devices differ from the mean by -12 %, 0 and 12 %
  // A device that every law fits badly is not typical.
  for (auto& law : summary.laws) *law.devices[1].objective.mean *= 4.0;
  EXPECT_EQ(typical_device(summary), 2u);
}

TEST(TypicalDevice, IsKnownByItsStiffnessAloneOfRecordsWithoutLaws) {
  auto summary = fixture::lot(5, 0);
  std::size_t nearest = 0;
  auto const stiffness = [&](std::size_t d) { return summary.devices[d].properties.reported->K_eff_kN_per_mm; };
  double mean = 0.0;
  for (std::size_t d = 0; d < 5; ++d) mean += stiffness(d) / 5.0;
  for (std::size_t d = 1; d < 5; ++d)
    if (std::abs(stiffness(d) - mean) < std::abs(stiffness(nearest) - mean)) nearest = d;
  EXPECT_EQ(typical_device(summary), nearest);
}

TEST(TypicalDevice, IsNoneThatWasRefused) {
  auto summary = fixture::lot(2);
  EXPECT_EQ(typical_device(summary), 0u);  // both are equally near the mean, so it is the first
  summary.devices[0].status = "refused";
  EXPECT_EQ(typical_device(summary), 1u);
  summary.devices.clear();
  EXPECT_EQ(typical_device(summary), std::nullopt);
}

}  // namespace
}  // namespace isolaw::study
