// --fit-blocks and --fit-cycles choose the part of a test on which laws are scored. The law still runs through the
// whole test.
#include <regex>

#include "cli/loops.hpp"
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"

namespace isolaw::cli_test {
namespace {

constexpr int samples_of_cycle = 200, cycles = 3;
constexpr std::size_t block_samples = samples_of_cycle * cycles;

// Returns three cycles at 60 mm and three at 100 mm of a bilinear device with K1 = 2.5 kN/mm, K2 = 0.5 kN/mm and xy =
// 10 mm. In block `disturbed` (1, 2, or 0 for none) the force is a third larger than the law's.
std::vector<Sample> two_blocks(int disturbed) {
  std::vector<Sample> samples;
  double z = 0.0, before = 0.0;
  for (std::size_t i = 0; i <= 2 * block_samples; ++i) {
    double const amplitude = i < block_samples ? 60.0 : 100.0;
    double const x =
        std::round(1e5 * amplitude * std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / samples_of_cycle)) /
        1e5;
    z = std::clamp(z + x - before, -10.0, 10.0);
    before = x;
    bool const in_block = disturbed == 1 ? i < block_samples : disturbed == 2 && i > block_samples;
    samples.push_back({0.01 * static_cast<double>(i), x, (0.5 * x + 2.0 * z) * (in_block ? 4.0 / 3.0 : 1.0)});
  }
  return samples;
}

// Computes the objective of Eq. (27) between the samples `first` and `last`: the mean absolute difference between the
// measured force and that of the law, divided by the standard deviation of the measured force.
double objective_of(std::vector<Sample> const& measured, std::vector<Sample> const& law, std::size_t first,
                    std::size_t last) {
  double sum = 0.0, mean = 0.0, square = 0.0;
  auto const n = static_cast<double>(last - first + 1);
  for (auto i = first; i <= last; ++i) {
    double const weight = i == first || i == last ? 0.5 : 1.0;
    sum += weight * std::abs(measured[i].force_kN - law[i].force_kN) / (n - 1.0);
    mean += measured[i].force_kN / n;
  }
  for (auto i = first; i <= last; ++i) square += std::pow(measured[i].force_kN - mean, 2) / n;
  return sum / std::sqrt(square);
}

class Scored : public InFreshDirectory {
 protected:
  // Calibrates with all parameters fixed at the device's values, weighed by time unless `more` says otherwise. The
  // result is the objective of the law that made the undisturbed record.
  Json calibrated(Words more, std::string const& file = "one.csv") {
    if (std::ranges::find(more, "--weights") == more.end()) more = more + Words{"--weights", "time"};
    auto const o =
        isolaw(Words{"calibrate", file, "--out", "O", "--fresh", "--laws", "bilinear", "--runs", "1"} +
               Words{"--set", "bilinear.K1=2.5", "--set", "bilinear.K2=0.5", "--set", "bilinear.xy=10"} + more);
    EXPECT_EQ(o.code, 0) << o;
    return json("O/summary.json");
  }
  std::string exported(std::string const& device) {
    auto const o = isolaw({"export", "O", "--law", "bilinear", "--device", device, "--to", "json", "--anyway"});
    EXPECT_EQ(o.code, 0) << o;
    return o.out;
  }
  static double objective(Json const& summary) { return summary["laws"][0]["devices"][0]["objective"]["best"]; }
};

constexpr double exact = 1e-6;  // the forces in the file have five decimals

TEST_F(Scored, only_the_chosen_block_is_judged_and_the_state_comes_from_the_one_before) {
  auto const measured = two_blocks(1), law = two_blocks(0);
  write("one.csv", csv(measured));
  EXPECT_LT(objective(calibrated({"--fit-blocks", "2"})), exact);
  // The law runs through block 1 first and enters block 2 after yielding. If it started block 2 from rest, its first
  // loading would differ from the record.
  EXPECT_LT(objective(calibrated({"--fit-blocks", "2", "--fit-cycles", "1"})), exact);
  double const other = objective_of(measured, law, 0, block_samples);
  EXPECT_GT(other, 0.2);
  EXPECT_NEAR(objective(calibrated({"--fit-blocks", "1"})), other, 1e-4);
  double const all = objective_of(measured, law, 0, 2 * block_samples);
  EXPECT_NEAR(objective(calibrated({})), all, 1e-4);
  EXPECT_NEAR(objective(calibrated({"--fit-blocks", "all", "--fit-cycles", "all"})), all, 1e-4);
  EXPECT_NEAR(objective(calibrated({"--fit-cycles", "3", "--fit-blocks", "1"})),
              objective_of(measured, law, 2 * samples_of_cycle, block_samples), 1e-4);
}

TEST_F(Scored, the_other_way_round) {
  auto const measured = two_blocks(2), law = two_blocks(0);
  write("one.csv", csv(measured));
  EXPECT_LT(objective(calibrated({"--fit-blocks", "1"})), exact);
  EXPECT_NEAR(objective(calibrated({"--fit-blocks", "2-"})),
              objective_of(measured, law, block_samples, 2 * block_samples), 1e-4);
}

TEST_F(Scored, the_search_finds_the_law_of_the_chosen_block) {
  write("one.csv", csv(two_blocks(1)));
  auto const found = [&](std::string const& block) {
    auto const o = isolaw(Words{"calibrate", "one.csv", "--out", "O", "--fresh", "--laws", "bilinear", "--runs", "2"} +
                          Words{"--population", "60", "--generations", "80", "--fit-blocks", block});
    EXPECT_EQ(o.code, 0) << o;
    return json("O/summary.json")["laws"][0]["devices"][0]["parameters"]["K2"]["best"].get<double>();
  };
  EXPECT_NEAR(found("2"), 0.5, 0.02);
  EXPECT_NEAR(found("1"), 2.0 / 3.0, 0.03);
}

TEST_F(Scored, what_was_chosen_is_recorded_and_shown) {
  write("one.csv", csv(two_blocks(1)));
  auto const settings = calibrated({"--fit-blocks", " 2", "--fit-cycles", "2 - 3"})["settings"];
  EXPECT_EQ(settings["fit-blocks"], "2");
  EXPECT_EQ(settings["fit-cycles"], "2-3");
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT json FROM setting WHERE key = 'fit-cycles'").at(0), "\"2-3\"");
  auto const device = page_data(read("O/report.html"))["devices"][0];
  // Cycles 2 and 3 of block 2, which the options choose, last from 8 s to 12 s.
  ASSERT_EQ(device["scored"].size(), 1u);
  EXPECT_NEAR(device["scored"][0]["from"].get<double>(), 8.0, 0.011);
  EXPECT_NEAR(device["scored"][0]["to"].get<double>(), 12.0, 0.011);
  EXPECT_TRUE(contains(device["cleaning"].dump(), "of 1201 samples (blocks 2, cycles 2-3)"));
  EXPECT_TRUE(page_data((calibrated({}), read("O/report.html")))["devices"][0]["scored"].is_null());
  auto const resumed =
      isolaw({"calibrate", "one.csv", "--out", "O", "--laws", "bilinear", "--runs", "1", "--set", "bilinear.K1=2.5",
              "--set", "bilinear.K2=0.5", "--set", "bilinear.xy=10", "--fit-blocks", "2"});
  expect_refused(resumed, {"fit-blocks: all there, 2 now"});
}

