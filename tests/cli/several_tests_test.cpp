// Tests how isolaw treats a device with several tests: one set of a law's parameters must hold for all of them. The
// device is given on the command line and in a lot file; the store, the reports and the exports are looked at.
#include <cmath>

#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"
#include "page_data.hpp"

namespace isolaw::cli_test {
namespace {

Words const laws{"--laws", "bilinear,bouc-wen", "--replicates", "0", "--figures", "none"};

class SeveralTests : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("small.csv", csv(record({.amplitude_mm = 50.0})));
    write("large.csv", csv(record({.amplitude_mm = 100.0})));
  }
};

TEST_F(SeveralTests, are_one_device_with_one_parameter_set) {
  auto const o =
      isolaw(Words{"calibrate", "small.csv", "large.csv", "--same-device", "--out", "O", "--analysis", "full"} + laws);
  ASSERT_EQ(o.code, 0) << o;
  auto const s = json("O/summary.json");
  ASSERT_EQ(s["devices"].size(), 1u);
  EXPECT_EQ(s["devices"][0]["name"], "small + large");
  EXPECT_EQ(s["devices"][0]["tests"][1]["name"], "large");
  EXPECT_EQ(s["devices"][0]["tests"][1]["file"], "large.csv");
  for (auto const& law : s["laws"]) {
    ASSERT_EQ(law["devices"].size(), 1u);
    auto const& fit = law["devices"][0];
    ASSERT_EQ(fit["tests"].size(), 2u);
    double const mean = (fit["tests"][0]["objective"].get<double>() + fit["tests"][1]["objective"].get<double>()) / 2.0;
    EXPECT_NEAR(fit["objective"]["best"].get<double>(), mean, 1e-9);
    EXPECT_TRUE(fit["larger_swings_objective"].is_number()) << "the large test shows how the law goes on";
  }
  auto const checked = isolaw({"check", "O"});
  EXPECT_EQ(checked.code, 0) << checked;

  // A law that is fitted to the smaller swings predicts the larger ones, and the page draws this prediction. The page
  // must mark where the larger swings are: in the second test, which follows the 601 samples of the first.
  auto const page = page_data(read("O/report.html"));
  auto const& device = page["devices"][0];
  ASSERT_FALSE(device["large_swings"].empty());
  ASSERT_EQ(device["tests"].size(), 2u);
  double const begin = 6.0;  // s, the length of the first test
  for (auto const& range : device["large_swings"]) EXPECT_GE(range["from"].get<double>(), begin);
  for (auto const& law : page["laws"]) {
    auto const& fit = law["devices"][0];
    ASSERT_TRUE(fit["larger_swings_force_kN"].is_object()) << law["id"];
    EXPECT_EQ(fit["larger_swings_force_kN"]["d"].size(), fit["force_kN"]["d"].size());
  }
}

// A lot file with a table [[device.test]] for each test must give the same numbers as the option --same-device. init
// must write such a lot file.
TEST_F(SeveralTests, are_the_same_in_a_lot_file) {
  write(
      "lot.toml",
      "title = \"lot\"\n[[device]]\nname = \"small + large\"\n[[device.test]]\nfile = \"small.csv\"\n[[device.test]]\n"
      "file = \"large.csv\"\nname = \"large\"\n");
  ASSERT_EQ(isolaw(Words{"calibrate", "lot.toml", "--out", "L"} + laws).code, 0);
  ASSERT_EQ(isolaw(Words{"calibrate", "small.csv", "large.csv", "--same-device", "--out", "O"} + laws).code, 0);
  EXPECT_EQ(json("L/summary.json")["laws"], json("O/summary.json")["laws"]);
  ASSERT_EQ(isolaw({"init", "small.csv", "large.csv", "--same-device", "--out", "made.toml"}).code, 0);
  auto const made = read("made.toml");
  EXPECT_TRUE(contains(made, "[[device.test]]")) << made;
  EXPECT_LT(made.find("# serial = "), made.find("[[device.test]]"))
      << "the open keys are those of the device: " << made;
  ASSERT_EQ(isolaw(Words{"calibrate", "made.toml", "--out", "M"} + laws).code, 0);
  EXPECT_EQ(json("M/summary.json")["laws"], json("O/summary.json")["laws"]);
}

// The files of the two tests state the same lot but different serial numbers. init must write the lot to the lot file.
// It must leave the serial number open and say what each file states.
TEST_F(SeveralTests, state_facts_of_their_device) {
  auto const facts = [](std::string const& serial) { return "Lot: L5\nSerial No: " + serial + "\n"; };
  write("small.csv", facts("S-77") + read("small.csv"));
  write("large.csv", facts("S-78") + read("large.csv"));
  auto const o = isolaw({"init", "small.csv", "large.csv", "--same-device", "--out", "made.toml"});
  expect_message(o, 0, {"serial: S-77 in small, S-78 in large", "are they tests of one device?"});
  auto const made = read("made.toml");
  EXPECT_TRUE(contains(made, "\nlot = 'L5'")) << made;
  ASSERT_EQ(isolaw(Words{"calibrate", "small.csv", "large.csv", "--same-device", "--out", "O"} + laws).code, 0);
  auto const warnings = json("O/summary.json")["warnings"];
  auto const about_facts =
      std::ranges::find_if(warnings, [](Json const& warning) { return warning["kind"] == "tests-state-differently"; });
  ASSERT_NE(about_facts, warnings.end());
  EXPECT_TRUE(contains((*about_facts)["sentence"].get<std::string>(), "S-77 in small, S-78 in large"));
  EXPECT_TRUE(contains(made, "\n# serial = \"\"  # the file says: S-77 in small, S-78 in large")) << made;
}

