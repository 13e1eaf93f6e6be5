// Tests how campaigns are prepared and run: which input is refused, and that the result of a run depends on seed,
// device, law and run number alone, not on threads, order, other runs or interruptions.
#include "isolaw/campaign/campaign.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "campaign_fixture.hpp"
#include "isolaw/api/merge.hpp"
#include "isolaw/base/error.hpp"
#include "isolaw/base/file.hpp"
#include "isolaw/campaign/check.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/campaign/store.hpp"
#include "isolaw/fit/objective.hpp"
#include "refusal.hpp"

namespace isolaw::campaign {
namespace {

using testing::device_input;
using testing::expect_same;
using testing::record_text;

class CampaignTest : public testing::Folder {
 protected:
  // Returns a lot of two devices of different stiffness. Their records have a time column.
  Lot lot(std::string_view laws = "bilinear,bouc-wen,jankowski") const {
    Lot lot_of_two;
    lot_of_two.settings.analysis = false;  // other tests cover the analyses
    lot_of_two.title = "test lot";
    lot_of_two.settings.laws = parse_laws(laws);
    lot_of_two.settings.method = Method::genetic;
    lot_of_two.settings.runs = 3;
    lot_of_two.settings.genetic.population = 10;
    lot_of_two.settings.genetic.generations = 5;
    lot_of_two.settings.seed = 42;
    lot_of_two.devices = {device_input("soft", {write("soft.csv", record_text(1.0))}),
                          device_input("stiff", {write("stiff.csv", record_text(1.3))})};
    return lot_of_two;
  }
  std::filesystem::path file(std::string_view name = "campaign.sqlite") const { return folder / name; }

