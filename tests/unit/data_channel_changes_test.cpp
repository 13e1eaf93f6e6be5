// Tests the search for faults of a channel that leave a plausible loop: gains that change, zeros that jump, hum, delays
// that grow and frequencies that sweep. Further tests count how often such a fault is reported for sound records of
// devices and of all laws.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/data/checks.hpp"
#include "isolaw/data/clean.hpp"
#include "isolaw/data/properties/error_budget.hpp"
#include "isolaw/data/properties/remainder.hpp"
#include "isolaw/data/properties/skew.hpp"
#include "isolaw/data/signals/signal_faults.hpp"
#include "isolaw/fit/objective.hpp"
#include "isolaw/laws/catalogue.hpp"
#include "isolaw/wording/table.hpp"
#include "motions.hpp"
#include "signals.hpp"

namespace isolaw::data::testing {
namespace {

// A bilinear device of K2 = 0.5 kN/mm and Q = 30 kN, four cycles of 150 mm at 0.5 Hz, 200 samples a second, with a
// little noise. K_eff is 0.7 kN/mm.
struct Bearing {
  int cycles = 4;
  // The record begins `start` samples after the motion.
  double rate_Hz = 200.0, first_stiffness = 2.9, frequency_Hz = 0.5, start = 0.0;
  std::function<double(double)> late_s = [](double) { return 0.0; };  // delay of the force at time t
  double noise = 1.0;
};

Motion record_of(Bearing const& of) {
  constexpr double D = 150.0, K = 0.5, Q = 30.0;
  constexpr int finer = 40;
  auto const yield = Q / (of.first_stiffness - K);
  auto const samples = static_cast<int>(std::lround(of.cycles / of.frequency_Hz * of.rate_Hz));
  std::vector<double> fine;
  double z = 0.0, before = 0.0;
  auto const at = [&](int i) {
    return D * std::sin(2.0 * pi * of.frequency_Hz * (i / (finer * of.rate_Hz) + of.start / of.rate_Hz));
  };
  for (int i = -static_cast<int>(of.start * finer); i <= samples * finer; ++i) {
    double const x = at(i);
    z = std::clamp(z + (x - before) / yield, -1.0, 1.0);
    before = x;
    if (i >= 0) fine.push_back(K * x + Q * z);
  }
  Drawn random(7);
  Motion motion;
  motion.dt_s = 1.0 / of.rate_Hz;
  for (int i = 0; i <= samples; ++i) {
    motion.add(at(i * finer) + 0.01 * of.noise * random.normal());
    double const then = i * finer - of.late_s(motion.time_s.back()) * finer * of.rate_Hz;
    motion.force_kN.push_back(value_at(fine, std::max(0.0, then)) + 0.05 * of.noise * random.normal());
  }
  return motion;
}

Budget budget_of(Motion const& motion) {
  return error_budget(motion.view(), motion.properties());
}

Finding const* find(Budget const& budget, FindingKind kind) {
  auto const found = std::ranges::find(budget.warnings, kind, &Finding::kind);
  return found == budget.warnings.end() ? nullptr : &*found;
}

std::string all_of(Budget const& budget) {
  std::string text;
  for (auto const& warning : budget.warnings) text += "\n  " + wording::sentence(warning);
  return text;
}

constexpr std::array new_kinds{
    FindingKind::stiffness_rises,  FindingKind::lag_grows,        FindingKind::hum,       FindingKind::offset_steps,
    FindingKind::frequency_sweeps, FindingKind::gain_of_one_side, FindingKind::force_late};

TEST(ChannelChanges, a_sound_record_has_none) {
  auto const budget = budget_of(record_of({}));
  EXPECT_TRUE(budget.warnings.empty()) << all_of(budget);
}

TEST(ChannelChanges, a_gain_that_changes_is_said_with_cycle_time_and_ratio) {
  for (double const gain : {1.06, 1.15})
    for (double const from_s : {3.4, 4.0, 4.7, 5.3}) {
      auto motion = record_of({.cycles = 5});
      for (std::size_t i = 0; i < motion.time_s.size(); ++i)
        if (motion.time_s[i] > from_s) motion.force_kN[i] *= gain;
      auto const budget = budget_of(motion);
      auto const* found = find(budget, FindingKind::stiffness_rises);
      ASSERT_NE(found, nullptr) << gain << " from " << from_s << all_of(budget);
      EXPECT_NEAR(found->number("percent"), 100.0 * (gain - 1.0), 0.5);
      EXPECT_NEAR(found->number("time_s"), from_s, 0.1) << gain;
      EXPECT_EQ(find(budget, FindingKind::offset_steps), nullptr);
    }
  auto softening = record_of({});
  for (std::size_t i = 0; i < softening.time_s.size(); ++i)
    softening.force_kN[i] *= 1.0 + 0.3 * std::exp(-softening.time_s[i] / 3.0);
  EXPECT_EQ(find(budget_of(softening), FindingKind::stiffness_rises), nullptr);
}

TEST(ChannelChanges, a_gain_of_one_side_is_told_from_an_offset) {
  auto one_sided = record_of({}), moved = record_of({});
  for (double& F : one_sided.force_kN)
    if (F > 0.0) F *= 1.12;
  for (double& F : moved.force_kN) F += 12.0;
  auto const budget = budget_of(one_sided);
  auto const* found = find(budget, FindingKind::gain_of_one_side);
  ASSERT_NE(found, nullptr) << all_of(budget);
  EXPECT_NEAR(found->number("ratio"), 1.12, 0.005);
  EXPECT_NEAR(found->number("K_plus_kN_per_mm"), 0.784, 0.002);
  EXPECT_NEAR(found->number("K_minus_kN_per_mm"), 0.7, 0.002);
  EXPECT_EQ(find(budget, FindingKind::off_centre), nullptr);
  auto const offset = budget_of(moved);
  EXPECT_EQ(find(offset, FindingKind::gain_of_one_side), nullptr) << all_of(offset);
  EXPECT_NE(find(offset, FindingKind::off_centre), nullptr);
}

// In a record with 60 samples a second, a hum of 50 Hz appears as one of 10 Hz (aliasing).
TEST(ChannelChanges, hum_is_said_with_amplitude_and_frequency) {
  for (double const rate : {60.0, 101.0, 200.0, 500.0})
    for (bool const in_force : {true, false}) {
      auto motion = record_of({.rate_Hz = rate});
      auto& values = in_force ? motion.force_kN : motion.disp_mm;
      double const size = in_force ? 8.0 : 2.0;
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += size * std::sin(2.0 * pi * 50.0 * motion.time_s[i] + 0.6);
      auto const budget = budget_of(motion);
      auto const* found = find(budget, FindingKind::hum);
      ASSERT_NE(found, nullptr) << rate << all_of(budget);
      EXPECT_EQ(found->word("channel"), in_force ? "force" : "displacement");
      double const seen = std::abs(50.0 - rate * std::round(50.0 / rate));
      EXPECT_NEAR(found->number("frequency_Hz"), seen, 0.1) << rate;
      EXPECT_NEAR(found->number(in_force ? "amplitude_kN" : "amplitude_mm"), size, 0.1 * size) << rate;
      EXPECT_EQ(found->number("mains_Hz"), 50.0);
      EXPECT_EQ(found->has_number("rate_Hz"), rate < 100.0);
      auto const effect = std::ranges::find(
          budget.effects, in_force ? "oscillation of force" : "oscillation of displacement", &Effect::effect);
      ASSERT_NE(effect, budget.effects.end());
      EXPECT_NEAR(effect->value, in_force ? 100.0 * 8.0 / 113.0 : 100.0 * 2.0 / 152.0, 0.8);
    }
}

TEST(ChannelChanges, a_delay_that_grows_is_said_for_its_cycles) {
  auto const growing = record_of({.late_s = [](double t) { return 0.03 * std::clamp((t - 2.0) / 6.0, 0.0, 1.0); }});
  auto const budget = budget_of(growing);
  auto const* found = find(budget, FindingKind::lag_grows);
  ASSERT_NE(found, nullptr) << all_of(budget);
  EXPECT_NEAR(found->number("first_ms"), 0.0, 4.0);
  EXPECT_NEAR(found->number("last_ms"), 25.0, 3.0);  // mean of the delays at the reversals at 6.5 and 7.5 s
  EXPECT_NEAR(found->number("reported_ms"), 15.0, 4.0);
  EXPECT_NEAR(found->number("damping_points"), -2.4, 0.7);  // -100 pi f times the delay of 15 ms
  EXPECT_EQ(find(budget, FindingKind::force_late), nullptr);
  auto const constant = budget_of(record_of({.late_s = [](double) { return 0.02; }}));
  EXPECT_EQ(find(constant, FindingKind::lag_grows), nullptr) << all_of(constant);
  EXPECT_NE(find(constant, FindingKind::force_late), nullptr);
}

TEST(ChannelChanges, a_step_of_the_zero_is_told_from_a_drift) {
  for (bool const in_force : {true, false})
    for (double const from_s : {4.0, 4.3, 4.9, 5.6}) {
      auto motion = record_of({.cycles = 5});
      for (std::size_t i = 0; i < motion.time_s.size(); ++i)
        if (motion.time_s[i] > from_s) (in_force ? motion.force_kN : motion.disp_mm)[i] += 12.0;
      auto const budget = budget_of(motion);
      auto const* found = find(budget, FindingKind::offset_steps);
      ASSERT_NE(found, nullptr) << in_force << " from " << from_s << all_of(budget);
      EXPECT_NEAR(found->number(in_force ? "step_kN" : "step_mm"), 12.0, 1.0);
      EXPECT_NEAR(found->number("time_s"), from_s, 0.1);
      EXPECT_EQ(find(budget, FindingKind::drift), nullptr);
      auto drifting = record_of({.cycles = 5});
      for (std::size_t i = 0; i < drifting.time_s.size(); ++i)
        (in_force ? drifting.force_kN : drifting.disp_mm)[i] += 1.5 * drifting.time_s[i];
      auto const slow = budget_of(drifting);
      EXPECT_EQ(find(slow, FindingKind::offset_steps), nullptr) << all_of(slow);
      EXPECT_NE(find(slow, FindingKind::drift), nullptr);
    }
}

std::optional<Remainder> remainder_of(Motion const& motion) {
  TestRecord record;
  record.time_s = motion.time_s, record.disp_mm = motion.disp_mm, record.force_kN = motion.force_kN;
  record.faults = signal_faults(record.disp_mm, record.force_kN, record.time_s);
  auto const properties = cyclic_properties(record);
  add_warnings(record, properties);
  return remainder(record, properties);
}

// The force channel jumps by 12 kN. The mean cycle contains a part of the jump, but the remainder (signal minus mean
// cycle) must still rise by 12 kN.
TEST(ChannelChanges, the_remainder_shows_a_step_at_its_time) {
  auto motion = record_of({.cycles = 5});
  EXPECT_FALSE(remainder_of(motion));
  for (std::size_t i = 0; i < motion.time_s.size(); ++i)
    if (motion.time_s[i] > 4.9) motion.force_kN[i] += 12.0;
  auto const found = remainder_of(motion);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->of_force);
  ASSERT_EQ(found->at.size(), 1u);
  EXPECT_NEAR(found->at.front(), 4.9, 0.1);
  auto const at = [&](double t) { return found->values[static_cast<std::size_t>(t * 200.0) - found->first]; };
  for (double const phase : {0.1, 0.6, 1.1, 1.6}) EXPECT_NEAR(at(6.0 + phase) - at(2.0 + phase), 12.0, 0.5) << phase;
}

// A hum of 50 Hz repeats exactly in every cycle of 0.5 Hz, so it would be part of a plain mean cycle. The remainder
// must show it all the same.
TEST(ChannelChanges, the_remainder_shows_hum_that_repeats_with_the_cycle) {
  auto motion = record_of({});
  for (std::size_t i = 0; i < motion.time_s.size(); ++i)
    motion.force_kN[i] += 8.0 * std::sin(100.0 * pi * motion.time_s[i] + 0.6);
  auto const found = remainder_of(motion);
  ASSERT_TRUE(found);
  double squares = 0.0;
  for (double const value : found->values) squares += value * value;
  EXPECT_NEAR(std::sqrt(2.0 * squares / static_cast<double>(found->values.size())), 8.0, 0.8);
}

// The spikes lie at the same place of each cycle. The mean cycle must not contain them, so that the remainder does.
TEST(ChannelChanges, the_remainder_shows_spikes) {
  auto motion = record_of({});
  std::vector<std::size_t> const spikes{50, 450, 850, 1250};
  for (auto const i : spikes) motion.force_kN[i] += 20.0;
  auto const found = remainder_of(motion);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->at.size(), spikes.size());
  for (std::size_t k = 1; k < spikes.size(); ++k) {
    EXPECT_NEAR(found->at[k], motion.time_s[spikes[k]], 1e-9);
    EXPECT_NEAR(found->values[spikes[k] - found->first], 20.0, 0.5);
  }
}

