// A lot file may name rule sets. Tests where their files may lie, what init --like takes over from a lot file, and what
// reports and `check` say of the rules.
#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class HeldTo : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("m/a.csv", csv(record()));
    write("m/b.csv", csv(record({.stiffness_kN_per_mm = 0.52})));
    write("m/c.csv", csv(record({.stiffness_kN_per_mm = 0.48})));
  }
  static std::string lot(std::string const& acceptance) {
    return "[acceptance]\n" + acceptance + "\n[[device]]\nfile = \"a.csv\"\n[[device]]\nfile = \"b.csv\"\n";
  }
  std::string own_rules(std::string const& id) {
    auto text = isolaw({"rules", "iso-22762-sa"}).out;
    auto const at = text.find("id = \"iso-22762-sa\"");
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, 19, "id = \"" + id + "\"");
  }
};

TEST_F(HeldTo, rules_of_a_lot_file_are_not_looked_for_where_the_program_runs) {
  write("secret.toml", own_rules("secret"));
  write("m/lot.toml", lot("rules = \"../secret.toml\""));
  for (Words const& command : {Words{"inspect", "m/lot.toml"}, Words{"calibrate", "m/lot.toml"}})
    expect_refused(isolaw(command), {"m/lot.toml:2: rules: '../secret.toml' leads outside", "--allow-outside"});
  // The file secret.toml lies in the directory where isolaw runs, not beside the lot file.
  write("m/lot.toml", lot("rules = \"secret.toml\""));
  expect_refused(isolaw({"inspect", "m/lot.toml"}),
                 {"m/lot.toml:2: rules: 'secret.toml' is neither a built-in rule set nor a file here"});
  write("m/lot.toml", lot("rules = \"../secret.toml\""));
  EXPECT_EQ(isolaw({"inspect", "m/lot.toml", "--allow-outside"}).code, 0);
}

TEST_F(HeldTo, rules_of_a_lot_file_are_built_in_or_beside_it) {
  write("m/own.toml", own_rules("own"));
  for (auto const& [name, id] : {std::pair{"own.toml", "own"}, std::pair{"ntc-2018", "ntc-2018"}}) {
    write("m/lot.toml", lot("rules = \"" + std::string(name) + "\""));
    auto const o = isolaw({"inspect", "m/lot.toml", "--json"});
    ASSERT_EQ(o.code, 0) << o;
    EXPECT_EQ(Json::parse(o.out)["assessment"]["rule_set"]["id"], id);
  }
}

