#include "isolaw/campaign/profile.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "isolaw/base/processor_time.hpp"
#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "unit/campaign_fixture.hpp"

namespace isolaw::campaign {
namespace {

class ProfileOfCampaign : public testing::Folder {
 protected:
  Lot lot(std::string laws, bool analysis) const {
    Lot lot_of_two;
    lot_of_two.settings.laws = parse_laws(laws);
    lot_of_two.settings.analysis = analysis;
    lot_of_two.settings.replicates = 40;
    lot_of_two.settings.complete();
    lot_of_two.devices = {testing::device_input("soft", {write("soft.csv", testing::record_text(1.0))}),
                          testing::device_input("stiff", {write("stiff.csv", testing::record_text(1.3))})};
    return lot_of_two;
  }
  Contents run_with(Profile* profile, Lot const& of, int jobs) const {
    auto contents = prepare(of);
    std::filesystem::remove(file());
    Store::create(file(), contents);
    EXPECT_TRUE(run(contents, file(), {.jobs = jobs, .progress = {}, .interrupted = {}, .profile = profile}));
    return contents;
  }
  std::filesystem::path file() const { return folder / "campaign.sqlite"; }
};

double sum_of(Profile const& profile, double PhaseCost::*what) {
  return std::accumulate(phases.begin(), phases.end(), 0.0,
                         [&](double sum, Phase phase) { return sum + profile[phase].*what; });
}

TEST(ProfileTest, TimeThatGoesByIsSharedByProcessorTimeSinceTheMarkBefore) {
  Profile profile;
  profile.add(Phase::determination, {.cpu_s = 100.0});
  profile.mark({Phase::read});
  double const read_s = profile[Phase::read].wall_s;
  EXPECT_GE(read_s, 0.0);
  EXPECT_EQ(profile[Phase::determination].wall_s, 0.0);
  profile.add(Phase::determination, {.cpu_s = 3.0});
  profile.add(Phase::intervals, {.cpu_s = 1.0});
  profile.mark({Phase::determination, Phase::intervals});
  EXPECT_GT(profile[Phase::intervals].wall_s, 0.0);
  EXPECT_NEAR(profile[Phase::determination].wall_s, 3.0 * profile[Phase::intervals].wall_s,
              1e-9 * profile[Phase::determination].wall_s);
  EXPECT_EQ(profile[Phase::read].wall_s, read_s);
}

TEST_F(ProfileOfCampaign, EvaluationsOfAPhaseAreThoseThatItsResultsSay) {
  Profile profile;
  auto const contents = run_with(&profile, lot("bilinear,jankowski", true), 2);
  std::uint64_t runs = 0, determination = 0, intervals = 0, lots = 0, left_out = 0;
  for (auto const& run : contents.runs) runs += static_cast<std::uint64_t>(run.evaluations);
  for (auto const& of_device : contents.device_analyses) {
    determination += static_cast<std::uint64_t>(of_device.determination.evaluations);
    intervals += static_cast<std::uint64_t>(of_device.intervals.evaluations);
  }
  for (auto const& of_lot : contents.lot_analyses)
    lots += static_cast<std::uint64_t>(of_lot.mean.evaluations + of_lot.worst.law.evaluations);
  for (auto const& of_others : contents.left_out)
    left_out += static_cast<std::uint64_t>(of_others.left_out.evaluations);
  EXPECT_EQ(profile[Phase::search].evaluations, runs);
  EXPECT_EQ(profile[Phase::determination].evaluations, determination);
  EXPECT_EQ(profile[Phase::intervals].evaluations, intervals);
  EXPECT_EQ(profile[Phase::lot].evaluations, lots);
  EXPECT_EQ(profile[Phase::left_out].evaluations, left_out);
  for (auto const phase : {Phase::search, Phase::determination, Phase::intervals, Phase::lot, Phase::left_out}) {
    EXPECT_GT(profile[phase].evaluations, 0u) << name(phase);
    EXPECT_GT(profile[phase].cpu_s, 0.0) << name(phase);
    EXPECT_GT(profile[phase].wall_s, 0.0) << name(phase);
  }
}

// Compares processor time, since waiting for other processes does not add to it.
TEST_F(ProfileOfCampaign, PhasesAddUpToTheProcessorTimeOfTheProcess) {
  Profile profile;
  auto campaign = lot("jankowski,bouc-wen", true);
  campaign.settings.runs = 1;
  auto contents = prepare(campaign);
  Store::create(file(), contents);
  double const before_s = process_time_s();
  EXPECT_TRUE(run(contents, file(), {.jobs = 2, .progress = {}, .interrupted = {}, .profile = &profile}));
  double const took_s = process_time_s() - before_s;
  EXPECT_NEAR(sum_of(profile, &PhaseCost::cpu_s), took_s, 0.02 * took_s + 0.01);
  EXPECT_GT(sum_of(profile, &PhaseCost::kernel_s), 0.1 * took_s);
  for (auto const phase : phases) EXPECT_LE(profile[phase].kernel_s, profile[phase].cpu_s) << name(phase);
}

TEST_F(ProfileOfCampaign, WhatWasThereCostsNothing) {
  auto contents = run_with(nullptr, lot("bilinear", false), 1);
  Profile profile;
  EXPECT_TRUE(run(contents, file(), {.jobs = 1, .progress = {}, .interrupted = {}, .profile = &profile}));
  EXPECT_EQ(profile[Phase::search].evaluations, 0u);
  EXPECT_EQ(profile[Phase::search].kernel_s, 0.0);
}

}  // namespace
}  // namespace isolaw::campaign