TEST(ChannelChanges, a_sweep_has_no_single_frequency) {
  Motion sweep;
  for (int i = 0; i <= 4000; ++i) {
    double const t = 0.01 * i;
    sweep.add(100.0 * std::sin(2.0 * pi * (0.05 * t + 0.5 * (0.95 / 40.0) * t * t)));
  }
  sweep.loop();
  auto const properties = sweep.properties();
  for (auto const& block : properties.blocks) {
    EXPECT_FALSE(block.frequency_Hz);
    ASSERT_TRUE(block.sweep_Hz);
  }
  auto const budget = error_budget(sweep.view(), properties);
  auto const* found = find(budget, FindingKind::frequency_sweeps);
  ASSERT_NE(found, nullptr);
  EXPECT_NEAR(found->number("first_Hz"), 0.14, 0.02);  // mean of the first cycle, which takes 7.3 s
  EXPECT_NEAR(found->number("last_Hz"), 0.98, 0.03);
  auto const steps = Motion().sine(100.0, 0.2, 3).sine(100.0, 0.5, 3).sine(100.0, 1.0, 3).end().loop();
  for (auto const& block : steps.properties().blocks) EXPECT_TRUE(block.frequency_Hz);
}

// If a device unloads steeply, the corners of its loop lie between samples. A delay below a sampling interval must then
// not be reported.
TEST(ChannelChanges, no_delay_is_claimed_that_the_samples_cannot_show) {
  int estimated = 0, claimed = 0;
  for (double const K1 : {5.0, 10.0, 20.0, 35.0, 50.0, 70.0, 100.0})
    for (double const per_cycle : {20.0, 24.0, 30.0, 35.0, 40.0, 50.0, 60.0, 70.0, 80.0, 100.0, 120.0, 150.0, 200.0})
      for (double const start : {0.0, 0.25, 0.5, 0.75})
        for (double const noise : {0.0, 1.0}) {
          auto const motion =
              record_of({.rate_Hz = per_cycle / 2.0, .first_stiffness = K1, .start = start, .noise = noise});
          auto const found = estimate_skew(motion.view(), motion.properties());
          if (!found) continue;
          ++estimated;
          bool const late = found->significant() && found->force_late > 0.0;
          bool const grows = found->grows();
          if (late || grows) {
            ++claimed;
            std::cout << "K1 " << K1 << ", " << per_cycle << " a cycle, start " << start << ", noise " << noise << ": "
                      << (late ? "late " : "") << (grows ? "grows " : "") << found->force_late * per_cycle / 2.0
                      << " intervals, phase " << found->phase << ", followed " << found->is_followed << ", +- "
                      << found->uncertainty * per_cycle / 2.0 << "\n";
          }
        }
  std::cout << claimed << " of " << estimated << "\n";
  EXPECT_EQ(claimed, 0) << "of " << estimated;
  EXPECT_GT(estimated, 100);
}

