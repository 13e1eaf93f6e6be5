// These tests use records and parameters that no device has but that a user may pass. Every law must answer with a
// finite force, with an objective of +infinity, or with an Error. With the environment variable ISOLAW_DRAWS=100000 the
// tests draw more parameter sets and use a record of a million samples.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "isolaw/base/error.hpp"
#include "isolaw/data/clean.hpp"
#include "laws/paper.hpp"
#include "laws/records.hpp"
#include "laws/single_laws.hpp"
#include "not_finite.hpp"

namespace isolaw::law_tests {
namespace {

using laws::Integration;
using Numbers = std::vector<double>;
constexpr std::array both{Integration::converged, Integration::paper};

data::FitRecord published_record() {
  return record_of(sine(208.0, 0.5, 3, 20), 0.1, 0.67, 45.0);
}

fit::SearchBox published_box(laws::LawEntry const& law) {
  return fit::make_box(law, fit::BoxKind::published, fit::scales_of(published_record(), law.info), {});
}

Motion motion_of(data::FitRecord const& record) {
  return {record.disp_mm, record.vel_mm_s};
}

class Faults : public ::testing::TestWithParam<std::string> {
 protected:
  laws::LawEntry const& law = laws::find_law(GetParam());
  fit::SearchBox const box = published_box(law);

