// A device may have a compression test beside its shear test. isolaw reads it, checks it against rules, stores and
// reports it.
#include "cli/records.hpp"
#include "cli/run.hpp"
#include "cli/store.hpp"
#include "cli/warts.hpp"

namespace isolaw::cli_test {
namespace {

class Vertical : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    for (auto const* name : {"D1", "D2"}) write(std::string(name) + ".csv", csv(record()));
    for (auto const* name : {"compression.csv", "compression-preload.csv", "compression-negative.csv"})
      fs::copy_file(wart_folder / name, path(name));
  }
  Words const quick{"--laws", "bilinear",      "--runs", "1",         "--population",
                    "4",      "--generations", "1",      "--figures", "none"};
  static void execute(fs::path const& store, std::string const& sql) {
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(store.c_str(), &db), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(db);
    EXPECT_GT(sqlite3_changes(db), 0);
    sqlite3_close(db);
  }
  Json vertical_of(Words const& words) {
    auto const o = isolaw(Words{"inspect"} + words + Words{"--json"});
    return Json::parse(o.out)["vertical"];
  }
};

TEST_F(Vertical, is_read_and_stands_in_every_output) {
  auto const o = isolaw({"inspect", "D1.csv", "--vertical", "D1=compression.csv", "--out", "O"});
  ASSERT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "vertical stiffness K_v: 1200 kN/mm, dF_v/dd_v, 3rd loading of 3, from 300 to ")) << o;
  EXPECT_TRUE(contains(o.out, "disp: column 1 'Vertical displacement [mm]', by its name")) << o;
  auto const found = json("O/inspection.json")["vertical"];
  EXPECT_NEAR(found["K_v_kN_per_mm"].get<double>(), 1200.0, 0.1);
  EXPECT_EQ(found["file"], "compression.csv");
  EXPECT_EQ(found["sha256"].get<std::string>().size(), 64u);
  EXPECT_EQ(found["loading"], 3);
  EXPECT_EQ(found["loadings_kN_per_mm"].size(), 3u);
  // During the first loading the device also settles a little and permanently, so this loading shows less stiffness.
  EXPECT_LT(found["loadings_kN_per_mm"][0].get<double>(), 1190.0);
  EXPECT_NEAR(found["low_kN"].get<double>(), 300.0, 1e-6);
  EXPECT_EQ(found["refusal"], "");
  EXPECT_TRUE(contains(read("O/tables/vertical.csv"), "D1,1200.")) << read("O/tables/vertical.csv");
  EXPECT_TRUE(contains(read("O/inspection.html"), "compression.csv"));
}

TEST_F(Vertical, is_null_where_none_is_given) {
  EXPECT_TRUE(vertical_of({"D1.csv"}).is_null());
  EXPECT_TRUE(contains(isolaw({"inspect", "D1.csv"}).out, "vertical stiffness K_v: not known"));
}

TEST_F(Vertical, passes_or_fails_the_set_that_names_it) {
  auto const inspect = [&](std::string const& design) {
    return isolaw(Words{"inspect", "D1.csv", "--vertical", "D1=compression.csv"} + held_to(design));
  };
  auto const passes = inspect("K_v=1500");
  EXPECT_EQ(passes.code, 0) << passes;
  EXPECT_TRUE(contains(
      passes.out, "pass          K_v                        1200 kN/mm, design 1500, -20.0 %, limit at least -30 %"))
      << passes;
  auto const fails = inspect("K_v=1800");
  EXPECT_EQ(fails.code, 1) << fails;
  EXPECT_TRUE(contains(fails.out, "fail          K_v ")) << fails;
  EXPECT_TRUE(contains(fails.out, "device: fail: K_v -33.3 %")) << fails;
  auto const open = inspect("K_eff=0.7,disp=100");
  EXPECT_EQ(open.code, 0) << open;
  EXPECT_TRUE(contains(open.out, "no design value: give K_v=... among the design values")) << open;
}

