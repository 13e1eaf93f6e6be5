// Tests the objective of Eq. (27) of the paper: compares it with values worked out by hand, and checks which
// combinations of law and record are refused. Further tests cover the outline, a selection of the samples that is
// faster to evaluate.
#include "isolaw/fit/objective.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"
#include "not_finite.hpp"

namespace isolaw::fit {
namespace {

using Values = std::vector<double>;

double objective_of(LawOnRecord const& model, Values const& parameters) {
  Values work;
  return model.objective(parameters, work);
}

// Returns a record with uneven intervals of time and without noise.
data::FitRecord uneven() {
  return {.time_s = {0.0, 1.0, 3.0, 3.5},
          .disp_mm = {0.0, 1.0, -1.0, 2.0},
          .vel_mm_s = {1.0, -0.5, 2.0, 6.0},
          .force_kN = {0.0, 2.0, -1.0, 3.0},
          .scored = {},
          .cleaning = {}};
}

// Returns three cycles of ±100 mm at 0.5 Hz with an elliptic loop of force.
data::FitRecord sine(int samples_per_cycle = 60) {
  data::FitRecord record;
  for (int i = 0; i <= 3 * samples_per_cycle; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / samples_per_cycle;
    record.time_s.push_back(2.0 * i / samples_per_cycle);
    record.disp_mm.push_back(100.0 * std::sin(phase));
    record.vel_mm_s.push_back(100.0 * std::numbers::pi * std::cos(phase));
    record.force_kN.push_back(80.0 * std::sin(phase) + 20.0 * std::cos(phase));
  }
  return record;
}

// Returns parameters of a law. For the laws of the paper, their force on sine() is finite and about as large as the
// record's. For other laws, they are the middle of the search box.
Values plausible(laws::LawEntry const& law) {
  if (law.info.id == "bilinear") return {1.5, 0.5, 30.0};
  if (law.info.id == "jankowski") return {3e5, 4e6, 5e6, 4e4, 5e3, 1.2e6, 4.0, 15.0, 5e4, 7e4, 0.4};
  if (law.info.id == "vaiana") return {4e5, 4.2e5, 4e4, 4.4e4, 45.0, 48.0, 0.4, -0.5, 24.0, -40.0, 0, 0, 0, 0, 0, 0};
  if (law.info.id == "bouc-wen") return {0.15, 3.0, 1.2, 0.05, 1.1, 0.04};
  if (law.info.id == "abe") return {7.0, 3.0, 0.03, 0.7, 7.0, 0.3, 40.0, 115.0, 1.7, 2.6, 40.0, 0.2, 0.1};
  if (law.info.id == "abe-y0") return {7.0, 3.0, 0.03, 0.7, 7.0, 0.3, 50.0, 115.0, 2.6, 40.0, 0.2, 0.1};
  if (law.info.id == "hwang-wu") return {4600, -0.8, 0.01, 55, 0.47, 6e4, 6.0, 55, -2.5e-6, -2e-6};
  auto const box = make_box(law, BoxKind::scaled, scales_of(sine(), law.info), {});
  Values values(law.parameters.size());
  box.expand(Values(box.free_count(), 0.5), values);
  return values;
}

TEST(Objective, IsEquation27WorkedOutByHand) {
  // With K1 = K2 = 1 kN/mm the law's force is F = x, so it differs from the measured force by 0, 1, 0 and 1 kN. The
  // trapezoids add up to 0.5 * 1 s + 0.5 * 2 s + 0.5 * 0.5 s = 1.75 kN s, which is 0.5 kN over 3.5 s. The measured
  // forces 0, 2, -1, 3 kN have the mean 1, squared deviations 1 + 1 + 4 + 4 = 10 and the population variance 2.5.
  LawOnRecord const model(laws::find_law("bilinear"), uneven(), laws::Integration::converged);
  EXPECT_NEAR(objective_of(model, {1.0, 1.0, 5.0}), 0.5 / std::sqrt(2.5), 1e-15);
  EXPECT_NEAR(objective_of(model, {1.0, 1.0, 5.0}), 0.31622776601683794, 1e-15);
}

TEST(Objective, WeighsByTheTrueTimeStamps) {
  // Computed and measured force still differ by 0, 1, 0 and 1 kN, but the middle interval is longer.
  auto record = uneven();
  record.time_s = {0.0, 0.1, 3.4, 3.5};
  LawOnRecord const model(laws::find_law("bilinear"), record, laws::Integration::converged);
  double const integral = 0.5 * (0.1 + 3.3 + 0.1);
  EXPECT_NEAR(objective_of(model, {1.0, 1.0, 5.0}), integral / 3.5 / std::sqrt(2.5), 1e-15);
}

// --- only a part of the record is scored, which means that it counts in the objective ---

TEST(Objective, OfThePartThatIsScoredWorkedOutByHand) {
  // One interval of 2 s is scored. The force of the law, F = x, misses the measured forces at the two ends of this
  // interval by 1 and 0 kN, so the integral is 1 kN s. The measured forces 2 and -1 kN have the standard deviation 1.5.
  auto record = uneven();
  record.scored = {0.0, 1.0, 1.0, 0.0};
  LawOnRecord const model(laws::find_law("bilinear"), record, laws::Integration::converged);
  EXPECT_NEAR(objective_of(model, {1.0, 1.0, 5.0}), 0.5 / 1.5, 1e-15);
  // Two intervals are scored and the time between them does not count: 0.5 kN s + 0.25 kN s over 1.5 s.
  record.scored = {1.0, 1.0, 0.0, 0.0};
  record.time_s.insert(record.time_s.end(), {4.0, 4.5});
  record.disp_mm.insert(record.disp_mm.end(), {1.0, 0.0});
  record.vel_mm_s.insert(record.vel_mm_s.end(), {-1.0, -1.0});
  record.force_kN.insert(record.force_kN.end(), {2.0, 0.0});
  record.scored.insert(record.scored.end(), {1.0, 1.0});
  LawOnRecord const two(laws::find_law("bilinear"), record, laws::Integration::converged);
  // The scored forces 0, 2, 2, 0 have the standard deviation 1.
  EXPECT_NEAR(objective_of(two, {1.0, 1.0, 5.0}), 0.75 / 1.5, 1e-15);
}

TEST(Objective, AllScoredIsAsGoodAsNoneSaid) {
  auto record = sine();
  for (auto const& law : laws::catalogue()) {
    record.scored.clear();
    double const plain = objective_of(LawOnRecord(law, record, laws::Integration::converged), plausible(law));
    record.scored.assign(record.size(), 1.0);
    double const all = objective_of(LawOnRecord(law, record, laws::Integration::converged), plausible(law));
    EXPECT_NEAR(all, plain, 1e-12 * plain) << law.info.id;
  }
}

// Only the last cycle is scored. Earlier forces do not count, but earlier displacements change the state of the law.
TEST(Objective, TheHistoryBeforeActsButIsNotScored) {
  for (auto const& law : laws::catalogue()) {
    auto record = sine();
    record.scored.assign(record.size(), 0.0);
    for (std::size_t i = 120; i < record.size(); ++i) record.scored[i] = 1.0;
    auto const of = [&] {
      return objective_of(LawOnRecord(law, record, laws::Integration::converged), plausible(law));
    };
    double const before = of();
    for (std::size_t i = 0; i < 120; ++i) record.force_kN[i] += 1000.0;
    EXPECT_EQ(of(), before) << law.info.id;
    record.force_kN[150] += 10.0;
    EXPECT_NE(of(), before) << law.info.id;
  }
  // The law abe remembers the largest displacement so far, so a larger one before the scored part changes the
  // objective.
  auto record = sine();
  record.scored.assign(record.size(), 0.0);
  for (std::size_t i = 120; i < record.size(); ++i) record.scored[i] = 1.0;
  auto const& abe = laws::find_law("abe");
  double const before = objective_of(LawOnRecord(abe, record, laws::Integration::converged), plausible(abe));
  record.disp_mm[15] = 140.0;
  EXPECT_NE(objective_of(LawOnRecord(abe, record, laws::Integration::converged), plausible(abe)), before);
}

TEST(Objective, BlocksOfCandidatesScoreTheSamePart) {
  auto record = sine();
  record.scored.assign(record.size(), 0.0);
  for (std::size_t i = 60; i < 130; ++i) record.scored[i] = 1.0;
  for (auto const& law : laws::catalogue()) {
    LawOnRecord const model(law, record, laws::Integration::converged);
    double const scalar = objective_of(model, plausible(law));
    for (auto const set : available_instruction_sets()) {
      Values blocks(40);
      model.objectives(
          blocks.size(), [&](std::size_t, std::span<double> p) { std::ranges::copy(plausible(law), p.begin()); },
          blocks, set);
      for (double const value : blocks) EXPECT_NEAR(value, scalar, block_tolerance * scalar) << law.info.id;
    }
  }
}

TEST(Objective, APartThatSaysNothingIsRefused) {
  auto record = sine();
  record.scored.assign(record.size(), 0.0);
  // Every second sample is scored, so no interval is scored at both ends.
  for (std::size_t i = 0; i < record.size(); i += 2) record.scored[i] = 1.0;
  EXPECT_THROW(LawOnRecord(laws::find_law("bilinear"), record, laws::Integration::converged), Error);
}

TEST(Objective, SamplesThatAllCountForNothingAreRefused) {
  auto record = sine();
  record.weights.assign(record.size(), 1.0);
  record.scored.assign(record.size(), 0.0);
  // The samples that are scored have no weight, and those with a weight are not scored.
  for (std::size_t i = 0; i < 60; ++i) {
    record.scored[i] = 1.0;
    record.weights[i] = 0.0;
  }
  try {
    LawOnRecord const model(laws::find_law("bilinear"), record, laws::Integration::converged);
    FAIL() << "not refused";
  } catch (Error const& error) {
    EXPECT_NE(std::string(error.what()).find("no sample that counts in the objective"), std::string::npos)
        << error.what();
  }
}

TEST(Objective, TimeMayStartAnywhere) {
  auto record = uneven();
  LawOnRecord const model(laws::find_law("bilinear"), record, laws::Integration::converged);
  for (double& t : record.time_s) t += 1000.0;
  LawOnRecord const later(laws::find_law("bilinear"), record, laws::Integration::converged);
  EXPECT_NEAR(objective_of(later, {1.0, 1.0, 5.0}), objective_of(model, {1.0, 1.0, 5.0}), 1e-12);
}

TEST(Objective, AnOffsetOfTheForceIsSeenInTheDifferenceAndNotInTheSpread) {
  auto record = uneven();
  for (double& f : record.force_kN) f += 10.0;
  LawOnRecord const model(laws::find_law("bilinear"), record, laws::Integration::converged);
  // Computed and measured force differ by 10, 11, 10 and 11 kN, with a mean over time of 10.5 kN.
  EXPECT_NEAR(objective_of(model, {1.0, 1.0, 5.0}), 10.5 / std::sqrt(2.5), 1e-14);
}

TEST(Objective, OfTheRecordTheLawItselfMadeIsZero) {
  for (auto const& law : laws::catalogue()) {
    auto record = sine();
    Values const parameters = plausible(law);
    for (auto const how : {laws::Integration::converged, laws::Integration::paper}) {
      record.force_kN = LawOnRecord(law, sine(), how).force_kN(parameters);
      LawOnRecord const model(law, record, how);
      EXPECT_LT(objective_of(model, parameters), 1e-14) << law.info.id;
      auto other = parameters;
      other[0] *= 1.1;
      EXPECT_GT(objective_of(model, other), 1e-4) << law.info.id;
    }
  }
}

TEST(Objective, DoesNotDependOnWhatTheScratchHeldBefore) {
  auto const& law = laws::find_law("abe");
  LawOnRecord const model(law, sine(), laws::Integration::converged);
  Values work(3, std::nan(""));
  double const first = model.objective(plausible(law), work);
  work.assign(5000, infinity);
  EXPECT_EQ(model.objective(plausible(law), work), first);
}

TEST(Objective, IsInfiniteWhereAForceIsNotFinite) {
  auto const objective = [](char const* id, Values const& parameters, laws::Integration how) {
    return objective_of(LawOnRecord(laws::find_law(id), sine(), how), parameters);
  };
  using enum laws::Integration;
  EXPECT_EQ(objective("vaiana", {4e5, 4e5, 4e4, 4e4, 45, 48, 0.4, -0.5, 1e5, -40.0, 0, 0, 0, 0, 0, 0}, converged),
            infinity);
  // With these parameters the hysteretic force does not saturate but grows without bound.
  EXPECT_EQ(objective("bouc-wen", {0.15, 3.0, 1.2, -0.05, 1.1, -0.04}, converged), infinity);
  EXPECT_EQ(objective("bouc-wen", {0.15, 3.0, 1.2, 500.0, 1.9, 500.0}, paper), infinity);  // Runge-Kutta is unstable
  EXPECT_EQ(objective("bilinear", {1.5, infinity, 30.0}, converged), infinity);
  EXPECT_EQ(objective("bilinear", {1.5, std::nan(""), 30.0}, converged), infinity);
}

// Three laws with different units (kN and mm, N and m, N and cm) are reduced to one elastic spring of 0.9 kN/mm. Their
// objectives must be equal.
TEST(Objective, DoesNotDependOnTheUnitsOfTheLaw) {
  auto const record = sine();
  auto const of = [&](char const* id, Values const& parameters) {
    return objective_of(LawOnRecord(laws::find_law(id), record, laws::Integration::converged), parameters);
  };
  double const expected = of("bilinear", {0.9, 0.9, 10.0});
  EXPECT_GT(expected, 0.1);
  EXPECT_NEAR(of("jankowski", {0.9e6, 0, 0, 0, 1, 0, 1, 1, 0, 0, 1}), expected, 1e-13);
  EXPECT_NEAR(of("hwang-wu", {0.9e4, 0, 0, 0, 1, 0, 0, 1, -1e-9, -1e-9}), expected, 1e-13);
}

TEST(Objective, DoesNotDependOnTheScaleOfForceAndTime) {
  auto record = sine();
  auto const& law = laws::find_law("bilinear");
  double const expected = objective_of(LawOnRecord(law, record, laws::Integration::converged), {1.5, 0.5, 30.0});
  for (double& f : record.force_kN) f *= 7.0;
  for (double& t : record.time_s) t *= 3.0;
  for (double& v : record.vel_mm_s) v /= 3.0;
  EXPECT_NEAR(objective_of(LawOnRecord(law, record, laws::Integration::converged), {10.5, 3.5, 30.0}), expected, 1e-13);
}

TEST(Force, IsTheLawsFormulaInKilonewton) {
  // Jankowski's force at 0.1 m and 0.5 m/s, computed by hand.
  data::FitRecord record{
      .time_s = {0.0, 0.1}, .disp_mm = {0.0, 100.0}, .vel_mm_s = {0.0, 500.0}, .force_kN = {0.0, 1.0}, .cleaning = {}};
  LawOnRecord const model(laws::find_law("jankowski"), record, laws::Integration::converged);
  double const x = 0.1, v = 0.5;
  double const K = 3e5 + 4e6 * x * x + 5e6 * x * x * x * x + 4e4 / std::pow(std::cosh(2.0 * v), 2) +
                   1.2e6 / (std::cosh(4.0 * v) * std::cosh(15.0 * x));
  double const C = (5e4 + 7e4 * x * x) / std::sqrt(0.16 + v * v);
  auto const force = model.force_kN(Values{3e5, 4e6, 5e6, 4e4, 2.0, 1.2e6, 4.0, 15.0, 5e4, 7e4, 0.4});
  ASSERT_EQ(force.size(), 2u);
  EXPECT_NEAR(force[1], (K * x + C * v) / 1000.0, 1e-10);
  EXPECT_EQ(force[0], 0.0);

  // Hwang-Wu's force at 10 cm and 50 cm/s without degradation (a9 = a10 = 0):
  // (a1 + a2 x^2 + a3 x^4 + a4 / cosh^2(a5 v)) x + 2 (a6 + a7 x^2) v / sqrt(a8^2 + v^2).
  LawOnRecord const other(laws::find_law("hwang-wu"), record, laws::Integration::converged);
  double const expected = (4000.0 - 1.0 * 100.0 + 0.01 * 1e4 + 60.0 / std::pow(std::cosh(0.02 * 50.0), 2)) * 10.0 +
                          2.0 * (5e4 + 6.0 * 100.0) * 50.0 / std::sqrt(60.0 * 60.0 + 2500.0);
  EXPECT_NEAR(other.force_kN(Values{4000, -1, 0.01, 60, 0.02, 5e4, 6, 60, -0.0, -0.0})[1], expected / 1000.0, 1e-10);
}

TEST(RecordWithoutTime, RefusesTheLawsThatNeedVelocity) {
  auto record = sine();
  record.vel_mm_s.clear();
  for (std::size_t i = 0; i < record.size(); ++i) record.time_s[i] = static_cast<double>(i);
  for (auto const* id : {"jankowski", "hwang-wu"}) {
    try {
      LawOnRecord const model(laws::find_law(id), record, laws::Integration::converged);
      FAIL() << id << " was accepted";
    } catch (Error const& error) {
      std::string const text = error.what();
      for (auto const* part : {id, "no time", "velocity", "--dt"})
        EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' is missing in: " << text;
    }
  }
}

TEST(RecordWithoutTime, GivesTheRateIndependentLawsTheObjectiveOfUniformSampling) {
  auto const with_time = sine();
  auto record = with_time;
  record.vel_mm_s.clear();
  for (std::size_t i = 0; i < record.size(); ++i) record.time_s[i] = static_cast<double>(i);
  for (auto const& law : laws::catalogue()) {
    if (!law.info.traits.rate_independent) continue;
    double const expected = objective_of(LawOnRecord(law, with_time, laws::Integration::converged), plausible(law));
    EXPECT_NEAR(objective_of(LawOnRecord(law, record, laws::Integration::converged), plausible(law)), expected, 1e-12)
        << law.info.id;
  }
}

TEST(Problem, EvaluatesTheExpandedPoints) {
  auto const record = sine();
  auto const& law = laws::find_law("vaiana");
  auto const box = make_box(law, BoxKind::scaled, scales_of(record, law.info), {});
  LawOnRecord const model(law, record, laws::Integration::converged);
  IdentificationProblem const problem(model, box);
  ASSERT_EQ(problem.dimension(), 10u);  // six of the sixteen parameters are fixed by default
  opt::Points points(10, 3);
  for (std::size_t i = 0; i < points.values.size(); ++i)
    points.values[i] = std::fmod(0.37 + 0.618 * static_cast<double>(i), 1.0);
  Values values(3, -1.0);
  problem.evaluate(points, values);
  for (std::size_t i = 0; i < 3; ++i) {
    Values parameters;
    for (std::size_t k = 0; k < 10; ++k) parameters.push_back(box.parameters[k].at(points[i][k]));
    parameters.resize(16, 0.0);
    double const expected = objective_of(model, parameters);
    EXPECT_NEAR(values[i], expected, block_tolerance * expected);
  }
}

TEST(Outline, HoldsEveryReversalAndItsSurroundingsAndAFractionOfTheRest) {
  auto const record = sine(400);
  LawOnMotion const motion(laws::find_law("vaiana"), record, laws::Integration::converged);
  auto const samples = motion.outline();
  EXPECT_LT(samples.size(), record.size() / 4);
  EXPECT_EQ(samples.front(), 0u);
  EXPECT_EQ(samples.back(), record.size() - 1);
  for (std::size_t k = 1; k < samples.size(); ++k) {
    EXPECT_LT(samples[k - 1], samples[k]);
    EXPECT_LE(samples[k], samples[k - 1] + 8) << "a wide gap at " << samples[k];
  }
  for (std::size_t reversal = 100; reversal < record.size(); reversal += 200)
    for (std::size_t i = reversal - 1; i <= reversal + 6; ++i)
      EXPECT_TRUE(std::ranges::binary_search(samples, i)) << "sample " << i << " near the reversal " << reversal;
}

TEST(Outline, HasTheForcesOfTheWholeWhereTheRateDoesNotAct) {
  auto const record = sine(200);
  for (auto const& law : laws::catalogue()) {
    if (!law.info.traits.rate_independent) continue;
    LawOnMotion const motion(law, record, laws::Integration::converged);
    auto const samples = motion.outline();
    auto const whole = motion.force_kN(plausible(law)), some = motion.at(samples).force_kN(plausible(law));
    ASSERT_EQ(some.size(), samples.size());
    double const peak = std::ranges::max(whole, {}, [](double f) { return std::abs(f); });
    for (std::size_t k = 0; k < samples.size(); ++k)
      // bwbn takes Runge-Kutta steps, which are longer with fewer samples. The other laws are exact or nearly so.
      EXPECT_NEAR(some[k], whole[samples[k]], (law.info.id == "bwbn" ? 1e-4 : 1e-5) * std::abs(peak))
          << law.info.id << ", sample " << samples[k];
  }
}

TEST(Outline, HasAboutTheObjectiveOfTheWhole) {
  auto record = sine(200);
  record.scored.assign(record.size(), 1.0);
  for (std::size_t i = 0; i < 150; ++i) record.scored[i] = 0.0;
  for (auto const& law : laws::catalogue()) {
    LawOnRecord const model(law, record, laws::Integration::converged);
    auto const outline = model.outline();
    ASSERT_TRUE(outline) << law.info.id;
    EXPECT_LT(outline->samples(), model.samples() / 3);
    double sum = 0.0;
    for (double const w : outline->residual_weights()) sum += w;
    EXPECT_NEAR(sum, 1.0, 1e-12);
    double const whole = objective_of(model, plausible(law));
    EXPECT_NEAR(objective_of(*outline, plausible(law)), whole, 0.02 * whole) << law.info.id;
  }
}

TEST(Outline, IsNotMadeWhereItSparesLittleOrWouldChangeTheIntegration) {
  EXPECT_FALSE(LawOnRecord(laws::find_law("bilinear"), sine(20), laws::Integration::converged).outline());
  auto const dense = sine(400);
  for (auto const& law : laws::catalogue())
    EXPECT_EQ(LawOnRecord(law, dense, laws::Integration::paper).outline().has_value(), !law.info.traits.path_integrated)
        << law.info.id;
}

TEST(Problem, HasAnOutlineOfTheSameParameters) {
  auto const& law = laws::find_law("vaiana");
  auto const dense = sine(400);
  auto const box = make_box(law, BoxKind::scaled, scales_of(dense, law.info), {});
  LawOnRecord const model(law, dense, laws::Integration::converged);
  IdentificationProblem const problem(model, box);
  auto const* outline = problem.outline();
  ASSERT_NE(outline, nullptr);
  EXPECT_EQ(outline->outline(), nullptr);
  EXPECT_EQ(outline->dimension(), problem.dimension());
  EXPECT_LT(outline->weights().size(), problem.weights().size() / 4);
  opt::Points const centre = [&] {
    opt::Points one(problem.dimension(), 1);
    std::ranges::fill(one.values, 0.5);
    return one;
  }();
  Values whole(1), some(1);
  problem.evaluate(centre, whole);
  outline->evaluate(centre, some);
  EXPECT_NEAR(some[0], whole[0], 0.02 * whole[0]);
}

TEST(IntegrationShift, IsZeroForLawsThatAreNotIntegrated) {
  for (auto const* id : {"bilinear", "jankowski", "vaiana"}) {
    auto const& law = laws::find_law(id);
    for (auto const how : {laws::Integration::converged, laws::Integration::paper})
      EXPECT_EQ(LawOnRecord(law, sine(), how).integration_shift(plausible(law)), 0.0) << id;
  }
}

}  // namespace
}  // namespace isolaw::fit