  Numbers middle() const {
    Numbers values(box.parameters.size());
    box.expand(Numbers(box.free_count(), 0.5), values);
    return values;
  }
  bool rate_independent() const { return law.info.traits.rate_independent; }
};
INSTANTIATE_TEST_SUITE_P(Every, Faults, ::testing::ValuesIn(law_ids()), ByLaw());

// Expects that all forces and the objective are finite, or that the objective is +infinity.
void expect_defined(laws::LawEntry const& law, data::FitRecord const& record, Numbers const& parameters,
                    Integration integration) {
  fit::LawOnRecord const model(law, record, integration);
  Numbers work;
  double const objective = model.objective(parameters, work);
  bool const finite = all_finite(model.force_kN(parameters));
  EXPECT_TRUE(objective == infinity || (finite && std::isfinite(objective)))
      << "objective " << objective << ": " << describe(law, parameters);
  if (inadmissible(law, parameters)) {
    EXPECT_EQ(objective, infinity) << describe(law, parameters);
  }
}

// Parameters ------------------------------------------------------------------------------------------------------

// If a parameter is NaN or infinite, no force may be finite. This holds even if the infinite value would have a meaning
// (an infinite yield displacement: no yielding), and if the motion does not involve the parameter (the device rests or
// moves one way only).
TEST_P(Faults, AParameterThatIsNotFiniteLeavesNoForce) {
  auto const moving = motion_of(published_record());
  Motion const rest{Numbers(5, 0.0), Numbers(5, 0.0)}, push{{0.0, 10.0, 20.0}, {10.0, 10.0, 10.0}};
  fit::LawOnRecord const model(law, published_record(), Integration::converged);
  Numbers work;
  for (std::size_t i = 0; i < middle().size(); ++i)
    for (double const value : {nan, infinity, -infinity}) {
      auto parameters = middle();
      parameters[i] = value;
      for (auto const integration : both)
        for (auto const& motion : {moving, rest, push})
          for (double const force : forces(law, parameters, motion, integration))
            ASSERT_FALSE(std::isfinite(force)) << describe(law, parameters);
      EXPECT_EQ(model.objective(parameters, work), infinity);
    }
}

// Each parameter is, at random, an ordinary value, zero, one of its physical limits, or so large or small that products
// overflow or vanish.
TEST_P(Faults, ParametersAtTheEndsOfThePhysicalLimits) {
  auto const record = record_of(irregular(7, 208.0, 2, 20), 0.02, 0.67, 45.0);
  for (std::uint32_t index = 0; index < draws(2000); ++index) {
    num::Draws choice(num::Stream(8), 0, index);
    auto parameters = candidate_in(box, index);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      auto const& [lower, upper] = law.parameters[i].physical;
      constexpr double huge = 1e300, tiny = std::numeric_limits<double>::min();
      switch (choice.below(8)) {
        case 0:
          parameters[i] = std::max(lower, -huge);
          break;
        case 1:
          parameters[i] = std::min(upper, huge);
          break;
        case 2:
          parameters[i] = std::clamp(0.0, lower, upper);
          break;
        case 3:
          parameters[i] = upper > 0.0 ? tiny : -tiny;
          break;
        default:
          break;
      }
    }
    for (auto const integration : both) expect_defined(law, record, parameters, integration);
    if (HasFailure()) break;
  }
}

// Each parameter whose physical limits include zero is set to zero, one parameter at a time. Examples: jankowski's a11
// or hwang-wu's a8 = 0 (damping saturates at once), vaiana's alpha = 0 (a branch never approaches its limit curve),
// abe's alpha = 0 (the stiffness softens at once).
TEST_P(Faults, AnyParameterThatMayBeZeroMayBeZero) {
  Motion const slow = scaled(irregular(3, 208.0, 2, 20), 1.0, 1e-200), still = scaled(slow, 1.0, 0.0);
  for (std::size_t i = 0; i < law.parameters.size(); ++i) {
    auto const& physical = law.parameters[i].physical;
    if (physical.lower > 0.0 || physical.upper < 0.0) continue;
    for (std::uint32_t index = 0; index < 50; ++index) {
      auto parameters = candidate_in(box, index);
      parameters[i] = 0.0;
      for (auto const& motion : {irregular(index, 208.0, 2, 20), slow, still}) {
        auto const force = forces(law, parameters, motion, Integration::converged);
        EXPECT_EQ(all_finite(force), !inadmissible(law, parameters)) << describe(law, parameters);
      }
      for (auto const integration : both) expect_defined(law, published_record(), parameters, integration);
    }
  }
}

TEST_P(Faults, AllParametersZero) {
  Numbers const zeros(law.parameters.size(), 0.0);
  for (auto const integration : both) {
    auto const force = forces(law, zeros, motion_of(published_record()), integration);
    if (needs_parameters(GetParam()))
      EXPECT_FALSE(all_finite(force));
    else
      EXPECT_EQ(largest_magnitude(force), 0.0);
    expect_defined(law, published_record(), zeros, integration);
  }
}

// Displacements ---------------------------------------------------------------------------------------------------

TEST_P(Faults, AConstantDisplacementKeepsTheVirginForce) {
  for (double const x_mm : {0.0, 35.0, -208.0})
    for (auto const integration : both)
      for (std::uint32_t index = 0; index < 20; ++index) {
        auto const parameters = candidate_in(box, index);
        auto const force = forces(law, parameters, {Numbers(50, x_mm), Numbers(50, 0.0)}, integration);
        ASSERT_TRUE(std::isfinite(force[0]));
        for (double const value : force) EXPECT_EQ(value, force[0]) << describe(law, parameters);
      }
}

TEST_P(Faults, MovingDisplacementsWithoutAVelocity) {
  Motion still = irregular(4, 208.0, 3, 20);
  still.velocity_mm_s.assign(still.size(), 0.0);
  for (std::uint32_t index = 0; index < 500; ++index) {
    auto const parameters = candidate_in(box, index);
    ASSERT_TRUE(all_finite(forces(law, parameters, still, Integration::converged))) << describe(law, parameters);
  }
}

TEST_P(Faults, TwoSamplesAreTheFirstTwoOfMore) {
  auto const whole = motion_of(published_record());
  Motion const two{{whole.disp_mm[0], whole.disp_mm[1]}, {whole.velocity_mm_s[0], whole.velocity_mm_s[1]}};
  for (auto const integration : both) {
    auto const expected = forces(law, middle(), whole, integration), found = forces(law, middle(), two, integration);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0], expected[0]);
    EXPECT_EQ(found[1], expected[1]);
    EXPECT_TRUE(all_finite(found));
  }
}

// The device is pushed to 300 mm in a straight line, and every force must be finite. The steps are 0.1 mm long, so
// short that an explicit Runge-Kutta step is stable for every parameter set of the published boxes.
TEST_P(Faults, AMonotonicRecord) {
  auto const push = polyline(Numbers{0.0, 300.0}, 3000), pull = scaled(push, -1.0, -1.0);
  for (std::uint32_t index = 0; index < 50; ++index)
    for (auto const integration : both)
      for (auto const& motion : {push, pull}) {
        auto const parameters = candidate_in(box, index);
        EXPECT_TRUE(all_finite(forces(law, parameters, motion, integration))) << describe(law, parameters);
      }
}