  // Runs a whole campaign into a store of its own. The results in memory and in the store must be equal.
  Contents done(Lot const& of, int jobs = 1, std::string_view store = "campaign.sqlite") const {
    auto contents = prepare(of);
    Store::create(file(store), contents);
    EXPECT_TRUE(run(contents, file(store), {.jobs = jobs, .progress = {}, .interrupted = {}}));
    EXPECT_TRUE(contents.complete());
    EXPECT_EQ(bytes_of(file(store)).at(18), 1)
        << "a finished campaign is one plain file, not one with a write-ahead log";
    EXPECT_FALSE(std::filesystem::exists(file(store).string() + "-wal"));
    expect_same(Store::read(file(store)), contents);
    return contents;
  }
};

using Key = std::tuple<std::string, std::string, int>;  // name of the device, law, number of the run

std::map<Key, Run> by_name(Contents const& contents) {
  std::map<Key, Run> found;
  for (auto run : contents.runs) {
    Key const key{contents.devices[run.device].name, run.law, run.number};
    run.device = 0;
    found.emplace(key, std::move(run));
  }
  return found;
}

bool sorted(std::vector<Run> const& runs) {
  return std::ranges::is_sorted(runs, {}, [](Run const& r) { return std::tie(r.device, r.law, r.number); });
}

// --- preparing a campaign ---

// The correction of a skew interpolates between samples, which spreads a spike over two samples so that it is no longer
// found. The store must therefore hold the faults that were found before the correction.
TEST_F(CampaignTest, TheStoreHoldsTheFaultsOfTheSignalsBeforeTheirCorrection) {
  std::string text = "time [s],disp [mm],force [kN]\n";
  for (int i = 0; i <= 1200; ++i) {
    double const phase = std::numbers::pi * i / 100.0, amplitude = i < 600 ? 100.0 : 50.0;
    text += fmt::format("{:.4f},{:.4f},{:.4f}\n", 0.01 * i, amplitude * std::sin(phase),
                        amplitude * (std::sin(phase) + 0.3 * std::cos(phase)) + (i == 815 ? 20.0 : 0.0));
  }
  auto of = lot("bilinear");
  of.devices = {device_input("D1", {write("d1.csv", text)})};
  of.devices.front().tests.front().read.corrections.skew_s = 0.0033;
  auto const contents = prepare(of);
  Store::create(file(), contents);
  auto const stored = Store::read(file());
  expect_same(stored, contents);
  auto const blocks = data::cyclic_properties(stored.devices.front().raw).blocks;
  ASSERT_EQ(blocks.size(), 2u);
  EXPECT_EQ(blocks[1].fault, "the force is disturbed by spikes");
  EXPECT_EQ(check(file()).faults, std::vector<std::string>{});
}

TEST_F(CampaignTest, PrepareMakesASearchForEveryDeviceAndLaw) {
  auto const contents = prepare(lot());
  EXPECT_EQ(contents.title, "test lot");
  ASSERT_EQ(contents.devices.size(), 2u);
  ASSERT_EQ(contents.searches.size(), 6u);
  EXPECT_EQ(contents.expected_runs(), 18u);
  EXPECT_FALSE(contents.complete());
  std::size_t i = 0;
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_TRUE(contents.devices[d].usable());
    EXPECT_EQ(contents.devices[d].raw.sha256.size(), 64u);
    EXPECT_EQ(contents.devices[d].raw.size(), 121u);
    for (auto const* law : {"bilinear", "bouc-wen", "jankowski"}) {
      EXPECT_EQ(contents.searches[i].device, d);
      EXPECT_EQ(contents.searches[i].law, law);
      EXPECT_EQ(contents.searches[i++].refusal, "");
    }
  }
}

TEST_F(CampaignTest, NoLawsMeansTheUsualOnes) {
  auto usual = lot();
  usual.settings.laws.clear();
  auto const contents = prepare(usual);
  EXPECT_EQ(contents.settings.laws, parse_laws("usual"));
  EXPECT_EQ(contents.searches.size(), 2 * parse_laws("usual").size());
}

TEST_F(CampaignTest, PrepareKeepsRefusedDevicesWithTheirReason) {
  auto mixed = lot();
  mixed.devices.insert(mixed.devices.begin() + 1,
                       device_input("bad", {write("bad.csv", "time,disp [mm],force [kN]\n0,0,x\n")}));
  mixed.devices.push_back(device_input("absent", {folder / "absent.csv"}));
  auto const contents = prepare(mixed);
  ASSERT_EQ(contents.devices.size(), 4u);
  EXPECT_TRUE(contents.devices[0].usable());
  EXPECT_FALSE(contents.devices[1].usable());
  EXPECT_NE(contents.devices[1].refusal.find("bad.csv"), std::string::npos) << contents.devices[1].refusal;
  EXPECT_TRUE(contents.devices[1].raw.disp_mm.empty());
  EXPECT_EQ(contents.devices[1].raw.file, "bad.csv");
  EXPECT_TRUE(contents.devices[2].usable());
  EXPECT_NE(contents.devices[3].refusal.find("absent.csv"), std::string::npos) << contents.devices[3].refusal;
  ASSERT_EQ(contents.searches.size(), 6u);
  EXPECT_EQ(contents.searches.back().device, 2u);  // a device has an index even if it was refused
}

TEST_F(CampaignTest, PrepareThrowsEveryReasonWhenNoDeviceIsUsable) {
  auto none = lot();
  none.devices = {device_input("first", {write("first.csv", "")}), device_input("second", {folder / "second.csv"})};
  try {
    prepare(none);
    FAIL() << "accepted";
  } catch (Error const& error) {
    ASSERT_EQ(error.complaints().size(), 3u);
    std::string const text = error.what();
    for (auto const* part : {"none of its 2", "first: ", "first.csv", "second: ", "second.csv"})
      EXPECT_NE(text.find(part), std::string::npos) << part << " is missing in: " << text;
  }
}

TEST_F(CampaignTest, PrepareRefusesSettingsOutOfRange) {
  auto wrong = lot();
  wrong.settings.runs = -1;
  EXPECT_THROW(prepare(wrong), Error);
  wrong = lot();
  wrong.settings.clean.smooth = 2;
  EXPECT_THROW(prepare(wrong), Error);
}

TEST_F(CampaignTest, WithoutTimeTheLawsThatNeedVelocityAreRefusedAndTheOthersRun) {
  auto mixed = lot("all");
  mixed.settings.runs = 1;
  mixed.devices[1] = device_input("no time", {write("no-time.csv", record_text(1.3, false))});
  auto const contents = done(mixed);
  std::set<std::string> need_time;
  for (auto const& law : laws::catalogue())
    if (!law.info.traits.rate_independent) need_time.emplace(law.info.id);
  EXPECT_EQ(contents.expected_runs(), 2 * laws::catalogue().size() - need_time.size());
  std::set<std::string> refused;
  for (auto const& search : contents.searches) {
    if (search.refusal.empty()) continue;
    EXPECT_EQ(search.device, 1u);
    EXPECT_NE(search.refusal.find("time"), std::string::npos) << search.refusal;
    EXPECT_NE(search.refusal.find("--dt"), std::string::npos) << search.refusal;
    refused.insert(search.law);
  }
  EXPECT_TRUE(need_time.contains("jankowski") && need_time.contains("hwang-wu"));
  EXPECT_EQ(refused, need_time);
  for (auto const& r : contents.runs) EXPECT_FALSE(r.device == 1 && refused.contains(r.law));
}

TEST_F(CampaignTest, SeveralFilesOfADeviceAreOneHistory) {
  auto two = lot();
  two.devices = {device_input("both", {folder / "soft.csv", folder / "stiff.csv"})};
  auto const contents = prepare(two);
  auto const& raw = contents.devices[0].raw;
  ASSERT_EQ(raw.size(), 242u);
  ASSERT_EQ(raw.time_s.size(), 242u);
  EXPECT_TRUE(std::ranges::is_sorted(raw.time_s, std::less_equal{}));
  EXPECT_NEAR(raw.time_s[121], raw.time_s[120] + 0.05, 1e-9);  // the second file continues after one sampling interval
  EXPECT_NEAR(raw.time_s.back() - raw.time_s[121], 6.0, 1e-9);
  EXPECT_NE(raw.sha256, prepare(lot()).devices[0].raw.sha256);

  two.devices = {device_input("mixed", {folder / "soft.csv", write("no-time.csv", record_text(1.0, false))})};
  try {
    prepare(two);
    FAIL() << "accepted";
  } catch (Error const& error) {
    EXPECT_NE(std::string(error.what()).find("time"), std::string::npos) << error.what();
  }
}

// --- running a campaign ---

// With Method::best, threads and interruptions must not change any run, and all runs of a search must end within 0.1 %
// of the search's least objective.
TEST_F(CampaignTest, DescentsEndAtOneObjective) {
  auto best = lot("bilinear,bouc-wen");
  best.settings.method = Method::best;
  best.settings.genetic = {};
  auto const whole = done(best);
  ASSERT_EQ(whole.runs.size(), 12u);
  std::map<std::pair<std::size_t, std::string>, double> least;
  for (auto const& r : whole.runs) {
    auto const [entry, is_new] = least.try_emplace(std::pair(r.device, r.law), r.objective);
    entry->second = std::min(entry->second, r.objective);
    EXPECT_EQ(r.outcome, Outcome::confirmed);
    EXPECT_GE(r.history.size(), 17u);  // 16 starts, and one or more entries for the refinement
    EXPECT_NEAR(r.history.back(), r.objective, fit::block_tolerance * std::max(r.objective, 1e-3));
    EXPECT_GT(r.evaluations, 500);
  }
  for (auto const& r : whole.runs) EXPECT_LE(r.objective, 1.001 * least.at(std::pair(r.device, r.law)) + 1e-9) << r.law;

  expect_same(done(best, 2, "threads.sqlite").runs, whole.runs);

  auto stopped = prepare(best);
  Store::create(file("stopped.sqlite"), stopped);
  std::atomic<int> asked = 0;
  EXPECT_FALSE(
      run(stopped, file("stopped.sqlite"), {.jobs = 1, .progress = {}, .interrupted = [&] { return ++asked > 60; }}));
  EXPECT_LT(stopped.runs.size(), 12u);
  auto resumed = Store::read(file("stopped.sqlite"));
  EXPECT_TRUE(run(resumed, file("stopped.sqlite"), {.jobs = 2, .progress = {}, .interrupted = {}}));
  expect_same(resumed.runs, whole.runs);
}

TEST_F(CampaignTest, EveryRunIsThereOnceAndIsWhatItSays) {
  auto const contents = done(lot("all"));
  auto const expected = 2 * 3 * laws::catalogue().size();
  ASSERT_EQ(contents.runs.size(), expected);
  EXPECT_TRUE(sorted(contents.runs));
  EXPECT_EQ(by_name(contents).size(), expected);
  std::set<double> objectives;
  for (auto const& r : contents.runs) {
    auto const& search =
        *std::ranges::find_if(contents.searches, [&](auto const& s) { return s.device == r.device && s.law == r.law; });
    auto const& law = laws::find_law(r.law);
    fit::LawOnRecord const model(law, contents.devices[r.device].record, laws::Integration::converged);
    ASSERT_EQ(r.parameters.size(), law.parameters.size());
    std::vector<double> work;
    EXPECT_EQ(r.objective, model.objective(r.parameters, work)) << r.law;
    EXPECT_EQ(r.integration_shift, model.integration_shift(r.parameters)) << r.law;
    EXPECT_EQ(r.evaluations, 50);
    EXPECT_EQ(r.outcome, Outcome::all_generations);
    ASSERT_EQ(r.history.size(), 5u);
    EXPECT_TRUE(std::ranges::is_sorted(r.history, std::greater{}));
    // Vectorised code computes the history and scalar code the final objective, so their last digits differ.
    EXPECT_NEAR(r.history.back(), r.objective, fit::block_tolerance * r.objective);
    for (std::size_t i = 0; i < r.parameters.size(); ++i) {
      auto const& p = search.box.parameters[i];
      if (p.free) {
        EXPECT_GE(r.parameters[i], p.lower) << r.law << " " << p.name;
        EXPECT_LE(r.parameters[i], p.upper) << r.law << " " << p.name;
      } else {
        EXPECT_EQ(r.parameters[i], p.value) << r.law << " " << p.name;
      }
    }
    objectives.insert(r.objective);
  }
  EXPECT_EQ(objectives.size(), expected);  // no two runs give the same objective
}

TEST_F(CampaignTest, ThreadsChangeNothing) {
  auto const of = lot("all");
  auto const one = done(of, 1, "1.sqlite");
  for (int const jobs : {2, 3, 0}) expect_same(done(of, jobs, fmt::format("{}.sqlite", jobs)), one);
}

TEST_F(CampaignTest, OrderOfDevicesChangesNothing) {
  auto const expected = by_name(done(lot()));
  auto other = lot();
  std::ranges::reverse(other.devices);
  auto const found = by_name(done(other, 2, "other.sqlite"));
  ASSERT_EQ(found.size(), expected.size());
  for (auto const& [key, run] : expected) expect_same(found.at(key), run);
}

TEST_F(CampaignTest, OtherLawsDevicesAndRunsChangeNothing) {
  auto const expected = by_name(done(lot()));
  auto fewer = lot("jankowski,bilinear");  // fewer laws than above and in another order
  fewer.devices.erase(fewer.devices.begin());
  fewer.settings.runs = 2;
  auto const found = by_name(done(fewer, 1, "fewer.sqlite"));
  EXPECT_EQ(found.size(), 4u);
  for (auto const& [key, run] : found) expect_same(expected.at(key), run);
}

TEST_F(CampaignTest, TheFilesNameAndTheTitleChangeNothing) {
  auto const expected = done(lot());
  auto other = lot();
  other.title = "another title";
  other.devices[0] = device_input("soft", {write("copy.csv", bytes_of(folder / "soft.csv"))});
  expect_same(done(other, 1, "other.sqlite").runs, expected.runs);
}

TEST_F(CampaignTest, SeedAndNameOfTheDeviceDecide) {
  auto const expected = done(lot("bilinear"));
  auto other = lot("bilinear");
  other.settings.seed = 43;
  auto const seeded = done(other, 1, "seed.sqlite");
  other = lot("bilinear");
  other.devices[0].name = "renamed";
  auto const renamed = done(other, 1, "name.sqlite");
  for (std::size_t i = 0; i < expected.runs.size(); ++i) {
    EXPECT_NE(seeded.runs[i].objective, expected.runs[i].objective);
    bool const same = renamed.runs[i].objective == expected.runs[i].objective;
    EXPECT_EQ(same, expected.runs[i].device == 1);
  }
}

// Both laws reduce to one elastic spring here, so their objectives are the same function. Equal objectives would show
// that the laws share random numbers.
TEST_F(CampaignTest, LawsHaveRandomNumbersOfTheirOwn) {
  auto springs = lot("bilinear,jankowski");
  for (auto const* text : {"bilinear.K1=2", "bilinear.xy=0", "bilinear.K2=0.4:1.2", "jankowski.a1=4e5:12e5",
                           "jankowski.a2=0", "jankowski.a3=0", "jankowski.a4=0", "jankowski.a5=1", "jankowski.a6=0",
                           "jankowski.a7=1", "jankowski.a8=1", "jankowski.a9=0", "jankowski.a10=0", "jankowski.a11=1"})
    springs.settings.overrides.push_back(fit::parse_override(text));
  springs.settings.genetic.generations = 1;
  auto const found = by_name(done(springs));
  for (auto const* device : {"soft", "stiff"})
    for (int number = 1; number <= 3; ++number)
      EXPECT_GT(std::abs(found.at({device, "bilinear", number}).objective -
                         found.at({device, "jankowski", number}).objective),
                1e-9);
}

TEST_F(CampaignTest, ProgressCountsEveryRunAndKnowsTheBest) {
  auto contents = prepare(lot());
  Store::create(file(), contents);
  std::vector<std::size_t> counts;
  Progress last;
  EXPECT_TRUE(run(contents, file(),
                  {.jobs = 2,
                   .progress =
                       [&](Progress const& p) {
                         counts.push_back(p.done);
                         last = p;
                       },
                   .interrupted = {}}));
  ASSERT_EQ(counts.size(), 18u);
  for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(counts[i], i + 1);
  EXPECT_EQ(last.total, 18u);
  std::map<std::string, double> best;
  for (auto const& r : contents.runs)
    best[r.law] = std::min(best.try_emplace(r.law, r.objective).first->second, r.objective);
  EXPECT_EQ(last.best, best);
}

// --- interrupting a campaign ---

TEST_F(CampaignTest, InterruptedAfterAnyRunAndResumedIsAsIfNeverInterrupted) {
  auto const expected = done(lot(), 1, "whole.sqlite");
  for (int const jobs : {1, 2})
    for (std::size_t const stop_after : {0u, 1u, 7u, 17u}) {
      if (jobs == 2 && stop_after == 17) continue;  // the last run may end before its thread asks whether to stop
      auto const store = file(fmt::format("stopped-{}-{}.sqlite", jobs, stop_after));
      auto contents = prepare(lot());
      Store::create(store, contents);
      std::atomic<bool> stop = stop_after == 0;
      RunOptions const options{.jobs = jobs,
                               .progress =
                                   [&](Progress const& p) {
                                     if (p.done >= stop_after) stop = true;
                                   },
                               .interrupted = [&] { return stop.load(); }};
      EXPECT_FALSE(run(contents, store, options));
      EXPECT_GE(contents.runs.size(), stop_after);
      EXPECT_LT(contents.runs.size(), 18u);
      EXPECT_TRUE(sorted(contents.runs));
      expect_same(Store::read(store), contents);  // the finished runs are kept

      auto resumed = Store::read(store);
      std::size_t first_done = 0;
      EXPECT_TRUE(run(resumed, store,
                      {.jobs = jobs,
                       .progress =
                           [&](Progress const& p) {
                             if (first_done == 0) first_done = p.done;
                             EXPECT_EQ(p.total, 18u);
                           },
                       .interrupted = {}}));
      EXPECT_EQ(first_done, contents.runs.size() + 1);  // no finished run is computed again
      expect_same(resumed, expected);
      expect_same(Store::read(store), expected);
    }
}

TEST_F(CampaignTest, InterruptedWithinARunKeepsNoPartOfIt) {
  auto const expected = done(lot("bilinear"), 1, "whole.sqlite");
  // The campaign is interrupted once it has asked `asked` times whether to stop. Each run asks about six times.
  for (int const asked : {2, 4, 9}) {
    auto const store = file(fmt::format("stopped-{}.sqlite", asked));
    auto contents = prepare(lot("bilinear"));
    Store::create(store, contents);
    std::atomic<int> questions = 0;
    EXPECT_FALSE(run(contents, store, {.jobs = 1, .progress = {}, .interrupted = [&] { return ++questions > asked; }}));
    auto stored = Store::read(store);
    EXPECT_LE(stored.runs.size(), 1u);
    for (std::size_t i = 0; i < stored.runs.size(); ++i) EXPECT_EQ(stored.runs[i].history.size(), 5u);
    EXPECT_TRUE(run(stored, store, {.jobs = 1, .progress = {}, .interrupted = {}}));
    expect_same(stored, expected);
  }
}

TEST_F(CampaignTest, ACompleteCampaignRunsNothingAgain) {
  auto contents = done(lot("bilinear"));
  auto const expected = contents;
  bool called = false;
  EXPECT_TRUE(
      run(contents, file(), {.jobs = 2, .progress = [&](Progress const&) { called = true; }, .interrupted = {}}));
  EXPECT_FALSE(called);
  expect_same(contents, expected);
  expect_same(Store::read(file()), expected);
}

// --- integration in finer steps ---

// With a dozen samples per cycle, one integration step per sample is far too long for hwang-wu in a corner of its
// search box. A search with such long steps ends in this corner, where only the step error makes the objective so low.
// isolaw must then search again in finer steps, until still finer ones hardly change the objective.
TEST_F(CampaignTest, AnOptimumThatLivesFromTheStepIsFittedAgainInFinerOnes) {
  Lot coarse;
  coarse.settings.laws = {"hwang-wu", "bilinear"};
  coarse.settings.runs = 1;
  coarse.settings.analysis = false;
  for (auto const* text :
       {"a3=0.107", "a4=14250", "a5=0.813", "a6=2469", "a7=-184", "a8=1.63", "a9=-2.2e-6", "a10=-4.7e-10"})
    coarse.settings.overrides.push_back(fit::parse_override(fmt::format("hwang-wu.{}", text)));
  coarse.devices = {device_input("coarse", {write("coarse.csv", record_text(1.0, true, 12))})};
  auto const contents = done(coarse);
  ASSERT_EQ(contents.runs.size(), 2u);
  auto const& exact = contents.runs[0];
  auto const& refined = contents.runs[1];
  EXPECT_EQ(exact.law, "bilinear");
  EXPECT_EQ(exact.refinement, 1);
  ASSERT_EQ(refined.law, "hwang-wu");
  EXPECT_GE(refined.refinement, 4);
  auto const& law = laws::find_law("hwang-wu");
  auto const& record = contents.devices[0].record;
  std::vector<double> work;
  auto const objective = [&](int refinement, std::vector<double> const& parameters) {
    return fit::LawOnRecord(law, record, laws::Integration::converged, laws::TurningPoints::as_sampled, refinement)
        .objective(parameters, work);
  };
  EXPECT_EQ(refined.objective, objective(refined.refinement, refined.parameters));
  for (int const finer : {2, 4})
    EXPECT_NEAR(objective(finer * refined.refinement, refined.parameters), refined.objective, 1e-3 * refined.objective);
  EXPECT_LT(refined.integration_shift, 1e-3 * refined.objective);
  // The search in coarse steps ended at an objective below that of accurate integration.
  EXPECT_LT(refined.history.back(), refined.objective);

  coarse.settings.integration = laws::Integration::paper;
  for (auto const& r : done(coarse, 1, "paper.sqlite").runs) EXPECT_EQ(r.refinement, 1) << r.law;
}

// --- searches without free parameters or without a finite force ---

TEST_F(CampaignTest, AllParametersFixedIsEvaluatedAsTheyAre) {
  auto fixed = lot("bilinear,abe-y0");
  std::vector<double> const K{1.5, 0.6, 20.0};
  fixed.settings.overrides = {fit::parse_override("bilinear.K1=1.5"), fit::parse_override("bilinear.K2=0.6"),
                              fit::parse_override("bilinear.xy=20")};
  auto const contents = done(fixed, 2);
  ASSERT_EQ(contents.runs.size(), 12u);
  for (auto const& r : contents.runs) {
    if (r.law != "bilinear") continue;
    fit::LawOnRecord const model(laws::find_law("bilinear"), contents.devices[r.device].record,
                                 laws::Integration::converged);
    std::vector<double> work;
    EXPECT_EQ(r.parameters, K);
    EXPECT_EQ(r.objective, model.objective(K, work));
    EXPECT_EQ(r.evaluations, 1);
    EXPECT_EQ(r.history, std::vector<double>{r.objective});
    EXPECT_EQ(r.outcome, Outcome::all_generations);
    EXPECT_EQ(r.integration_shift, 0.0);
  }
}

// The search box of one law is set so that an exponential overflows. Runs of this law must fail and the runs of the
// others must not change.
TEST_F(CampaignTest, ARunWithoutAnyFiniteForceIsRecordedAsSuch) {
  auto const expected = by_name(done(lot("bilinear"), 1, "plain.sqlite"));
  std::vector<fit::Override> searched{fit::parse_override("vaiana.beta1+=1:2"),
                                      fit::parse_override("vaiana.beta2+=1e8:1e9")};
  std::vector<fit::Override> fixed;
  for (auto const* text : {"Kb+=1e5", "Kb-=1e5", "f0+=1e4", "f0-=1e4", "alpha+=10", "alpha-=10", "beta1+=1", "beta1-=1",
                           "beta2+=1e9", "beta2-=1e9"})
    fixed.push_back(fit::parse_override(std::string("vaiana.") + text));
  for (auto const& overrides : {searched, fixed}) {
    auto failing = lot("vaiana,bilinear");
    failing.settings.overrides = overrides;
    auto const contents = done(failing, 2);
    ASSERT_EQ(contents.runs.size(), 12u);
    for (auto const& r : contents.runs) {
      if (r.law == "bilinear") continue;
      EXPECT_EQ(r.outcome, Outcome::no_finite_value);
      EXPECT_FALSE(r.usable());
      EXPECT_TRUE(std::isnan(r.objective));
      EXPECT_TRUE(std::isnan(r.integration_shift));
      EXPECT_EQ(r.history, std::vector<double>{std::numeric_limits<double>::infinity()});
    }
    auto const found = by_name(contents);
    for (auto const& [key, run] : expected) expect_same(found.at(key), run);
  }
}

TEST_F(CampaignTest, AStoreThatIsNotThereIsRefused) {
  auto contents = prepare(lot("bilinear"));
  EXPECT_THROW(run(contents, folder / "absent.sqlite", {.jobs = 1, .progress = {}, .interrupted = {}}), Error);
}

// If `calibrate` continues a stored campaign, its result states the changes that the command line would print: here the
// added device, and that the new call no longer names the rule set.
TEST_F(CampaignTest, OfADirectoryIsSaidWhatItContinues) {
  auto const record = [&](std::string name, double stiffness) {
    auto const file = write(name + ".csv", record_text(stiffness));
    return NamedRecord{.name = std::move(name), .record = data::read_record(file), .info = {}};
  };
  auto settings = lot("bilinear").settings;
  CalibrateOptions options;
  options.directory = folder / "out";
  options.acceptance.rules_file = "ntc-2018";
  EXPECT_TRUE(calibrate({record("a", 1.0)}, settings, options).continued.added.empty());
  options.acceptance = {};
  auto const grown = calibrate({record("a", 1.0), record("b", 1.1)}, settings, options);
  EXPECT_EQ(grown.continued.added, std::vector<std::string>{"1 device"});
  EXPECT_FALSE(grown.continued.dropped_rules.empty());
  EXPECT_EQ(grown.devices.size(), 2u);
}

// `calibrate` is called once per part. The parts together must give the results of a campaign on one machine.
TEST_F(CampaignTest, InPartsEndsAsOneMachine) {
  auto const record = [&](std::string name, double stiffness) {
    auto const file = write(name + ".csv", record_text(stiffness));
    return NamedRecord{.name = std::move(name), .record = data::read_record(file), .info = {}};
  };
  auto const settings = lot("bilinear").settings;
  auto const of = [&](std::string const& directory, std::optional<Part> part) {
    CalibrateOptions options;
    options.directory = folder / directory;
    options.part = part;
    return calibrate({record("a", 1.0), record("b", 1.1)}, settings, options);
  };
  EXPECT_TRUE(of("whole", {}).complete());
  EXPECT_TRUE(of("1", Part{1, 2}).complete());
  EXPECT_FALSE(std::filesystem::exists(folder / "1/summary.json"));
  auto const missing = refusal_of([&] { isolaw::merge(folder / "merged", {folder / "1", folder / "2"}); });
  EXPECT_NE(missing.find("of part 2/2 ("), std::string::npos) << missing;
  of("2", Part{2, 2});
  EXPECT_TRUE(isolaw::merge(folder / "merged", {folder / "2"}).complete());
  ReadLimits const any{.largest_bytes = 1U << 30, .allowed = {}, .when_too_large = {}};
  for (auto const* name : {"campaign.sqlite", "summary.json"})
    EXPECT_EQ(read_file(folder / "merged" / name, any), read_file(folder / "whole" / name, any)) << name;
  EXPECT_NE(refusal_of([&] { of("3", Part{3, 2}); }).find("3/2"), std::string::npos);
  CalibrateOptions nowhere;
  nowhere.part = Part{1, 2};
  EXPECT_NE(refusal_of([&] { calibrate({record("a", 1.0)}, settings, nowhere); }).find("no directory"),
            std::string::npos);
}

}  // namespace
}  // namespace isolaw::campaign
