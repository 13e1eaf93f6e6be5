// isolaw decides which parameters a record determines. The right answer is known in four cases: a redundant parameter,
// a parameter without effect, a true value outside the box, and a record that determines everything.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "isolaw/analysis/determination.hpp"
#include "isolaw/opt/multistart.hpp"
#include "twins.hpp"

namespace isolaw::analysis {
namespace {

using Names = std::set<std::string>;

std::vector<fit::Override> overrides(std::vector<std::string> const& texts) {
  std::vector<fit::Override> parsed;
  for (auto const& text : texts) parsed.push_back(fit::parse_override(text));
  return parsed;
}

fit::LawOnRecord model_of(twins::Twin const& twin) {
  return {*twin.law, twin.record, laws::Integration::converged};
}

Determination judged(twins::Twin const& twin) {
  return *determine(model_of(twin), twin.box, twin.truth);
}

Verdict verdict_of(Determination const& judged, twins::Twin const& twin, std::string const& name) {
  auto const index = twin.law->index_of(name);
  return std::ranges::find(judged.parameters, index, &ParameterDetermination::parameter)->verdict;
}

Names names_of(TradeOff const& trade_off, twins::Twin const& twin) {
  Names names;
  for (auto const i : trade_off.parameters) names.insert(twin.box.parameters[i].name);
  return names;
}

std::vector<std::string> sentences(Determination const& judged) {
  std::vector<std::string> texts;
  for (auto const& t : judged.trade_offs) texts.push_back(t.sentence);
  return texts;
}

void expect_all_determined(Determination const& judged, twins::Twin const& twin) {
  for (auto const& p : judged.parameters)
    EXPECT_EQ(name(p.verdict), name(Verdict::determined)) << twin.box.parameters[p.parameter].name;
  EXPECT_EQ(sentences(judged), std::vector<std::string>{});
  EXPECT_EQ(judged.singular_values.size(), judged.parameters.size());
}

TEST(Identifiability, ARecordOfABilinearDeviceDeterminesAll) {
  auto const twin = twins::twin_in_box("bilinear", twins::growing_cycles(3, 100));
  auto const found = judged(twin);
  ASSERT_EQ(found.parameters.size(), 3u);
  expect_all_determined(found, twin);
  EXPECT_LT(found.objective, 1e-12);
  for (auto const& p : found.parameters) {
    double const truth = twin.truth[p.parameter];
    EXPECT_LT(p.lower, truth);
    EXPECT_GT(p.upper, truth);
    EXPECT_FALSE(p.open_below || p.open_above);
    ASSERT_EQ(p.profile.value.size(), p.profile.objective.size());
    EXPECT_TRUE(std::ranges::is_sorted(p.profile.value));
    auto const least = std::ranges::min_element(p.profile.objective) - p.profile.objective.begin();
    EXPECT_DOUBLE_EQ(p.profile.value[static_cast<std::size_t>(least)], truth);
    EXPECT_GT(std::min(p.profile.objective.front(), p.profile.objective.back()), found.rise);
  }
}

// The unit of bouc-wen's z is arbitrary. A change of the unit rescales A, alpha and Ke, and unless n = 1 also beta and
// gamma, while the force stays the same.
TEST(Identifiability, AOfBoucWenIsRedundant) {
  for (bool const n_is_one : {false, true}) {
    auto const set = n_is_one ? std::vector<std::string>{"bouc-wen.n=1"} : std::vector<std::string>{};
    auto const twin = twins::twin_in_box("bouc-wen", twins::growing_cycles(3, 100), overrides(set));
    auto const found = judged(twin);
    Names const redundant = n_is_one ? Names{"alpha", "Ke", "A"} : Names{"alpha", "Ke", "A", "beta", "gamma"};
    ASSERT_EQ(found.trade_offs.size(), 1u);
    EXPECT_EQ(names_of(found.trade_offs.front(), twin), redundant);
    for (auto const& parameter : redundant)
      EXPECT_NE(found.trade_offs.front().sentence.find(parameter), std::string::npos)
          << parameter << ": " << found.trade_offs.front().sentence;
    for (auto const& p : found.parameters) {
      auto const& parameter = twin.box.parameters[p.parameter].name;
      EXPECT_EQ(p.verdict == Verdict::determined, !redundant.contains(parameter)) << parameter;
    }
  }
}

TEST(Identifiability, WithAFixedBoucWenIsDetermined) {
  for (auto const& set : {std::vector<std::string>{"bouc-wen.A=1"}, {"bouc-wen.A=1", "bouc-wen.n=1"}}) {
    auto const twin = twins::twin_in_box("bouc-wen", twins::growing_cycles(3, 100), overrides(set));
    expect_all_determined(judged(twin), twin);
  }
}

// jankowski's stiffness a4 / cosh^2(a5 v) acts only at small velocities v. In this test a5 is at least 4000 s/m and the
// device moves faster than 4 mm/s at every sample, so a5 |v| is above 16 and the stiffness vanishes: neither a4 nor a5
// has an effect.
TEST(Identifiability, WhatDoesNotActIsSaidOnceAndLeavesTheOthersAlone) {
  auto const motion = twins::growing_cycles(3, 98);
  ASSERT_GT(std::abs(*std::ranges::min_element(motion.vel_mm_s, {}, [](double v) { return std::abs(v); })), 4.0);
  auto const twin = twins::twin_in_box("jankowski", motion, overrides({"jankowski.a5=4e3:1e4"}));
  auto const found = judged(twin);
  auto said = sentences(found);
  std::ranges::sort(said);
  EXPECT_EQ(said, (std::vector<std::string>{"a4 does not act on this record", "a5 does not act on this record"}));
  for (auto const* idle : {"a4", "a5"}) EXPECT_EQ(verdict_of(found, twin, idle), Verdict::undetermined) << idle;
  EXPECT_EQ(found.singular_values.size(), 9u);
  for (auto const* active : {"a1", "a6", "a7", "a8", "a9"})
    EXPECT_EQ(verdict_of(found, twin, active), Verdict::determined) << active;
}

// With 100 samples a cycle one sample at each reversal has no velocity. There the stiffness is a4 for any a5, so a4 has
// an effect and a5 has none.
TEST(Identifiability, AParameterThatActsIsNotNamedWithOneThatDoesNot) {
  auto const twin = twins::twin_in_box("jankowski", twins::growing_cycles(3, 100), overrides({"jankowski.a5=4e3:1e4"}));
  auto const found = judged(twin);
  EXPECT_EQ(sentences(found), std::vector<std::string>{"a5 does not act on this record"});
  EXPECT_EQ(verdict_of(found, twin, "a5"), Verdict::undetermined);
  EXPECT_EQ(verdict_of(found, twin, "a4"), Verdict::determined);
}

TEST(Identifiability, ATruthOutsideTheBoxEndsAtItsBound) {
  auto twin = twins::twin_in_box("bilinear", twins::growing_cycles(3, 100));
  auto& K2 = twin.box.parameters[twin.law->index_of("K2")];
  K2.lower = 1.2 * twin.truth[twin.law->index_of("K2")];
  auto const model = model_of(twin);
  std::vector<double> optimum(twin.truth.size());
  twin.box.expand(opt::descend(fit::IdentificationProblem(model, twin.box), twin.box.contract(twin.truth), 1.0).best,
                  optimum);
  auto const found = *determine(model, twin.box, optimum);
  EXPECT_EQ(verdict_of(found, twin, "K2"), Verdict::at_bound);
  EXPECT_DOUBLE_EQ(found.optimum[twin.law->index_of("K2")], K2.lower);
  EXPECT_EQ(verdict_of(found, twin, "K1"), Verdict::determined);
  EXPECT_EQ(verdict_of(found, twin, "xy"), Verdict::determined);
  EXPECT_EQ(found.singular_values.size(), 2u);  // only K1 and xy have singular values, because K2 is at its bound
  auto const& p = found.parameters[1];
  EXPECT_TRUE(p.open_below);
  EXPECT_FALSE(p.open_above);
  EXPECT_GE(p.lower, K2.lower);
}

// Returns the root mean square over time of the difference of two forces, divided by the standard deviation of the
// measured force.
double force_change(fit::LawOnRecord const& model, std::vector<double> const& from, std::vector<double> const& to) {
  std::vector<double> residuals(2 * model.samples());
  model.residuals(
      2, [&](std::size_t i, std::span<double> values) { std::ranges::copy(i == 0 ? from : to, values.begin()); },
      residuals);
  double sum = 0.0;
  for (std::size_t j = 0; j < model.samples(); ++j)
    sum += model.residual_weights()[j] * std::pow(residuals[model.samples() + j] - residuals[j], 2);
  return std::sqrt(sum);
}

// A sentence on a trade-off says by how many percent its parameters may change together, and how little the force then
// changes. If the parameters change together like this, the force must change by little more than the sentence says,
// even if some parameters are negative. The sentence leaves out parameters that take little part in the trade-off.
// Their absence may add a tenth of the change that the first parameter causes alone.
TEST(Identifiability, ATradeOffHoldsForParametersOfEitherSign) {
  struct Case {
    std::string law;
    std::vector<std::string> set;
    double noise;
  };
  std::size_t of_opposite_sign = 0, laws_with_one = 0;
  for (auto const& c : {Case{"abe-y0", {}, 0.0}, Case{"bouc-wen", {}, 0.0}, Case{"vaiana", {}, 0.0},
                        Case{"jankowski", {"jankowski.a3=-9e7:-1e6"}, 0.1},
                        Case{"vaiana", {"vaiana.beta1+=-100:-10", "vaiana.beta2+=20:50"}, 0.0}, Case{"abe", {}, 0.01},
                        Case{"hwang-wu", {}, 0.05}}) {
    SCOPED_TRACE(c.law);
    auto twin = twins::twin_in_box(c.law, twins::growing_cycles(3, 100), overrides(c.set));
    if (c.noise > 0.0) {
      num::Draws draws(num::Stream(stable_hash(c.law)), 1, 0);
      twin.record = twins::with_noise(twin.record, {.share = c.noise}, draws);
    }
    auto const model = model_of(twin);
    auto const found = *determine(model, twin.box, twin.truth);
    laws_with_one += found.trade_offs.empty() ? 0u : 1u;
    for (auto const& t : found.trade_offs) {
      constexpr double small = 1e-4;
      auto changed = found.optimum, alone = found.optimum;
      for (std::size_t i = 0; i < t.parameters.size(); ++i) {
        changed[t.parameters[i]] *= 1.0 + small * t.change[i];
        if (t.change[i] == 1.0) alone[t.parameters[i]] *= 1.0 + small;
        of_opposite_sign += found.optimum[t.parameters[i]] * found.optimum[t.parameters[0]] < 0.0 ? 1u : 0u;
      }
      double const together = force_change(model, found.optimum, changed) / small,
                   by_one = force_change(model, found.optimum, alone) / small;
      EXPECT_LT(together, 1.01 * t.force_change + 0.1 * by_one) << t.sentence;
      if (t.parameters.size() == 1) {
        EXPECT_NEAR(by_one, t.force_change, 0.01 * by_one) << t.sentence;
      }
    }
  }
  EXPECT_GT(of_opposite_sign, 0u);
  EXPECT_GE(laws_with_one, 4u);
}

}  // namespace
}  // namespace isolaw::analysis