// The displacements are so small that their differences are denormal numbers and the squares of velocities are 0. Where
// the automatic box of such a record is infinite, the objective must be infinite.
TEST_P(Faults, DenormalDisplacements) {
  for (double const size : {1e-150, 1e-300, 1e-310, 5e-324}) {
    Motion const motion = scaled(irregular(5, 1.0, 3, 20), size, size);
    auto record = published_record();
    record.disp_mm = motion.disp_mm;
    record.vel_mm_s = motion.velocity_mm_s;
    record.time_s.clear();
    record.force_kN.resize(motion.size());
    for (std::size_t i = 0; i < motion.size(); ++i) record.time_s.push_back(0.02 * static_cast<double>(i));
    auto const scaled_box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(record, law.info), {});
    for (std::uint32_t index = 0; index < 50; ++index)
      for (auto const integration : both) {
        auto const parameters = candidate_in(box, index);
        EXPECT_TRUE(all_finite(forces(law, parameters, motion, integration))) << describe(law, parameters);
        expect_defined(law, record, candidate_in(scaled_box, index), integration);
      }
  }
}

// The device moves by a kilometre. The bounds of the automatic box grow with the displacement, so the forces of its
// parameter sets must be finite, except for the sets that single_laws.hpp exempts. The published bounds do not grow, so
// vaiana's exponentials (50 per metre) and the powers of other laws may overflow; the objective must then be infinite.
TEST_P(Faults, HugeDisplacements) {
  auto const record = record_of(irregular(6, 1e6, 3, 20), 0.02, 0.67, 45e3);
  auto const scaled_box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(record, law.info), {});
  for (std::uint32_t index = 0; index < 500; ++index) {
    auto const parameters = candidate_in(scaled_box, index);
    if (!inadmissible(law, parameters) && !may_run_away(law, parameters, 1.2e6)) {
      EXPECT_TRUE(all_finite(forces(law, parameters, motion_of(record), Integration::converged)))
          << describe(law, parameters);
    }
    for (auto const integration : both) {
      expect_defined(law, record, parameters, integration);
      expect_defined(law, record, candidate_in(box, index), integration);
    }
  }
}

// No sensor reports a displacement that is NaN, infinite or near the largest double. A law must answer such a record
// with a force or an infinite objective, not with undefined behaviour.
TEST_P(Faults, DisplacementsThatAreNotFinite) {
  for (double const value : {nan, infinity, -infinity, 1.5e308}) {
    auto record = published_record();
    record.disp_mm[10] = value;
    record.disp_mm[11] = -value;
    for (auto const integration : both)
      for (std::uint32_t index = 0; index < 20; ++index)
        expect_defined(law, record, candidate_in(box, index), integration);
  }
}

// A slow acquisition may record every sample three times. Repeated samples add no travel, so no force changes.
TEST_P(Faults, RepeatedSamplesChangeNothing) {
  auto const once = irregular(9, 208.0, 2, 40);
  Motion thrice;
  for (std::size_t i = 0; i < once.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      thrice.disp_mm.push_back(once.disp_mm[i]);
      thrice.velocity_mm_s.push_back(once.velocity_mm_s[i]);
    }
  for (std::uint32_t index = 0; index < 50; ++index) {
    auto const parameters = candidate_in(box, index);
    auto const expected = forces(law, parameters, once, Integration::converged),
               found = forces(law, parameters, thrice, Integration::converged);
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i], expected[i / 3]) << describe(law, parameters);
    expect_defined(law, record_of(thrice, 0.01, 0.67, 45.0), parameters, Integration::paper);
  }
}

// Sampling --------------------------------------------------------------------------------------------------------

