// For each option that affects the numbers, tests what it does and how wrong values are refused.
#include <cmath>
#include <sstream>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"
#include "setting_samples.hpp"

namespace isolaw::cli_test {
namespace {

class Settings : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("one.csv", csv(record()));
  }
  Words command(Words const& more) const { return Words{"calibrate", "one.csv", "--out", "O", "--fresh"} + more; }
  Outcome run(Words const& more, std::string const& laws = "bilinear") {
    return isolaw(command(Words{"--laws", laws, "--runs", "2", "--population", "8", "--generations", "2"} + more));
  }
  Json parameter(std::string const& name) {
    return json("O/summary.json")["laws"][0]["devices"][0]["parameters"][name];
  }
  void expect_nothing_written() { EXPECT_FALSE(exists("O")); }
};

TEST_F(Settings, set_fixes_a_parameter) {
  auto const o = run({"--set", "bilinear.K2=0.4"});
  EXPECT_EQ(o.code, 0) << o;
  auto const K2 = parameter("K2");
  EXPECT_EQ(K2["free"], false);
  for (auto const* key : {"mean", "best"}) EXPECT_EQ(K2[key], 0.4);
  EXPECT_EQ(K2["std"], 0.0);
  EXPECT_TRUE(K2["at_bound"].is_null());
  EXPECT_EQ(parameter("K1")["free"], true);
}

TEST_F(Settings, set_bounds_a_parameter) {
  auto const o = run({"--set", "bilinear.K2=0.3:0.35"});
  EXPECT_EQ(o.code, 0) << o;
  auto const K2 = parameter("K2");
  EXPECT_EQ(K2["lower"], 0.3);
  EXPECT_EQ(K2["upper"], 0.35);
  EXPECT_GE(K2["best"].get<double>(), 0.3);
  EXPECT_LE(K2["best"].get<double>(), 0.35);
}

TEST_F(Settings, set_frees_a_parameter_that_is_fixed_by_default) {
  EXPECT_EQ(run({}, "vaiana").code, 0);
  EXPECT_EQ(parameter("gamma1+")["free"], false);
  EXPECT_EQ(parameter("gamma1+")["best"], 0.0);
  auto const o = run({"--set", "vaiana.gamma1+=free"}, "vaiana");
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(parameter("gamma1+")["free"], true);
  EXPECT_NE(parameter("gamma1+")["best"], 0.0);
  EXPECT_EQ(parameter("gamma1-")["free"], false);
}