// The force of one test is zero, so no law can be fitted to that test. The message must name the test.
TEST_F(SeveralTests, are_named_where_a_law_cannot_be_fitted) {
  write("large.csv",
        csv(record({.amplitude_mm = 100.0}), "time [s],displacement [mm],force [kN]",
            [](std::size_t, Sample const& s) { return fmt::format("{:.4f},{:.5f},0", s.time_s, s.disp_mm); }));
  auto const o = isolaw(Words{"calibrate", "small.csv", "large.csv", "--same-device", "--out", "O"} + laws);
  EXPECT_TRUE(contains(o.err, "large")) << o;
}

TEST_F(SeveralTests, of_a_device_grow_with_the_lot) {
  std::string const one =
      "[[device]]\nname = \"d\"\n[[device.test]]\nfile = \"small.csv\"\n[[device.test]]\nfile = \"large.csv\"\n";
  write("one.toml", one);
  write("two.toml", one + "[[device]]\nname = \"e\"\nfile = \"large.csv\"\n");
  ASSERT_EQ(isolaw(Words{"calibrate", "one.toml", "--out", "G"} + laws).code, 0);
  expect_message(isolaw(Words{"calibrate", "two.toml", "--out", "G"} + laws), 0, {"grows by 1 device\n"});
  ASSERT_EQ(isolaw(Words{"calibrate", "two.toml", "--out", "W"} + laws).code, 0);
  EXPECT_EQ(read("G/summary.json"), read("W/summary.json"));
  EXPECT_EQ(all_rows(path("G/campaign.sqlite")), all_rows(path("W/campaign.sqlite")));
}

TEST_F(SeveralTests, have_each_their_own_way_of_reading) {
  write("metres.csv", csv(record({.amplitude_mm = 0.1, .stiffness_kN_per_mm = 500.0, .yield_mm = 0.01}), "time,a,b"));
  write("lot.toml",
        "[[device]]\nname = \"d\"\n[[device.test]]\nfile = \"small.csv\"\n[[device.test]]\nfile = \"metres.csv\"\n"
        "columns = { disp = \"a\", force = \"b\" }\nunits = { time = \"s\", disp = \"m\", force = \"kN\" }\n");
  auto const o = isolaw({"inspect", "lot.toml", "--json"});
  ASSERT_EQ(o.code, 0) << o;
  auto const device = Json::parse(o.out);
  EXPECT_EQ(device["tests"].size(), 2u);
  EXPECT_EQ(device["blocks"].size(), 2u);
  EXPECT_NEAR(device["blocks"][1]["amplitude_mm"].get<double>(), 100.0, 0.1);
}

TEST_F(SeveralTests, are_refused_where_they_make_no_sense) {
  auto const device = [](std::string const& rest) { return "[[device]]\nname = \"d\"\n" + rest; };
  auto const refused = [&](std::string const& lot, Words const& parts) {
    write("lot.toml", lot);
    expect_refused(isolaw({"inspect", "lot.toml"}), parts);
  };
  refused(device("file = \"small.csv\"\n[[device.test]]\nfile = \"large.csv\"\n"),
          {"a device with a file and with tests"});
  refused(device("[[device.test]]\nname = \"a\"\n"), {"a test without a file"});
  refused(
      device(
          "[[device.test]]\nfile = \"small.csv\"\nname = \"a\"\n[[device.test]]\nfile = \"large.csv\"\nname = \"a\"\n"),
      {"two tests of a device are named 'a'"});
  refused(device("[[device.test]]\nfile = \"../x.csv\"\n"), {"lot.toml:4", "leads outside"});
  refused(device("[[device.test]]\nfile = \"small.csv\"\nfiel = 1\n"), {"unknown key 'fiel'", "file"});
  refused("[[read.test]]\nfile = \"small.csv\"\n" + device("file = \"small.csv\"\n"), {"lot.toml:1", "test"});
  refused(device(""), {"a device without a file", "[[device.test]]"});
  write("lot.toml", device("file = \"small.csv\"\n"));
  expect_refused(isolaw({"inspect", "lot.toml", "--same-device"}), {"--same-device", "[[device.test]]"});
}

TEST_F(SeveralTests, are_read_from_the_store_and_exported) {
  ASSERT_EQ(isolaw(Words{"calibrate", "small.csv", "large.csv", "--same-device", "--out", "O"} + laws).code, 0);
  auto const before = json("O/summary.json");
  ASSERT_EQ(isolaw({"report", "O", "--out", "R", "--figures", "none"}).code, 0);
  EXPECT_EQ(json("R/summary.json")["laws"], before["laws"]);
  auto const page = page_data(read("R/report.html"));
  EXPECT_EQ(page["devices"][0]["tests"].size(), 2u);
  EXPECT_TRUE(contains(page["command"].get<std::string>(), "small.csv large.csv --same-device")) << page["command"];
  auto const exported =
      isolaw({"export", "O", "--law", "bilinear", "--device", "small + large", "--to", "opensees", "--out", "b.tcl"});
  EXPECT_EQ(exported.code, 0) << exported;
  EXPECT_TRUE(contains(json("R/summary.json")["recommendation"]["reach"].back()["sentence"].get<std::string>(),
                       "the 2 best laws have a stiffness of"));
  write("other.toml",
        "[[device]]\nname = \"small + large\"\n[[device.test]]\nfile = \"large.csv\"\n[[device.test]]\nfile = "
        "\"small.csv\"\n");
  expect_refused(isolaw(Words{"calibrate", "other.toml", "--out", "O"} + laws), {"its tests are in another order"});
  auto const again = isolaw(Words{"calibrate", "small.csv", "large.csv", "--out", "O"} + laws);
  EXPECT_NE(again.code, 0) << "two devices are another campaign than one device with two tests";
}

}  // namespace
}  // namespace isolaw::cli_test