// The samples at every rate from 10 Hz on include the extremes of this sine, so the path between the extremes is the
// same at every rate. Laws that depend on the path alone must give the same force to rounding, abe and bwbn within
// their integration errors. Of the laws that use the velocity, only hwang-wu interpolates it between samples, so its
// error falls as the rate grows. The others take it at the sample alone and must also agree to rounding.
TEST_P(Faults, TheSamplingRateDoesNotMatterFrom10To10000Hz) {
  constexpr double slowest_Hz = 10.0;
  std::vector<double> largest(3, 0.0);
  for (std::uint32_t index = 0; index < 40; ++index) {
    auto const parameters = candidate_in(box, index);
    auto const at_common_instants = [&](int ratio) {
      auto const all = forces(law, parameters, sine(208.0, 0.5, 3, 20 * ratio), Integration::converged);
      EXPECT_TRUE(all_finite(all)) << describe(law, parameters);
      Numbers kept;
      for (std::size_t i = 0; i < all.size(); i += static_cast<std::size_t>(ratio)) kept.push_back(all[i]);
      return kept;
    };
    auto const reference = at_common_instants(1000);
    std::size_t k = 0;
    for (int const ratio : {1, 10, 100}) {
      double const error = largest_difference(at_common_instants(ratio), reference) / largest_magnitude(reference);
      largest[k] = std::max(largest[k], error);
      ++k;
      EXPECT_LE(error, error_of_the_rate(GetParam(), slowest_Hz * ratio)) << ratio << ": " << describe(law, parameters);
    }
  }
  fmt::print("{:10} against 10000 Hz, of the peak force: 10 Hz {:.1e}, 100 Hz {:.1e}, 1000 Hz {:.1e}\n", GetParam(),
             largest[0], largest[1], largest[2]);
}

// A path with steps of 1 to 1000 yield displacements is compared with the same path after each step is divided into a
// thousand.
TEST_P(Faults, StepsOfAThousandYieldDisplacements) {
  if (!rate_independent()) GTEST_SKIP() << "not a function of the path alone";
  for (double const yields : {1.0, 10.0, 100.0, 1000.0}) {
    double largest = 0.0;
    for (std::uint32_t index = 0; index < 40; ++index) {
      auto const p = candidate_in(box, index);
      double const s = yields * yield_mm(law, p);
      auto const motion = polyline(Numbers{0.0, s, 0.3 * s, s, -s, 0.0, -0.2 * s, s}, 1);
      auto const one = forces(law, p, motion, Integration::converged),
                 many = forces(law, p, motion, Integration::converged, 1000);
      if (!all_finite(many)) continue;  // vaiana's exponentials overflow at displacements of metres
      ASSERT_TRUE(all_finite(one)) << describe(law, p);
      largest = std::max(largest, largest_difference(one, many) / largest_magnitude(many));
    }
    fmt::print("{:10} steps of {:4} yield displacements: {:.1e} of the peak force\n", GetParam(), yields, largest);
    EXPECT_LE(largest, error_of_steps(GetParam(), yields)) << yields;
  }
}

// Very long records -----------------------------------------------------------------------------------------------

// The motion has 500 equal cycles, or 5000 if ISOLAW_DRAWS is 100,000 or more. The last loop must equal the tenth
// within rounding. The second loop still depends on the first loading of the device, so it may differ more from the
// last one. The largest such difference, in abe, was 6e-7 of the peak force.
TEST_P(Faults, AMillionSamplesDoNotDrift) {
  constexpr std::size_t per_cycle = 200;
  std::size_t const cycles = draws(2000) >= 100000 ? 5000 : 500;
  auto const cycle = sine(208.0, 0.5, 1, static_cast<int>(per_cycle));
  Motion motion;
  for (std::size_t i = 0; i <= cycles * per_cycle; ++i) {
    motion.disp_mm.push_back(cycle.disp_mm[i % per_cycle]);
    motion.velocity_mm_s.push_back(cycle.velocity_mm_s[i % per_cycle]);
  }
  auto const began = std::chrono::steady_clock::now();
  auto const force = forces(law, middle(), motion, Integration::converged);
  double const time_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  EXPECT_TRUE(all_finite(force));
  std::size_t const last = force.size() - 1 - per_cycle;
  double since_second = 0.0, since_tenth = 0.0, peak = 0.0;
  for (std::size_t i = 0; i <= per_cycle; ++i) {
    double const now = force[last + i];
    since_second = std::max(since_second, std::abs(now - force[per_cycle + i]));
    since_tenth = std::max(since_tenth, std::abs(now - force[9 * per_cycle + i]));
    peak = std::max(peak, std::abs(now));
  }
  fmt::print(
      "{:10} {} samples: {:.0f} ns each; last cycle less the second {:.1e}, the tenth {:.1e} of the peak force\n",
      GetParam(), force.size(), 1e9 * time_s / static_cast<double>(force.size()), since_second / peak,
      since_tenth / peak);
  if (!changes_over_cycles(GetParam())) {
    constexpr auto hint =
        "if its loops change over equal cycles, name the law in changes_over_cycles (single_laws.hpp)";
    EXPECT_LE(since_second, 5e-6 * peak) << hint;
    EXPECT_LE(since_tenth, 1e-12 * peak) << hint;
  }
}