TEST_F(Vertical, of_a_lot_is_given_in_the_lot_file) {
  write("lot.toml",
        "[[device]]\nname = \"a\"\nfile = \"D1.csv\"\nK_v = 1100.0\n"
        "[[device]]\nname = \"b\"\nfile = \"D2.csv\"\nvertical = \"compression-negative.csv\"\n"
        "[[device]]\nname = \"c\"\nfile = \"D2.csv\"\n"
        "[device.vertical]\nfile = \"compression-preload.csv\"\nloads = \"400:1000\"\nunits = { load = \"kN\" }\n");
  auto const o = isolaw(Words{"inspect", "lot.toml", "--out", "O"} + held_to("K_v=1500"));
  EXPECT_EQ(o.code, 0) << o;  // 1100 is 26.7 % below 1500, within the permitted 30 %
  EXPECT_TRUE(contains(o.out, "  a       vertical stiffness K_v: 1100 kN/mm, as the laboratory states it")) << o;
  EXPECT_TRUE(contains(o.out, "  b       vertical stiffness K_v: 1200 kN/mm, dF_v/dd_v")) << o;
  EXPECT_TRUE(contains(o.out, "  c       vertical stiffness K_v: 1200 kN/mm, dF_v/dd_v, 3rd loading of 3, from 400 to"))
      << o;
  EXPECT_TRUE(contains(o.out, "K_v       kN/mm    3 ")) << o;
  EXPECT_TRUE(contains(read("O/tables/lot.csv"), "\nK_v,kN/mm,")) << read("O/tables/lot.csv");
}

TEST_F(Vertical, that_gives_no_stiffness_is_said_and_the_device_stays) {
  auto const alone = isolaw({"inspect", "D1.csv", "--vertical", "D1=compression-preload.csv"});
  EXPECT_EQ(alone.code, 1) << alone;
  EXPECT_TRUE(contains(alone.out, "K_eff")) << alone;  // the shear record still gives its properties
  EXPECT_TRUE(contains(alone.out, "no vertical stiffness K_v, see the warnings")) << alone;
  EXPECT_TRUE(contains(
      alone.out,
      "vertical test: compression-preload.csv: the loading goes from 400 to 1000 kN, K_v is asked for between 300 and 1000 kN"))
      << alone;
  EXPECT_TRUE(contains(alone.out, "loads = \"400:1000\"")) << alone;
  auto const lot = isolaw({"inspect", "D1.csv", "D2.csv", "--vertical", "D1=compression-preload.csv"});
  EXPECT_EQ(lot.code, 1) << lot;
  EXPECT_TRUE(contains(lot.out, "D1: vertical test: compression-preload.csv: the loading goes")) << lot;
  EXPECT_TRUE(contains(lot.out, "D1         1     3    100.00")) << lot;
  auto const held = isolaw(Words{"inspect", "D1.csv", "D2.csv", "--vertical", "D1=nothere.csv"} + held_to("K_v=1500"));
  EXPECT_EQ(held.code, 1) << held;
  EXPECT_TRUE(contains(held.out, "nothere.csv: no such file")) << held;
}

TEST_F(Vertical, softer_down_than_a_bearing_is_warned_of) {
  write("lot.toml",
        "[[device]]\nname = \"a\"\nfile = \"D1.csv\"\n"
        "[device.vertical]\nfile = \"compression.csv\"\nloads = \"0.3:1\"\nunits = { load = \"N\" }\n");
  auto const o = isolaw({"inspect", "lot.toml"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "vertical test: 1.2 kN/mm is less than 3 times the horizontal stiffness")) << o;
  EXPECT_FALSE(contains(isolaw({"inspect", "D1.csv", "--vertical", "D1=compression.csv"}).out, "less than 3 times"));
}