// Computes the objective with a weight for each interval between two samples. Each of these two samples gets half of
// the weight.
double weighted_objective(std::vector<Sample> const& measured, std::vector<Sample> const& law,
                          std::vector<double> const& of_interval) {
  std::vector<double> weights(measured.size(), 0.0);
  double total = 0.0, mean = 0.0, sum = 0.0, square = 0.0;
  for (std::size_t i = 0; i < of_interval.size(); ++i) {
    weights[i] += 0.5 * of_interval[i], weights[i + 1] += 0.5 * of_interval[i];
    total += of_interval[i];
  }
  for (std::size_t i = 0; i < measured.size(); ++i) mean += weights[i] / total * measured[i].force_kN;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    sum += weights[i] / total * std::abs(measured[i].force_kN - law[i].force_kN);
    square += weights[i] / total * std::pow(measured[i].force_kN - mean, 2);
  }
  return sum / std::sqrt(square);
}

// With --weights swing, time counts in proportion to the amplitude of the swing in progress; a swing is the way from
// one extreme to the next and takes half a cycle. The quarters of a cycle before the first extreme and after the last
// one count for nothing. The swing from one block to the other goes from -60 to 100 mm, so its amplitude is 80 mm. With
// --weights travel, an interval counts by the distance travelled.
TEST_F(Scored, samples_count_by_swing_or_by_travel_if_asked_for) {
  auto const measured = two_blocks(1), law = two_blocks(0);
  write("one.csv", csv(measured));
  constexpr std::size_t half = samples_of_cycle / 2, quarter = half / 2;
  std::vector<double> by_swing, by_travel;
  for (std::size_t i = 0; i < 2 * block_samples; ++i) {
    bool const outside = i < quarter || i >= 2 * block_samples - quarter;
    by_swing.push_back(outside ? 0.0 : i < block_samples - quarter ? 60.0 : i < block_samples + quarter ? 80.0 : 100.0);
    by_travel.push_back(std::abs(measured[i + 1].disp_mm - measured[i].disp_mm));
  }
  double const by_time = objective_of(measured, law, 0, 2 * block_samples);
  auto const swing = calibrated({"--weights", "swing"});
  EXPECT_NEAR(objective(swing), weighted_objective(measured, law, by_swing), 1e-4);
  EXPECT_LT(objective(swing), 0.8 * by_time);  // the disturbed cycles are the smaller ones, which count less
  EXPECT_NEAR(swing["laws"][0]["devices"][0]["objective_by_time"].get<double>(), by_time, 1e-4);
  EXPECT_TRUE(contains(page_data(read("O/report.html"))["devices"][0]["cleaning"].dump(), "by swing"));
  EXPECT_TRUE(contains(exported("one"), "samples that count by swing"));
  EXPECT_NEAR(objective(calibrated({"--weights", "travel"})), weighted_objective(measured, law, by_travel), 1e-4);
  EXPECT_TRUE(calibrated({})["laws"][0]["devices"][0]["objective_by_time"].is_null());
  expect_refused(isolaw({"calibrate", "one.csv", "--out", "O", "--laws", "bilinear", "--weights", "travel"}),
                 {"weights: time there, travel now"});
}