// --- how often faults are reported for sound records ---

using Counts = std::map<std::string, int>;

void count_kinds(Counts& counts, CycleView const& view, std::string const& text) {
  auto const properties = cyclic_properties(view);
  if (!properties.reported) return;
  ++counts["records"];
  auto const budget = error_budget(view, properties);
  for (auto const kind : new_kinds)
    if (auto const* found = find(budget, kind)) {
      auto const key = std::string(wording::row(kind).key);
      if (++counts[key] <= 12) std::cout << key << ": " << text << "\n    " << wording::sentence(*found) << "\n";
    }
}

void expect_rare(Counts const& counts) {
  for (auto const& [key, count] : counts) {
    std::cout << key << " " << count << "\n";
    if (key == "records") continue;
    EXPECT_LE(100 * count, counts.at("records")) << key;
  }
}

TEST(ChannelChanges, none_is_reported_of_sound_devices) {
  Counts counts;
  for (unsigned seed = 0; seed < 1800; ++seed) {
    Drawn random(200000 + seed);
    auto plan = draw(random, {.fewest_samples = 20}, seed % 2 == 0);
    if (plan.samples * plan.cycles > 4000) plan.samples = 4000 / plan.cycles;
    auto const record = finish(random, plan, true_motion(plan));
    count_kinds(counts, record.view(), record.text);
  }
  EXPECT_GT(counts["records"], 1500);
  expect_rare(counts);
}