TEST_F(Vertical, is_refused_where_it_belongs_to_no_device) {
  expect_refused(isolaw({"inspect", "D1.csv", "--vertical", "D7=compression.csv"}),
                 {"--vertical", "'D7=compression.csv': no such device", "DEVICE is 'D1'", "--vertical D1=FILE"});
  expect_refused(isolaw({"inspect", "D1.csv", "--vertical", "D1="}), {"'D1=': no file"});
  expect_refused(isolaw({"inspect", "D1.csv", "--vertical", "D1=compression.csv", "--vertical", "D1=compression.csv"}),
                 {"'D1' is given twice"});
}

TEST_F(Vertical, of_a_lot_file_is_checked_with_the_rest_of_it) {
  write("bad.toml",
        "[[device]]\nname = \"a\"\nfile = \"D1.csv\"\nK_v = -1.0\nvertical = { loads = \"3\", fily = \"x\" }\n"
        "[[device]]\nname = \"b\"\nfile = \"D2.csv\"\nvertical = \"../elsewhere.csv\"\n"
        "[[device]]\nname = \"c\"\nfile = \"D2.csv\"\nK_v = 1.0\nvertical = \"compression.csv\"\n");
  expect_refused(
      isolaw({"inspect", "bad.toml"}),
      {"bad.toml:4: K_v: -1; allowed: vertical stiffness in kN/mm, above 0",
       "bad.toml:5: loads: '3'; allowed: LOW:HIGH", "bad.toml:5: unknown key 'fily' in vertical",
       "bad.toml:5: a vertical test without a file", "bad.toml:9: vertical: '../elsewhere.csv' leads outside",
       "bad.toml:14: K_v and vertical for one device"});
}

TEST_F(Vertical, of_a_campaign_is_stored_and_reported_and_may_come_later) {
  Words const with{"--vertical", "D1=compression.csv"};
  auto const first = isolaw(Words{"calibrate", "D1.csv", "--out", "O"} + quick + held_to("K_v=1500"));
  ASSERT_EQ(first.code, 0) << first;
  EXPECT_TRUE(contains(read("O/tables/tests.csv"), "no vertical test is given")) << read("O/tables/tests.csv");
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT vertical FROM device"), Words{""});
  // The compression test is added to a finished campaign. No law depends on K_v, so the campaign keeps its runs.
  auto const later = isolaw(Words{"calibrate", "D1.csv", "--out", "O"} + quick + held_to("K_v=1500") + with);
  ASSERT_EQ(later.code, 0) << later;
  EXPECT_FALSE(contains(later.err, "another campaign")) << later;
  EXPECT_TRUE(contains(read("O/tables/vertical.csv"), "D1,1200.")) << read("O/tables/vertical.csv");
  EXPECT_TRUE(contains(read("O/tables/tests.csv"), "\"Table 11.9.IV, K_v, supply\"")) << read("O/tables/tests.csv");
  EXPECT_EQ(query(path("O/campaign.sqlite"),
                  "SELECT channel || ' ' || count FROM series WHERE channel LIKE 'vertical%' ORDER BY channel"),
            (Words{"vertical_disp_mm 300", "vertical_load_kN 300"}));
  fs::remove(path("compression.csv"));
  auto const report = isolaw({"report", "O", "--design", "K_v=1800"});
  EXPECT_EQ(report.code, 1) << report;
  EXPECT_TRUE(contains(read("O/tables/tests.csv"), ",fail,")) << read("O/tables/tests.csv");
  auto const check = isolaw({"check", "O"});
  EXPECT_EQ(check.out.find("fault"), std::string::npos) << check;
}

TEST_F(Vertical, that_cannot_be_read_does_not_stop_a_campaign) {
  auto const o = isolaw(Words{"calibrate", "D1.csv", "--out", "O", "--vertical", "D1=nothere.csv"} + quick);
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.err, "D1: no vertical stiffness\n  nothere.csv: no such file")) << o;
  EXPECT_TRUE(contains(read("O/summary.json"), "vertical test: nothere.csv: no such file"));
}

