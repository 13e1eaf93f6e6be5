// What decides a campaign's numbers: written as pairs, read back, and the words of the command line.
#include "isolaw/campaign/settings.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "campaign_fixture.hpp"
#include "isolaw/base/error.hpp"

namespace isolaw::campaign {
namespace {

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

// Two campaigns that could differ in their numbers differ in their pairs: this is what decides whether one is resumed.
TEST(Settings, EveryChangeShowsInThePairs) {
  std::vector<std::function<void(Settings&)>> const changes{
      [](Settings& s) { s.laws.pop_back(); },
      [](Settings& s) { s.method = Method::best; },
      [](Settings& s) { s.integration = laws::Integration::converged; },
      [](Settings& s) { s.runs = 8; },
      [](Settings& s) { s.genetic.population = 38; },
      [](Settings& s) { s.genetic.generations = 12; },
      [](Settings& s) { s.genetic.mutation_rate = 0.3; },  // 0.1 + 0.2 is another number
      [](Settings& s) { s.genetic.stagnation = 6; },
      [](Settings& s) { s.genetic.stagnation_tolerance = 2e-7; },
      [](Settings& s) { s.genetic.selection_pressure = 3.4; },
      [](Settings& s) { s.seed += 1; },
      [](Settings& s) { s.box = fit::BoxKind::scaled; },
      [](Settings& s) { s.overrides.pop_back(); },
      [](Settings& s) { s.overrides[1] = fit::parse_override("bilinear.K1=1.7000000000000002"); },
      [](Settings& s) { s.clean.smooth = 7; },
      [](Settings& s) { s.clean.samples_per_cycle = 200; },
      [](Settings& s) { s.clean.center = false; },
  };
  auto const before = to_pairs(unusual());
  for (std::size_t i = 0; i < changes.size(); ++i) {
    auto changed = unusual();
    changes[i](changed);
    EXPECT_NE(to_pairs(changed), before) << "change " << i;
  }
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
  EXPECT_EQ(best.runs, 3);
  EXPECT_EQ(genetic.runs, 20);  // of the paper
  EXPECT_EQ(given.runs, 7);
}

TEST(Settings, Defaults) {  // of the genetic algorithm: the paper's
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

std::string refusal(std::function<void()> const& action) {
  try {
    action();
  } catch (Error const& error) {
    return error.what();
  }
  return "";
}

bool holds(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}

TEST(Settings, ValidateRefusesWhatIsOutOfRange) {
  auto const with = [](std::function<void(Settings&)> const& change) {
    Settings s;
    s.method = Method::genetic;
    s.runs = 20;
    change(s);
    return refusal([&] { s.validate(); });
  };
  EXPECT_EQ(with([](Settings&) {}), "");
  auto const method = refusal([] { parse_method("pso"); });
  EXPECT_TRUE(holds(method, "--method") && holds(method, "'pso'") && holds(method, "allowed: best, ga")) << method;
  auto const runs = with([](Settings& s) { s.runs = -1; });
  EXPECT_TRUE(holds(runs, "--runs") && holds(runs, "-1") && holds(runs, "1 to 100000")) << runs;
  EXPECT_TRUE(holds(with([](Settings& s) { s.genetic.population = 3; }), "--population"));
  EXPECT_TRUE(holds(with([](Settings& s) { s.genetic.generations = 0; }), "--generations"));
  EXPECT_TRUE(holds(with([](Settings& s) { s.clean.smooth = 4; }), "smooth"));
  EXPECT_TRUE(holds(with([](Settings& s) { s.clean.samples_per_cycle = 19; }), "samples"));
  EXPECT_TRUE(holds(with([](Settings& s) { s.laws = {"bilinear", "nope"}; }), "'nope'"));
}

TEST(Words, Laws) {
  std::vector<std::string> all;
  for (auto const& law : laws::catalogue()) all.emplace_back(law.info.id);
  EXPECT_EQ(parse_laws("all"), all);
  EXPECT_EQ(parse_laws("abe,bilinear"), (std::vector<std::string>{"abe", "bilinear"}));
  EXPECT_EQ(parse_laws("abe, bilinear ,abe"), (std::vector<std::string>{"abe", "bilinear"}));
  for (auto const* text : {"", "bilinear,", "bilinear;abe", "Bilinear", "all,abe"}) {
    auto const said = refusal([&] { parse_laws(text); });
    EXPECT_TRUE(holds(said, "hwang-wu")) << "'" << text << "' must be refused with the list of laws: " << said;
  }
}

TEST(Words, BoxIntegrationAndThinning) {
  EXPECT_EQ(parse_box("published"), fit::BoxKind::published);
  EXPECT_EQ(parse_box("auto"), fit::BoxKind::scaled);
  EXPECT_EQ(parse_integration("converged"), laws::Integration::converged);
  EXPECT_EQ(parse_integration("paper"), laws::Integration::paper);
  EXPECT_EQ(parse_samples_per_cycle("all"), std::nullopt);
  EXPECT_EQ(parse_samples_per_cycle("150"), 150);
  for (auto const kind : {fit::BoxKind::published, fit::BoxKind::scaled}) EXPECT_EQ(parse_box(name(kind)), kind);
  for (auto const how : {laws::Integration::converged, laws::Integration::paper})
    EXPECT_EQ(parse_integration(name(how)), how);
  auto const box = refusal([] { parse_box("scaled"); });
  EXPECT_TRUE(holds(box, "--box") && holds(box, "'scaled'") && holds(box, "published, auto")) << box;
  auto const how = refusal([] { parse_integration("rk4"); });
  EXPECT_TRUE(holds(how, "--integration") && holds(how, "'rk4'") && holds(how, "converged, paper")) << how;
  for (auto const* text : {"", "many", "200.5", "200 ", "1e2", "99999999999"}) {
    auto const said = refusal([&] { parse_samples_per_cycle(text); });
    EXPECT_TRUE(holds(said, "--samples-per-cycle") && holds(said, "all")) << "'" << text << "': " << said;
  }
}

}  // namespace
}  // namespace isolaw::campaign