TEST_F(Scored, a_motion_without_swings_is_weighed_by_time) {
  std::vector<Sample> pulse;
  for (int i = 0; i <= 400; ++i) {
    double const x = 50.0 * std::pow(std::sin(std::numbers::pi * i / 400.0), 2);
    pulse.push_back({0.01 * i, x, 2.0 * x});
  }
  write("pulse.csv", csv(pulse));
  double const by_time = objective(calibrated({}, "pulse.csv"));
  auto const summary = calibrated({"--weights", "swing"}, "pulse.csv");
  EXPECT_EQ(objective(summary), by_time);
  EXPECT_TRUE(contains(page_data(read("O/report.html"))["devices"][0]["cleaning"].dump(), "no two turning points"));
  EXPECT_FALSE(contains(exported("pulse"), "samples that count by"));
}

// Eight samples of the first block lose their force. The law is fitted to the second block alone, and the page of the
// campaign says which block is faulty.
TEST_F(Scored, a_faulty_block_is_left_out_of_the_fit) {
  auto samples = two_blocks(0);
  for (std::size_t i = 230; i < 238; ++i) samples[i].force_kN = 0.0;
  write("one.csv", csv(samples));
  auto const summary = calibrated({});
  EXPECT_EQ(summary["devices"][0]["status"], "ok");
  EXPECT_LT(objective(summary), exact);
  auto const page = read(fs::path("O") / "report.html");
  EXPECT_TRUE(contains(page, "laws are not fitted to block 1, in which a signal or a loop cannot be true"));
  EXPECT_TRUE(contains(page, "the force drops out"));
  EXPECT_LT(objective(calibrated({"--fit-blocks", "2"})), exact);
  auto const refused = isolaw({"calibrate", "one.csv", "--out", "P", "--laws", "bilinear", "--fit-blocks", "1"});
  EXPECT_EQ(refused.code, 2) << refused;
  EXPECT_TRUE(contains(refused.err, "what is to be fitted is faulty")) << refused;
}

// In the second cycle of the second block the device keeps a twentieth of its force. Laws are fitted to the time
// before.
TEST_F(Scored, a_device_that_fails_is_judged_by_the_time_before) {
  auto samples = two_blocks(0);
  for (std::size_t i = block_samples + samples_of_cycle; i < samples.size(); ++i) samples[i].force_kN *= 0.05;
  write("one.csv", csv(samples));
  auto const summary = calibrated({});
  EXPECT_EQ(summary["devices"][0]["status"], "ok");
  EXPECT_LT(objective(summary), exact);
  auto const page = read(fs::path("O") / "report.html");
  EXPECT_TRUE(contains(page, "laws are fitted to what the device did before cycle 2 of block 2")) << page.size();
  EXPECT_TRUE(contains(page, "the force is suddenly lost"));
}

