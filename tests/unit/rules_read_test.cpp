// Tests rule files: what they may contain, the built-in files, and the messages about mistakes, which give the line.
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "rules_fixture.hpp"

namespace isolaw::rules {
namespace {

using testing::expect_parts;
using testing::head;
using testing::rules_of;

std::string bytes_of(std::filesystem::path const& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

Limit const* limit_of(RuleSet const& set, Quantity quantity, Scope scope) {
  for (auto const& limit : set.limits)
    if (limit.quantity == quantity && limit.scope == scope) return &limit;
  return nullptr;
}

void expect_limit(RuleSet const& set, Quantity quantity, Scope scope, std::optional<double> lower,
                  std::optional<double> upper) {
  auto const* limit = limit_of(set, quantity, scope);
  ASSERT_NE(limit, nullptr) << set.id << " " << name(quantity);
  EXPECT_EQ(limit->lower_percent, lower) << set.id << " " << name(quantity);
  EXPECT_EQ(limit->upper_percent, upper) << set.id << " " << name(quantity);
}

std::string refused(std::string_view tail) {  // the first line of the tail is line 11 of the file
  return refusal_of([&] { rules_of(tail); });
}

constexpr std::string_view one_limit = "[[limit]]\nquantity = \"K_eff\"\napplies_to = \"each\"\nwithin_percent = 20\n";

TEST(BuiltInRules, AreTheFilesOfTheProject) {
  std::set<std::string> files;
  for (auto const& entry : std::filesystem::directory_iterator(ISOLAW_SOURCE_DIR "/rules")) {
    auto const stem = entry.path().stem().string();
    files.insert(stem);
    EXPECT_EQ(rule_set_text(stem), bytes_of(entry.path())) << stem;
  }
  EXPECT_TRUE(files.erase("template"));
  for (auto const& set : built_in_rule_sets()) {
    EXPECT_TRUE(files.erase(set.id)) << set.id;
    EXPECT_EQ(set.origin, "built in");
    EXPECT_EQ(find_rule_set(set.id).title, set.title);
  }
  EXPECT_TRUE(files.empty());
}

TEST(BuiltInRules, OnlyTheOneThatWasReadIsVerified) {
  for (auto const& set : built_in_rule_sets()) EXPECT_EQ(set.verified(), set.id == "ntc-2018") << set.id;
}

TEST(BuiltInRules, NtcIsTable_11_9_IV) {
  auto const set = find_rule_set("ntc-2018");
  EXPECT_EQ(set.stiffness_formula, Formula::per_side);
  EXPECT_EQ(set.damping_formula, Formula::per_side);
  EXPECT_EQ(set.cycles.counting, Counting::one);
  EXPECT_EQ(set.cycles.first, 3);
  EXPECT_EQ(set.test.frequencies_Hz, (std::vector{0.1, 0.5}));
  expect_limit(set, Quantity::K_eff, Scope::each, -20, 20);
  expect_limit(set, Quantity::damping, Scope::each, -20, 20);
  expect_limit(set, Quantity::K_v, Scope::each, -30, std::nullopt);
  EXPECT_EQ(set.limits.size(), 3u);
  EXPECT_EQ(set.sample->share_percent, 20);
  EXPECT_EQ(set.sample->least, 4);
  EXPECT_EQ(set.load_variation->largest_percent, 15);
  EXPECT_EQ(set.mean_analysis->within_percent, 20);
}

// Table 11.9.IV of NTC 2018 limits the effects of ageing, temperature and test frequency to 20 % for K_e and xi_e. It
// sets no limit for K_v.
TEST(BuiltInRules, NtcLimitsTheDependenceOnAgeingTemperatureAndFrequency) {
  auto const set = find_rule_set("ntc-2018");
  std::set<std::pair<std::string_view, std::string_view>> limited;
  for (auto const& limit : set.dependence) {
    limited.emplace(name(limit.effect), name(limit.quantity));
    EXPECT_EQ(limit.within_percent, 20);
    EXPECT_EQ(limit.levels, limit.effect == Effect::rate ? (std::vector{0.1, 0.5}) : std::vector<double>());
    EXPECT_TRUE(limit.clause.starts_with("Table 11.9.IV, ")) << limit.clause;
  }
  EXPECT_EQ(set.dependence.size(), 6u);
  EXPECT_EQ(limited, (std::set<std::pair<std::string_view, std::string_view>>{{"ageing", "K_eff"},
                                                                              {"ageing", "damping"},
                                                                              {"temperature", "K_eff"},
                                                                              {"temperature", "damping"},
                                                                              {"rate", "K_eff"},
                                                                              {"rate", "damping"}}));
  EXPECT_TRUE(set.effects.empty());
  EXPECT_FALSE(set.combination);
}

TEST(BuiltInRules, CombineEffectsAsCommonlyQuoted) {
  auto const aashto = find_rule_set("aashto"), en = find_rule_set("en-15129"), asce = find_rule_set("asce-7-22");
  EXPECT_EQ(aashto.combination->form, Form::each);
  EXPECT_EQ(aashto.combination->adjust, 1.0);
  EXPECT_EQ(en.combination->form, Form::each);
  EXPECT_EQ(en.combination->adjust, 0.9);
  for (auto const* set : {&aashto, &en})
    for (auto const effect : {Effect::ageing, Effect::scragging})
      for (auto const quantity : {Quantity::K_d, Quantity::Q_d}) {
        auto const* rule = set->default_of(effect, quantity);
        ASSERT_NE(rule, nullptr) << set->id;
        EXPECT_EQ(rule->default_max, 1.2);
        EXPECT_EQ(rule->default_min, 1.0);
      }
  EXPECT_EQ(aashto.default_of(Effect::ageing, Quantity::energy), nullptr);
  EXPECT_EQ(aashto.default_of(Effect::temperature, Quantity::K_d), nullptr);
  EXPECT_EQ(asce.combination->form, Form::asce);
  EXPECT_EQ(asce.combination->adjust, 0.75);
  for (auto const* id : {"iso-22762-sa", "iso-22762-sb", "iso-22762-sa-11"})
    EXPECT_FALSE(find_rule_set(id).combination) << id;
  for (auto const& set : built_in_rule_sets()) EXPECT_TRUE(set.effects.empty() || !set.verified()) << set.id;
}

TEST(BuiltInRules, OfElevenCyclesTheMeanWithoutTheFirstIsHeldToTheSameLimits) {
  auto const eleven = find_rule_set("iso-22762-sa-11"), third = find_rule_set("iso-22762-sa");
  EXPECT_EQ(eleven.cycles.counting, Counting::mean);
  EXPECT_EQ(eleven.cycles.first, 2);
  EXPECT_EQ(eleven.cycles.last, 11);
  ASSERT_EQ(eleven.limits.size(), third.limits.size());
  for (auto const& limit : third.limits)
    expect_limit(eleven, limit.quantity, limit.scope, limit.lower_percent, limit.upper_percent);
}

TEST(BuiltInRules, TheOthersHoldWhatIsCommonlyQuoted) {
  auto const sa = find_rule_set("iso-22762-sa"), sb = find_rule_set("iso-22762-sb"), en = find_rule_set("en-15129"),
             asce = find_rule_set("asce-7-22"), aashto = find_rule_set("aashto");
  expect_limit(sa, Quantity::K_eff, Scope::each, -15, 15);
  expect_limit(sa, Quantity::K_eff, Scope::mean, -10, 10);
  expect_limit(sb, Quantity::K_eff, Scope::each, -25, 25);
  expect_limit(sb, Quantity::K_eff, Scope::mean, -20, 20);
  expect_limit(en, Quantity::damping, Scope::each, -20, 20);
  ASSERT_EQ(en.stability.size(), 2u);
  EXPECT_EQ(en.stability[0].bound, 0.7);
  EXPECT_EQ(en.stability[0].first, 2);
  EXPECT_EQ(en.stability[1].bound, 0.6);
  EXPECT_EQ(en.stability[1].first, 1);
  expect_limit(asce, Quantity::K_eff, Scope::mean, -15, 15);
  EXPECT_EQ(asce.sample->share_percent, 100);
  EXPECT_EQ(asce.factors.system_factor, 0.75);
  EXPECT_EQ(asce.factors.max_not_below, 1.8);
  EXPECT_EQ(asce.factors.min_not_above, 0.6);
  expect_limit(aashto, Quantity::energy, Scope::each, -25, std::nullopt);
  expect_limit(aashto, Quantity::energy, Scope::mean, -15, std::nullopt);
}

TEST(Template, MeansWhatItsCommentsSay) {
  auto const set = read_rule_text(rule_set_text("template"), "template.toml");
  EXPECT_EQ(set.id, "contract");
  EXPECT_FALSE(set.verified());
  EXPECT_EQ(set.origin, "template.toml");
  EXPECT_EQ(set.stiffness_formula, Formula::peak_to_peak);
  EXPECT_EQ(set.cycles.first, 3);
  EXPECT_EQ(set.cycles.last, 3);
  EXPECT_EQ(set.test.strains_percent, std::vector{100.0});
  EXPECT_EQ(set.test.strain_tolerance_percent, 5);
  EXPECT_EQ(set.test.clause, "B.1");
  EXPECT_EQ(set.same_condition.temperature_C, 3);
  EXPECT_EQ(set.same_condition.frequency_percent, 15);
  EXPECT_EQ(set.same_condition.load_percent, 15);
  EXPECT_EQ(set.same_condition.amplitude_percent, 8);
  EXPECT_EQ(set.same_condition.earlier_cycles, 2);
  EXPECT_EQ(set.same_condition.clause, "B.1");
  EXPECT_EQ(set.test.frequencies_Hz, std::vector{0.5});
  EXPECT_EQ(set.test.frequency_tolerance_percent, 10);
  EXPECT_EQ(set.test.displacement_tolerance_percent, 5);
  EXPECT_EQ(set.test.load_tolerance_percent, 10);
  EXPECT_EQ(set.sample->least, 4);
  EXPECT_EQ(set.sample->clause, "B.2");
  EXPECT_EQ(set.load_variation->largest_percent, 15);
  EXPECT_EQ(set.mean_analysis->within_percent, 20);
  expect_limit(set, Quantity::K_eff, Scope::each, -15, 15);
  expect_limit(set, Quantity::K_eff, Scope::mean, -10, 10);
  expect_limit(set, Quantity::energy, Scope::each, -25, std::nullopt);
  ASSERT_EQ(set.stability.size(), 2u);
  EXPECT_EQ(set.stability[0].measure, Measure::min_over_max);
  EXPECT_EQ(set.stability[0].last, 10);
  EXPECT_EQ(set.stability[1].measure, Measure::loss_from_first);
  EXPECT_EQ(set.stability[1].bound, 20);
  EXPECT_EQ(set.factors.system_factor, 0.75);
  auto const* factors = set.factors_of(Quantity::K_d);
  ASSERT_NE(factors, nullptr);
  EXPECT_EQ(factors->environment_min, 0.9);
  EXPECT_EQ(factors->environment_max, 1.3);
  EXPECT_EQ(factors->spec_min, 0.85);
  EXPECT_EQ(factors->spec_max, 1.15);
  EXPECT_EQ(set.factors_of(Quantity::energy), nullptr);
  EXPECT_EQ(set.combination->form, Form::each);
  EXPECT_EQ(set.combination->adjust, 0.7);
  EXPECT_EQ(set.combination->clause, "B.9");
  ASSERT_EQ(set.effects.size(), 2u);
  auto const* ageing = set.default_of(Effect::ageing, Quantity::K_d);
  ASSERT_NE(ageing, nullptr);
  EXPECT_EQ(ageing->default_max, 1.2);
  EXPECT_EQ(ageing->default_min, 1.0);
  EXPECT_EQ(ageing->clause, "B.10");
  EXPECT_EQ(set.effects[1].effect, Effect::contamination);
  EXPECT_FALSE(set.effects[1].quantity);
  ASSERT_EQ(set.dependence.size(), 2u);
  EXPECT_EQ(set.dependence[0].effect, Effect::temperature);
  EXPECT_EQ(set.dependence[0].quantity, Quantity::K_eff);
  EXPECT_EQ(set.dependence[0].within_percent, 20);
  EXPECT_TRUE(set.dependence[0].levels.empty());
  EXPECT_EQ(set.dependence[1].effect, Effect::rate);
  EXPECT_EQ(set.dependence[1].quantity, Quantity::damping);
  EXPECT_EQ(set.dependence[1].levels, (std::vector{0.1, 0.5}));
}

// A comment of the template lists other ways of counting cycles. Each must be valid in place of the template's own.
TEST(Template, OffersThreeWaysOfCountingCycles) {
  auto const with = [](std::string_view cycles) {
    std::string text(rule_set_text("template"));
    auto const at = text.find("one = 3 ");
    return read_rule_text(text.replace(at, 8, cycles), "t.toml").cycles;
  };
  EXPECT_EQ(with("mean_of = [1, 3]").counting, Counting::mean);
  EXPECT_EQ(with("mean_of = [1, 3]").first, 1);
  EXPECT_EQ(with("each_of = [2, 10]").counting, Counting::each);
  EXPECT_EQ(with("each_of = [2, 10]").last, 10);
}

TEST(ReadRules, ASignedFileIsVerified) {
  EXPECT_TRUE(rules_of(one_limit).verified());
  auto unsigned_text = head + std::string(one_limit);
  unsigned_text.replace(unsigned_text.find("the test"), 8, "");
  EXPECT_FALSE(read_rule_text(unsigned_text, "rules.toml").verified());
  unsigned_text.replace(unsigned_text.find("verified_by = \"\""), 16, "verified_by = \"  \"");
  expect_parts(refusal_of([&] { read_rule_text(unsigned_text, "rules.toml"); }), {"rules.toml:5: ", "blanks alone"});
}

TEST(ReadRules, SaysEverythingThatIsWrongAtOnce) {
  auto const said = refused(
      "[tset]\n[sample]\nshare_percent = 120\nleast = 0\n[[limit]]\nquantity = \"K_off\"\napplies_to = \"all\"\n"
      "within_percent = true\n[[limit]]\nquantity = \"energy\"\napplies_to = \"each\"\n");
  expect_parts(said, {"rules.toml:11: unknown key 'tset'", "rules.toml:13: share_percent: 120 is out of range",
                      "rules.toml:14: least: 0 is out of range", "rules.toml:16: quantity: 'K_off'; allowed: \"K_eff\"",
                      "rules.toml:17: applies_to: 'all'", "rules.toml:18: 'within_percent' is not a number",
                      "rules.toml:19: a limit without a bound"});
}

TEST(ReadRules, RefusesLimitsThatContradictOneAnother) {
  auto const each = [](std::string_view bounds) {
    return refused(fmt::format("[[limit]]\nquantity = \"K_eff\"\napplies_to = \"each\"\n{}\n", bounds));
  };
  EXPECT_EQ(each("lower_percent = -25"), "");
  EXPECT_EQ(each("lower_percent = 0\nupper_percent = 0"), "");
  expect_parts(each("within_percent = 20\nlower_percent = -25"), {"rules.toml:11: ", "beside"});
  expect_parts(each("lower_percent = 5\nupper_percent = 10"), {"rules.toml:11: ", "outside the limit"});
  expect_parts(each("lower_percent = 5\nupper_percent = -5"), {"rules.toml:11: ", "outside the limit"});
  expect_parts(each("within_percent = nan"), {"rules.toml:14: ", "out of range"});
  expect_parts(each("within_percent = inf"), {"rules.toml:14: ", "out of range"});
  expect_parts(each("within_percent = -20"), {"rules.toml:14: ", "out of range"});
  expect_parts(refused(fmt::format("{0}{0}", one_limit)), {"rules.toml:15: a second limit of K_eff for each device"});
}

TEST(ReadRules, RefusesWhatIsHalfGiven) {
  auto const with = [](std::string_view tail) { return refused(fmt::format("{}{}", tail, one_limit)); };
  EXPECT_EQ(with(""), "");
  expect_parts(refused(""), {"no limits"});
  EXPECT_EQ(refused("[[effect]]\nname = \"ageing\"\n"), "");
  expect_parts(with("[test]\nstrains_percent = [100]\n"), {"strains without their tolerance"});
  expect_parts(with("[test]\nfrequencies_Hz = [0.5]\n"), {"frequencies without their tolerance"});
  expect_parts(with("[test]\nfrequencies_Hz = []\nfrequency_tolerance_percent = 5\n"), {"not a list of numbers"});
  expect_parts(with("[[factor]]\nquantity = \"K_d\"\nspec_min = 0.9\n"), {"half a contract band"});
  expect_parts(with("[[factor]]\nquantity = \"K_d\"\nenvironment_max = 0.9\n"), {"0.9 is out of range"});
  expect_parts(with("[[factor]]\nquantity = \"K_d\"\n[[factor]]\nquantity = \"K_d\"\n"), {"a second [[factor]]"});
  expect_parts(
      with("[[stability]]\nquantity = \"K_eff\"\nmeasure = \"min_over_max\"\ncycles = [10, 2]\nat_least = 0.7\n"),
      {"not a range of cycles"});
  expect_parts(
      with("[[stability]]\nquantity = \"K_v\"\nmeasure = \"min_over_max\"\ncycles = [2, 10]\nat_most_percent = 7\n"),
      {"'at_least' is missing", "unknown key 'at_most_percent'", "K_v is not measured in cycles"});
}

std::string refused_beside_a_limit(std::string_view tail) {  // the first line of the tail is line 15 of the file
  return refused(fmt::format("{}{}", one_limit, tail));
}

TEST(ReadRules, CombinesEffectsInOneOfFourForms) {
  auto const with = [](std::string_view tail) { return rules_of(fmt::format("{}{}", one_limit, tail)).combination; };
  EXPECT_FALSE(with(""));
  auto const of_factors = with("[factors]\nsystem_factor = 0.75\nclause = \"17.2.8\"\n");
  EXPECT_EQ(of_factors->form, Form::asce);
  EXPECT_EQ(of_factors->adjust, 0.75);
  EXPECT_EQ(of_factors->clause, "17.2.8");
  auto const each = with("[combination]\nform = \"each\"\nadjust = 0.66\n[factors]\nsystem_factor = 0.75\n");
  EXPECT_EQ(each->form, Form::each);
  EXPECT_EQ(each->adjust, 0.66);
  EXPECT_EQ(with("[combination]\nform = \"asce\"\n[factors]\nsystem_factor = 0.5\n")->adjust, 0.5);
  EXPECT_EQ(with("[combination]\nform = \"product\"\n")->adjust, 1.0);
  EXPECT_EQ(with("[combination]\nform = \"sum\"\nmargin = 1.2\n")->margin, 1.2);

  expect_parts(refused_beside_a_limit("[combination]\nadjust = 0.66\nshare = 1\n"),
               {"rules.toml:15: 'form' is missing", "rules.toml:17: unknown key 'share' in [combination]"});
  expect_parts(refused_beside_a_limit("[combination]\nform = \"both\"\nadjust = 1.5\n"),
               {"rules.toml:16: form: 'both'; allowed: \"asce\", \"each\", \"product\", \"sum\"",
                "rules.toml:17: adjust: 1.5 is out of range"});
  expect_parts(refused_beside_a_limit("[combination]\nform = \"asce\"\nadjust = 0.66\n"),
               {"rules.toml:15: 'adjust' with the form \"asce\"", "system_factor in [factors]"});
  expect_parts(refused_beside_a_limit("[combination]\nform = \"sum\"\nadjust = 0.66\n"), {"'adjust' with the form"});
  expect_parts(refused_beside_a_limit("[combination]\nform = \"each\"\nmargin = 1.2\n"),
               {"'margin' with the form \"each\""});
}

TEST(ReadRules, AnEffectHasOneGroupAndOneDefaultForAQuantity) {
  auto const ageing_of = [](std::string_view quantity, std::string_view more = "") {
    return fmt::format("[[effect]]\nname = \"ageing\"\nquantity = \"{}\"\ndefault_max = 1.2\ndefault_min = 0.9\n{}",
                       quantity, more);
  };
  auto const set = rules_of(fmt::format("{}{}{}[[effect]]\nname = \"load\"\n", one_limit, ageing_of("K_d"),
                                        ageing_of("Q_d", "group = \"test\"\n")));
  EXPECT_EQ(set.default_of(Effect::ageing, Quantity::Q_d)->default_max, 1.2);
  EXPECT_EQ(set.default_of(Effect::ageing, Quantity::Q_d)->default_min, 0.9);
  EXPECT_EQ(set.default_of(Effect::load, Quantity::K_d), nullptr);
  EXPECT_EQ(set.group_of(Effect::ageing), Group::test);
  std::vector<std::pair<Effect, Group>> const usual{
      {Effect::temperature, Group::environment},  {Effect::rate, Group::test},      {Effect::load, Group::none},
      {Effect::ageing, Group::environment},       {Effect::scragging, Group::test}, {Effect::cycles, Group::test},
      {Effect::contamination, Group::environment}};
  for (auto const& [effect, group] : usual) EXPECT_EQ(rules_of(one_limit).group_of(effect), group) << name(effect);

  expect_parts(refused_beside_a_limit(ageing_of("K_d") + ageing_of("K_d")),
               {"rules.toml:20: a second [[effect]] of ageing on K_d"});
  expect_parts(refused_beside_a_limit("[[effect]]\nname = \"rate\"\n[[effect]]\nname = \"rate\"\n"),
               {"rules.toml:17: a second [[effect]] of rate"});
  expect_parts(refused_beside_a_limit(ageing_of("K_d", "group = \"test\"\n") + ageing_of("Q_d", "group = \"none\"\n")),
               {"rules.toml:21: ageing is of group \"test\" and of group \"none\""});
  for (auto const* half : {"quantity = \"K_d\"\n", "default_max = 1.2\n", "quantity = \"K_d\"\ndefault_max = 1.2\n",
                           "default_max = 1.2\ndefault_min = 1.0\n"})
    expect_parts(refused_beside_a_limit(fmt::format("[[effect]]\nname = \"ageing\"\n{}", half)),
                 {"rules.toml:15: half a default"});
  expect_parts(refused_beside_a_limit("[[effect]]\nname = \"aging\"\ngroup = \"tests\"\nkind = 1\n"),
               {"rules.toml:16: name: 'aging'; allowed: \"temperature\"", "rules.toml:17: group: 'tests'",
                "rules.toml:18: unknown key 'kind' in [[effect]]"});
  expect_parts(refused_beside_a_limit("[[effect]]\ngroup = \"test\"\n"), {"rules.toml:15: 'name' is missing"});
  expect_parts(refused_beside_a_limit(ageing_of("damping")), {"rules.toml:17: quantity: 'damping'"});
  expect_parts(refused_beside_a_limit("[[effect]]\nname = \"rate\"\nquantity = \"K_d\"\ndefault_max = 0.9\ndefault_min "
                                      "= 1.1\n"),
               {"rules.toml:18: default_max: 0.9 is out of range", "rules.toml:19: default_min: 1.1 is out of range"});
}

TEST(ReadRules, LimitsADependenceOnceAtEachLevel) {
  auto const limit = [](std::string_view effect, std::string_view more = "") {
    return fmt::format("[[dependence]]\neffect = \"{}\"\nquantity = \"K_eff\"\nwithin_percent = 20\n{}", effect, more);
  };
  EXPECT_EQ(refused_beside_a_limit(limit("temperature", "levels = [-20]\n") + limit("temperature", "levels = [-10]\n") +
                                   limit("load") + limit("ageing")),
            "");
  expect_parts(refused_beside_a_limit(limit("load") + limit("load", "levels = [1000]\n")),
               {"rules.toml:19: a second limit of load on K_eff"});
  expect_parts(refused_beside_a_limit(limit("rate", "levels = [0.1, 0.5]\n") + limit("rate", "levels = [0.5]\n")),
               {"rules.toml:20: a second limit of rate on K_eff"});
  expect_parts(refused_beside_a_limit(limit("ageing", "levels = [14]\n")), {"rules.toml:15: 'levels' of ageing"});
  for (auto const* effect : {"scragging", "cycles", "contamination"})
    expect_parts(refused_beside_a_limit(limit(effect)),
                 {"rules.toml:16: effect: ", "allowed: \"temperature\", \"rate\", \"load\", \"ageing\""});
  expect_parts(refused_beside_a_limit("[[dependence]]\neffect = \"rate\"\nquantity = \"K_v\"\nlevels = [0]\nat = 1\n"),
               {"rules.toml:15: 'within_percent' is missing", "rules.toml:17: quantity: 'K_v'",
                "rules.toml:18: levels: 0 is out of range", "rules.toml:19: unknown key 'at' in [[dependence]]"});
  expect_parts(refused_beside_a_limit(limit("temperature", "levels = [-300]\n")), {"-300 is out of range"});
}

TEST(ReadRules, CountsCyclesInExactlyOneWay) {
  auto const with = [](std::string_view cycles) {
    auto text = head + std::string(one_limit);
    text.replace(text.find("one = 3"), 7, cycles);
    return refusal_of([&] { read_rule_text(text, "rules.toml"); });
  };
  EXPECT_EQ(with("one = 1"), "");
  expect_parts(with(""), {"rules.toml:9: not exactly one way"});
  expect_parts(with("one = 3\nmean_of = [1, 3]"), {"not exactly one way"});
  expect_parts(with("one = 3.0"), {"'one' is not a whole number"});
  expect_parts(with("mean_of = [0, 3]"), {"not a range of cycles"});
}

TEST(ReadRules, RefusesHostileFiles) {
  auto const read = [](std::string const& text) { return refusal_of([&] { read_rule_text(text, "rules.toml"); }); };
  expect_parts(read(std::string(largest_rule_file + 1, '#')), {"a rule file of at most"});
  expect_parts(read("a = " + std::string(100'000, '[')), {"rules.toml:1: ", "nested deeper than any rule file needs"});
  expect_parts(read("id = "), {"rules.toml:1: "});
  auto const escape = refused("[sample]\nshare_percent = 20\nclause = \"\\u001b[2J\"\n" + std::string(one_limit));
  expect_parts(escape, {"control characters", "\\x1b"});
  EXPECT_EQ(escape.find('\x1b'), std::string::npos);
  expect_parts(refused("[sample]\nshare_percent = 20\nclause = \"" + std::string(3000, 'x') + "\"\n"),
               {"3000 bytes long"});
  std::string many;
  for (int i = 0; i < 200; ++i) many += fmt::format("wrong{} = 1\n", i);
  expect_parts(read(many), {"and more of the kind"});
  many.clear();
  for (int i = 0; i < 101; ++i) many += one_limit;
  expect_parts(refused(many), {"at most 100 tables"});
  expect_parts(read("id = \"../x\"\n"), {"rules.toml:1: id: '../x'"});
}

TEST(FindRules, NamesWhatThereIs) {
  expect_parts(refusal_of([] { find_rule_set("no-such"); }),
               {"no-such: no such file", "ntc-2018", "or a rule file", "isolaw rules template"});
  expect_parts(refusal_of([] { rule_set_text("no-such"); }), {"no rule set 'no-such'", "ntc-2018, template"});
  expect_parts(refusal_of([] { find_rule_set("/dev"); }), {"is a directory"});
}

// A campaign without rules stores an empty text. An empty file must therefore not be accepted as a rule set.
TEST(FindRules, AnEmptyFileIsNoRuleSet) {
  auto const path = std::filesystem::temp_directory_path() / "isolaw-empty-rules.toml";
  std::ofstream(path).close();
  expect_parts(refusal_of([&] { load_rule_text(path.string()); }), {"an empty file", "isolaw rules template"});
  std::filesystem::remove(path);
}

TEST(RequiredSample, IsTheShareWithinItsBounds) {
  SampleRule const ntc{.share_percent = 20, .least = 4, .clause = {}};
  // The sample is min(N, max(4, ceil(0.2 N))). For 28 devices 5.6 is rounded up to 6. For 35 it is exactly 7, although
  // 0.2 is inexact in binary. Of 3 or 4 devices all are tested.
  std::vector<std::pair<int, int>> const by_size{{0, 0},  {1, 1},  {3, 3},  {4, 4},   {20, 4},
                                                 {21, 5}, {28, 6}, {35, 7}, {100, 20}};
  for (auto const& [lot, sample] : by_size) EXPECT_EQ(required_sample(ntc, lot), sample) << lot;
  for (int lot = 5; lot < 1000; lot += 5) EXPECT_EQ(required_sample(ntc, lot), std::max(lot / 5, 4)) << lot;
  // 2.2 % of 1500 is 33, but in binary arithmetic it is 33.000000000000004.
  EXPECT_EQ(required_sample({.share_percent = 2.2, .least = 1, .clause = {}}, 1500), 33);
  EXPECT_EQ(required_sample({.share_percent = 100, .least = 1, .clause = {}}, 28), 28);
}

}  // namespace
}  // namespace isolaw::rules