TEST(ChannelChanges, none_is_reported_of_the_laws) {
  Counts counts;
  unsigned seed = 300000;
  laws::RecordScales const device{
      .disp = 208.0, .force = 140.0, .stiffness = 0.67, .strength = 45.0, .velocity = 650.0, .work = 1e5};
  for (auto const& law : laws::catalogue())
    for (int k = 0; k < 40; ++k) {
      Drawn random(seed++);
      auto plan = draw(random, {.fewest_samples = 20, .most_samples = 400}, k % 4 == 0);
      plan.amplitude_mm = 208.0 * random.between(0.5, 1.0);
      plan.frequency_Hz = random.on_logs(0.2, 1.0);
      auto motion = true_motion(plan);
      TestRecord raw;
      raw.time_s = motion.time_s;
      raw.disp_mm = motion.disp_mm;
      raw.force_kN.assign(raw.disp_mm.size(), 0.0);
      double const to_force = 1.0 / law.info.force.in_record_units, to_length = 1.0 / law.info.length.in_record_units;
      laws::RecordScales const scales{.disp = device.disp * to_length,
                                      .force = device.force * to_force,
                                      .stiffness = device.stiffness * to_force / to_length,
                                      .strength = device.strength * to_force,
                                      .velocity = device.velocity * to_length,
                                      .work = device.work * to_force * to_length};
      std::vector<double> values;
      for (auto const& parameter : law.parameters) {
        auto const scaled = parameter.scaled(scales);
        auto const [lower, upper] = parameter.published ? *parameter.published : scaled;
        values.push_back(parameter.fixed_by_default && !parameter.published ? *parameter.fixed_by_default
                         : !parameter.published && parameter.scaled_search == laws::Scale::logarithmic
                             ? random.on_logs(std::max(lower, 1e-6 * upper), upper)
                             : random.between(lower, upper));
      }
      if (law.unmet(values)) continue;
      motion.force_kN =
          fit::LawOnMotion(law, motion_of(raw), laws::Integration::converged, laws::TurningPoints::interpolated, 4)
              .force_kN(values);
      if (!std::ranges::all_of(motion.force_kN, [](double F) { return std::isfinite(F); })) continue;
      auto const record = finish(random, plan, motion);
      count_kinds(counts, record.view(), std::string(law.info.id) + " " + record.text);
    }
  expect_rare(counts);
}

