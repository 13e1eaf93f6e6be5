// A law's traits declare whether it depends on velocity, is odd, or is integrated along the path. These tests check the
// declarations, and the mechanics that every hysteretic law must obey.
#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "laws/motion.hpp"
#include "laws/paper.hpp"
#include "laws/single_laws.hpp"

namespace isolaw::law_tests {
namespace {

using laws::Integration;

template <class Law>
class Traits : public ::testing::Test {};
TYPED_TEST_SUITE(Traits, EveryLaw, LawName);

Motion slower_motion() {
  return irregular(3, 150.0, 4, 60);
}

// The velocities are multiplied by a factor; the displacements stay. A rate-independent law must give the same bits. A
// rate-dependent law must change its force by more than 1 % of the peak for at least half of the parameter sets.
TYPED_TEST(Traits, RateIndependence) {
  auto const motion = slower_motion();
  constexpr std::uint32_t candidates = 10;
  for (auto const integration : both_integrations)
    for (double const factor : {0.0, 0.1, 5.0}) {
      std::uint32_t differing = 0;
      for (std::uint32_t index = 0; index < candidates; ++index) {
        auto const values = candidate<TypeParam>(index);
        auto const slow = forces<TypeParam>(values, motion, 1, integration);
        auto const fast = forces<TypeParam>(values, scaled(motion, 1.0, factor), 1, integration);
        if constexpr (TypeParam::info.traits.rate_independent) {
          EXPECT_EQ(fast, slow) << name_of(integration) << ", velocity times " << factor;
        } else if (largest_difference(fast, slow) > 0.01 * largest_magnitude(slow)) {
          ++differing;
        }
      }
      if (!TypeParam::info.traits.rate_independent) {
        EXPECT_GE(differing, candidates / 2) << name_of(integration) << ", velocity times " << factor;
      }
    }
}

TYPED_TEST(Traits, ARecordWithoutTimeServesARateIndependentLaw) {
  auto const motion = scaled(slower_motion(), 1.0 / TypeParam::info.length.in_record_units, 1.0);
  auto const values = candidate<TypeParam>(0);
  auto const without = forces<TypeParam>(values, laws::make_path(motion.disp_mm, {}));
  auto const with = forces<TypeParam>(values, laws::make_path(motion.disp_mm, motion.velocity_mm_s));
  EXPECT_EQ(without == with, TypeParam::info.traits.rate_independent);
}

// An odd law must give exactly the opposite force for the mirrored motion, because each of its operations gives the
// opposite result for opposite operands. A law that is not odd must differ visibly.
TYPED_TEST(Traits, OddSymmetry) {
  auto const motion = slower_motion(), mirrored = scaled(motion, -1.0, -1.0);
  for (auto const integration : both_integrations)
    for (std::uint32_t index = 0; index < 10; ++index) {
      auto const values = candidate<TypeParam>(index);
      auto const force = forces<TypeParam>(values, motion, 1, integration);
      auto opposite = forces<TypeParam>(values, mirrored, 1, integration);
      for (double& f : opposite) f = -f;
      double const difference = largest_difference(opposite, force);
      if constexpr (TypeParam::info.traits.odd) {
        EXPECT_EQ(difference, 0.0) << name_of(integration) << ": " << describe<TypeParam>(values);
      } else {
        EXPECT_GT(difference, least_asymmetry(TypeParam::info.id) * largest_magnitude(force))
            << name_of(integration) << ": " << describe<TypeParam>(values);
      }
    }
}

// Vaiana's law is odd if the parameters of loading and unloading are exchanged at the same time. Its non-linear part,
// Eqs. (8)-(9) of Cucuzza et al. 2025, obeys f_e(-x; beta1, beta2, gamma1, gamma2, gamma3) = -f_e(x; -beta1, -beta2,
// gamma1, gamma2, -gamma3).
TEST(TraitsOfVaiana, MirroredWithItsBranchesExchanged) {
  using laws::Vaiana;
  auto const motion = slower_motion(), mirrored = scaled(motion, -1.0, -1.0);
  for (std::uint32_t index = 0; index < 20; ++index) {
    auto const values = candidate<Vaiana>(index);
    auto exchanged = values;
    for (std::string_view const name : {"Kb", "f0", "alpha", "beta1", "beta2", "gamma1", "gamma2", "gamma3"}) {
      double const sign = name == "beta1" || name == "beta2" || name == "gamma3" ? -1.0 : 1.0;
      std::size_t const up = index_of<Vaiana>(std::string(name) + '+'),
                        down = index_of<Vaiana>(std::string(name) + '-');
      exchanged[up] = sign * values[down];
      exchanged[down] = sign * values[up];
    }
    auto const force = forces<Vaiana>(values, motion);
    auto opposite = forces<Vaiana>(exchanged, mirrored);
    for (double& f : opposite) f = -f;
    // The sigmoid is odd by an identity of the exponential, which does not hold bit by bit.
    EXPECT_LT(largest_difference(opposite, force), 1e-12 * largest_magnitude(force)) << describe<Vaiana>(values);
  }
}

// A law without a differential equation gives the same force with both integrations and any refinement. A law with a
// differential equation is integrated in steps, by the Runge-Kutta of Cucuzza et al. 2025 or by its own method, so its
// force changes with the refinement.
TYPED_TEST(Traits, IntegrationMattersToPathIntegratedLawsOnly) {
  auto const motion = slower_motion();
  auto const values = candidate<TypeParam>(1);
  auto const converged = forces<TypeParam>(values, motion),
             paper = forces<TypeParam>(values, motion, 1, Integration::paper);
  auto const finer = forces<TypeParam>(values, motion, 7, Integration::paper);
  double const rounding = 1e-12 * largest_magnitude(converged);
  EXPECT_EQ(paper == converged, !laws::HasPaperStep<TypeParam>);
  if constexpr (TypeParam::info.traits.path_integrated)
    EXPECT_GT(largest_difference(finer, paper), rounding);
  else
    EXPECT_LT(largest_difference(finer, converged), rounding);
}

// The third cycle must dissipate energy at 208 mm, the amplitude of the published tests, for every device and for a
// motion that starts to either side. At 20 mm it must not return energy: bilinear is elastic there and its energy is
// only rounding.
TYPED_TEST(Traits, AClosedLoopDissipates) {
  constexpr int samples_per_cycle = 400;
  for (double const amplitude_mm : {20.0, 208.0})
    for (double const sign : {1.0, -1.0})
      for (std::size_t number = 0; number < table_a5::devices; ++number) {
        auto const motion = scaled(sine(amplitude_mm, 0.5, 3, samples_per_cycle), sign, sign);
        auto const force = forces<TypeParam>(device<TypeParam>(number), motion);
        double energy = 0.0;
        for (std::size_t i = 2 * samples_per_cycle; i + 1 < motion.size(); ++i)
          energy += 0.5 * (force[i] + force[i + 1]) * (motion.disp_mm[i + 1] - motion.disp_mm[i]);
        double const least = amplitude_mm < 100.0 ? -1e-12 * amplitude_mm * largest_magnitude(force) : 0.0;
        EXPECT_GT(energy, least) << "device " << number + 1 << ", amplitude " << sign * amplitude_mm;
      }
}

TYPED_TEST(Traits, RestAtTheOriginIsForceFree) {
  Motion const rest{std::vector<double>(20, 0.0), std::vector<double>(20, 0.0)};
  for (auto const integration : both_integrations)
    for (std::uint32_t index = 0; index < 10; ++index)
      for (double const force : forces<TypeParam>(candidate<TypeParam>(index), rest, 2, integration))
        EXPECT_EQ(force, 0.0);
}

// While the device rests the force stays constant, at any displacement and before or after a motion, because no law
// depends on time itself.
TYPED_TEST(Traits, RestElsewhereKeepsTheForce) {
  for (auto const integration : both_integrations)
    for (std::uint32_t index = 0; index < 10; ++index) {
      auto const values = candidate<TypeParam>(index);
      for (std::size_t moved : {std::size_t{1}, std::size_t{37}, std::size_t{150}}) {
        auto motion = slower_motion();
        motion.disp_mm.resize(moved);
        motion.velocity_mm_s.resize(moved);
        motion.disp_mm.resize(moved + 20, motion.disp_mm.back());
        motion.velocity_mm_s.resize(moved + 20, 0.0);
        auto const force = forces<TypeParam>(values, motion, 1, integration);
        for (std::size_t i = moved; i < force.size(); ++i)
          EXPECT_EQ(force[i], force[moved]) << name_of(integration) << ", held from sample " << moved;
        if constexpr (TypeParam::info.traits.rate_independent) {
          EXPECT_EQ(force[moved], force[moved - 1]);
        }
      }
    }
}

// Five repeated samples in the middle of a motion must not change any later force.
TYPED_TEST(Traits, AHoldLeavesNoTrace) {
  auto const motion = slower_motion();
  for (auto const integration : both_integrations)
    for (std::size_t hold : {std::size_t{0}, std::size_t{37}, std::size_t{75}}) {
      auto held = motion;
      auto const at = static_cast<std::ptrdiff_t>(hold);
      held.disp_mm.insert(held.disp_mm.begin() + at, 5, motion.disp_mm[hold]);
      held.velocity_mm_s.insert(held.velocity_mm_s.begin() + at, 5, motion.velocity_mm_s[hold]);
      auto const values = candidate<TypeParam>(2);
      auto with = forces<TypeParam>(values, held, 1, integration);
      with.erase(with.begin() + at, with.begin() + at + 5);
      EXPECT_EQ(with, forces<TypeParam>(values, motion, 1, integration)) << name_of(integration) << ", sample " << hold;
    }
}

}  // namespace
}  // namespace isolaw::law_tests