// Records for which no objective can be computed ----------------------------------------------------------------------

TEST_P(Faults, AnEmptyRecordIsRefused) {
  data::FitRecord empty;
  EXPECT_THROW(fit::LawOnRecord(law, empty, Integration::converged), Error);
  EXPECT_THROW(fit::scales_of(empty, law.info), Error);
  laws::Path const path = laws::make_path({}, {});
  EXPECT_EQ(path.samples(), 0u);
  law.evaluate(middle(), path, Integration::converged, {});
}

// The objective of Eq. (27) divides by the standard deviation of the force and by the duration. A record for which
// either is zero is refused.
TEST_P(Faults, ARecordThatNothingCanBeJudgedByIsRefused) {
  auto const refused = [&](data::FitRecord const& record) {
    try {
      fit::LawOnRecord const model(law, record, Integration::converged);
    } catch (Error const&) {
      return true;
    }
    return false;
  };
  auto const good = published_record();
  EXPECT_FALSE(refused(good));
  // 0.1 has no exact binary form, so the computed mean of a constant force of 0.1 is not exactly 0.1, and the computed
  // standard deviation is not exactly 0.
  for (double const constant : {0.0, 0.1, -140.0, 1e-300, 1e300, infinity, nan}) {
    auto record = good;
    record.force_kN.assign(record.size(), constant);
    EXPECT_TRUE(refused(record)) << "constant force " << constant;
  }
  for (double const size : {1e-200, 1e200}) {  // the squares of such forces are 0 or infinite
    auto record = good;
    for (double& force : record.force_kN) force *= size;
    EXPECT_TRUE(refused(record)) << "force times " << size;
  }
  auto record = good;
  record.time_s.assign(record.size(), 3.0);
  EXPECT_TRUE(refused(record)) << "no duration";
  record = good;
  for (auto* channel : {&record.time_s, &record.disp_mm, &record.vel_mm_s, &record.force_kN}) channel->resize(1);
  EXPECT_TRUE(refused(record)) << "one sample";
}

TEST_P(Faults, AConstantDisplacementIsFlaggedOrHasAForce) {
  for (double const x_mm : {0.0, 35.0}) {
    auto record = published_record();
    record.disp_mm.assign(record.size(), x_mm);
    record.vel_mm_s.assign(record.size(), 0.0);
    auto const scaled_box = fit::make_box(law, fit::BoxKind::scaled, fit::scales_of(record, law.info), {});
    for (std::uint32_t index = 0; index < 50; ++index)
      for (auto const integration : both) {
        expect_defined(law, record, candidate_in(box, index), integration);
        expect_defined(law, record, candidate_in(scaled_box, index), integration);
      }
  }
}

TEST(FaultsOfCleaning, AnEmptyRecordIsRefused) {
  for (bool const center : {false, true})
    EXPECT_THROW(data::clean({}, {.smooth = 5, .samples_per_cycle = 200, .center = center}), Error);
}

TEST(FaultsOfCleaning, ShortAndConstantRecordsKeepTheirSamples) {
  for (std::size_t const size : {1u, 2u, 3u, 50u})
    for (double const x_mm : {0.0, 12.0, 1e-310}) {
      data::TestRecord raw;
      for (std::size_t i = 0; i < size; ++i) {
        raw.time_s.push_back(0.1 * static_cast<double>(i));
        raw.disp_mm.push_back(x_mm);
        raw.force_kN.push_back(1.0);
      }
      auto const record = data::clean(raw, {.smooth = 5, .samples_per_cycle = 200, .center = true});
      ASSERT_EQ(record.size(), size);
      for (std::size_t i = 0; i < size; ++i) {
        EXPECT_NEAR(record.disp_mm[i], 0.0, 1e-12);
        EXPECT_NEAR(record.vel_mm_s[i], 0.0, 1e-10);
      }
    }
}

}  // namespace
}  // namespace isolaw::law_tests
