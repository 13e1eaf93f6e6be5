// Tests the settings that decide a campaign's numbers: how they are written as pairs of key and value, read from pairs,
// and given on the command line.
#include "isolaw/campaign/settings.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "campaign_fixture.hpp"
#include "isolaw/base/error.hpp"
#include "refusal.hpp"
#include "setting_samples.hpp"

namespace isolaw::campaign {
namespace {

using isolaw::testing::another;
using isolaw::testing::not_allowed;
using isolaw::testing::with;
using testing::expect_same;

Settings unusual() {
  Settings s;
  s.laws = {"hwang-wu", "bilinear", "abe-y0"};
  s.method = Method::genetic;
  s.integration = laws::Integration::paper;
  s.runs = 7;
  s.genetic = {.population = 36,
               .generations = 11,
               .mutation_rate = 0.1 + 0.2,
               .stagnation = 5,
               .stagnation_tolerance = 1e-7,
               .selection_pressure = 3.3};
  s.seed = std::numeric_limits<std::uint64_t>::max() - 1;
  s.box = fit::BoxKind::published;
  s.overrides = {fit::parse_override("vaiana.Kb+=1e5:2e5"), fit::parse_override("bilinear.K1=1.7"),
                 fit::parse_override("vaiana.gamma1-=free")};
  s.clean = {.smooth = 9, .samples_per_cycle = std::nullopt, .center = true};
  return s;
}

TEST(Settings, PairsReadBack) {
  expect_same(settings_from_pairs(to_pairs(unusual())), unusual());
  Settings plain;
  plain.laws = parse_laws("all");
  expect_same(settings_from_pairs(to_pairs(plain)), plain);
  auto best = unusual();
  best.method = Method::best;
  best.genetic = {};
  best.multistart = {.least_starts = 5,
                     .starts = 9,
                     .hits = 2,
                     .hit_tolerance = 0.1 + 0.2,
                     .most_evaluations = 777,
                     .scattered = 3,
                     .hops = 0};
  expect_same(settings_from_pairs(to_pairs(best)), best);
  auto other = unusual();
  other.clean.samples_per_cycle = 33;
  other.overrides.clear();
  expect_same(settings_from_pairs(to_pairs(other)), other);
}

bool holds(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

// --- tests of each row of the table of settings ---

TEST(EverySetting, HasADefaultThatItMayHaveAndHelpWhereItIsAnOption) {
  for (auto const& setting : setting_table()) {
    SCOPED_TRACE(setting.key);
    Settings usual;
    usual.complete();
    EXPECT_EQ(refusal_of([&] { setting.set(usual, setting.get(usual)); }), "");
    EXPECT_NE(setting.get(usual), another(setting));
    EXPECT_TRUE(setting.stored_only || !setting.help.empty());
    for (auto const word : setting.words) EXPECT_TRUE(holds(setting.help, std::string(word))) << setting.help;
  }
}

// isolaw continues a campaign only if its stored pairs of key and value equal those of the new settings. The pairs must
// therefore contain every setting that can change a number.
TEST(EverySetting, IsStoredReadBackAndComparedByItsKey) {
  for (auto const& setting : setting_table()) {
    SCOPED_TRACE(setting.key);
    auto const after = with(setting, another(setting));
    Settings usual;
    usual.complete();
    auto before = after;
    setting.set(before, setting.get(usual));
    expect_same(settings_from_pairs(to_pairs(after)), after);
    EXPECT_EQ(setting.get(after), another(setting));
    EXPECT_NE(to_pairs(after), to_pairs(before));
    auto const said = differences(before, after);
    ASSERT_EQ(said.size(), 1u);
    EXPECT_TRUE(said[0].starts_with(std::string(setting.key) + ": ")) << said[0];
    EXPECT_TRUE(said[0].ends_with(" there, " + text_of(another(setting)) + " now")) << said[0];
  }
}

TEST(EverySetting, ComesBackFromTheWordsOfTheCommandLine) {
  for (auto const& setting : setting_table()) {
    if (setting.stored_only) continue;
    SCOPED_TRACE(setting.key);
    auto const words = words_of(setting, another(setting));
    std::vector<std::string> values;
    for (auto const& word : words)
      if (word != "--" + setting.option()) values.push_back(word);
    EXPECT_LT(values.size(), words.size());
    Settings settings;
    apply({{std::string(setting.key), value_of(setting.kind, values)}}, settings);
    EXPECT_EQ(setting.get(settings), another(setting));
    EXPECT_EQ(settings.method, setting.only_method.value_or(setting.key == "method" ? Method::genetic : Method::best));
  }
}

TEST(EverySetting, RefusesWhatItMayNotBeByItsName) {
  for (auto const& setting : setting_table())
    for (auto const& value : not_allowed(setting)) {
      SCOPED_TRACE(fmt::format("{} {}", setting.key, value.dump()));
      auto const given = refusal_of([&] {
        Settings settings;
        apply({{std::string(setting.key), value}}, settings);
      });
      EXPECT_TRUE(given.starts_with(setting.where())) << given;
      EXPECT_TRUE(holds(given, shown(value)) || setting.key == "set") << given;
      EXPECT_TRUE(holds(given, "; allowed: ")) << given;
      auto pairs = to_pairs(with(setting, another(setting)));
      std::ranges::find(pairs, setting.key, &std::pair<std::string, std::string>::first)->second = value.dump();
      auto const stored = refusal_of([&] { settings_from_pairs(pairs); });
      EXPECT_TRUE(value == setting.get({}) || stored.starts_with(setting.where())) << stored;
    }
}

TEST(EverySetting, IsMissedWhereAStoreLacksItOrIsWhatItsRowSays) {
  for (auto const& setting : setting_table()) {
    auto pairs = to_pairs(with(setting, another(setting)));
    std::erase_if(pairs, [&](auto const& pair) { return pair.first == setting.key; });
    if (setting.value_if_absent.is_null())
      EXPECT_TRUE(holds(refusal_of([&] { settings_from_pairs(pairs); }), setting.where() + ": is missing"));
    else
      EXPECT_EQ(setting.get(settings_from_pairs(pairs)), setting.value_if_absent) << setting.key;
  }
}

TEST(Settings, WhatOneMethodAloneHasChoosesItUnlessAnotherOneIsNamed) {
  Settings settings;
  apply({{"population", 40}}, settings);
  EXPECT_EQ(settings.method, Method::genetic);
  EXPECT_EQ(settings.genetic.population, 40);
  EXPECT_EQ(
      refusal_of([&] {
        apply({{"population", 40}, {"method", "best"}}, settings);
      }),
      "--population: belongs to method ga, but the method is best; allowed: with method ga, or without a method: it then chooses ga");
}

TEST(Settings, EverythingWrongIsSaidAtOnce) {
  Settings settings;
  auto const said = refusal_of([&] { apply({{"runs", 0}, {"smooth", 4}}, settings); });
  EXPECT_EQ(said, "--runs: 0; allowed: 1 to 100000\n--smooth: 4; allowed: an odd number of samples, 1 for none");
}

TEST(Settings, PairsHaveDistinctKeysInAFixedOrder) {
  Settings plain;
  plain.method = Method::genetic;
  auto const pairs = to_pairs(unusual()), others = to_pairs(plain);
  std::set<std::string> keys;
  ASSERT_EQ(pairs.size(), others.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i].first, others[i].first);
    EXPECT_TRUE(keys.insert(pairs[i].first).second) << pairs[i].first;
  }
  for (auto const* key : {"laws", "method", "integration", "turning-points", "runs", "population", "generations",
                          "seed", "box", "set", "smooth", "samples-per-cycle", "center"})
    EXPECT_TRUE(keys.contains(key)) << key;
}

TEST(Settings, RunsAreThoseTheMethodNeeds) {
  Settings best, genetic, given;
  genetic.method = given.method = Method::genetic;
  given.runs = 7;
  for (auto* s : {&best, &genetic, &given}) s->complete();
  EXPECT_EQ(best.runs, 2);
  EXPECT_FALSE(best.clean.weights);  // empty: isolaw chooses a weighting for each record
  EXPECT_EQ(genetic.clean.weights, data::Weighting::time);
  EXPECT_EQ(genetic.runs, 20);  // as in the published study
  EXPECT_EQ(given.runs, 7);
}

TEST(Settings, Defaults) {  // the genetic algorithm has the settings of the published study
  Settings const s;
  EXPECT_EQ(s.method, Method::best);
  EXPECT_EQ(s.integration, laws::Integration::converged);
  EXPECT_EQ(s.genetic.population, 100);
  EXPECT_EQ(s.genetic.generations, 50);
  EXPECT_EQ(s.genetic.mutation_rate, 0.01);
  EXPECT_EQ(s.genetic.stagnation, 20);
  EXPECT_EQ(s.genetic.stagnation_tolerance, 0.0);
  EXPECT_EQ(s.box, fit::BoxKind::scaled);
  EXPECT_EQ(s.clean.smooth, 1);
  EXPECT_EQ(s.clean.samples_per_cycle, 200);
  EXPECT_FALSE(s.clean.center);
}

TEST(Settings, ValidateRefusesWhatIsOutOfRangeOrDoesNotGoTogether) {
  auto const with_change = [](std::function<void(Settings&)> const& change) {
    Settings s;
    change(s);
    return refusal_of([&] { s.validate(); });
  };
  auto const ga = [](Settings& s) -> opt::GeneticOptions& {
    s.method = Method::genetic;
    return s.genetic;
  };
  EXPECT_EQ(with_change([](Settings&) {}), "");
  auto const runs = with_change([](Settings& s) { s.runs = -1; });
  EXPECT_TRUE(holds(runs, "--runs") && holds(runs, "-1") && holds(runs, "1 to 100000")) << runs;
  EXPECT_TRUE(holds(with_change([&](Settings& s) { ga(s).population = 3; }), "--population"));
  EXPECT_TRUE(holds(with_change([&](Settings& s) { ga(s).mutation_rate = 1.5; }), "mutation_rate"));
  EXPECT_TRUE(holds(with_change([](Settings& s) { s.multistart.hit_tolerance = std::nan(""); }), "hit_tolerance"));
  EXPECT_TRUE(holds(with_change([](Settings& s) { s.multistart.starts = 15; }), "starts: 15"));
  EXPECT_TRUE(holds(with_change([](Settings& s) { s.multistart.hits = 17; }), "hits: 17"));
  EXPECT_TRUE(holds(with_change([](Settings& s) { s.clean.smooth = 4; }), "--smooth"));
  EXPECT_TRUE(holds(with_change([](Settings& s) { s.clean.samples_per_cycle = 19; }), "--samples-per-cycle"));
  EXPECT_TRUE(holds(with_change([](Settings& s) { s.clean.scored.predicted = data::parse_numbers("", "2"); }),
                    "--score-blocks: '2'; allowed: together with --fit-blocks"));
  EXPECT_TRUE(holds(with_change([](Settings& s) { s.laws = {"bilinear", "nope"}; }), "'nope'"));
}

TEST(Words, Laws) {
  std::vector<std::string> all;
  for (auto const& law : laws::catalogue()) all.emplace_back(law.info.id);
  EXPECT_EQ(parse_laws("all"), all);
  EXPECT_EQ(parse_laws("abe,bilinear"), (std::vector<std::string>{"abe", "bilinear"}));
  EXPECT_EQ(parse_laws("abe, bilinear ,abe"), (std::vector<std::string>{"abe", "bilinear"}));
  std::vector<std::string> const paper{"bilinear", "jankowski", "vaiana", "bouc-wen", "abe", "abe-y0", "hwang-wu"};
  EXPECT_EQ(parse_laws("paper"), paper);
  auto usual = paper;
  usual.emplace_back("power-masing");
  EXPECT_EQ(parse_laws("usual"), usual);
  EXPECT_EQ(parse_laws("all,abe"), all);
  EXPECT_EQ(parse_laws("abe,paper").size(), paper.size());
  EXPECT_EQ(parse_laws("abe,paper").front(), "abe");
  for (auto const* text : {"", "bilinear,", "bilinear;abe", "Bilinear", "Paper"}) {
    auto const said = refusal_of([&] { parse_laws(text); });
    EXPECT_TRUE(holds(said, "hwang-wu")) << "'" << text << "' must be refused with the list of laws: " << said;
  }
}

TEST(Words, ThinningIsANumberOrAll) {
  auto const& thinning = *find_setting("samples-per-cycle");
  Settings settings;
  thinning.set(settings, "all");
  EXPECT_EQ(settings.clean.samples_per_cycle, std::nullopt);
  for (Json const& number : {Json(150), Json("150")}) {
    thinning.set(settings, number);
    EXPECT_EQ(settings.clean.samples_per_cycle, 150);
  }
  for (auto const* text : {"", "many", "200.5", "200 ", "1e2", "99999999999", "19"})
    EXPECT_TRUE(holds(refusal_of([&] { thinning.set(settings, text); }), "20 or more, or all")) << text;
}

}  // namespace
}  // namespace isolaw::campaign
