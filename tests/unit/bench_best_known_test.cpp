// Tests the file of the best objectives known: what makes two problems different, how the file is read and written, and
// that a stored objective never rises while the problem stays the same.
#include "bench/best_known.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "isolaw/base/error.hpp"
#include "isolaw/campaign/lot_file.hpp"
#include "isolaw/campaign/prepare.hpp"
#include "isolaw/fit/objective.hpp"

namespace isolaw::bench {
namespace {

data::FitRecord cycle() {
  data::FitRecord record;
  for (int i = 0; i <= 40; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / 40.0;
    record.time_s.push_back(0.05 * i);
    record.disp_mm.push_back(100.0 * std::sin(phase));
    record.vel_mm_s.push_back(100.0 * std::numbers::pi * std::cos(phase));
    record.force_kN.push_back(80.0 * std::sin(phase) + 20.0 * std::cos(phase));
  }
  return record;
}

struct Problem {
  std::string law = "bilinear";
  laws::Integration integration = laws::Integration::converged;
  laws::TurningPoints turning_points = laws::TurningPoints::as_sampled;
  data::FitRecord record = cycle();
  fit::SearchBox box =
      fit::make_box(laws::find_law(law), fit::BoxKind::scaled, fit::scales_of(record, laws::find_law(law).info), {});

  std::string key() const { return problem_key(laws::find_law(law), integration, turning_points, record, box); }
};

BestKnown entry(std::string key_digit = "a", double objective = 0.5) {
  std::string key;
  while (key.size() < 64) key += key_digit;
  return {.record = "a \"named\" record, D01",
          .settings = "box auto, integration converged",
          .law = "bilinear",
          .key = key,
          .objective = objective,
          .parameters = {1.0 / 3.0, 1e-30, 2.0},
          .found_by = "someone"};
}

std::string text_without(std::string const& part, std::string const& instead = {}) {
  auto text = best_known_text(std::vector{entry()});
  auto const at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), instead);
}

void expect_refused(std::string const& text, std::string const& expected) {
  try {
    read_best_known(text, "best.toml");
    FAIL() << "not refused: " << text;
  } catch (Error const& error) {
    EXPECT_NE(std::string(error.what()).find(expected), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("best.toml"), std::string::npos) << error.what();
  }
}

TEST(ProblemKey, ChangesWithWhatDecidesTheObjective) {
  std::set<std::string> keys{Problem{}.key()};
  auto const expect_another = [&](Problem const& problem, char const* what) {
    EXPECT_TRUE(keys.insert(problem.key()).second) << what;
  };
  expect_another({.law = "bouc-wen"}, "law");
  expect_another({.integration = laws::Integration::paper}, "integration");
  expect_another({.turning_points = laws::TurningPoints::interpolated}, "turning points");
  for (auto const channel :
       {&data::FitRecord::time_s, &data::FitRecord::disp_mm, &data::FitRecord::vel_mm_s, &data::FitRecord::force_kN}) {
    Problem changed;
    (changed.record.*channel)[7] *= 1.0 + 1e-6;
    expect_another(changed, "a sample");
    Problem shorter;
    (shorter.record.*channel).pop_back();
    expect_another(shorter, "one sample less");
  }
  Problem judged;
  judged.record.scored.assign(judged.record.size(), 1.0);
  judged.record.scored[3] = 0.0;
  expect_another(judged, "what is scored");
  Problem weighed;
  weighed.record.weights.assign(weighed.record.size(), 1.0);
  expect_another(weighed, "weights");
  weighed.record.weights[3] = 2.0;
  expect_another(weighed, "one weight");
  Problem bounds;
  bounds.box.parameters[1].upper *= 1.0 + 1e-6;
  expect_another(bounds, "a bound");
  Problem fixed;
  fixed.box.parameters[1].free = false;
  fixed.box.parameters[1].value = 1.0;
  expect_another(fixed, "a fixed parameter");
  fixed.box.parameters[1].value = 2.0;
  expect_another(fixed, "its value");
}

TEST(ProblemKey, IsTheSameOnEveryScaleAndDespiteRounding) {
  Problem const plain;
  Problem logarithmic;
  for (auto& p : logarithmic.box.parameters) p.scale = laws::Scale::logarithmic;
  EXPECT_EQ(plain.key(), logarithmic.key());
  Problem linear;
  for (auto& p : linear.box.parameters) p.scale = laws::Scale::linear;
  EXPECT_EQ(plain.key(), linear.key());
  // The key must not change if the last digits of every number change, up and down, nor if numbers change that are
  // nothing but rounding errors, such as the sine of pi.
  Problem rounded;
  for (std::size_t i = 0; i < rounded.record.size(); ++i) {
    double const factor = i % 2 == 0 ? 1.0 - 2e-15 : 1.0 + 2e-15;
    for (auto const channel :
         {&data::FitRecord::time_s, &data::FitRecord::disp_mm, &data::FitRecord::vel_mm_s, &data::FitRecord::force_kN})
      (rounded.record.*channel)[i] = (rounded.record.*channel)[i] * factor + 3e-15;
  }
  for (auto& p : rounded.box.parameters) {
    p.lower *= 1.0 + 2e-15;
    p.upper *= 1.0 - 2e-15;
  }
  EXPECT_EQ(plain.key(), rounded.key());
}

