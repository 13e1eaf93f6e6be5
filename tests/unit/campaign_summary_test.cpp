// Tests the numbers of the report on made-up runs of a campaign, whose statistics are worked out by hand.
#include "finding_text.hpp"
#include "isolaw/study/build_summary.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "campaign_fixture.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::study {
namespace {

using campaign::Contents;
using campaign::Outcome;
using campaign::Run;

// Returns three cycles of ±100 mm with the force of a bilinear device: K1 = 1.5 and K2 = 0.6 kN/mm, xy = 20 mm.
data::FitRecord record() {
  data::FitRecord r;
  for (int i = 0; i <= 600; ++i) {
    r.time_s.push_back(0.01 * i);
    r.disp_mm.push_back(100.0 * std::sin(std::numbers::pi * 0.01 * i));
    r.vel_mm_s.push_back(100.0 * std::numbers::pi * std::cos(std::numbers::pi * 0.01 * i));
    r.force_kN.push_back(static_cast<double>(i));  // a placeholder for the law's force, which is set below
  }
  fit::LawOnRecord const model(laws::find_law("bilinear"), r, laws::Integration::converged);
  r.force_kN = model.force_kN(std::vector{1.5, 0.6, 20.0});
  return r;
}

campaign::Device device(std::string name) {
  campaign::Device d;
  d.name = std::move(name);
  d.file = d.name + ".csv";
  d.raw.file = d.file;
  d.raw.sha256 = "abc";
  d.record = record();
  d.raw.time_s = d.record.time_s;
  d.raw.disp_mm = d.record.disp_mm;
  d.raw.force_kN = d.record.force_kN;
  return d;
}

fit::SearchParameter parameter(std::string name, double lower, double upper) {
  return {.name = std::move(name), .unit = "kN/mm", .free = true, .value = 0.0, .lower = lower, .upper = upper};
}

campaign::Search bilinear_search(std::size_t device_index) {
  campaign::Search search{.device = device_index, .law = "bilinear", .refusal = "", .box = {}};
  search.box.parameters = {parameter("K1", 1.0, 2.0), parameter("K2", 0.35, 0.95), parameter("xy", 10.0, 80.0)};
  search.first_box = search.box;
  return search;
}

Run run(std::size_t device_index, std::string law, int number, double objective, std::vector<double> parameters) {
  return {.device = device_index,
          .law = std::move(law),
          .number = number,
          .outcome = Outcome::all_generations,
          .objective = objective,
          .integration_shift = 1e-6 * number,
          .evaluations = 100,
          .failed_evaluations = 0,
          .failure = {},
          .parameters = std::move(parameters),
          .history = {1.0, objective}};
}

Run failed(std::size_t device, std::string law, int number) {
  return campaign::testing::failed_run(device, std::move(law), number,
                                       "none of the first 100 parameter sets gave a finite force");
}

// The objectives are 0.1, 0.2, 0.3 for device A and 0.3, 0.5, 0.7 for device B. The mean K1 over the runs is 1.2 for A
// and 1.8 for B, which is -20 % and +20 % of their mean 1.5. The mean K2 is 0.5 and 0.6, which is -1/11 and +1/11 of
// 0.55. The mean xy is 40 for both.
Contents two_devices() {
  Contents c;
  c.title = "by hand";
  c.settings.laws = {"bilinear"};
  c.settings.runs = 3;
  c.settings.seed = 5;
  c.devices = {device("A"), device("B")};
  c.searches = {bilinear_search(0), bilinear_search(1)};
  c.runs = {run(0, "bilinear", 1, 0.2, {1.2, 0.5, 40.0}),     run(0, "bilinear", 2, 0.1, {1.0005, 0.45, 41.0}),
            run(0, "bilinear", 3, 0.3, {1.3995, 0.55, 39.0}), run(1, "bilinear", 1, 0.3, {1.65, 0.66, 20.0}),
            run(1, "bilinear", 2, 0.5, {1.8, 0.6, 40.0}),     run(1, "bilinear", 3, 0.7, {1.95, 0.54, 60.0})};
  return c;
}

TEST(Summary, HoldsWhatTheCampaignIs) {
  auto contents = two_devices();
  contents.devices[1].info = {.serial = "s",
                              .lot = "l",
                              .test_date = "d",
                              .temperature_C = 1.0,
                              .rubber_thickness_mm = 2.0,
                              .rubber_area_mm2 = 3.0};
  auto const summary = build_summary(contents);
  EXPECT_EQ(summary.title, "by hand");
  EXPECT_EQ(summary.seed, 5u);
  EXPECT_FALSE(summary.version.empty());
  // A summary lists the seed apart from the other settings.
  EXPECT_EQ(summary.settings.size() + 1, to_pairs(contents.settings).size());
  ASSERT_EQ(summary.devices.size(), 2u);
  EXPECT_EQ(summary.devices[1].name, "B");
  EXPECT_EQ(summary.devices[1].file, "B.csv");
  EXPECT_EQ(summary.devices[1].sha256, "abc");
  EXPECT_EQ(summary.devices[1].status, "ok");
  EXPECT_EQ(summary.devices[1].serial, "s");
  EXPECT_EQ(summary.devices[1].rubber_area_mm2, 3.0);
  ASSERT_TRUE(summary.devices[1].properties.reported);
  EXPECT_NEAR(summary.devices[1].properties.reported->K_eff_kN_per_mm, 0.6 + 0.9 * 20.0 / 100.0, 1e-9);
  ASSERT_EQ(summary.laws.size(), 1u);
  EXPECT_EQ(summary.laws[0].id, "bilinear");
}

TEST(Summary, StatisticsOverRuns) {
  auto const summary = build_summary(two_devices());
  auto const& fits = summary.laws[0].devices;
  ASSERT_EQ(fits.size(), 2u);
  EXPECT_EQ(fits[0].device, "A");
  EXPECT_NEAR(*fits[0].objective.mean, 0.2, 1e-15);
  EXPECT_NEAR(*fits[0].objective.std, 0.1, 1e-15);  // sample standard deviation sqrt((0.01 + 0 + 0.01) / 2)
  EXPECT_EQ(*fits[0].objective.best, 0.1);
  EXPECT_NEAR(*fits[1].objective.mean, 0.5, 1e-15);
  EXPECT_NEAR(*fits[1].objective.std, 0.2, 1e-15);
  EXPECT_EQ(*fits[1].objective.best, 0.3);
  auto const& K1 = fits[0].parameters[0];
  EXPECT_EQ(K1.name, "K1");
  EXPECT_NEAR(*K1.value.mean, 1.2, 1e-15);
  EXPECT_NEAR(*K1.value.std, std::sqrt(2 * 0.1995 * 0.1995 / 2), 1e-15);
  EXPECT_EQ(*K1.value.best, 1.0005);  // K1 in the run with the least objective
  EXPECT_EQ(*fits[1].parameters[2].value.best, 20.0);
  EXPECT_NEAR(*fits[1].parameters[2].value.std, 20.0, 1e-13);
  EXPECT_EQ(fits[0].runs, 3);
  EXPECT_EQ(fits[0].failed_runs, 0);
  ASSERT_EQ(fits[0].histories.size(), 3u);
  EXPECT_EQ(fits[0].histories[1], (std::vector{1.0, 0.1}));
  EXPECT_EQ(*fits[0].integration_shift, 2e-6);  // from the second run, which has the least objective
}

TEST(Summary, StatisticsOverTheLot) {
  auto const summary = build_summary(two_devices());
  auto const& law = summary.laws[0];
  EXPECT_NEAR(*law.objective.mean, 0.35, 1e-15);
  EXPECT_EQ(*law.objective.best, 0.1);
  ASSERT_TRUE(law.beta) << law.beta_note;
  EXPECT_NEAR(*law.beta, (0.2 + 1.0 / 11.0 + 0.0) / 3.0, 1e-14);
  EXPECT_EQ(law.beta_note, "");
  EXPECT_NEAR(*law.devices[0].parameters[0].percent_of_lot, -20.0, 1e-12);
  EXPECT_NEAR(*law.devices[1].parameters[0].percent_of_lot, 20.0, 1e-12);
  EXPECT_NEAR(*law.devices[0].parameters[1].percent_of_lot, -100.0 / 11.0, 1e-12);
  EXPECT_NEAR(*law.devices[1].parameters[2].percent_of_lot, 0.0, 1e-12);
  EXPECT_TRUE(law.on_front);  // there is no other law
}

TEST(Summary, TheMeanOfALawIsTheMeanOfItsDevicesMeans) {
  auto contents = two_devices();
  contents.runs.erase(contents.runs.begin() + 5);  // B keeps the objectives 0.3 and 0.5, whose mean is 0.4
  auto const summary = build_summary(contents);
  // The mean of the devices' means 0.2 and 0.4 is 0.3. The mean of all runs would be 1.4 / 5 = 0.28.
  EXPECT_NEAR(*summary.laws[0].objective.mean, 0.3, 1e-15);
  EXPECT_EQ(summary.laws[0].devices[1].runs, 2);
}

TEST(Summary, AtBoundIsThatOfTheBestRun) {
  auto contents = two_devices();
  auto summary = build_summary(contents);
  EXPECT_EQ(summary.laws[0].devices[0].parameters[0].at_bound, fit::AtBound::lower);  // 1.0005 in the box [1, 2]
  EXPECT_EQ(summary.laws[0].devices[0].parameters[1].at_bound, fit::AtBound::no);
  contents.runs[1].parameters = {1.002, 0.9498, 41.0};
  summary = build_summary(contents);
  EXPECT_EQ(summary.laws[0].devices[0].parameters[0].at_bound, fit::AtBound::no);
  EXPECT_EQ(summary.laws[0].devices[0].parameters[1].at_bound, fit::AtBound::upper);
  // Only the box of device A is changed, so K2 of device A is no longer at a bound.
  contents.searches[0].box.parameters[1].upper = 2.0;
  EXPECT_EQ(build_summary(contents).laws[0].devices[0].parameters[1].at_bound, fit::AtBound::no);
  // K1 of the first run lies at the lower end of its box. Only the best run is judged, and that is the second.
  contents.runs[0].parameters = {1.0, 0.35, 10.0};
  EXPECT_EQ(build_summary(contents).laws[0].devices[0].parameters[0].at_bound, fit::AtBound::no);
}

TEST(Summary, ErrorsOfTheBestFitAgainstTheRecord) {
  auto contents = two_devices();
  // The best run of B has 1.1 times the record's K1 and K2 and the same yield displacement, so 1.1 times its force.
  auto summary = build_summary(contents);
  auto const& fit = summary.laws[0].devices[1];
  EXPECT_NEAR(*fit.K_eff_error_percent, 10.0, 1e-9);
  EXPECT_NEAR(*fit.energy_error_percent, 10.0, 1e-9);
  EXPECT_NEAR(*fit.damping_error_percent, 0.0, 1e-9);
  ASSERT_EQ(fit.force_kN.size(), 601u);
  for (std::size_t i = 0; i < 601; i += 50)
    EXPECT_NEAR(fit.force_kN[i], 1.1 * contents.devices[1].record.force_kN[i], 1e-12);
  // The best run has the record's stiffnesses and twice its characteristic strength: (1.5 - 0.6) 40 = 36 kN, not 18 kN.
  contents.runs[3].parameters = {1.5, 0.6, 40.0};
  summary = build_summary(contents);
  double const K_eff = 100.0 * ((0.6 + 0.36) / (0.6 + 0.18) - 1.0),
               energy = 100.0 * (36.0 * 60.0 / (18.0 * 80.0) - 1.0);
  EXPECT_NEAR(*summary.laws[0].devices[1].K_eff_error_percent, K_eff, 1e-6);
  // The samples slightly miss the yield points, so the energy is not exact.
  EXPECT_NEAR(*summary.laws[0].devices[1].energy_error_percent, energy, 0.1);
  EXPECT_NEAR(*summary.laws[0].devices[1].damping_error_percent, 100.0 * ((1 + energy / 100) / (1 + K_eff / 100) - 1),
              0.1);
}

TEST(Summary, OneDeviceHasNoBeta) {
  auto contents = two_devices();
  contents.devices.pop_back();
  contents.searches.pop_back();
  contents.runs.resize(3);
  auto const summary = build_summary(contents);
  EXPECT_FALSE(summary.laws[0].beta);
  EXPECT_NE(summary.laws[0].beta_note, "");
  EXPECT_FALSE(summary.laws[0].on_front);
  EXPECT_NEAR(*summary.laws[0].objective.mean, 0.2, 1e-15);
}

TEST(Summary, OneRunHasNoStandardDeviation) {
  auto contents = two_devices();
  contents.runs = {contents.runs[0], contents.runs[3]};
  auto const summary = build_summary(contents);
  EXPECT_EQ(*summary.laws[0].devices[0].objective.mean, 0.2);
  EXPECT_FALSE(summary.laws[0].devices[0].objective.std);
  EXPECT_FALSE(summary.laws[0].devices[0].parameters[0].value.std);
  EXPECT_TRUE(summary.laws[0].beta);
}

TEST(Summary, AMeanNearZeroLeavesBetaUndefinedAndSaysWhich) {
  auto contents = two_devices();
  for (auto& r : contents.runs) r.parameters[1] = r.device == 0 ? 0.5 : -0.5;
  auto const summary = build_summary(contents);
  EXPECT_FALSE(summary.laws[0].beta);
  EXPECT_NE(summary.laws[0].beta_note.find("K2"), std::string::npos) << summary.laws[0].beta_note;
  EXPECT_EQ(summary.laws[0].beta_note.find("K1"), std::string::npos) << summary.laws[0].beta_note;
  EXPECT_FALSE(summary.laws[0].devices[0].parameters[1].percent_of_lot);
  EXPECT_TRUE(summary.laws[0].devices[0].parameters[0].percent_of_lot);
}

TEST(Summary, FixedParametersTakeNoPartInBeta) {
  auto contents = two_devices();
  for (auto& search : contents.searches) search.box.parameters[2].free = false;
  auto const summary = build_summary(contents);
  EXPECT_NEAR(*summary.laws[0].beta, (0.2 + 1.0 / 11.0) / 2.0, 1e-14);
  EXPECT_FALSE(summary.laws[0].devices[0].parameters[2].free);
  EXPECT_EQ(summary.laws[0].devices[0].parameters[2].at_bound, fit::AtBound::no);
}

TEST(Summary, FailedRunsAreCountedAndTakeNoPart) {
  auto contents = two_devices();
  contents.runs[1] = failed(0, "bilinear", 2);
  auto const fit = build_summary(contents).laws[0].devices[0];
  EXPECT_EQ(fit.runs, 3);
  EXPECT_EQ(fit.failed_runs, 1);
  EXPECT_NE(fit.failure, "");
  EXPECT_NEAR(*fit.objective.mean, 0.25, 1e-15);
  EXPECT_EQ(*fit.objective.best, 0.2);
  EXPECT_NEAR(*fit.parameters[0].value.mean, (1.2 + 1.3995) / 2, 1e-15);
  EXPECT_EQ(fit.histories.size(), 3u);
}

TEST(Summary, ADeviceWhereEveryRunFailedLeavesTheOthersTheirStatistics) {
  auto contents = two_devices();
  contents.devices.insert(contents.devices.begin(), device("first"));
  for (auto& search : contents.searches) ++search.device;
  for (auto& r : contents.runs) ++r.device;
  contents.searches.insert(contents.searches.begin(), bilinear_search(0));
  contents.runs.insert(contents.runs.begin(), failed(0, "bilinear", 1));
  auto const summary = build_summary(contents);
  auto const& law = summary.laws[0];
  ASSERT_EQ(law.devices.size(), 3u);
  EXPECT_EQ(fit_status(law.devices[0]), "failed");
  EXPECT_FALSE(law.devices[0].objective.mean);
  EXPECT_FALSE(law.devices[0].K_eff_error_percent);
  EXPECT_NEAR(*law.objective.mean, 0.35, 1e-15);
  EXPECT_NEAR(*law.beta, (0.2 + 1.0 / 11.0) / 3.0, 1e-14);
  EXPECT_NEAR(*law.devices[1].parameters[0].percent_of_lot, -20.0, 1e-12);
  EXPECT_NEAR(*law.devices[2].parameters[0].percent_of_lot, 20.0, 1e-12);
}

TEST(Summary, RefusedDevicesAndLawsAreThereWithTheirReason) {
  auto contents = two_devices();
  campaign::Device bad;
  bad.name = "bad";
  bad.refusal = "bad.csv:7: not a number";
  contents.devices.insert(contents.devices.begin(), bad);
  for (auto& search : contents.searches) ++search.device;
  for (auto& r : contents.runs) ++r.device;
  contents.settings.laws = {"bilinear", "jankowski"};
  contents.searches.push_back({.device = 1, .law = "jankowski", .refusal = "no time channel", .box = {}});
  contents.searches.push_back({.device = 2, .law = "jankowski", .refusal = "no time channel", .box = {}});
  auto const summary = build_summary(contents);
  ASSERT_EQ(summary.devices.size(), 3u);
  EXPECT_EQ(summary.devices[0].status, "refused");
  EXPECT_EQ(summary.devices[0].message, "bad.csv:7: not a number");
  EXPECT_EQ(summary.devices[1].status, "ok");
  ASSERT_EQ(summary.laws.size(), 2u);
  EXPECT_NEAR(*summary.laws[0].objective.mean, 0.35, 1e-15);
  EXPECT_EQ(summary.laws[0].devices[0].device, "A");
  auto const& refused = summary.laws[1];
  ASSERT_EQ(refused.devices.size(), 2u);
  EXPECT_EQ(refused.devices[0].refusal, "no time channel");
  EXPECT_EQ(fit_status(refused.devices[0]), "refused");
  EXPECT_FALSE(refused.objective.mean);
  EXPECT_FALSE(refused.beta);
  EXPECT_NE(refused.beta_note, "");
  EXPECT_FALSE(refused.on_front);
  EXPECT_TRUE(summary.laws[0].on_front);
}

// The four laws have these values of the robustness index beta and of the mean objective: bilinear (0.1, 0.30),
// jankowski (0.2, 0.20), bouc-wen (0.3, 0.25) and vaiana (0.4, 0.10). Jankowski is better than bouc-wen in both
// numbers. Bouc-wen must therefore be the only law that is not on the Pareto front.
TEST(Summary, TheFrontIsThatOfSmallBetaAndSmallObjective) {
  Contents c;
  c.settings.laws = {"vaiana", "bouc-wen", "bilinear", "jankowski"};
  c.settings.runs = 1;
  c.devices = {device("A"), device("B")};
  auto const add = [&](std::string const& law, double beta, double objective) {
    auto const count = laws::find_law(law).parameters.size();
    for (std::size_t d = 0; d < 2; ++d) {
      campaign::Search search{.device = d, .law = law, .refusal = "", .box = {}};
      std::vector<double> values;
      for (auto const& info : laws::find_law(law).parameters) {
        search.box.parameters.push_back(parameter(std::string(info.name), 0.0, 1.0));
        values.push_back(d == 0 ? 0.001 * (1.0 - beta) : 0.001 * (1.0 + beta));
      }
      ASSERT_EQ(values.size(), count);
      c.searches.push_back(search);
      c.runs.push_back(run(d, law, 1, objective, values));
    }
  };
  add("bilinear", 0.1, 0.30);
  add("jankowski", 0.2, 0.20);
  add("bouc-wen", 0.3, 0.25);
  add("vaiana", 0.4, 0.10);
  std::ranges::sort(c.runs, {}, [](campaign::Run const& r) { return std::tie(r.device, r.law, r.number); });
  auto const summary = build_summary(c);
  ASSERT_EQ(summary.laws.size(), 4u);
  EXPECT_EQ(summary.laws[0].id, "vaiana");  // in the order of the settings
  EXPECT_NEAR(*summary.laws[0].beta, 0.4, 1e-12);
  EXPECT_TRUE(summary.laws[0].on_front);
  EXPECT_FALSE(summary.laws[1].on_front);  // bouc-wen, which jankowski dominates
  EXPECT_TRUE(summary.laws[2].on_front);
  EXPECT_TRUE(summary.laws[3].on_front);
}

TEST(Summary, ACampaignWithoutRunsHasNoNumbers) {
  auto contents = two_devices();
  contents.runs.clear();
  auto const summary = build_summary(contents);
  ASSERT_EQ(summary.laws.size(), 1u);
  EXPECT_FALSE(summary.laws[0].objective.mean);
  EXPECT_FALSE(summary.laws[0].objective.best);
  EXPECT_FALSE(summary.laws[0].beta);
  EXPECT_NE(summary.laws[0].beta_note, "");
  EXPECT_FALSE(summary.laws[0].on_front);
  EXPECT_EQ(summary.laws[0].devices[0].runs, 0);
}

// A moving average of 31 samples, at 200 samples per cycle, lowers the peak of a sine by 1 - sin(31 pi/200)/(31
// sin(pi/200)) = 3.9 %.
TEST(Summary, WarnsOfWhatTheMovingAverageTakes) {
  auto const warnings = [](int smooth) {
    Contents contents;
    contents.devices = {device("A")};
    contents.settings.clean.smooth = smooth;
    auto const summary = build_summary(contents);
    std::string all;
    all = text_of(summary.devices[0].raw.warnings);
    return all;
  };
  EXPECT_EQ(warnings(1).find("moving average"), std::string::npos);
  // A moving average of 3 samples lowers the peak by 0.033 %, too little for a warning.
  EXPECT_EQ(warnings(3).find("moving average"), std::string::npos);
  for (auto const* part : {"moving average over 31 samples, of 200 in a cycle, removes 3.9 %",
                           "This affects only the laws", "properties are computed from raw values"})
    EXPECT_NE(warnings(31).find(part), std::string::npos) << warnings(31);
}

}  // namespace
}  // namespace isolaw::study