TEST_F(Settings, set_may_be_repeated_for_other_parameters) {
  auto const o = run({"--set", "bilinear.K1=1.5", "--set", "bilinear.K2=0.45"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_EQ(parameter("K2")["best"], 0.45);
  EXPECT_EQ(parameter("K1")["best"], 1.5);
  EXPECT_EQ(json("O/summary.json")["settings"]["set"], Json::array({"bilinear.K1=1.5", "bilinear.K2=0.45"}));
}

TEST_F(Settings, set_may_stand_before_the_inputs) {
  auto const o = isolaw({"calibrate", "--set", "bilinear.K2=0.4", "one.csv", "--laws", "bilinear", "--runs", "1",
                         "--population", "4", "--generations", "1", "--out", "O"});
  EXPECT_EQ(o.code, 0) << o;
}

TEST_F(Settings, all_parameters_fixed_evaluates_that_one_point) {
  auto const o = run({"--set", "bilinear.K1=2.5", "--set", "bilinear.K2=0.5", "--set", "bilinear.xy=10"});
  EXPECT_EQ(o.code, 0) << o;
  auto const law = json("O/summary.json")["laws"][0];
  // The fixed values are those of the device that made the record. The objective is not exactly 0, because the record
  // gives displacement and force with five decimals.
  EXPECT_LT(law["objective"]["best"].get<double>(), 0.02);
  EXPECT_EQ(law["objective"]["std"], 0.0);
  EXPECT_TRUE(contains(law["beta_note"].get<std::string>(), "no free parameter"));
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT DISTINCT evaluations, length(history) / 8 FROM run"),
            Words{"1|1"});
}

TEST_F(Settings, best_value_at_an_edge_of_its_box_is_reported) {
  // The device has K2 = 0.5, so in the box from 3 to 4 the best value of K2 is 3. Some of the 4000 random points lie so
  // near to 3 that they differ from it by at most 0.1 % of the box's width.
  auto const o = isolaw(command({"--laws", "bilinear", "--runs", "1", "--population", "4000", "--generations", "3",
                                 "--set", "bilinear.K1=4.5", "--set", "bilinear.xy=10", "--set", "bilinear.K2=3:4"}));
  EXPECT_EQ(o.code, 0) << o;
  auto const K2 = parameter("K2");
  EXPECT_LE(K2["best"].get<double>(), 3.001);
  EXPECT_EQ(K2["at_bound"], "lower");
  EXPECT_TRUE(contains(o.out, "Bilinear: K2 at its lower bound on one"));
  EXPECT_TRUE(contains(read("O/tables/parameters.csv"), "one lower"));
}

TEST_F(Settings, malformed_set_is_refused) {
  std::string const form = "law.parameter=value, law.parameter=lower:upper, law.parameter=free";
  for (std::string const text : {"bilinear", "bilinear.K2", "bilinear=3", "K2=0.4"})
    expect_refused(run({"--set", text}), {"--set " + text, "not of the form", form});
  for (std::string const value : {"abc", "1:2:3", ":", "nan", "inf", "1e400", "0,4", " 0.4", "free,bilinear.K1=3", ""})
    expect_refused(run({"--set", "bilinear.K2=" + value}),
                   {"--set bilinear.K2=" + value, "'" + value + "' is not a number", form});
  expect_nothing_written();
}

TEST_F(Settings, set_of_an_unknown_law_or_parameter_is_refused) {
  expect_refused(run({"--set", "nope.K2=3"}), {"'nope'", "no such law", "bilinear, jankowski", "isolaw laws"});
  expect_refused(run({"--set", "bilinear.K9=3"}),
                 {"law bilinear", "unknown parameter 'K9'", "K1, K2, xy", "isolaw laws bilinear"});
  expect_nothing_written();
}

TEST_F(Settings, box_with_lower_not_below_upper_is_refused) {
  expect_refused(run({"--set", "bilinear.K2=0.5:0.3"}),
                 {"--set bilinear.K2=0.5:0.3", "the lower bound 0.5 is not below the upper bound 0.3", "lower < upper",
                  "try: --set bilinear.K2=0.3:0.5"});
  expect_refused(run({"--set", "bilinear.K2=0.5:0.5"}), {"is not below", "one value to fix"});
  expect_nothing_written();
}

TEST_F(Settings, values_outside_the_physical_limits_are_refused) {
  expect_refused(run({"--set", "abe.n=-1"}), {"--set abe.n=-1", "physical limits of n", "allowed: "});
  expect_refused(run({"--set", "bilinear.xy=-5:10"}), {"[-5, 10]", "physical limits of xy", "mm"});
  expect_nothing_written();
}

TEST_F(Settings, published_and_auto_boxes_differ_and_are_recorded) {
  ASSERT_EQ(run({"--box", "published"}).code, 0);
  EXPECT_EQ(parameter("K2")["lower"], 0.35);
  EXPECT_EQ(parameter("K2")["upper"], 0.95);
  EXPECT_EQ(json("O/summary.json")["settings"]["box"], "published");
  ASSERT_EQ(run({}).code, 0);  // --box auto is the default
  EXPECT_EQ(json("O/summary.json")["settings"]["box"], "auto");
  EXPECT_NE(parameter("K2")["upper"], 0.95);
  // The automatic box follows from the record and must contain the device's values.
  EXPECT_LT(parameter("K2")["lower"].get<double>(), 0.5);
  EXPECT_GT(parameter("K2")["upper"].get<double>(), 0.5);
  EXPECT_LT(parameter("K1")["lower"].get<double>(), 2.5);
  EXPECT_GT(parameter("K1")["upper"].get<double>(), 2.5);
  EXPECT_LT(parameter("xy")["lower"].get<double>(), 10.0);
  EXPECT_GT(parameter("xy")["upper"].get<double>(), 10.0);
}

TEST_F(Settings, auto_box_follows_a_device_of_another_size_and_unit) {
  // The new header multiplies displacements by 10 and forces by 1000. The automatic box must change in proportion.
  write("big.csv", csv(record(), "time [s],displacement [cm],force [MN]"));
  ASSERT_EQ(run({}).code, 0);
  auto const small = parameter("K2");
  auto const o = isolaw({"calibrate", "big.csv", "--laws", "bilinear", "--runs", "2", "--population", "8",
                         "--generations", "2", "--out", "P"});
  ASSERT_EQ(o.code, 0) << o;
  auto const big = json("P/summary.json")["laws"][0]["devices"][0]["parameters"]["K2"];
  EXPECT_NEAR(big["lower"].get<double>(), 100.0 * small["lower"].get<double>(),
              1e-9 * std::abs(big["lower"].get<double>()));
  EXPECT_NEAR(big["upper"].get<double>(), 100.0 * small["upper"].get<double>(), 1e-9 * big["upper"].get<double>());
}

TEST_F(Settings, paper_and_converged_integration_give_other_objectives) {
  ASSERT_EQ(run({"--integration", "paper"}, "bouc-wen").code, 0);
  auto const paper = json("O/summary.json");
  ASSERT_EQ(run({"--integration", "converged"}, "bouc-wen").code, 0);
  auto const converged = json("O/summary.json");
  EXPECT_EQ(paper["settings"]["integration"], "paper");
  EXPECT_EQ(converged["settings"]["integration"], "converged");
  EXPECT_NE(paper["laws"][0]["objective"], converged["laws"][0]["objective"]);
  EXPECT_LT(converged["laws"][0]["devices"][0]["integration_shift"].get<double>(), 1e-4);
}

TEST_F(Settings, turning_points_between_the_samples_are_an_option_that_is_stored_and_reported) {
  write("one.csv", csv(record({.per_cycle = 199})));  // with 199 samples a cycle the peaks lie between samples
  ASSERT_EQ(run({"--turning-points", "interpolated"}, "bouc-wen").code, 0);
  auto const interpolated = json("O/summary.json");
  EXPECT_EQ(isolaw({"check", "O"}).code, 0);
  ASSERT_EQ(run({}, "bouc-wen").code, 0);
  auto const sampled = json("O/summary.json");
  EXPECT_EQ(interpolated["settings"]["turning-points"], "interpolated");
  EXPECT_EQ(sampled["settings"]["turning-points"], "sampled");
  EXPECT_NE(interpolated["laws"][0]["objective"], sampled["laws"][0]["objective"]);
  expect_refused(run({"--turning-points", "rounded"}), {"turning-points", "'rounded'", "sampled, interpolated"});
}

TEST_F(Settings, unknown_words_are_refused_with_the_known_ones) {
  expect_refused(run({"--box", "wide"}), {"--box", "'wide'", "published, auto"});
  expect_refused(run({"--integration", "rk"}), {"--integration", "'rk'", "converged, paper"});
  expect_refused(run({"--method", "pso"}), {"--method", "'pso'", "ga"});
  expect_refused(run({}, "nope"), {"'nope'", "no such law", "bilinear, jankowski"});
  expect_refused(run({}, "bilinear,nope"), {"'nope'", "no such law"});
  expect_refused(run({}, ""), {"''", "no such law"});
  expect_refused(run({"--samples-per-cycle", "some"}), {"--samples-per-cycle", "'some'", "20 or more, or all"});
  expect_nothing_written();
}

TEST_F(Settings, numbers_out_of_range_are_refused) {
  auto const with = [&](char const* option, char const* value) {
    return isolaw({"calibrate", "one.csv", "--out", "O", option, value});
  };
  for (auto const* value : {"0", "-1", "1000000"})
    expect_refused(with("--runs", value), {"--runs", value, "1 to 100000"});
  for (auto const* value : {"7", "2", "0", "-4"})
    expect_refused(with("--population", value), {"--population", value, "an even number from 4"});
  for (auto const* value : {"0", "-1"}) expect_refused(with("--generations", value), {"--generations", value, "1 to "});
  for (auto const* value : {"4", "0", "-3"})
    expect_refused(with("--smooth", value), {"smooth", value, "an odd number"});
  for (auto const* value : {"5", "19", "-200"})
    expect_refused(with("--samples-per-cycle", value), {"samples", value, "20 or more, or all"});
  expect_refused(with("--jobs", "-1"), {"--jobs", "-1"});
  expect_nothing_written();
}

TEST_F(Settings, seed_below_zero_or_beyond_64_bits_is_refused) {
  expect_refused(run({"--seed", "-1"}), {"--seed", "-1"});
  expect_refused(run({"--seed", "99999999999999999999"}), {"--seed", "99999999999999999999"});
  expect_nothing_written();
}

TEST_F(Settings, largest_seed_comes_back_exactly) {
  ASSERT_EQ(run({"--seed", "18446744073709551615"}).code, 0);
  EXPECT_EQ(json("O/summary.json")["seed"].get<std::uint64_t>(), 18446744073709551615u);
}

TEST_F(Settings, cleaning_is_done_and_recorded) {
  write("fine.csv", csv(record({.samples = 2401, .per_cycle = 800, .interval_s = 0.0025})));
  auto const o =
      isolaw({"calibrate", "fine.csv", "--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1",
              "--smooth", "5", "--samples-per-cycle", "100", "--center", "--out", "P"});
  EXPECT_EQ(o.code, 0) << o;
  auto const cleaning = query(path("P/campaign.sqlite"), "SELECT cleaning FROM device").at(0);
  EXPECT_TRUE(contains(cleaning, R"("kind":"smoothed","numbers":{"window_samples":5.0,)"));
  EXPECT_TRUE(contains(cleaning, R"("kind":"centred")"));
  EXPECT_TRUE(contains(cleaning, R"("every":8.0,"of_samples":2401.0,"samples":301.0)"));
  EXPECT_EQ(query(path("P/campaign.sqlite"), "SELECT kind, count FROM series WHERE channel = 'disp_mm' ORDER BY kind"),
            (Words{"fit|301", "raw|2401"}));
}

// Returns three cycles at 100 mm followed by three at 60 mm.
std::vector<Sample> two_blocks() {
  auto samples = record();
  auto const block = record({.amplitude_mm = 60.0});
  auto const end = samples.back().time_s;
  for (std::size_t i = 1; i < block.size(); ++i)
    samples.push_back({end + block[i].time_s, block[i].disp_mm, block[i].force_kN});
  return samples;
}

// Gives every setting a value that is not its default, once on the command line and once in a lot file. Both campaigns
// must be equal. The command that report.html shows must make the same campaign again.
TEST_F(Settings, every_setting_comes_by_command_line_and_lot_file_and_makes_the_campaign_again) {
  write("one.csv", csv(two_blocks()));
  Words words{"calibrate", "one.csv", "--out", "O"};
  Json expected;
  std::string lot = "title = \"one\"\n[[device]]\nfile = \"one.csv\"\n[calibrate]\n";
  for (auto const& setting : campaign::setting_table()) {
    if (setting.stored_only) continue;
    auto const value = testing::another(setting);
    words = words + words_of(setting, value);
    lot += fmt::format("{} = {}\n", setting.option(),
                       setting.key == "seed" ? fmt::format("'{}'", text_of(value)) : value.dump());
    expected[std::string(setting.key)] = Json::parse(value.dump());
  }
  auto const once = isolaw(words);
  ASSERT_EQ(once.code, 0) << once;
  auto const summary = json("O/summary.json");
  EXPECT_EQ(summary["seed"], expected["seed"]);
  expected.erase("seed");
  for (auto const& [key, value] : expected.items()) EXPECT_EQ(summary["settings"][key], value) << key;

  write("lot.toml", lot);
  auto const from_file = isolaw({"calibrate", "lot.toml", "--out", "L"});
  EXPECT_EQ(from_file.code, 0) << from_file;
  EXPECT_EQ(json("L/summary.json")["laws"], summary["laws"]);
  EXPECT_EQ(json("L/summary.json")["settings"], summary["settings"]);

  auto const page = read("O/report.html");
  auto const start = page.find("\"command\":\"isolaw ") + 18;
  std::istringstream command(page.substr(start, page.find('"', start) - start));
  Words again;
  for (std::string word; command >> word;) again.push_back(word);
  auto const repeated = isolaw(again + Words{"--out", "P"});
  EXPECT_EQ(repeated.code, 0) << repeated;
  EXPECT_EQ(read("P/summary.json"), read("O/summary.json"));
}

TEST_F(Settings, every_setting_refuses_what_it_may_not_be_by_its_name) {
  for (auto const& setting : campaign::setting_table()) {
    if (setting.stored_only || setting.kind == Kind::flag) continue;
    for (auto const& value : testing::not_allowed(setting)) {
      auto const option = "--" + setting.option();
      auto const o = isolaw({"calibrate", "one.csv", "--out", "O", option, text_of(value)});
      expect_refused(
          o, {"isolaw: " + option, setting.kind == Kind::repeated ? text_of(value) : shown(value), "; allowed: "});
      EXPECT_EQ(count_of("\n", o.err), 1u) << o;
    }
  }
  expect_nothing_written();
}

TEST_F(Settings, columns_by_name_and_by_number_and_units_read_a_file_without_names) {
  write("bare.csv", csv(record()).substr(std::string(header).size() + 1));
  expect_refused(isolaw({"inspect", "bare.csv"}), {"bare.csv", "no line names the 3 columns", "column numbers 1 to 3",
                                                   "--columns time=1,disp=2,force=3"});
  auto const by_number = isolaw(
      {"inspect", "bare.csv", "--columns", "time=1,disp=2,force=3", "--units", "time=s,disp=mm,force=kN", "--json"});
  ASSERT_EQ(by_number.code, 0) << by_number;
  auto const by_name = isolaw({"inspect", "one.csv", "--columns", "force=force [kN],disp=displacement", "--json"});
  ASSERT_EQ(by_name.code, 0) << by_name;
  EXPECT_EQ(Json::parse(by_number.out)["cycles"], Json::parse(by_name.out)["cycles"]);
}

TEST_F(Settings, malformed_columns_and_units_are_refused) {
  auto const with = [&](char const* option, char const* value) {
    return isolaw({"inspect", "one.csv", option, value});
  };
  expect_refused(with("--columns", "disp"), {"--columns", "disp has no value", "CHANNEL=VALUE"});
  expect_refused(with("--columns", "displ=2"), {"--columns", "unknown channel 'displ'", "time, disp, force, load"});
  expect_refused(with("--columns", "disp=2,disp=3"), {"disp is given twice"});
  expect_refused(with("--columns", "disp=9"), {"one.csv:1", "no column 9 for disp", "1 to 3", "3 'force [kN]'"});
  expect_refused(with("--columns", "force=shear"), {"one.csv:1", "'shear'", "2 'displacement [mm]'"});
  expect_refused(with("--columns", "disp=3"), {"one.csv:1", "kN", "is a force, not a length"});
  expect_refused(with("--units", "force=stone"), {"--units force", "'stone'", "kN, N, MN, tonf, kgf"});
  expect_refused(with("--units", "force=mm"), {"--units force", "mm is a length", "kN, N, MN"});
}

}  // namespace
}  // namespace isolaw::cli_test
