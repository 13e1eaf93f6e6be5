// Tests the search for faults of signals on random records of fixed seeds, and counts how often a fault is found and
// how often one is reported where there is none. docs/properties.md describes the records and states the bounds checked
// here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "finding_text.hpp"
#include "isolaw/data/channels/time_gaps.hpp"
#include "isolaw/data/cycles/holds.hpp"
#include "isolaw/data/signals/signal_faults.hpp"
#include "motions.hpp"
#include "signals.hpp"

namespace isolaw::data::testing {
namespace {

constexpr unsigned records = 600;

std::vector<SignalFault> faults_of(Recording const& record) {
  return signal_faults(record.disp_mm, record.force_kN_, record.time_s);
}

bool names(std::vector<SignalFault> const& faults, std::string_view channel, FaultKind kind) {
  return std::ranges::any_of(faults, [&](auto const& f) { return f.channel == channel && f.kind == kind; });
}

// Returns whether the channel is reported as clipped or as stuck. Both are right for a channel that stays at its
// extreme value.
bool stands(std::vector<SignalFault> const& faults, std::string_view channel) {
  return names(faults, channel, FaultKind::clipped) || names(faults, channel, FaultKind::stuck);
}

std::string text_of(std::vector<SignalFault> const& faults) {
  std::string text;
  for (auto const& fault : faults) text += "\n  " + text_of(fault.finding);
  return text;
}

// Returns how many samples per cycle are changed if clipping cuts off one side of the signal. `depth` is the share of
// the amplitude that is cut off.
double samples_beyond(Plan const& plan, double depth) {
  return plan.samples * (plan.waveform == Waveform::triangle ? depth / 2.0 : std::acos(1.0 - depth) / std::numbers::pi);
}

void clip(std::vector<double>& x, double level, int sides) {
  for (double& value : x) {
    if (sides != 1) value = std::min(value, level);
    if (sides != 0) value = std::max(value, -level);
  }
}

bool near_a_turn(Plan const& plan, Recording const& record, std::size_t where, std::size_t reach) {
  auto turns = reversals(record.disp_mm).at;
  auto const rest = static_cast<std::size_t>(plan.samples / 4);
  for (int k = 0; k <= plan.cycles; ++k) turns.push_back(rest + static_cast<std::size_t>(k * plan.samples));
  turns.push_back(record.disp_mm.size() - rest);
  return std::ranges::any_of(turns, [&](auto turn) { return std::max(turn, where) - std::min(turn, where) < reach; });
}

// Draws the plan of one record per seed and calls `of`, which makes the record, in most tests with a fault. `of`
// returns whether isolaw judges the record rightly, or that the record does not count. Records that are judged wrongly
// are counted as missed.
enum class Found { left_out, no, yes };
struct Rate {
  int drawn = 0, missed = 0;
};
Rate rate_of(unsigned first_seed, bool holds, std::function<Found(Plan&, Drawn&)> const& of) {
  Rate rate;
  for (unsigned seed = first_seed; seed < first_seed + records; ++seed) {
    Drawn random(seed);
    auto plan = draw(random, {}, holds);
    auto const found = of(plan, random);
    if (found == Found::left_out) continue;
    ++rate.drawn;
    if (found == Found::no) ++rate.missed;
  }
  return rate;
}

// Returns whether isolaw finds the clipping in `record`. Prints the record if it does not.
Found found_at(double depth, auto const& record, std::string const& channel) {
  auto const faults = faults_of(record);
  if (stands(faults, channel)) return Found::yes;
  std::cout << "not found: depth " << depth << ", " << record.text << text_of(faults) << "\n";
  return Found::no;
}

TEST(Signals, a_true_record_is_left_alone) {
  auto const rate = rate_of(0, true, [](Plan& plan, Drawn& random) {
    auto const record = finish(random, plan, true_motion(plan));
    auto const faults = faults_of(record);
    EXPECT_TRUE(faults.empty()) << record.text << text_of(faults);
    return faults.empty() ? Found::yes : Found::no;
  });
  EXPECT_EQ(rate.drawn, static_cast<int>(records));
  EXPECT_EQ(rate.missed, 0);
}

TEST(Signals, clipped_displacement_is_found_from_one_percent_of_the_amplitude) {
  for (bool const noise_first : {true, false}) {
    auto const rate = rate_of(10000, false, [&](Plan& plan, Drawn& random) {
      double const depth = random.on_logs(0.01, 0.2);
      int const sides = random.whole(0, 2);
      if (samples_beyond(plan, depth) < 5.0 || plan.device == Device::viscous) return Found::left_out;
      auto motion = true_motion(plan);
      if (!noise_first) {
        plan.disp_noise = std::min(plan.disp_noise, 0.01 * depth);
        clip(motion.disp_mm, (1.0 - depth) * plan.amplitude_mm, sides);
      }
      auto record = finish(random, plan, motion);
      if (noise_first) clip(record.disp_mm, (1.0 - depth) * plan.amplitude_mm, sides);
      return found_at(depth, record, "displacement");
    });
    EXPECT_GT(rate.drawn, 200);
    // A clipped triangle with noise added afterwards may look like a trapezoid, so more faults may be missed than with
    // noise before the clipping.
    EXPECT_LE((noise_first ? 200 : 40) * rate.missed, rate.drawn) << rate.missed << " of " << rate.drawn;
  }
}

TEST(Signals, trapezoids_with_short_holds_are_left_alone) {
  auto const rate = rate_of(130000, false, [](Plan& plan, Drawn& random) {
    plan.waveform = Waveform::trapezoid;
    double const hold = random.between(0.02, 0.12);  // duration of the hold at each peak over that of a cycle
    plan.overdriven = 1.0 / (1.0 - 2.0 * hold);
    auto const record = finish(random, plan, true_motion(plan));
    auto const faults = faults_of(record);
    if (!faults.empty()) std::cout << "hold " << hold << ", " << record.text << text_of(faults) << "\n";
    return faults.empty() ? Found::yes : Found::no;
  });
  EXPECT_GT(rate.drawn, 300);
  EXPECT_LE(100 * rate.missed, rate.drawn) << rate.missed << " of " << rate.drawn;
}

TEST(Signals, clipped_force_is_found_from_three_percent) {
  auto const rate = rate_of(20000, false, [](Plan& plan, Drawn& random) {
    double const depth = random.on_logs(0.03, 0.2);
    int const sides = random.whole(0, 2);
    if (samples_beyond(plan, depth) < 8.0 || plan.device == Device::viscous || plan.device == Device::friction)
      return Found::left_out;
    auto record = finish(random, plan, true_motion(plan));
    auto const [least, largest] = std::ranges::minmax(record.force_kN_);
    clip(record.force_kN_, (1.0 - depth) * std::min(largest, -least), sides);
    return found_at(depth, record, "force");
  });
  EXPECT_GT(rate.drawn, 200);
  EXPECT_LE(200 * rate.missed, rate.drawn);
}

// A saturated amplifier clips the force before noise is added, so the plateau is noisy. The clipping must still be
// found in at least the stated share of the records.
TEST(Signals, force_clipped_before_its_noise_is_found) {
  struct Case {
    double least_noise, most_noise, least_depth, most_depth;
    int least_found_percent;
  };
  for (auto const& [least_noise, most_noise, least_depth, most_depth, least_found] :
       {Case{1e-5, 1e-3, 0.05, 0.3, 95}, Case{1e-3, 5e-3, 0.05, 0.1, 85}, Case{1e-3, 5e-3, 0.1, 0.3, 95}}) {
    auto const rate = rate_of(60000, false, [&](Plan& plan, Drawn& random) {
      double const depth = random.between(least_depth, most_depth);
      int const sides = random.whole(0, 2);
      plan.samples = random.whole(200, 1000);
      plan.force_noise = random.on_logs(least_noise, most_noise);
      if (plan.bits > 0) plan.bits = 16;
      if (plan.device == Device::viscous || plan.device == Device::friction) return Found::left_out;
      auto motion = true_motion(plan);
      auto const [least, largest] = std::ranges::minmax(motion.force_kN);
      clip(motion.force_kN, (1.0 - depth) * std::min(largest, -least), sides);
      return names(faults_of(finish(random, plan, motion)), "force", FaultKind::clipped) ? Found::yes : Found::no;
    });
    EXPECT_GT(rate.drawn, 200);
    EXPECT_GE(100 * (rate.drawn - rate.missed), least_found * rate.drawn) << rate.missed << " of " << rate.drawn;
  }
}

TEST(Signals, displacement_clipped_before_its_noise_is_found) {
  auto const rate = rate_of(70000, false, [](Plan& plan, Drawn& random) {
    double const depth = random.between(0.05, 0.3);
    int const sides = random.whole(0, 2);
    plan.samples = random.whole(200, 1000);
    plan.disp_noise = random.on_logs(1e-5, 5e-3);
    if (plan.device == Device::viscous) return Found::left_out;
    auto motion = true_motion(plan);
    clip(motion.disp_mm, (1.0 - depth) * plan.amplitude_mm, sides);
    return stands(faults_of(finish(random, plan, motion)), "displacement") ? Found::yes : Found::no;
  });
  EXPECT_GT(rate.drawn, 200);
  EXPECT_GE(100 * (rate.drawn - rate.missed), 95 * rate.drawn) << rate.missed << " of " << rate.drawn;
}

// The force of these devices hardly rises after yielding. Their motion has a random waveform. The constant force is
// real and must not be reported as a fault.
TEST(Signals, a_device_that_yields_flat_is_left_alone) {
  auto const rate = rate_of(80000, true, [](Plan& plan, Drawn& random) {
    double const way = plan.amplitude_mm * random.on_logs(0.005, 0.5);
    double const hardening = random.chance(0.5) ? 0.0 : random.on_logs(1e-4, 0.05);
    bool const rigid = random.chance(0.3);
    auto motion = true_motion(plan);
    double z = 0.0, before = motion.disp_mm.front();
    for (std::size_t i = 0; i < motion.disp_mm.size(); ++i) {
      double const step = motion.disp_mm[i] - before;
      before = motion.disp_mm[i];
      z = rigid && step != 0.0 ? std::copysign(1.0, step) : std::clamp(z + step / way, -1.0, 1.0);
      motion.force_kN[i] = 100.0 * (z + hardening * before / plan.amplitude_mm);
    }
    auto const record = finish(random, plan, motion);
    auto const faults = faults_of(record);
    EXPECT_TRUE(faults.empty()) << "yields at " << way << ", hardens by " << hardening << ", " << record.text
                                << text_of(faults);
    return faults.empty() ? Found::yes : Found::no;
  });
  EXPECT_EQ(rate.drawn, static_cast<int>(records));
  EXPECT_EQ(rate.missed, 0);
}

TEST(Signals, spikes_are_found_from_five_percent_of_the_peak) {
  for (bool const of_force : {true, false}) {
    auto const rate = rate_of(30000, false, [&](Plan& plan, Drawn& random) {
      auto record = finish(random, plan, true_motion(plan));
      auto& x = of_force ? record.force_kN_ : record.disp_mm;
      double const size = random.on_logs(0.05, 2.0) * (random.chance(0.5) ? 1.0 : -1.0);
      auto const where = static_cast<std::size_t>(random.whole(3, static_cast<int>(x.size()) - 4));
      if (std::abs(size) < 20.0 * (of_force ? plan.force_noise : plan.disp_noise)) return Found::left_out;
      // A spike beside a jump or a corner of the signal itself need not be found.
      if (near_a_turn(plan, record, where, of_force ? 8 : 4)) return Found::left_out;
      x[where] += size * (of_force ? record.force_kN : record.amplitude_mm);
      auto const faults = faults_of(record);
      bool const found = faults.size() == 1 && faults.front().kind == FaultKind::spike &&
                         faults.front().channel == (of_force ? "force" : "displacement") &&
                         faults.front().samples == std::vector{where};
      if (!found)
        std::cout << "not found: "
                  << "size " << size << " at " << where << ", " << record.text << text_of(faults) << "\n";
      return found ? Found::yes : Found::no;
    });
    EXPECT_GT(rate.drawn, 200);
    EXPECT_LE(200 * rate.missed, rate.drawn);
  }
}

TEST(Signals, a_stuck_channel_is_found) {
  for (bool const of_force : {true, false}) {
    auto const rate = rate_of(40000, false, [&](Plan& plan, Drawn& random) {
      auto record = finish(random, plan, true_motion(plan));
      auto& x = of_force ? record.force_kN_ : record.disp_mm;
      int const length = std::max(8, static_cast<int>(plan.samples * random.on_logs(0.05, 0.5)));
      auto const rest = plan.samples / 4;
      auto const from =
          static_cast<std::size_t>(random.whole(rest + 5, rest + plan.samples * plan.cycles - length - 5));
      auto const to = from + static_cast<std::size_t>(length);
      double const level = x[from];
      double const amplitude = of_force ? record.force_kN : record.amplitude_mm;
      // The fault must be found only if the channel goes on at another value in the middle of a motion. A force that is
      // constant without noise may otherwise come from a device that yields.
      bool const jumps = std::abs(x[to] - level) > (of_force ? 0.3 : 0.15) * amplitude;
      bool const moves = std::abs(record.disp_mm[to] - record.disp_mm[from]) > 0.15 * record.amplitude_mm;
      if (!jumps || !moves || plan.device == Device::viscous || plan.device == Device::friction ||
          near_a_turn(plan, record, to, 8))
        return Found::left_out;
      for (auto i = from; i < to; ++i) x[i] = level;
      auto const faults = faults_of(record);
      bool const found = stands(faults, of_force ? "force" : "displacement");
      if (!found)
        std::cout << "not found: " << length << " from " << from << ", " << record.text << text_of(faults) << "\n";
      return found ? Found::yes : Found::no;
    });
    EXPECT_GT(rate.drawn, 120);
    EXPECT_LE(100 * rate.missed, rate.drawn);
  }
}

TEST(Signals, a_channel_that_stuck_before_its_noise_is_found) {
  for (bool const of_force : {true, false}) {
    auto const rate = rate_of(90000, false, [&](Plan& plan, Drawn& random) {
      plan.force_noise = plan.disp_noise = random.on_logs(1e-4, 1e-3);
      if (plan.bits > 0) plan.bits = 16;
      auto motion = true_motion(plan);
      auto& x = of_force ? motion.force_kN : motion.disp_mm;
      auto const [least, largest] = std::ranges::minmax(x);
      int const length = std::max(8, static_cast<int>(plan.samples * random.on_logs(0.05, 0.5)));
      auto const rest = plan.samples / 4;
      auto const from =
          static_cast<std::size_t>(random.whole(rest + 5, rest + plan.samples * plan.cycles - length - 5));
      auto const to = from + static_cast<std::size_t>(length);
      bool const jumps = std::abs(x[to] - x[from]) > (of_force ? 0.15 : 0.075) * (largest - least);
      bool const moves = std::abs(motion.disp_mm[to] - motion.disp_mm[from]) > 0.15 * plan.amplitude_mm;
      if (!jumps || !moves || plan.device == Device::viscous || plan.device == Device::friction) return Found::left_out;
      std::fill(x.begin() + static_cast<std::ptrdiff_t>(from), x.begin() + static_cast<std::ptrdiff_t>(to), x[from]);
      return stands(faults_of(finish(random, plan, motion)), of_force ? "force" : "displacement") ? Found::yes
                                                                                                  : Found::no;
    });
    EXPECT_GT(rate.drawn, 120);
    EXPECT_GE(100 * (rate.drawn - rate.missed), 80 * rate.drawn) << rate.missed << " of " << rate.drawn;
    std::cout << "stuck before noise: " << rate.missed << " of " << rate.drawn << " missed\n";
  }
}

// One channel is zero, or at another wrong value, for 3 to 20 samples while the other channel is sound.
TEST(Signals, a_channel_that_drops_out_is_found) {
  for (bool const of_force : {true, false})
    for (bool const to_nought : {true, false}) {
      auto const rate = rate_of(130000, false, [&](Plan& plan, Drawn& random) {
        auto record = finish(random, plan, true_motion(plan));
        auto& x = of_force ? record.force_kN_ : record.disp_mm;
        double const amplitude = of_force ? record.force_kN : record.amplitude_mm;
        int const length = random.whole(3, std::min(20, plan.samples / 8));
        auto const rest = plan.samples / 4;
        auto const from =
            static_cast<std::size_t>(random.whole(rest + 5, rest + plan.samples * plan.cycles - length - 5));
        auto const to = from + static_cast<std::size_t>(length);
        double const level = to_nought ? 0.0 : amplitude * random.between(-1.5, 1.5);
        // The dropout must be found only if its value is clearly above both the sample before it and the one after, or
        // clearly below both, and if neither of its ends is near a turn, where the force of a device with friction
        // jumps by itself.
        double const off = std::min(std::abs(level - x[from - 1]), std::abs(level - x[to]));
        bool const one_way = (level - x[from - 1]) * (level - x[to]) > 0.0;
        if (!one_way || off < 0.3 * amplitude ||
            off < 20.0 * amplitude * (of_force ? plan.force_noise : plan.disp_noise))
          return Found::left_out;
        if (near_a_turn(plan, record, from, 8 + static_cast<std::size_t>(length)) ||
            near_a_turn(plan, record, to, 8 + static_cast<std::size_t>(length)))
          return Found::left_out;
        for (auto i = from; i < to; ++i) x[i] = level;
        auto const faults = faults_of(record);
        bool const found = faults.size() == 1 && faults.front().kind == FaultKind::dropout &&
                           faults.front().channel == (of_force ? "force" : "displacement") &&
                           faults.front().samples == std::vector{from};
        if (!found)
          std::cout << "not found: " << length << " from " << from << ", " << record.text << text_of(faults) << "\n";
        return found ? Found::yes : Found::no;
      });
      EXPECT_GT(rate.drawn, 100);
      EXPECT_LE(50 * rate.missed, rate.drawn);
      std::cout << "dropouts: " << rate.missed << " of " << rate.drawn << " missed\n";
    }
}

TEST(Signals, a_true_record_does_not_drop_out) {
  for (unsigned seed = 200000; seed < 204000; ++seed) {
    Drawn random(seed);
    auto plan = draw(random, {.most_disp_noise = seed % 2 == 0 ? 0.0 : 0.002, .fewest_samples = 20}, true);
    if (seed % 4 == 0) plan.device = Device::friction;
    if (seed % 8 == 0) plan.disp_noise = plan.force_noise = 0.0;
    auto const record = finish(random, plan, true_motion(plan));
    EXPECT_TRUE(dropouts(record.disp_mm, record.force_kN_, OtherChannel::may_stand).empty()) << record.text;
    EXPECT_TRUE(dropouts(record.force_kN_, record.disp_mm, OtherChannel::moves).empty()) << record.text;
  }
}

TEST(Signals, a_dropout_is_said_with_its_samples) {
  std::vector<double> disp, force, time;
  for (int i = 0; i < 400; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / 100.0;
    disp.push_back(100.0 * std::sin(phase));
    force.push_back(60.0 * std::sin(phase) + 20.0 * std::cos(phase));
    time.push_back(0.01 * i);
  }
  EXPECT_TRUE(signal_faults(disp, force, time).empty());
  for (std::size_t i = 212; i < 217; ++i) force[i] = 0.0;
  auto const faults = signal_faults(disp, force, time);
  ASSERT_EQ(faults.size(), 1u) << text_of(faults);
  EXPECT_EQ(said_of(faults.front().kind), "interrupted");
  EXPECT_EQ(text_of(faults.front().finding).find("the force drops out: 0 kN for 5 samples between "), 0u)
      << text_of(faults.front().finding);
}

TEST(Signals, a_channel_without_its_sign_is_found) {
  for (bool const of_force : {true, false}) {
    auto const rate = rate_of(50000, false, [&](Plan& plan, Drawn& random) {
      auto record = finish(random, plan, true_motion(plan));
      for (double& value : of_force ? record.force_kN_ : record.disp_mm) value = std::abs(value);
      auto const faults = faults_of(record);
      bool const found = names(faults, of_force ? "force" : "displacement", FaultKind::rectified);
      if (!found) std::cout << "not found: " << record.text << text_of(faults) << "\n";
      return found ? Found::yes : Found::no;
    });
    EXPECT_LE(200 * rate.missed, rate.drawn);
  }
}

// --- records made by formulas ---

TEST(Signals, sentences_name_the_word_the_sample_and_the_time) {
  auto motion = Motion().sine(100.0, 0.5, 3).end().loop();
  auto clipped = motion;
  for (double& x : clipped.disp_mm) x = std::min(x, 95.0);
  auto const faults = signal_faults(clipped.disp_mm, clipped.force_kN, clipped.time_s);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(
      text_of(faults.front().finding),
      "the displacement is clipped at 95 mm for up to 21 samples from 0.4 s (sample 41), 2.4 s (sample 241) and "
      "4.4 s (sample 441), while the force goes on. Whatever is computed from such a signal is wrong: test again, "
      "or give a channel that was not disturbed.");
  motion.force_kN[212] += 8.0;
  auto const spike = signal_faults(motion.disp_mm, motion.force_kN, motion.time_s);
  ASSERT_EQ(spike.size(), 1u);
  EXPECT_NE(text_of(spike.front().finding).find("the force has a single-sample spike at 2.12 s (sample 213): +"),
            std::string::npos)
      << text_of(spike.front().finding);
}

// The loops are those of elastic-plastic devices and of springs with play, without noise or rounding. The force may be
// a few samples late. No fault must be reported.
TEST(Signals, loops_of_formulas_are_left_alone) {
  for (bool const triangle : {false, true})
    for (double const part : {0.05, 0.2, 0.5})
      for (std::size_t const late : {0u, 1u, 3u})
        for (bool const plastic : {false, true}) {
          Motion motion;
          if (triangle)
            for (int cycle = 0; cycle < 3; ++cycle)
              motion.ramp(0.0, 100.0, 0.5).ramp(100.0, -100.0, 1.0).ramp(-100.0, 0.0, 0.5);
          else
            motion.sine(100.0, 0.5, 3);
          motion.hold(0.0, 0.5).end();
          double z = 0.0, before = 0.0;
          for (double const x : motion.disp_mm) {
            z = std::clamp(z + (x - before) / (100.0 * part), -1.0, 1.0);
            before = x;
            double const beyond = std::max(0.0, std::abs(x) - 100.0 * part);
            motion.force_kN.push_back(plastic ? 100.0 * z : std::copysign(beyond, x));
          }
          std::shift_right(motion.force_kN.begin(), motion.force_kN.end(), static_cast<std::ptrdiff_t>(late));
          std::fill_n(motion.force_kN.begin(), late, 0.0);
          auto const faults = signal_faults(motion.disp_mm, motion.force_kN, motion.time_s);
          EXPECT_TRUE(faults.empty()) << (triangle ? "triangle" : "sine") << ", " << part << ", late by " << late
                                      << (plastic ? ", plastic" : ", play") << text_of(faults);
        }
}

// A device with play has exactly zero force until the play is used up. Then the force jumps, also after a hold. Neither
// must be reported as a fault.
TEST(Signals, play_is_no_stuck_force) {
  for (bool const holds : {false, true}) {
    Motion motion;
    for (int cycle = 0; cycle < 3; ++cycle)
      for (double const side : {1.0, -1.0}) {
        motion.ramp(0.0, 100.0 * side, 0.5);
        if (holds) motion.hold(100.0 * side, 0.4);
        motion.ramp(100.0 * side, 0.0, 0.5);
      }
    motion.end();
    double middle = 0.0;
    for (double const x : motion.disp_mm) {
      middle = std::clamp(middle, x - 10.0, x + 10.0);
      motion.force_kN.push_back(std::abs(x - middle) >= 10.0 - 1e-9 ? std::copysign(30.0, x - middle) + 0.3 * x : 0.0);
    }
    auto const faults = signal_faults(motion.disp_mm, motion.force_kN, motion.time_s);
    EXPECT_TRUE(faults.empty()) << text_of(faults);
  }
}

TEST(Signals, a_time_gap_does_not_change_the_frequency) {
  for (int const cycles : {2, 3, 5})
    for (double const gap_s : {0.3, 1.0, 30.0})
      for (std::size_t const after : {130u, 177u, 260u}) {
        auto motion = Motion().sine(100.0, 0.5, cycles).end().loop();
        for (auto i = after; i < motion.time_s.size(); ++i) motion.time_s[i] += gap_s;
        auto const properties = motion.properties();
        ASSERT_EQ(properties.blocks.size(), 1u) << cycles << ", " << gap_s << ", " << after;
        EXPECT_EQ(properties.blocks.front().counted().size(), static_cast<std::size_t>(cycles));
        EXPECT_NEAR(*properties.blocks.front().frequency_Hz, 0.5, 0.005);
      }
}

// The slow block has as many samples a cycle as the fast block, at longer intervals. Its intervals must not count as
// gaps in time.
TEST(Signals, a_slow_part_with_as_many_samples_a_cycle_has_its_own_frequency) {
  auto motion = Motion().sine(50.0, 0.5, 8).sine(100.0, 0.5, 4).end().loop();
  std::size_t const slow = 8 * 200;
  double const from = motion.time_s[slow];
  for (auto i = slow; i < motion.time_s.size(); ++i) motion.time_s[i] = from + 25.0 * (motion.time_s[i] - from);
  auto const properties = motion.properties();
  ASSERT_EQ(properties.blocks.size(), 2u);
  EXPECT_NEAR(*properties.blocks[0].frequency_Hz, 0.5, 0.005);
  EXPECT_NEAR(*properties.blocks[1].frequency_Hz, 0.02, 0.0002);
  EXPECT_TRUE(time_gaps(motion.disp_mm, motion.time_s).empty());
}

// 55 samples at a peak are missing, so the time jumps there. This cycle is not counted, but it must keep its number:
// the rest of it must not be taken for a pre-load or for cycles of growing amplitude.
TEST(Signals, a_time_gap_over_a_peak_leaves_the_cycles_their_numbers) {
  for (std::size_t const first : {25u, 225u, 325u}) {
    auto motion = Motion().sine(100.0, 0.5, 5).end().loop();
    auto const cut = [&](std::vector<double>& x) {
      x.erase(x.begin() + static_cast<std::ptrdiff_t>(first), x.begin() + static_cast<std::ptrdiff_t>(first) + 55);
    };
    cut(motion.time_s), cut(motion.disp_mm), cut(motion.force_kN);
    auto const segmentation = motion.cut();
    ASSERT_EQ(segmentation.cycles.size(), 5u) << first;
    auto const& with_gap = segmentation.cycles[first / 200];
    EXPECT_NE(with_gap.not_counted.find("the time jumps within it"), std::string::npos) << with_gap.not_counted;
    EXPECT_EQ(counted_per_block(segmentation), std::vector<int>{4}) << first;
  }
}

TEST(Signals, energy_given_back_refuses) {
  auto motion = Motion().sine(100.0, 0.5, 3).end().loop();
  for (std::size_t i = 0; i < motion.force_kN.size(); ++i)
    motion.force_kN[i] = 2.0 * 0.5 * motion.disp_mm[i] - motion.force_kN[i];
  auto const properties = motion.properties();
  EXPECT_FALSE(properties.reported);
  EXPECT_NE(text_of(properties.refusal).find("gives back"), std::string::npos) << text_of(properties.refusal);
}

// --- plateaus without noise ---

// Describes four cycles of 20 mm at 1 Hz. `step` returns the next force from the last force, the displacement since
// then and the travel since the last turn.
struct Exact {
  int samples = 200;
  bool triangle = false;
  double hold = 0.0;  // the triangle is cut off at 1 / (1 + hold) of its height
  std::function<double(double force, double way, double back)> step;
};

Motion exact(Exact const& of) {
  Motion motion;
  motion.dt_s = 1.0 / of.samples;
  double force = 0.0, before = 0.0, back = 0.0, direction = 0.0;
  for (int i = 0; i <= 4 * of.samples; ++i) {
    double const phase = static_cast<double>(i % of.samples) / of.samples;
    double const triangle = phase < 0.25 ? 4.0 * phase : phase < 0.75 ? 2.0 - 4.0 * phase : 4.0 * phase - 4.0;
    double const x =
        20.0 * (of.triangle ? std::clamp((1.0 + of.hold) * triangle, -1.0, 1.0) : std::sin(2.0 * pi * phase));
    double const way = x - before;
    if (way * direction < 0.0) back = 0.0;
    if (way != 0.0) direction = way;
    back += std::abs(way);
    before = x;
    force = of.step(force, way, back);
    motion.add(x);
    motion.force_kN.push_back(std::round(1e4 * force) / 1e4);
  }
  return motion;
}

std::vector<SignalFault> faults_of(Motion const& motion) {
  return signal_faults(motion.disp_mm, motion.force_kN, motion.time_s);
}

// The force of this soft device stays constant once it reaches a limit, and falls at once when the motion turns. A
// clipped channel would instead stay at its level until the true force has fallen below it.
double soft_then_flat(double force, double way, double back, double lower, double upper) {
  bool const unloads = force * way < 0.0 && back < 1.0;
  return std::clamp(force + (unloads ? 10.0 : 1.0) * way, lower, upper);
}

TEST(Plateaus, a_force_that_turns_with_the_motion_is_not_clipped) {
  for (int const samples : {100, 200, 500})
    for (double const lower : {-8.0, samples == 200 ? -1e9 : -8.0}) {
      auto const motion = exact({.samples = samples, .step = [&](double force, double way, double back) {
                                   return soft_then_flat(force, way, back, lower, 8.0);
                                 }});
      auto const faults = faults_of(motion);
      EXPECT_TRUE(faults.empty()) << samples << ", " << lower << text_of(faults);
    }
  auto const properties = exact({.step = [](double force, double way, double back) {
                            return soft_then_flat(force, way, back, -8.0, 8.0);
                          }}).properties();
  EXPECT_NEAR(properties.reported->K_eff_kN_per_mm, 0.4, 1e-9);
  EXPECT_NEAR(properties.reported->damping_percent, 57.7, 0.2);
}

double bilinear_step(double force, double way, double& yielding) {
  double const before = yielding;
  yielding = std::clamp(yielding + 4.5 * way, -4.0, 4.0);
  return force + 0.5 * way + yielding - before;
}

TEST(Plateaus, of_a_clipped_sensor_are_found_on_one_side_or_both) {
  for (int const samples : {50, 100, 200, 500})
    for (double const level : {0.9, 0.7})
      for (bool const both : {true, false}) {
        double yielding = 0.0;
        auto motion = exact({.samples = samples, .step = [&](double force, double way, double) {
                               return bilinear_step(force, way, yielding);
                             }});
        double const top = *std::ranges::max_element(motion.force_kN);
        for (double& F : motion.force_kN) F = std::clamp(F, both ? -level * top : -1e9, level * top);
        EXPECT_TRUE(names(faults_of(motion), "force", FaultKind::clipped)) << samples << ", " << level << ", " << both;
      }
}

// No fault must be reported for a device with a gap, which has no force within it, for a coarse digitiser, which
// repeats values, and for a rig that holds a triangle at its peaks.
TEST(Plateaus, of_a_gap_a_hold_or_a_digitiser_are_no_fault) {
  for (int const samples : {50, 100, 200, 500}) {
    auto gap = exact({.samples = samples, .step = [](double, double, double) { return 0.0; }});
    for (std::size_t i = 0; i < gap.disp_mm.size(); ++i) {
      double const x = gap.disp_mm[i], over = std::max(0.0, std::abs(x) - 8.0), most = 12.0;
      bool const comes_back = i > 0 && std::abs(x) < std::abs(gap.disp_mm[i - 1]);
      gap.force_kN[i] = std::round(1e4 * std::copysign(comes_back ? over * over / most : over, x)) / 1e4;
    }
    EXPECT_TRUE(faults_of(gap).empty()) << samples << text_of(faults_of(gap));
    for (double const hold : {0.0, 0.1})
      for (double const step_kN : {1e-4, 0.1, 0.5}) {
        double yielding = 0.0;
        auto motion =
            exact({.samples = samples, .triangle = true, .hold = hold, .step = [&](double force, double way, double) {
                     return bilinear_step(force, way, yielding);
                   }});
        for (double& F : motion.force_kN) F = step_kN * std::round(F / step_kN);
        EXPECT_TRUE(faults_of(motion).empty())
            << samples << ", " << hold << ", " << step_kN << text_of(faults_of(motion));
      }
  }
}

// The range of this converter is -12 to 12 kN. Above 12 kN it goes on from -12 kN.
TEST(Plateaus, a_force_that_wraps_around_is_found) {
  for (int const samples : {50, 100, 200, 500}) {
    double yielding = 0.0;
    auto motion = exact({.samples = samples, .step = [&](double force, double way, double) {
                           return bilinear_step(force, way, yielding);
                         }});
    EXPECT_TRUE(faults_of(motion).empty()) << text_of(faults_of(motion));
    for (double& F : motion.force_kN)
      if (F > 12.0) F -= 24.0;
    auto const faults = faults_of(motion);
    EXPECT_TRUE(names(faults, "force", FaultKind::wrapped)) << samples << text_of(faults);
  }
}

// The force of a slider jumps where the motion turns. If the force comes some samples late, it jumps within the motion.
TEST(Plateaus, a_late_force_of_friction_does_not_wrap) {
  for (int const samples : {50, 100, 200, 500})
    for (bool const triangle : {false, true})
      for (std::size_t const late : {2u, 4u, 6u}) {
        auto motion = exact({.samples = samples, .triangle = triangle, .step = [](double, double way, double) {
                               return way > 0.0 ? 50.0 : -50.0;
                             }});
        for (std::size_t i = 0; i < motion.force_kN.size(); ++i) motion.force_kN[i] += 0.02 * motion.disp_mm[i];
        std::rotate(motion.force_kN.begin(), motion.force_kN.end() - static_cast<std::ptrdiff_t>(late),
                    motion.force_kN.end());
        auto const faults = faults_of(motion);
        EXPECT_FALSE(names(faults, "force", FaultKind::wrapped))
            << samples << ", " << triangle << ", " << late << text_of(faults);
      }
}

// In three cycles, for 3 to 10 samples where the force is steep, the logger repeats the last force or writes 0.
TEST(Plateaus, of_a_dropout_that_is_held_are_found) {
  for (int const samples : {50, 100, 200})
    for (std::size_t const length : {3u, 5u, 10u})
      for (bool const held : {true, false}) {
        double yielding = 0.0;
        auto motion = exact({.samples = samples, .step = [&](double force, double way, double) {
                               return bilinear_step(force, way, yielding);
                             }});
        for (double const cycle : {1.12, 2.12, 3.12}) {
          auto const first = static_cast<std::size_t>(samples * cycle);
          double const value = held ? motion.force_kN[first - 1] : 0.0;
          std::fill_n(motion.force_kN.begin() + static_cast<std::ptrdiff_t>(first), length, value);
        }
        auto const faults = faults_of(motion);
        EXPECT_TRUE(names(faults, "force", FaultKind::stuck) || names(faults, "force", FaultKind::dropout))
            << samples << ", " << length << ", " << held << text_of(faults);
      }
}

}  // namespace
}  // namespace isolaw::data::testing