TEST_F(Vertical, of_which_a_signal_cannot_be_true_gives_no_stiffness) {
  write("spike.csv", [&] {
    auto text = read("compression.csv");
    std::size_t at = 0;
    for (int line = 0; line < 240; ++line) at = text.find('\n', at) + 1;
    auto const comma = text.find_first_of(",;\t", at), end = text.find_first_of("\r\n", at);
    return text.replace(comma + 1, end - comma - 1, "2800");
  }());
  auto const o = isolaw({"inspect", "D1.csv", "--vertical", "D1=spike.csv"});
  EXPECT_EQ(o.code, 1) << o;
  EXPECT_TRUE(contains(o.out, "spike.csv: vertical load is disturbed by spikes at sample ")) << o;
  EXPECT_TRUE(contains(o.out, "no vertical stiffness K_v")) << o;
}

TEST_F(Vertical, under_two_devices_is_said) {
  for (std::string const command : {"inspect", "calibrate"}) {
    auto words =
        Words{command, "D1.csv", "D2.csv", "--vertical", "D1=compression.csv", "--vertical", "D2=compression.csv"};
    if (command == "calibrate") words = words + Words{"--out", "O"} + quick;
    auto const o = isolaw(words);
    EXPECT_TRUE(contains(o.out + o.err, "D1 and D2 hold the same compression test: its K_v counts 2 times")) << o;
  }
}

TEST_F(Vertical, that_was_changed_in_the_store_is_found_by_check) {
  ASSERT_EQ(isolaw(Words{"calibrate", "D1.csv", "--out", "O", "--vertical", "D1=compression.csv"} + quick).code, 0);
  EXPECT_EQ(isolaw({"check", "O"}).code, 0);
  auto const store = path("O/campaign.sqlite");
  auto const kept = query(store, "SELECT hex(\"values\") FROM series WHERE channel = 'vertical_load_kN'").front();
  // The test first changes one sample of the load, outside the range that gives K_v: check must find that the curve
  // differs. Then the test replaces all samples: check must find that K_v differs.
  execute(store, "UPDATE series SET \"values\" = x'" + std::string(12, '0') + "5940" + kept.substr(16) +
                     "' WHERE channel = 'vertical_load_kN'");
  auto const one = isolaw({"check", "O"});
  EXPECT_EQ(one.code, 1) << one;
  EXPECT_TRUE(contains(one.out + one.err, "D1: the curve of its compression test is not the one that was read")) << one;
  execute(store,
          "UPDATE series SET \"values\" = (SELECT \"values\" FROM series WHERE channel = 'vertical_disp_mm') "
          "WHERE channel = 'vertical_load_kN'");
  auto const all = isolaw({"check", "O"});
  EXPECT_TRUE(contains(all.out + all.err, "D1: its compression test gives K_v = ")) << all;
}

TEST_F(Vertical, of_a_campaign_stays_unless_its_lot_file_drops_it) {
  Words const campaign = Words{"calibrate", "D1.csv", "--out", "O"} + quick;
  ASSERT_EQ(isolaw(campaign + Words{"--vertical", "D1=compression.csv"}).code, 0);
  auto const without = isolaw(campaign);
  EXPECT_EQ(without.code, 0) << without;
  EXPECT_TRUE(contains(without.err, "the campaign keeps its compression tests: D1 (compression.csv)")) << without;
  EXPECT_TRUE(contains(read("O/tables/vertical.csv"), "D1,1200.")) << read("O/tables/vertical.csv");
  write("lot.toml", "[[device]]\nname = \"D1\"\nfile = \"D1.csv\"\n");
  auto const dropped = isolaw(Words{"calibrate", "lot.toml", "--out", "O"} + quick);
  EXPECT_TRUE(
      contains(dropped.err,
               "the lot file no longer names compression tests of D1 (compression.csv); the campaign drops their K_v"))
      << dropped;
  EXPECT_EQ(query(path("O/campaign.sqlite"), "SELECT vertical FROM device"), Words{""});
}

}  // namespace
}  // namespace isolaw::cli_test