// --- how often real faults are found ---

struct PutFault {
  FindingKind kind;
  int least_percent;  // the fault must be found in so many records, in %
  // Puts the fault into a record. Returns its time in s or its frequency in Hz, if the warning must say this.
  std::function<std::optional<double>(Recording&, Plan const&, Drawn&)> put;
};

TEST(ChannelChanges, faults_of_random_records_are_found) {
  auto const after = [](Recording& record, Plan const& plan, Drawn& random, auto change) {
    double const from_s = random.between(2.0, plan.cycles - 1.0) / plan.frequency_Hz;
    for (std::size_t i = 0; i < record.time_s.size(); ++i)
      if (record.time_s[i] > from_s) change(record.force_kN_[i]);
    return std::optional(from_s);
  };
  std::vector<PutFault> const faults{
      {FindingKind::stiffness_rises, 98,
       [&](Recording& record, Plan const& plan, Drawn& random) {
         double const gain = random.between(1.05, 1.2);
         return after(record, plan, random, [&](double& F) { F *= gain; });
       }},
      {FindingKind::offset_steps, 97,
       [&](Recording& record, Plan const& plan, Drawn& random) {
         double const step = random.between(0.04, 0.15) * record.force_kN;
         return after(record, plan, random, [&](double& F) { F += step; });
       }},
      {FindingKind::gain_of_one_side, 75,
       [](Recording& record, Plan const&, Drawn& random) {
         double const gain = random.between(1.08, 1.2);
         for (double& F : record.force_kN_)
           if (F > 0.0) F *= gain;
         return std::optional<double>();
       }},
      {FindingKind::hum, 88,
       [](Recording& record, Plan const& plan, Drawn& random) {
         double const size = random.between(0.02, 0.1) * record.force_kN, phase = random.between(0.0, 6.0),
                      frequency = plan.frequency_Hz * random.between(12.0, plan.samples / 2.0);
         for (std::size_t i = 0; i < record.time_s.size(); ++i)
           record.force_kN_[i] += size * std::sin(2.0 * pi * frequency * record.time_s[i] + phase);
         return std::optional(frequency);
       }},
      {FindingKind::lag_grows, 45, [](Recording& record, Plan const& plan, Drawn& random) {
         auto const sound = record.force_kN_;
         double const growth =
             random.between(0.08, 0.15) / (2.0 * pi) * plan.samples / static_cast<double>(sound.size());
         for (std::size_t i = 0; i < sound.size(); ++i)
           record.force_kN_[i] = value_at(sound, (1.0 - growth) * static_cast<double>(i));
         return std::optional<double>();
       }}};
  for (auto const& fault : faults) {
    int drawn = 0, found = 0, wrong = 0;
    for (unsigned seed = 0; seed < 600; ++seed) {
      Drawn random(700000 + seed);
      auto plan = draw(random, {.fewest_samples = 40}, false);
      plan.cycles = std::max(plan.cycles, 5);
      plan.samples = std::min(plan.samples, 4000 / plan.cycles);
      if (plan.waveform == Waveform::stages) plan.waveform = Waveform::sine;
      if (plan.device == Device::friction) continue;
      auto record = finish(random, plan, true_motion(plan));
      auto const put = fault.put(record, plan, random);
      auto const properties = cyclic_properties(record.view());
      if (!properties.reported) continue;
      ++drawn;
      auto const budget = error_budget(record.view(), properties);
      auto const* said = find(budget, fault.kind);
      if (said == nullptr) continue;
      ++found;
      bool const timed = fault.kind != FindingKind::hum;
      if (put && std::abs(said->number(timed ? "time_s" : "frequency_Hz") - *put) >
                     (timed ? 0.25 / plan.frequency_Hz : 0.5 * plan.frequency_Hz))
        ++wrong;
    }
    std::cout << wording::row(fault.kind).key << ": " << found << " of " << drawn << ", " << wrong << " elsewhere\n";
    EXPECT_GT(drawn, 400);
    EXPECT_GE(100 * found, fault.least_percent * drawn) << wording::row(fault.kind).key;
    EXPECT_LE(50 * wrong, drawn) << wording::row(fault.kind).key;
  }
}

