#include "isolaw/campaign/estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <queue>
#include <set>
#include <sstream>

#include "isolaw/campaign/campaign.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "unit/campaign_fixture.hpp"

namespace isolaw::campaign {
namespace {

TEST(EstimateTest, WhatWasMeasuredCountsAndThreadsShareTheRest) {
  Estimate estimate(2);
  estimate.expect(TaskKind::run, "a", {.evaluations = 100.0, .evaluation_s = 1.0}, 5, 0);
  EXPECT_EQ(estimate.share(0.0), 0.0);
  EXPECT_DOUBLE_EQ(estimate.left_s(0.0), 250.0);
  auto const first = estimate.begin(TaskKind::run, "a", 10.0);
  EXPECT_EQ(estimate.end(first, 200, 14.0), 4.0);
  EXPECT_DOUBLE_EQ(estimate.share(14.0), 0.2);
  EXPECT_DOUBLE_EQ(estimate.left_s(14.0), 8.0);
}

TEST(EstimateTest, ATaskUnderWayIsPartlyDoneAndOneGivenUpIsNot) {
  Estimate estimate(1);
  estimate.expect(TaskKind::run, "a", {.evaluations = 10.0, .evaluation_s = 1.0}, 3, 0);
  estimate.end(estimate.begin(TaskKind::run, "a", 0.0), 10, 10.0);
  auto const second = estimate.begin(TaskKind::run, "a", 10.0);
  EXPECT_DOUBLE_EQ(estimate.left_s(14.0), 16.0);
  EXPECT_DOUBLE_EQ(estimate.share(14.0), 14.0 / 30.0);
  EXPECT_DOUBLE_EQ(estimate.left_s(100.0), 10.0);  // longer than the others took; nothing is left of it
  estimate.give_up(second);
  EXPECT_DOUBLE_EQ(estimate.left_s(100.0), 20.0);
}

TEST(EstimateTest, OneThatGoesOnForLongerThanIsLikelyIsTheFirstMeasurementOfItsKind) {
  Estimate estimate(1);
  estimate.expect(TaskKind::run, "a", {.evaluations = 10.0, .evaluation_s = 1.0}, 3, 0);
  estimate.begin(TaskKind::run, "a", 0.0);
  EXPECT_DOUBLE_EQ(estimate.left_s(40.0), 80.0);
}

TEST(EstimateTest, WhatWasNotMeasuredGoesByItsLawsSpeedAndItsKindsEvaluations) {
  Estimate estimate(1);
  for (auto const kind : {TaskKind::run, TaskKind::device})
    for (auto const* law : {"a", "b"})
      estimate.expect(kind, law, {.evaluations = kind == TaskKind::run ? 10.0 : 40.0, .evaluation_s = 1.0}, 1, 0);
  // Evaluations take twice as long, which holds for all tasks; there are more of them, which holds for searches alone.
  estimate.end(estimate.begin(TaskKind::run, "a", 0.0), 30, 60.0);
  double const runs = (30.0 + 2.0) / (10.0 + 2.0);  // a tenth of what the group was expected to need is added to both
  EXPECT_DOUBLE_EQ(estimate.left_s(60.0), runs * 10.0 * 2.0 + 2 * 40.0 * 2.0);
  estimate.end(estimate.begin(TaskKind::run, "b", 60.0), 10, 65.0);
  EXPECT_DOUBLE_EQ(estimate.left_s(65.0), 40.0 * 2.0 + 40.0 * 0.5);
  // The analysis took half as many evaluations as expected, so that of the other law may need fewer too.
  estimate.end(estimate.begin(TaskKind::device, "a", 65.0), 20, 105.0);
  EXPECT_DOUBLE_EQ(estimate.left_s(105.0), (20.0 + 8.0) / (40.0 + 8.0) * 40.0 * 0.5);
}

TEST(EstimateTest, PhasesFollowOneAnotherAndNoneIsFasterThanItsLongestTask) {
  Estimate estimate(8);
  estimate.expect(TaskKind::run, "a", {.evaluations = 1.0, .evaluation_s = 1.0}, 16, 0);
  estimate.expect(TaskKind::lot, "a", {.evaluations = 1.0, .evaluation_s = 30.0}, 1, 0);
  estimate.expect(TaskKind::lot, "b", {.evaluations = 1.0, .evaluation_s = 2.0}, 1, 0);
  EXPECT_DOUBLE_EQ(estimate.left_s(0.0), 2.0 + 30.0);
}

TEST(EstimateTest, WhatWasThereBeforeIsDoneWork) {
  Estimate estimate(1);
  estimate.expect(TaskKind::run, "a", {.evaluations = 10.0, .evaluation_s = 1.0}, 1, 3);
  EXPECT_DOUBLE_EQ(estimate.share(0.0), 0.75);
  EXPECT_DOUBLE_EQ(estimate.left_s(0.0), 10.0);
  estimate.end(estimate.begin(TaskKind::run, "a", 0.0), 10, 5.0);
  EXPECT_EQ(estimate.share(5.0), 1.0);
  EXPECT_EQ(estimate.left_s(5.0), 0.0);
}

TEST(EstimateTest, ATaskThatNobodyExpectedIsNoneOfTheWork) {
  Estimate estimate(1);
  estimate.expect(TaskKind::run, "a", {.evaluations = 10.0, .evaluation_s = 1.0}, 1, 0);
  auto const other = estimate.begin(TaskKind::lot, "b", 0.0);
  EXPECT_DOUBLE_EQ(estimate.left_s(5.0), 10.0);
  estimate.end(other, 10, 20.0);
  EXPECT_GT(estimate.left_s(20.0), 0.0);
}

TEST(EstimateTest, TasksThatAreNotToBeDoneAfterAllAreNotWaitedFor) {
  Estimate estimate(1);
  for (auto const* law : {"a", "b"})
    estimate.expect(TaskKind::device, law, {.evaluations = 10.0, .evaluation_s = 1.0}, 4, 0);
  estimate.expect_left(TaskKind::device, {{"b", 2}});
  EXPECT_DOUBLE_EQ(estimate.left_s(0.0), 20.0);
}

class ShareOfCampaign : public testing::Folder {
 protected:
  Lot lot(bool analysis) const {
    Lot made;
    made.settings.laws = parse_laws("bilinear");
    made.settings.analysis = analysis;
    made.settings.replicates = 0;
    made.settings.runs = 3;
    made.devices = {testing::device_input("soft", {write("soft.csv", testing::record_text(1.0))}),
                    testing::device_input("stiff", {write("stiff.csv", testing::record_text(1.3))})};
    return made;
  }
  std::filesystem::path file() const { return folder / "campaign.sqlite"; }
};

TEST_F(ShareOfCampaign, IsOfRunsAndAnalysesTogether) {
  auto contents = prepare(lot(true));
  Store::create(file(), contents);
  std::vector<Progress> told;
  std::map<TaskKind, int> tasks;
  EXPECT_TRUE(run(contents, file(),
                  {.jobs = 1,
                   .progress = [&](Progress const& p) { told.push_back(p); },
                   .interrupted = {},
                   .task_done =
                       [&](TaskCost const& task) {
                         ++tasks[task.kind];
                         EXPECT_EQ(task.law, "bilinear");
                         EXPECT_GT(task.evaluations, 0);
                         EXPECT_GT(task.seconds, 0.0);
                       }}));
  ASSERT_EQ(told.size(), 11u);  // six runs, two devices, one law for the lot, and two with a device left out
  EXPECT_EQ(tasks, (std::map<TaskKind, int>{
                       {TaskKind::run, 6}, {TaskKind::device, 2}, {TaskKind::lot, 1}, {TaskKind::left_out, 2}}));
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
  EXPECT_NEAR(shares[0], 5.0 / 6.0, 1e-9);  // all runs are of one law, so each counts the same
  EXPECT_EQ(shares[1], 1.0);
}

// --- Logged times, played back ---------------------------------------------------------------------------------------

struct Logged {
  TaskKind kind;
  std::string law;
  int evaluations;
  double seconds;
};

// The tasks in the order in which they began, measured with two threads on one core.
std::vector<Logged> logged(std::string_view campaign) {
  std::ifstream file(ISOLAW_SOURCE_DIR "/tests/unit/task_times.csv");
  std::vector<Logged> tasks;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string of, kind, law, evaluations, seconds;
    for (auto* cell : {&of, &kind, &law, &evaluations, &seconds}) std::getline(cells, *cell, ',');
    if (of != campaign) continue;
    Logged task{
        .kind = TaskKind::run, .law = law, .evaluations = std::stoi(evaluations), .seconds = std::stod(seconds)};
    while (name(task.kind) != kind) task.kind = static_cast<TaskKind>(static_cast<int>(task.kind) + 1);
    tasks.push_back(task);
  }
  return tasks;
}

struct Campaign {
  std::string_view name;
  double samples;
  std::size_t devices;
  bool genetic;
};

// Costs when the times were logged: ns per step of a candidate, for residuals and in populations; free parameters.
struct LawThen {
  std::string_view law;
  double residuals_ns, population_ns;
  std::size_t free;
};
constexpr LawThen laws_then[]{{"bilinear", 1.78, 0.22, 3}, {"jankowski", 3.58, 2.74, 11}, {"vaiana", 3.38, 2.08, 10},
                              {"bouc-wen", 7.36, 5.48, 6}, {"abe", 62.6, 34.2, 13},       {"abe-y0", 10.8, 6.90, 12},
                              {"hwang-wu", 13.8, 8.93, 10}};

// Plays a campaign back on so many threads. After every task, once a tenth of the work is done, it asks when all will
// be done. Returns the largest ratio, up or down, between that answer and the true end.
double worst_ratio(Campaign const& campaign, std::size_t threads) {
  auto const tasks = logged(campaign.name);
  Estimate estimate(threads);
  double all = 0.0;
  for (auto const& task : tasks) all += task.seconds;
  for (auto const& law : laws_then)
    for (auto const kind : {TaskKind::run, TaskKind::device, TaskKind::lot, TaskKind::left_out}) {
      auto const left = static_cast<std::size_t>(
          std::ranges::count_if(tasks, [&](auto const& task) { return task.kind == kind && task.law == law.law; }));
      TaskSize const size{.step_s = 1e-9 * law.residuals_ns,
                          .population_step_s = 1e-9 * law.population_ns,
                          .steps = campaign.samples,
                          .devices = kind == TaskKind::lot        ? campaign.devices
                                     : kind == TaskKind::left_out ? campaign.devices - 1
                                                                  : 1,
                          .free = law.free,
                          .in_populations = campaign.genetic ? 5000.0 : 0.0};
      estimate.expect(kind, law.law, likely(kind, size), left, 0);
    }
  struct Ending {
    double at;
    std::size_t id;
    Logged const* task;
    bool operator<(Ending const& other) const { return at > other.at; }
  };
  std::priority_queue<Ending> running;
  std::vector<std::pair<double, double>> told;  // time of the answer, and the end that it predicted
  double now = 0.0, done = 0.0;
  auto const finish_one = [&] {
    auto const ending = running.top();
    running.pop();
    now = ending.at;
    estimate.end(ending.id, ending.task->evaluations, now);
    done += ending.task->seconds;
    if (done >= 0.1 * all) told.emplace_back(now, now + estimate.left_s(now));
  };
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (i > 0 && tasks[i].kind != tasks[i - 1].kind)
      while (!running.empty()) finish_one();
    if (running.size() == threads) finish_one();
    running.push({now + tasks[i].seconds, estimate.begin(tasks[i].kind, tasks[i].law, now), &tasks[i]});
  }
  while (!running.empty()) finish_one();
  double worst = 1.0;
  for (auto const& [when, end] : told) worst = std::max({worst, end / now, now / end});
  EXPECT_EQ(estimate.share(now), 1.0);
  EXPECT_FALSE(told.empty());
  return worst;
}

TEST(EstimateTest, TheEndIsToldWithinAFactorOfOneAndAHalfAfterATenthOfTheWork) {
  for (std::size_t const threads : {1u, 2u, 4u})
    for (auto const& campaign : {Campaign{"lot best", 601.0, 10, false}, Campaign{"lot ga", 601.0, 10, true},
                                 Campaign{"bearing", 4942.0, 1, false}}) {
      double const ratio = worst_ratio(campaign, threads);
      EXPECT_LT(ratio, 1.5) << campaign.name << ", " << threads << " threads";
    }
}

}  // namespace
}  // namespace isolaw::campaign