TEST_F(HeldTo, the_output_names_no_path_of_the_machine) {
  write("m/own.toml", own_rules("own"));
  write("m/lot.toml", lot("rules = \"own.toml\""));
  auto const o = isolaw({"inspect", path("m/lot.toml").string(), "--json"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_EQ(Json::parse(o.out)["assessment"]["rule_set"]["origin"], "own.toml");
  EXPECT_FALSE(contains(o.out, path("m").string())) << o.out;
}

TEST_F(HeldTo, like_takes_it_over) {
  write("m/own.toml", own_rules("own"));
  write("m/lot.toml", lot("rules = \"own.toml\"\ndesign = { K_eff = 0.62, disp = 100.0 }\nlot-size = 28"));
  auto const o = isolaw({"init", "m", "--like", "m/lot.toml", "--out", "m/next.toml"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "lot-size = 28"));
  auto const inspected = isolaw({"inspect", "m/next.toml", "--json"});
  ASSERT_EQ(inspected.code, 0) << inspected;
  auto const held = Json::parse(inspected.out)["assessment"];
  EXPECT_EQ(held["rule_set"]["id"], "own");
  EXPECT_EQ(held["design"][0]["value"], 0.62);
  EXPECT_EQ(held["lot"]["size"], 28);
  write("m/lot.toml", lot("lot-size = 2"));
  auto const fewer = isolaw({"init", "m", "--like", "m/lot.toml", "--out", "m/more.toml"});
  EXPECT_EQ(fewer.code, 0) << fewer;
  EXPECT_TRUE(contains(fewer.err, "left out: there are 3 devices here"));
  EXPECT_FALSE(contains(read("m/more.toml"), "lot-size"));
}

TEST_F(HeldTo, a_report_with_other_rules_is_no_fault) {
  ASSERT_EQ(isolaw({"calibrate", "m", "--laws", "bilinear", "--runs", "1", "--population", "4", "--generations", "1",
                    "--out", "O"})
                .code,
            0);
  ASSERT_EQ(isolaw({"report", "O", "--rules", "iso-22762-sa", "--design", "K_eff=0.7,disp=100"}).code, 0);
  auto const other = isolaw({"check", "O"});
  EXPECT_EQ(other.code, 0) << other;
  EXPECT_TRUE(contains(other.out, "written with other rules, design values or lot size than the store holds"));
  // Reports may be written with other rules than the store's. check must find a change in such reports too.
  write("O/tables/tests.csv", read("O/tables/tests.csv") + "x");
  auto const edited = isolaw({"check", "O"});
  EXPECT_EQ(edited.code, 1) << edited;
  EXPECT_TRUE(contains(edited.out, "fault: tables/tests.csv is not what the store gives"));
  ASSERT_EQ(isolaw({"report", "O"}).code, 0);
  auto const own = isolaw({"check", "O"});
  EXPECT_EQ(own.code, 0) << own;
  EXPECT_FALSE(contains(own.out, "other rules"));
}

TEST_F(HeldTo, a_wide_moving_average_is_warned_of) {
  auto const o = isolaw({"calibrate", "m/a.csv", "--laws", "bilinear", "--runs", "1", "--population", "4",
                         "--generations", "1", "--smooth", "31", "--out", "O"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "the moving average over 31 samples"));
  EXPECT_TRUE(contains(unwrapped(o.out), "removes 3.9 % of"));
}

TEST_F(HeldTo, inspection_states_its_schema_first) {
  for (Words const& files : {Words{"m/a.csv"}, Words{"m/a.csv", "m/b.csv"}}) {
    auto const o = isolaw(Words{"inspect", "--json"} + files);
    ASSERT_EQ(o.code, 0) << o;
    auto const found = Json::parse(o.out);
    EXPECT_EQ(found.begin().key(), "schema");
    EXPECT_EQ(found["schema"], 1);
  }
}

TEST_F(HeldTo, one_device_is_no_lot) {
  auto const o = isolaw({"inspect", "m/a.csv", "--json"});
  auto const lot = Json::parse(o.out)["assessment"]["lot"];
  EXPECT_TRUE(contains(lot["note"].get<std::string>(), "one device is no lot"));
  EXPECT_TRUE(lot["factors"].empty());
  EXPECT_EQ(lot["mean_analysis"]["sentence"], "");
  EXPECT_TRUE(contains(isolaw({"inspect", "m/a.csv", "--rules", "ntc-2018"}).out, "one device is no lot"));
  EXPECT_EQ(Json::parse(isolaw({"inspect", "m/a.csv", "m/b.csv", "--json"}).out)["assessment"]["lot"]["note"], "");
}

TEST_F(HeldTo, two_devices_bound_a_quantity_from_above_alone) {
  write("m/d.csv", csv(record({.stiffness_kN_per_mm = 0.9, .strength_kN = 40.0})));
  auto const o = isolaw({"inspect", "m/a.csv", "m/d.csv", "--json"});
  auto const lot = Json::parse(o.out)["assessment"]["lot"];
  auto const& K_eff = lot["quantities"][0];
  EXPECT_TRUE(K_eff["tolerance_lower"].is_null());
  EXPECT_NEAR(K_eff["tolerance_k"].get<double>(), 36.519, 1e-3);
  EXPECT_TRUE(contains(K_eff["no_lower_bound"].get<std::string>(), "too few devices for a lower bound"));
  for (auto const& factor : lot["factors"])
    if (factor["source"] == "statistical, each device" && factor["property"] == "K_eff") {
      for (auto const* key : {"spec_min", "lambda_min", "lower"}) EXPECT_TRUE(factor[key].is_null()) << key;
      EXPECT_TRUE(contains(factor["no_lower_bound"].get<std::string>(), "too few devices for a lower bound"));
    }
  EXPECT_TRUE(contains(isolaw({"inspect", "m/a.csv", "m/d.csv"}).out, "too few devices for a lower bound"));
  EXPECT_TRUE(contains(isolaw({"inspect", "m/a.csv", "m/d.csv"}).out, "(k = 36.52)"));
}

TEST_F(HeldTo, too_small_a_sample_permits_no_analysis_with_mean_properties) {
  auto const said = [&](std::string const& size) {
    return Json::parse(isolaw({"inspect", "m", "--rules", "ntc-2018", "--lot-size", size, "--json"})
                           .out)["assessment"]["lot"]["mean_analysis"];
  };
  EXPECT_TRUE(said("20")["permitted"].is_null());  // 3 devices were tested, but the rules require 4
  EXPECT_TRUE(contains(said("20")["sentence"].get<std::string>(), "cannot be said: 3 devices"));
  EXPECT_EQ(said("3")["permitted"], true);
}

// The strength of this measured bearing rises from the first cycle to the second, so cycle 2 has the largest value. The
// observed bounds must enclose the strength of cycle 2 as well as that of cycle 3.
TEST_F(HeldTo, bounds_enclose_the_measured_strength) {
  auto const file = data / "hdrb-gallardo-device/cyclic-24-49-98pct.csv";
  if (!fs::exists(file)) GTEST_SKIP() << "measured data are not here: " << file;
  fs::copy_file(file, path("again.csv"));
  auto const o = isolaw({"inspect", file, "again.csv", "--json"});
  ASSERT_EQ(o.code, 0) << o;
  auto const found = Json::parse(o.out);
  auto const& cycles = found["devices"][0]["blocks"][2]["cycles"];
  for (auto const& factor : found["assessment"]["lot"]["factors"])
    if (factor["property"] == "Q_d" && factor["source"] == "observed") {
      EXPECT_GT(factor["upper"].get<double>(), cycles[1]["Q_d_kN"].get<double>());  // strength of cycle 2
      EXPECT_LT(factor["lower"].get<double>(), cycles[2]["Q_d_kN"].get<double>());
    }
  auto const& test = found["assessment"]["lot"]["quantities"][3]["lambda_test"];
  EXPECT_EQ(test["max_cycle"], 2);
  EXPECT_EQ(test["min_cycle"], 7);
}

}  // namespace
}  // namespace isolaw::cli_test