// --- steep reversals are no spikes ---

// Makes the record of a steel coupon. The first stiffness is 50 to 200 times the second, the cycles grow or have one
// amplitude, and there are few samples a cycle.
Recording coupon(Drawn& random) {
  constexpr int finer = 32;
  int const samples = random.whole(20, 40), cycles = random.whole(4, 12);
  bool const triangle = random.chance(0.5), grows = random.chance(0.6);
  double const D = 10.0, yields_at = random.on_logs(0.02, 0.5), ratio = random.on_logs(50.0, 200.0),
               noise = random.chance(0.5) ? 0.0 : random.on_logs(1e-5, 1e-3), R = random.on_logs(1.0, 20.0);
  double const start = random.between(0.0, 1.0), rate = samples * random.between(0.95, 1.05);
  double z = 0.0, before = 0.0;
  Recording record;
  for (int i = 0; i <= cycles * samples * finer; ++i) {
    double const phase = i / (rate * finer), part = phase - std::floor(phase);
    double const amplitude = grows ? D * (std::floor(phase) + 1.0) / cycles : D;
    double const x = amplitude * (triangle ? part < 0.25   ? 4.0 * part
                                             : part < 0.75 ? 2.0 - 4.0 * part
                                                           : 4.0 * part - 4.0
                                           : std::sin(2.0 * pi * part));
    double const way = (x - before) / (yields_at * D);
    z += way * (z * way > 0.0 ? 1.0 - std::pow(std::abs(z), R) : 1.0);
    z = std::clamp(z, -1.0, 1.0);
    before = x;
    if ((i - static_cast<int>(start * finer)) % finer != 0 || i < start * finer) continue;
    record.time_s.push_back(0.01 * static_cast<double>(record.time_s.size()));
    record.disp_mm.push_back(x + noise * D * random.normal());
    record.force_kN_.push_back(x + (ratio - 1.0) * yields_at * D * z);
  }
  record.force_kN = half_range(record.force_kN_);
  for (double& F : record.force_kN_) F += noise * record.force_kN * random.normal();
  record.text = std::to_string(samples) + " a cycle, " + std::to_string(cycles) + " cycles, yields at " +
                std::to_string(yields_at) + ", R " + std::to_string(R) + ", noise " + std::to_string(noise) +
                (triangle ? ", triangle" : ", sine") + (grows ? ", growing" : "");
  return record;
}

