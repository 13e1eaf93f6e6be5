#include "isolaw/campaign/estimate.hpp"

#include <gtest/gtest.h>

#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/part_assignment.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "unit/campaign_fixture.hpp"

namespace isolaw::campaign {
namespace {

class ShareOfCampaign : public testing::Folder {
 protected:
  Lot lot(bool analysis) const {
    Lot lot_of_two;
    lot_of_two.settings.laws = parse_laws("bilinear");
    lot_of_two.settings.analysis = analysis;
    lot_of_two.settings.replicates = 0;
    lot_of_two.settings.runs = 3;
    lot_of_two.devices = {testing::device_input("soft", {write("soft.csv", testing::record_text(1.0))}),
                          testing::device_input("stiff", {write("stiff.csv", testing::record_text(1.3))})};
    return lot_of_two;
  }
  std::filesystem::path file() const { return folder / "campaign.sqlite"; }
};

TEST_F(ShareOfCampaign, IsOfRunsAndAnalysesTogether) {
  auto contents = prepare(lot(true));
  Store::create(file(), contents);
  std::vector<Progress> told;
  EXPECT_TRUE(
      run(contents, file(), {.jobs = 1, .progress = [&](Progress const& p) { told.push_back(p); }, .interrupted = {}}));
  // Progress is reported after each of six runs, two device analyses, one fit to the lot and two fits without a device.
  ASSERT_EQ(told.size(), 11u);
  EXPECT_EQ(told[5].done, told[5].total);
  EXPECT_LT(told[5].share, 1.0);
  EXPECT_GT(told[5].left_s, 0.0);
  EXPECT_TRUE(told[6].analysis);
  EXPECT_GT(told[6].share, 0.0);
  EXPECT_EQ(told.back().share, 1.0);
  EXPECT_EQ(told.back().left_s, 0.0);
}

TEST_F(ShareOfCampaign, CountsWhatAnInterruptedCampaignHad) {
  auto contents = prepare(lot(false));
  Store::create(file(), contents);
  bool stop = false;
  EXPECT_FALSE(run(
      contents, file(),
      {.jobs = 1, .progress = [&](Progress const& p) { stop = p.done == 4; }, .interrupted = [&] { return stop; }}));
  ASSERT_EQ(contents.runs.size(), 4u);
  std::vector<double> shares;
  EXPECT_TRUE(run(contents, file(),
                  {.jobs = 1, .progress = [&](Progress const& p) { shares.push_back(p.share); }, .interrupted = {}}));
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_NEAR(shares[0], 5.0 / 6.0, 1e-9);  // five of six equal runs are done
  EXPECT_EQ(shares[1], 1.0);
}

TEST_F(ShareOfCampaign, WeighsATaskByItsLawAndItsKind) {
  auto of = lot(true);
  of.settings.laws = parse_laws("bilinear,abe");
  auto const contents = prepare(of);
  Estimate estimate(contents);
  EXPECT_EQ(estimate.share(), 0.0);
  double all_runs = 0.0;
  for (auto const& search : contents.searches) all_runs += static_cast<double>(relative_cost(contents, search));
  double const abe_to_all = static_cast<double>(relative_cost(contents, contents.searches[1])) / all_runs;
  double const before_s = estimate.work_left_s(TaskKind::run);
  estimate.done(TaskKind::run, "abe");
  // One of the three runs of abe on one device has ended.
  EXPECT_NEAR(1.0 - estimate.work_left_s(TaskKind::run) / before_s, abe_to_all / 3.0, 1e-9);
  double const after_abe = estimate.share();
  estimate.done(TaskKind::run, "bilinear");
  EXPECT_GT(after_abe, 0.0);
  EXPECT_GT(estimate.share(), after_abe);
  EXPECT_LT(estimate.share(), 1.01 * after_abe);
  for (auto const kind : {TaskKind::run, TaskKind::lot, TaskKind::left_out}) estimate.expect_none(kind);
  EXPECT_GT(estimate.left_s(), 0.0);
  estimate.expect_none(TaskKind::device);
  EXPECT_EQ(estimate.left_s(), 0.0);
  EXPECT_EQ(estimate.share(), 1.0);
}

}  // namespace
}  // namespace isolaw::campaign
