// Tests how laws that are fitted to the small swings of a record are judged on the large ones.
#include "isolaw/analysis/larger_swings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "isolaw/analysis/steady_cycle.hpp"
#include "twins.hpp"

namespace isolaw::analysis {
namespace {

SwingModels models_of(laws::LawEntry const& law, data::FitRecord const& record) {
  std::array const tests{record};
  auto const sizes = data::swing_sizes(tests, data::Weighting::time);
  EXPECT_TRUE(sizes.shows_larger_swings);
  return swing_models(law, tests, sizes, laws::Integration::converged, laws::TurningPoints::as_sampled, 1);
}

// The law itself computed this record. A fit to its small swings must therefore predict its large ones.
TEST(LargerSwings, ArePredictedByTheTrueLaw) {
  auto const twin = twins::twin_in_box("bilinear", twins::growing_cycles(6, 80));
  auto const found = predict_larger_swings(models_of(*twin.law, twin.record), twin.box, num::Stream(1));
  ASSERT_TRUE(found);
  EXPECT_LT(found->fitted, 1e-3);
  EXPECT_LT(found->predicted, 2e-3);
  EXPECT_LE(found->least_predicted, found->predicted);
  EXPECT_GT(found->evaluations, 0);
}

// This device is linear in its small swings and twice as stiff beyond 105 mm, where only its large swings go. The small
// swings do not show this, so a law that is fitted to them alone must predict the large swings badly.
TEST(LargerSwings, ShowThatALawDoesNotKnowThem) {
  auto record = twins::growing_cycles(6, 80);
  for (std::size_t i = 0; i < record.size(); ++i) {
    double const x = record.disp_mm[i];
    record.force_kN[i] = x + std::copysign(std::max(0.0, std::abs(x) - 105.0), x);
  }
  auto const& law = laws::find_law("bilinear");
  auto const box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(record, law.info), {});
  auto const found = predict_larger_swings(models_of(law, record), box, num::Stream(1));
  ASSERT_TRUE(found);
  EXPECT_LT(found->fitted, 0.01);
  EXPECT_GT(found->predicted, 0.05);
  auto const again = predict_larger_swings(models_of(law, record), box, num::Stream(1));
  EXPECT_EQ(found->parameters, again->parameters);
  EXPECT_FALSE(predict_larger_swings(models_of(law, record), box, num::Stream(1), [] { return true; }));
}

// The yield displacement is fixed at 110 mm, which no small swing reaches, so the small swings do not determine the
// stiffness after yield. The descents of the search end at equally good fits with different values of this stiffness.
// The fit that predicts the large swings worst must be taken.
TEST(LargerSwings, CountByTheWorstOfEquallyGoodFits) {
  auto const record = twins::growing_cycles(6, 80);
  auto const& law = laws::find_law("bilinear");
  std::vector<fit::Override> const overrides{
      {.law = "bilinear", .parameter = "xy", .interval = laws::Interval{110.0, 110.0}}};
  auto const box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(record, law.info), overrides);
  auto const models = models_of(law, record);
  auto const found = predict_larger_swings(models, box, num::Stream(1));
  ASSERT_TRUE(found);
  EXPECT_LT(found->least_predicted, 0.95 * found->predicted);
  EXPECT_EQ(found->predicted, mean_objective(models.large, found->parameters));
}

// The forces beyond 110 mm, which the record reaches only after its last small swing, must not change the objective of
// the small swings.
TEST(LargerSwings, LeaveTheFitOfTheSmallOnesAlone) {
  auto const twin = twins::twin_in_box("power-masing", twins::growing_cycles(6, 80));
  auto changed = twin.record;
  for (std::size_t i = 0; i < changed.size(); ++i)
    if (std::abs(changed.disp_mm[i]) > 110.0) changed.force_kN[i] *= 1.5;
  auto const models = models_of(*twin.law, twin.record), of_changed = models_of(*twin.law, changed);
  EXPECT_EQ(mean_objective(models.small, twin.truth), mean_objective(of_changed.small, twin.truth));
  EXPECT_LT(mean_objective(models.large, twin.truth), 1e-9);
  EXPECT_GT(mean_objective(of_changed.large, twin.truth), 0.1);
  EXPECT_LT(models.small.front().samples(), models.large.front().samples());
}

// The two sets of parameters are an elastoplastic slider and a linear spring. Their third cycles are known in closed
// form.
TEST(SteadyCycles, OfKnownLoopsHaveTheirStiffnessAndEnergy) {
  std::vector<std::vector<double>> const laws{{100.0, 0.0, 0.5}, {2.0, 2.0, 1.0}};
  auto const cycles =
      steady_cycles(laws::find_law("bilinear"), laws, {.amplitude_mm = 100.0}, laws::Integration::converged);
  ASSERT_EQ(cycles.size(), 2u);
  EXPECT_NEAR(cycles[0].K_kN_per_mm, 0.5, 1e-9);                // 50 kN at 100 mm
  EXPECT_NEAR(cycles[0].energy_kN_mm, 4.0 * 50.0 * 99.5, 1.0);  // 4 Qd (amplitude - yield displacement)
  EXPECT_NEAR(cycles[0].overshoot, 1.0, 1e-9);
  EXPECT_NEAR(cycles[1].K_kN_per_mm, 2.0, 1e-9);
  EXPECT_NEAR(cycles[1].energy_kN_mm, 0.0, 1e-6);
  EXPECT_NEAR(cycles[1].jump, 2.0 * std::numbers::pi / 4000.0, 1e-5);  // the steepest change of a sine
}

}  // namespace
}  // namespace isolaw::analysis