// No two cycles have the same amplitude, so isolaw must judge the record by its largest swings instead of cycles. The
// force of a spring and a dashpot is F = 2 (x + 0.2 v / w) kN with w = 2 pi / s: the stiffness is 2 kN/mm, and the
// loops are nearly ellipses with a damping of 10 %.
TEST_F(Scored, a_motion_without_cycles_is_judged_by_its_largest_swings) {
  // The half cycles of this record grow until 9 s and shrink afterwards, as in an earthquake. No amplitude comes twice.
  std::vector<Sample> samples;
  for (int i = 0; i <= 1200; ++i) {
    double const t = 0.01 * i, w = 2.0 * std::numbers::pi;
    double const growth = t < 9.0 ? std::log(1.15) / 0.5 : -std::log(1.4) / 0.5;
    double const size = std::exp(std::log(1.15) / 0.5 * 9.0 + growth * (t - 9.0));
    double const x = size * std::sin(w * t), v = size * (w * std::cos(w * t) + growth * std::sin(w * t));
    samples.push_back({t, x, 2.0 * (x + 0.2 * v / w)});
  }
  write("swings.csv", csv(samples));
  auto const inspected = isolaw({"inspect", "swings.csv"});
  EXPECT_TRUE(contains(inspected.out, "the motion is not cyclic")) << inspected;
  EXPECT_TRUE(contains(inspected.out, "the largest swings, with an amplitude of")) << inspected;
  std::smatch found;
  std::regex const note("have a stiffness of ([0-9.]+) kN/mm and a damping of ([0-9.]+) %");
  ASSERT_TRUE(std::regex_search(inspected.out, found, note)) << inspected;
  EXPECT_NEAR(std::stod(found[1]), 2.0, 0.02);  // the turning points lie at samples, a hundred to a cycle
  EXPECT_NEAR(std::stod(found[2]), 10.0, 0.3);
  auto const elastic = isolaw({"calibrate", "swings.csv", "--out", "O", "--fresh", "--laws", "bilinear", "--runs", "1",
                               "--set", "bilinear.K1=2", "--set", "bilinear.K2=2", "--set", "bilinear.xy=10"});
  ASSERT_EQ(elastic.code, 0) << elastic;
  auto const fit = json("O/summary.json")["laws"][0]["devices"][0];
  EXPECT_NEAR(fit["K_eff_error_percent"].get<double>(), 0.0, 1.0);
  EXPECT_NEAR(fit["energy_error_percent"].get<double>(), -100.0, 0.5);
}

TEST_F(Scored, errors_in_properties_are_of_a_cycle_that_was_judged) {
  write("one.csv", csv(two_blocks(1)));
  for (auto const& [block, error] : {std::pair{"2", 0.0}, {"1", -25.0}}) {
    auto const fit = calibrated({"--fit-blocks", block})["laws"][0]["devices"][0];
    EXPECT_NEAR(fit["K_eff_error_percent"].get<double>(), error, 1e-3) << block;
    // The last cycle of block 1 ends with a sample of block 2, where the force is not disturbed. The energy therefore
    // differs a little from the expected one.
    EXPECT_NEAR(fit["energy_error_percent"].get<double>(), error, 0.2) << block;
  }
}

TEST_F(Scored, refused_values_say_what_is_allowed) {
  write("one.csv", csv(two_blocks(1)));
  auto const run = [&](Words const& more) { return isolaw(Words{"calibrate", "one.csv", "--out", "O"} + more); };
  for (std::string const text : {"0", "x", "3-1", "1,,2"})
    expect_refused(run({"--fit-cycles", text}),
                   {"--fit-cycles: '" + text + "'", "all, or numbers from 1 and ranges of them", "3, 2-5, 4-"});
  expect_refused(run({"--fit-blocks", "first"}), {"--fit-blocks: 'first'"});
  expect_refused(run({"--fit-blocks", "3"}), {"--fit-blocks 3 --fit-cycles all", "no cycle of the record",
                                              "block 1: cycles 1 to 3; block 2: cycles 1 to 3", "isolaw inspect"});
  expect_refused(run({"--fit-blocks", "2", "--fit-cycles", "4-"}), {"--fit-blocks 2 --fit-cycles 4-"});
  EXPECT_FALSE(exists("O"));
}

TEST_F(Scored, the_lot_file_has_the_same_keys) {
  write("one.csv", csv(two_blocks(1)));
  auto const lot = [](std::string const& keys) {
    return "[calibrate]\n" + keys + "\n[[device]]\nfile = \"one.csv\"\n";
  };
  write("lot.toml", lot("fit-blocks = \"2\"\nfit-cycles = \"2-\""));
  auto const summary = calibrated({}, "lot.toml");
  EXPECT_EQ(summary["settings"]["fit-blocks"], "2");
  EXPECT_EQ(summary["settings"]["fit-cycles"], "2-");
  EXPECT_LT(objective(summary), exact);
  EXPECT_GT(objective(calibrated({"--fit-blocks", "1"}, "lot.toml")), 0.2) << "the command line wins";
  write("lot.toml", lot("fit-blocks = \"0\"\nfit-cycles = 2"));
  expect_refused(isolaw({"calibrate", "lot.toml", "--out", "P"}),
                 {"lot.toml:2", "'0'", "numbers from 1", "lot.toml:3", "fit-cycles"});
}

}  // namespace
}  // namespace isolaw::cli_test