TEST(BestKnown, TextReadsBackForEveryLaw) {
  std::vector<BestKnown> entries;
  for (auto const& law : laws::catalogue()) {
    auto best = entry(fmt::format("{:04x}", law.index), 0.1 + 0.2);
    best.law = law.info.id;
    best.parameters.clear();
    for (std::size_t i = 0; i < law.parameters.size(); ++i)
      best.parameters.push_back((static_cast<double>(i) - 2.0) / 3.0);
    entries.push_back(best);
  }
  auto const read = read_best_known(best_known_text(entries), "best.toml");
  ASSERT_EQ(read.size(), entries.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].record, entries[i].record);
    EXPECT_EQ(read[i].settings, entries[i].settings);
    EXPECT_EQ(read[i].law, entries[i].law);
    EXPECT_EQ(read[i].key, entries[i].key);
    EXPECT_EQ(read[i].objective, entries[i].objective);
    EXPECT_EQ(read[i].parameters, entries[i].parameters);
    EXPECT_EQ(read[i].found_by, entries[i].found_by);
  }
}

TEST(BestKnown, MalformedFilesAreRefusedWithWhatIsWrong) {
  auto const good = best_known_text(std::vector{entry()});
  EXPECT_EQ(read_best_known(good, "best.toml").size(), 1U);
  EXPECT_TRUE(read_best_known("", "best.toml").empty());
  expect_refused("[[best]\n", "best.toml:1");
  expect_refused("best = 1\n", "[[best]]");
  expect_refused("other = 1\n", "other");
  expect_refused(text_without("objective = 0.5\n"), "'objective' is missing");
  expect_refused(text_without("objective = 0.5", "objective = \"0.5\""), "a number");
  expect_refused(text_without("objective = 0.5", "objective = nan"), "a finite number");
  expect_refused(text_without("objective = 0.5", "objective = -0.5"), "0 or more");
  expect_refused(text_without("aaaa", "aaa"), "64 hexadecimal digits");
  expect_refused(text_without("aaaa", "aaaX"), "64 hexadecimal digits");
  expect_refused(text_without("found_by = \"someone\"\n"), "'found_by' is missing");
  expect_refused(text_without("law = \"bilinear\"", "law = \"linear\""), "no law 'linear'");
  expect_refused(text_without("K1 = ", "K1 = true, K0 = "), "a number");
  expect_refused(text_without("K1 = ", "K9 = "), "'K1' is missing");
  expect_refused(text_without("record = ", "date = 2\nrecord = "), "date");
  expect_refused(good + good, "second time");
}

TEST(BestKnown, IsLoweredAndNeverRaised) {
  std::vector<BestKnown> entries;
  EXPECT_EQ(lower(entries, entry("a", 0.5)), Change::added);
  auto better = entry("a", 0.4);
  better.found_by = "another";
  better.parameters = {3.0, 2.0, 1.0};
  EXPECT_EQ(lower(entries, better), Change::lowered);
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].objective, 0.4);
  EXPECT_EQ(entries[0].found_by, "another");
  EXPECT_EQ(entries[0].parameters, better.parameters);

  for (double const objective : {0.4, 0.4 * (1.0 - 0.5 * least_lowering), 0.45, 10.0, std::nan("")}) {
    EXPECT_EQ(lower(entries, entry("a", objective)), Change::none) << objective;
    EXPECT_EQ(entries[0].objective, 0.4);
    EXPECT_EQ(entries[0].found_by, "another");
  }

  auto elsewhere = entry("b", 0.9);
  elsewhere.record = "another record";
  EXPECT_EQ(lower(entries, elsewhere), Change::added);
  // The same record, settings and law with another key, as after a change of the box, are another problem. Its entry
  // replaces the stored one, although its objective is higher.
  EXPECT_EQ(lower(entries, entry("c", 0.6)), Change::redefined);
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].key, entry("c").key);
  EXPECT_EQ(entries[0].objective, 0.6);
}

// The key of a search is a hash of all that decides its best objective, such as record, law and box. This build must
// compute the keys in best_known.toml, and the parameters in that file must give its objectives.
TEST(BestKnown, HoldsEverySearchOfTheExampleLot) {
  auto const lot = campaign::read_lot_file(ISOLAW_SOURCE_DIR "/examples/published-lot/study.toml");
  auto const contents = campaign::prepare(lot);
  ASSERT_EQ(contents.searches.size(), 70U);
  auto const all = load_best_known(ISOLAW_SOURCE_DIR "/bench/best_known.toml");
  std::vector<double> work;
  for (auto const& search : contents.searches) {
    auto const& device = contents.devices[search.device];
    auto const& law = laws::find_law(search.law);
    auto const& settings = contents.settings;
    auto const best = std::ranges::find(
        all, problem_key(law, settings.integration, settings.turning_points, device.record, search.box),
        &BestKnown::key);
    ASSERT_NE(best, all.end()) << search.law << " on " << device.name;
    EXPECT_EQ(best->law, search.law);
    EXPECT_EQ(best->record, "example lot, " + device.name);
    fit::LawOnRecord const model(law, device.record, settings.integration, settings.turning_points);
    EXPECT_NEAR(model.objective(best->parameters, work), best->objective, fit::evaluation_tolerance * best->objective)
        << search.law << " on " << device.name;
    for (std::size_t i = 0; i < best->parameters.size(); ++i) {
      auto const& p = search.box.parameters[i];
      EXPECT_GE(best->parameters[i], p.free ? p.lower : p.value) << search.law << " on " << device.name;
      EXPECT_LE(best->parameters[i], p.free ? p.upper : p.value) << search.law << " on " << device.name;
    }
  }
}

}  // namespace
}  // namespace isolaw::bench
