// Tests sentences about the same fault in several records. A sentence may give sizes as a range, but it gives each
// sample, time, cycle and block with its device.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "contains.hpp"
#include "isolaw/wording/table.hpp"

namespace isolaw::wording {
namespace {

Finding spike(std::string device, double sample, double time_s, double value_kN, double expected_kN) {
  return {.kind = FindingKind::signal_spike,
          .devices = {std::move(device)},
          .numbers = {{"count", 1.0},
                      {"sample", sample},
                      {"time_s", time_s},
                      {"value_kN", value_kN},
                      {"expected_kN", expected_kN}},
          .words = {{"channel", "force"}, {"unit", "kN"}}};
}

TEST(RecordSentences, OfOneDeviceNameThePlace) {
  EXPECT_EQ(
      sentence(spike("device-01", 151, 1.5, -11.0, -71.0)),
      "device-01: the force has a single-sample spike at 1.5 s (sample 151): +60 kN (to -11 kN). No "
      "properties are computed from such a record; --repair spikes replaces the samples by interpolation between their neighbours.");
}

TEST(RecordSentences, ConvertNumbersToTheReadersUnits) {
  auto const& imperial = find_unit_system("kip-in");
  EXPECT_TRUE(contains(sentence(spike("device-01", 151, 1.5, -11.0, -71.0), imperial),
                       "+13.5 kip (to -2.473 kip)"));  // 60 kN and -11 kN
  Finding const bearings{.kind = FindingKind::displacement_beyond_tests,
                         .law = "bilinear",
                         .numbers = {{"most_mm", 254.0}, {"tested_mm", 127.0}}};
  EXPECT_TRUE(contains(sentence(bearings), "up to 254 mm"));
  EXPECT_TRUE(contains(sentence(bearings, imperial), "up to 10.0 in"));
  Finding const range{.kind = FindingKind::laws_disagree,
                      .numbers = {{"count", 2.0},
                                  {"disp_mm", 254.0},
                                  {"K_low_kN_per_mm", 1.0},
                                  {"K_high_kN_per_mm", 2.0},
                                  {"energy_low_kN_mm", 1000.0},
                                  {"energy_high_kN_mm", 2000.0}}};
  EXPECT_TRUE(contains(
      sentence(range, imperial),
      "At 10 in, the 2 best laws have a stiffness of 5.71 to 11.4 kip/in and dissipate 8.85 to 17.7 kip-in in a cycle."))
      << sentence(range, imperial);
}

// Three devices have a spike of +60 kN, each at another sample. The one sentence about them must state the sample and
// the value for each device, and no range of samples.
TEST(RecordSentences, SpikesOfSeveralDevicesKeepTheirSamplesAndValues) {
  auto const said = sentences({spike("device-01", 151, 1.5, -11.0, -71.0), spike("device-02", 421, 4.2, 742.0, 682.0),
                               spike("device-03", 301, 3.0, 120.0, 60.0)});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(said[0].starts_with("device-01, device-02 and device-03: the force has single-sample spikes: "))
      << said[0];
  for (auto const* part :
       {"+60 kN (to -11 kN) at 1.5 s (sample 151) on device-01",
        "+60 kN (to 742 kN) at 4.2 s (sample 421) on device-02", "+60 kN (to 120 kN) at 3 s (sample 301) on device-03"})
    EXPECT_TRUE(contains(said[0], part)) << said[0];
  for (auto const* range : {"151 to 421", "1.5 to 4.2", "-71 to 682"})
    EXPECT_FALSE(contains(said[0], range)) << said[0];
}

TEST(RecordSentences, CyclesAndBlocksStandWithTheirDevice) {
  auto const open = [](std::string device, int block, double cycle, double closure_mm) {
    return Finding{.kind = FindingKind::loop_open,
                   .devices = {std::move(device)},
                   .blocks = {block},
                   .numbers = {{"cycle", cycle},
                               {"closure_mm", closure_mm},
                               {"percent", closure_mm},
                               {"limit_percent", 1.0},
                               {"energy_kN_mm", 10.0 * closure_mm}}};
  };
  auto const said = sentences({open("a", 1, 3, 2.5), open("b", 4, 5, 4.5)});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(contains(said[0],
                       "cycle 3 of block 1 ends 2.5 mm from where it starts on a and cycle 5 of block 4 ends "
                       "4.5 mm from where it starts on b, 2.5 to 4.5 % of the whole travel (limit 1 %)"))
      << said[0];
}

TEST(RecordSentences, OfTwoBlocksOfOneDeviceNameBoth) {
  auto const odd = [](int block, double cycle, double percent) {
    return Finding{.kind = FindingKind::cycle_unlike_neighbours,
                   .devices = {"a"},
                   .blocks = {block},
                   .numbers = {{"percent", percent}, {"cycle", cycle}}};
  };
  auto const said = sentences({odd(1, 3, 48), odd(2, 4, 61)});
  ASSERT_EQ(said.size(), 1u);
  EXPECT_TRUE(contains(said[0], "the peak of cycle 3 of block 1 has 48 % of the force in the cycles beside it"))
      << said[0];
  EXPECT_TRUE(contains(said[0], "the peak of cycle 4 of block 2 has 61 % of the force in the cycles beside it"))
      << said[0];
}

TEST(RecordSentences, PartsOfAHistoryAreNamedAndNotJoined) {
  auto first = spike("a", 3, 0.2, 9.0, 1.0), second = first;
  second.words.push_back({"part", "second.csv"});
  auto const said = sentences({first, second});
  ASSERT_EQ(said.size(), 2u);
  EXPECT_TRUE(said[1].starts_with("a: second.csv: the force has")) << said[1];
}

// No kind of finding may merge the positions of several devices into a range.
TEST(RecordSentences, NoKindMakesARangeOfPositions) {
  struct Place {
    std::string name;
    double first, second;
  };
  std::vector<Place> const places{{"sample", 11111, 22222},
                                  {"time_s", 333.33, 444.44},
                                  {"cycle", 5555, 6666},
                                  {"first_s", 1234, 2345},
                                  {"last_s", 3456, 4567}};
  for (auto const& row : rows()) {
    if (row.topic != "record") continue;
    Finding a{.kind = row.kind, .devices = {"a"}, .blocks = {7777}, .numbers = {{"count", 1.0}}}, b = a;
    a.words = b.words = {{"unit", "kN"}, {"channel", "force"}, {"text", "x"}, {"of", "sine"}};
    b.devices = {"b"};
    b.blocks = {8888};
    for (auto const& [name, first, second] : places) {
      a.numbers.push_back({name, first});
      b.numbers.push_back({name, second});
    }
    std::vector<Finding> const both{a, b};
    auto const text = remark(both);
    auto const expect_apart = [&](std::string const& one, std::string const& other) {
      EXPECT_FALSE(contains(text, one + " to " + other)) << row.key << ": " << text;
      if ((row.appearance & in_report) == 0) return;
      EXPECT_EQ(contains(text, one), contains(text, other)) << row.key << ": " << text;
    };
    for (auto const& [name, first, second] : places) expect_apart(fmt::format("{}", first), fmt::format("{}", second));
    expect_apart("7777", "8888");
  }
}

// A sentence about several devices must have a part for each device, and each part must be complete when read alone.
TEST(RecordSentences, PartsOfSeveralDevicesStandForThemselves) {
  auto const odd = [](std::string device, int block, double percent) {
    return Finding{.kind = FindingKind::cycle_unlike_neighbours,
                   .devices = {std::move(device)},
                   .blocks = {block},
                   .numbers = {{"percent", percent}, {"cycle", 4.0}}};
  };
  auto const unlike = sentences({odd("a", 1, 9.48), odd("b", 2, 61)});
  ASSERT_EQ(unlike.size(), 1u);
  EXPECT_TRUE(contains(unlike[0],
                       "the peak of cycle 4 of block 1 has 9.48 % of the force in the cycles beside it on a and the "
                       "peak of cycle 4 of block 2 has 61 % of the force in the cycles beside it on b. A channel"))
      << unlike[0];
  auto const jump = [](std::string device, double count) {
    return Finding{
        .kind = FindingKind::time_jumps,
        .devices = {std::move(device)},
        .numbers = {{"count", count}, {"length_s", 2.0}, {"sample", 9.0}, {"time_s", 3.0}, {"taken_s", 0.1}}};
  };
  auto const jumps = sentences({jump("a", 1), jump("b", 3)});
  ASSERT_EQ(jumps.size(), 1u);
  EXPECT_TRUE(contains(jumps[0], "time jumps: 1 jump of up to 2 s")) << jumps[0];
  EXPECT_TRUE(contains(jumps[0], "of that as motion on a and 3 jumps of up to 2 s")) << jumps[0];
}

// If a channel is clipped at both of its ends, one sentence says so, and what follows from the clipping is said once.
TEST(RecordSentences, ReasonsOfOneKindAreOneSentence) {
  auto const clipped = [](double level) {
    return Finding{.kind = FindingKind::signal_clipped,
                   .numbers = {{"level_kN", level}, {"longest_samples", 33.0}, {"count", 1.0}, {"sample", 25.0}},
                   .words = {{"channel", "force"}, {"unit", "kN"}}};
  };
  auto const said = reasons({clipped(100), clipped(-100)});
  EXPECT_TRUE(contains(said, "clipped at 100 kN for up to 33 samples from sample 25 and at -100 kN")) << said;
  EXPECT_EQ(said.find("Whatever is computed"), said.rfind("Whatever is computed")) << said;
}

}  // namespace
}  // namespace isolaw::wording