TEST(ChannelChanges, steep_reversals_are_no_spikes) {
  int refused = 0, found = 0;
  constexpr int drawn = 1500;
  for (unsigned seed = 0; seed < drawn; ++seed) {
    Drawn random(400000 + seed);
    auto record = coupon(random);
    auto const faults = signal_faults(record.disp_mm, record.force_kN_, record.time_s);
    if (!faults.empty() && ++refused <= 30) std::cout << record.text << ": " << text_of(faults.front().finding) << "\n";
    auto const turns = reversals(record.disp_mm).at;
    std::size_t at = 0;
    do {
      at = static_cast<std::size_t>(random.whole(6, static_cast<int>(record.disp_mm.size()) - 7));
    } while (std::ranges::any_of(turns, [&](auto turn) { return std::max(turn, at) - std::min(turn, at) < 4; }));
    record.force_kN_[at] += (random.chance(0.5) ? 0.3 : -0.3) * record.force_kN;
    for (auto const& fault : signal_faults(record.disp_mm, record.force_kN_, record.time_s))
      if (fault.kind == FaultKind::spike && std::ranges::count(fault.samples, at) > 0) ++found;
  }
  std::cout << refused << " refused, " << found << " spikes found of " << drawn << "\n";
  EXPECT_LE(100 * refused, drawn);
  EXPECT_GE(4 * found, 3 * drawn);
}

}  // namespace
}  // namespace isolaw::data::testing
