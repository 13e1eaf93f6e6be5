// Tests small things that trouble a first-time user, such as wrong input that is accepted without a message, or that a
// message quotes oddly.
#include <sqlite3.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <utility>

#include "cli/records.hpp"
#include "cli/run.hpp"

namespace isolaw::cli_test {
namespace {

class SmallThings : public InFreshDirectory {
 protected:
  void SetUp() override {
    InFreshDirectory::SetUp();
    write("a.csv", csv(record()));
  }
  static constexpr char const* device = "[[device]]\nname = \"a\"\nfile = \"a.csv\"\n";
  Outcome inspected(std::string const& lot) {
    write("lot.toml", lot);
    return isolaw({"inspect", "lot.toml"});
  }
  static std::string utf_16(std::string const& text, bool little) {
    std::string wide = little ? "\xFF\xFE" : "\xFE\xFF";
    for (char const c : text) wide += little ? std::string{c, '\0'} : std::string{'\0', c};
    return wide;
  }
};

TEST_F(SmallThings, init_leaves_out_a_date_or_a_temperature_that_is_none_and_says_why) {
  write("b.csv",
        "Date: 31.02.2024\nTemperature: 1000 \xC2\xB0"
        "C\n" +
            csv(record()));
  auto const o = isolaw({"init", "b.csv"});
  EXPECT_EQ(o.code, 0) << o;
  auto const text = read("lot.toml");
  EXPECT_TRUE(contains(text, "# test-date = \"\"  # the file says: 31.02.2024; allowed: a date of the calendar"))
      << text;
  EXPECT_TRUE(contains(text, "# temperature-C = 0.0  # the file says: 1000")) << text;
  EXPECT_TRUE(contains(text, "-100 to 200")) << text;
}

// isolaw names a device after its file and must remove blanks around the name. If a lot file cannot hold the name, init
// must refuse the file.
TEST_F(SmallThings, init_writes_names_that_lot_files_allow) {
  for (auto const* file : {" lead.csv", "trail .csv"}) {
    write(file, csv(record()));
    auto const o = isolaw({"init", file, "--force"});
    ASSERT_EQ(o.code, 0) << o;
    auto const read_back = isolaw({"inspect", "lot.toml", "--json"});
    ASSERT_EQ(read_back.code, 0) << read_back;
    auto const name = Json::parse(read_back.out)["name"].get<std::string>();
    EXPECT_TRUE(name == "lead" || name == "trail") << name;
    EXPECT_EQ(Json::parse(isolaw({"inspect", file, "--json"}).out)["name"], name);
    EXPECT_EQ(isolaw(Words{"calibrate", "lot.toml", "--out", "O", "--fresh"} + smallest_search).code, 0);
  }
  write("lot.toml", "[[device]]\nfile = \" lead.csv\"\n");
  EXPECT_EQ(Json::parse(isolaw({"inspect", "lot.toml", "--json"}).out)["name"], "lead");
  auto const turned = "r\xE2\x80\xAEl.csv";
  write(turned, csv(record()));
  expect_refused(isolaw({"init", turned, "--force"}),
                 {"r\\u202el.csv: a file name that no lot file can hold: it has control characters, marks that turn",
                  "try: rename the file, or calibrate it without a lot file"});
  EXPECT_EQ(isolaw({"inspect", turned}).code, 0);
}

TEST_F(SmallThings, dates_of_lot_files_are_dates) {
  for (auto const* date : {"31.02.2024", "tomorrow", "2024-13-01", "17"})
    expect_refused(inspected(fmt::format("{}test-date = \"{}\"\n", device, date)),
                   {"lot.toml:4: test-date: '", "is no date", "2024-03-17"});
  for (auto const* date : {"2024-02-29", "29.02.2024", "02/29/2024", "20240229", "17 May 2024", "spring 2024"}) {
    auto const o = inspected(fmt::format("{}test-date = \"{}\"\n", device, date));
    EXPECT_EQ(o.code, 0) << date << o;
  }
}

TEST_F(SmallThings, mistakes_of_a_lot_file_have_their_line) {
  expect_refused(inspected("[acceptance]\ndesign = \"K_eff=none\"\n" + std::string(device)),
                 {"lot.toml:2: design: K_eff='none'", "a positive number"});
  expect_refused(inspected("[acceptance]\nrules = \"no-such-set\"\n" + std::string(device)),
                 {"lot.toml:2: rules: 'no-such-set'", "isolaw rules"});
  expect_refused(inspected("[[device]]\nname = \"a \"\nfile = \"a.csv\"\n"),
                 {"lot.toml:2: name: 'a ' begins or ends with a blank"});
  expect_refused(inspected("[[device]]\nname = \"a\"\nfile = \"a.csv\"\nfiles = [\"a.csv\"]\n"),
                 {"lot.toml:4: both file and files"});
}

TEST_F(SmallThings, what_is_given_twice_or_empty_is_refused) {
  expect_refused(
      isolaw({"calibrate", "a.csv", "--laws", "bilinear", "--set", "bilinear.K2=0.4", "--set", "bilinear.K2=0.5"}),
      {"--set", "bilinear.K2 is set twice"});
  expect_refused(isolaw({"simulate", "bilinear", "--set", "K1=2", "--set", "K1=3", "--motion", "a.csv"}),
                 {"--set: K1 is given twice"});
  expect_refused(isolaw({"inspect", "a.csv", "--design", ""}), {"--design", "K_eff=1.2"});
}

TEST_F(SmallThings, rows_are_quoted_as_they_are_typed) {
  auto const o = isolaw({"inspect", "a.csv", "--rows", ":500"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "(--rows :500)")) << o.out;
}

TEST_F(SmallThings, one_thing_is_not_several) {
  write("one.csv", "time [s],displacement [mm],force [kN]\n0,1,2\n");
  auto const one = isolaw({"inspect", "one.csv"});
  EXPECT_FALSE(contains(one.err, "1 samples") || contains(one.err, "1 lines") || contains(one.err, "1 rows")) << one;
  write("word.csv", "nothing\n");
  EXPECT_TRUE(contains(isolaw({"inspect", "word.csv"}).err, "in 1 line;"));
}

TEST_F(SmallThings, messages_say_the_programs_name_once_and_break_no_line) {
  expect_refused(isolaw({}), {"isolaw: no command given"});
  expect_refused(isolaw({"frobnicate"}), {"isolaw: frobnicate: no such command"});
  write("bad.csv", "time [s],displacement [mm],force [kN]\n0,1,x\n1,y,3\n2,3,4\n3,4,5\n4,5,6\n5,6,7\n6,7,8\n7,8,9\n");
  auto const o = isolaw({"inspect", "a.csv", "bad.csv"});
  EXPECT_FALSE(contains(o.out + o.err, "\\n")) << o;
}

TEST_F(SmallThings, an_output_without_its_directory_says_so) {
  expect_message(isolaw({"init", "a.csv", "--out", "nowhere/lot.toml"}), 2,
                 {"nowhere/lot.toml", "there is no directory nowhere", "mkdir -p nowhere"});
}

TEST_F(SmallThings, text_in_utf_16_is_read) {
  auto const plain = isolaw({"inspect", "--json", "a.csv"});
  for (bool const little : {true, false}) {
    write("wide.csv", utf_16(read("a.csv"), little));
    auto const wide = isolaw({"inspect", "--json", "wide.csv"});
    ASSERT_EQ(wide.code, 0) << wide;
    EXPECT_EQ(Json::parse(wide.out)["blocks"], Json::parse(plain.out)["blocks"]);
    EXPECT_TRUE(contains(wide.out, "the text is read as UTF-16"));
  }
}

TEST_F(SmallThings, a_number_alone_below_the_rows_is_a_footer_where_that_is_asked) {
  write("f.csv", csv(record()) + "1234\n");
  expect_refused(isolaw({"inspect", "f.csv"}), {"f.csv:603: 1 column: '1234'"});
  auto const o = isolaw({"inspect", "f.csv", "--footer", "skip"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.out, "left out (--footer skip)")) << o.out;
}

TEST_F(SmallThings, days_under_a_name_with_seconds_are_remarked) {
  write("days.csv", csv(record(), "Time [s],Displacement [mm],Force [kN]", [](std::size_t, Sample const& s) {
          return fmt::format("{:.10f},{:.4f},{:.5f}", 45414.4 + s.time_s / 86400.0, s.disp_mm, s.force_kN);
        }));
  auto const o = isolaw({"inspect", "days.csv"});
  EXPECT_TRUE(contains(o.out, "look like days of a spreadsheet; try --units time=d")) << o.out;
  auto const told = isolaw({"inspect", "--json", "days.csv", "--units", "time=d"});
  ASSERT_EQ(told.code, 0) << told;
  EXPECT_NEAR(Json::parse(told.out)["blocks"][0]["frequency_Hz"].get<double>(),
              Json::parse(isolaw({"inspect", "--json", "a.csv"}).out)["blocks"][0]["frequency_Hz"].get<double>(), 1e-3);
}

// To compute the damping, isolaw divides by the stiffness. This record has practically no stiffness, so the quotient
// would consist of rounding errors. isolaw must give no damping and say so.
TEST_F(SmallThings, damping_without_stiffness_is_not_defined) {
  write("v.csv", csv(record(), "Time [s],Displacement [mm],Force [kN]", [](std::size_t i, Sample const& s) {
          double const phase = std::asin(std::clamp(s.disp_mm / 100.0, -1.0, 1.0));
          bool const rises = i % 200 < 50 || i % 200 >= 150;
          return fmt::format("{:.4f},{:.4f},{:.9f}", s.time_s, s.disp_mm,
                             (rises ? 50.0 : -50.0) * std::cos(phase) + 1e-7 * s.disp_mm);
        }));
  auto const o = isolaw({"inspect", "v.csv"});
  EXPECT_TRUE(contains(o.out, "a viscous device by its loop")) << o.out;
  auto const machine = Json::parse(isolaw({"inspect", "--json", "v.csv"}).out);
  EXPECT_TRUE(machine["blocks"][0]["cycles"][1]["damping_percent"].is_null()) << machine["blocks"][0]["cycles"][1];
}

TEST_F(SmallThings, a_motion_may_be_a_part_of_its_file_and_says_what_it_leaves_aside) {
  Words const law{"simulate", "bilinear", "--set", "K1=2", "--set", "K2=0.4", "--set", "xy=10"};
  write("m.csv", "time [s],displacement [mm],velocity [mm/s]\n0,0,5\n1,5,5\n2,10,0\n3,5,-5\n4,0,-5\n");
  auto const whole = isolaw(law + Words{"--motion", "m.csv"});
  auto const part = isolaw(law + Words{"--motion", "m.csv", "--motion-from", "1", "--motion-to", "3"});
  ASSERT_EQ(whole.code, 0) << whole;
  EXPECT_TRUE(contains(whole.err, "'velocity [mm/s]' is not used: velocities are computed")) << whole;
  ASSERT_EQ(part.code, 0) << part;
  EXPECT_TRUE(contains(part.err, "samples 2 to 4 of 5 are read (--motion-from 1 --motion-to 3)")) << part;
}

// A database of another program may lie where isolaw writes its store. --fresh must refuse to replace that database.
TEST_F(SmallThings, starting_over_replaces_no_database_of_another_program) {
  Words const fit =
      Words{"calibrate", "a.csv", "--out", "o", "--figures", "none", "--analysis", "none", "--fresh"} + smallest_search;
  auto const make = [&](std::string const& sql) {
    fs::create_directories(path("o"));
    fs::remove(path("o/campaign.sqlite"));
    sqlite3* db = nullptr;
    ASSERT_EQ(sqlite3_open(path("o/campaign.sqlite").c_str(), &db), SQLITE_OK);
    ASSERT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(db);
  };
  make("CREATE TABLE accounts (name TEXT); INSERT INTO accounts VALUES ('x')");
  auto const before = read("o/campaign.sqlite");
  expect_refused(isolaw(fit), {"o/campaign.sqlite", "is a database of another program", "'accounts'", "--fresh"});
  EXPECT_EQ(read("o/campaign.sqlite"), before);

  // --fresh does replace a file that is empty or no database at all, and must say what is lost.
  for (auto const& [bytes, told] :
       {std::pair("", "was an empty file: nothing is lost"),
        std::pair("no database at all", "was damaged, or no store of isolaw: its 18 bytes are lost")}) {
    write("o/campaign.sqlite", bytes);
    auto const o = isolaw(fit);
    EXPECT_EQ(o.code, 0) << o;
    EXPECT_TRUE(contains(o.err, told)) << o;
  }
  auto const again = isolaw(fit);
  EXPECT_EQ(again.code, 0) << again;
  EXPECT_FALSE(contains(again.err, "lost")) << again;

  // merge --fresh must refuse a database of another program too.
  fs::rename(path("o"), path("whole"));
  make("CREATE TABLE accounts (name TEXT)");
  expect_refused(isolaw({"merge", "o", "whole", "--fresh"}), {"is a database of another program"});
}

// The command that report.html shows must contain every option with which the record was read. Given again, this
// command must give the same campaign.
TEST_F(SmallThings, the_command_of_a_report_reads_the_records_in_the_same_way) {
  std::string untimed = "disp [mm],force [kN]\n";
  for (auto const& sample : record()) untimed += fmt::format("{:.5f},{:.5f}\n", sample.disp_mm, -sample.force_kN);
  write("u.csv", untimed);
  Words const read_so{"--dt", "0.01", "--rows", "1:500", "--flip-force", "--repair", "spikes", "--skew-ms", "2"};
  Words const rest = Words{"--figures", "none", "--analysis", "none"} + smallest_search;
  auto const o = isolaw(Words{"calibrate", "u.csv", "--out", "o"} + read_so + rest);
  ASSERT_EQ(o.code, 0) << o;
  auto const page = read("o/report.html");
  auto const from = page.find("isolaw calibrate u.csv");
  ASSERT_NE(from, std::string::npos);
  auto const command = page.substr(from, page.find('"', from) - from);
  for (auto const* part : {"--dt 0.01", "--rows :500", "--flip-force", "--repair spikes", "--skew-ms 2"})
    EXPECT_TRUE(contains(command, part));
  std::istringstream words(command);
  Words again;
  for (std::string word; words >> word;) again.push_back(word);
  again.erase(again.begin());
  auto const repeated = isolaw(again + Words{"--out", "p", "--figures", "none"});
  ASSERT_EQ(repeated.code, 0) << repeated;
  EXPECT_EQ(read("p/summary.json"), read("o/summary.json"));
}

TEST_F(SmallThings, a_merge_of_a_part_that_is_not_there_does_not_end_well) {
  auto const fit =
      isolaw(Words{"calibrate", "a.csv", "--out", "o", "--figures", "none", "--analysis", "none"} + smallest_search);
  ASSERT_EQ(fit.code, 0) << fit;
  expect_message(isolaw({"merge", "o", "nosuch", "--figures", "none"}), 1, {"nosuch/campaign.sqlite: not there"});
  EXPECT_EQ(isolaw({"merge", "o", "--figures", "none"}).code, 0);
}

// The user writes a report with other rules and without figures. report must remove the figures that show the former
// rules, and check must not miss them.
TEST_F(SmallThings, a_check_does_not_miss_figures_that_a_report_left_out) {
  write("b.csv", csv(record({.stiffness_kN_per_mm = 0.55})));
  auto const fit = isolaw(Words{"calibrate", "a.csv", "b.csv", "--out", "o", "--figures", "lot", "--analysis", "none"} +
                          smallest_search);
  ASSERT_EQ(fit.code, 0) << fit;
  auto const report = isolaw({"report", "o", "--rules", "en-15129", "--design", "K_eff=0.6", "--figures", "none"});
  EXPECT_TRUE(contains(report.err, "showed other results than these reports")) << report;
  auto const check = isolaw({"check", "o"});
  EXPECT_EQ(check.code, 0) << check;
  auto const drawn = isolaw({"report", "o", "--rules", "en-15129", "--design", "K_eff=0.6", "--figures", "lot"});
  EXPECT_TRUE(exists("o/figures/properties.dat")) << drawn;
}

// A campaign with one device has no law of the lot, so the list of allowed devices must not contain "lot".
TEST_F(SmallThings, what_is_allowed_is_not_refused_in_turn) {
  auto const fit =
      isolaw(Words{"calibrate", "a.csv", "--out", "o", "--figures", "none", "--analysis", "none"} + smallest_search);
  ASSERT_EQ(fit.code, 0) << fit;
  auto const wrong = isolaw({"export", "o", "--law", "bilinear", "--device", "b", "--to", "csv"});
  expect_refused(wrong, {"device 'b'", "allowed: a"});
  EXPECT_FALSE(contains(wrong.err, "lot")) << wrong;
  expect_refused(isolaw({"export", "o", "--law", "bilinear", "--device", "lot", "--to", "csv"}),
                 {"the name of the one device: a"});
}

TEST_F(SmallThings, a_file_that_is_missing_is_named_once) {
  auto const o = isolaw({"calibrate", "nosuch"});
  expect_refused(o, {"nosuch: no such file"});
  EXPECT_EQ(count_of("nosuch", o.err), 1u) << o;
  expect_refused(isolaw({"building"}), {"isolaw building: no building file and no campaign is given"});
  expect_refused(isolaw({"building", "b.toml"}), {"isolaw building: no campaign is given (--from)"});
}

TEST_F(SmallThings, mistakes_of_a_lot_file_stand_in_its_order_and_name_the_key_that_is_meant) {
  write("lot.toml",
        "titel = \"x\"\n[calibrate]\nlaw = \"bouc-wen\"\nruns = \"many\"\n[[device]]\nname = \"D\"\nfil = \"a.csv\"\n");
  auto const o = isolaw({"calibrate", "lot.toml"});
  expect_refused(o, {"unknown key 'titel'", "try: title", "try: laws", "try: file"});
  std::size_t last = 0;
  for (auto const* place : {"lot.toml:1:", "lot.toml:3:", "lot.toml:4:", "lot.toml:5:", "lot.toml:7:"}) {
    auto const at = o.err.find(place);
    ASSERT_NE(at, std::string::npos) << place << o;
    EXPECT_GE(at, last) << place << o;
    last = at;
  }
}

// Some rows of the record lack the force. The advice must take all of these rows into account and not only the first.
TEST_F(SmallThings, advice_about_ragged_rows_leads_past_all_of_them) {
  auto const ragged = [&](auto const& is_short) {
    auto const samples = record();
    std::string text = "time [s],disp [mm],force [kN]\n";
    for (std::size_t i = 0; i < samples.size(); ++i)
      text +=
          is_short(i) ? fmt::format("{:.4f},{:.5f}\n", samples[i].time_s, samples[i].disp_mm) : row(samples[i]) + "\n";
    write("ragged.csv", text);
    return isolaw({"inspect", "ragged.csv"});
  };
  auto const often = ragged([](std::size_t i) { return i % 50 == 49; });
  expect_refused(often, {"export the record again with a number in every cell, or delete these 12 rows from a copy"});
  EXPECT_FALSE(contains(often.err, "--rows")) << often;
  auto const early = ragged([](std::size_t i) { return i == 3 || i == 40; });
  expect_refused(early, {"try: --rows 42:601, the longest part without such rows"});
  EXPECT_EQ(isolaw({"inspect", "ragged.csv", "--rows", "42:601"}).code, 0);
  expect_refused(ragged([](std::size_t i) { return i == 3; }), {"try: --rows 5:, the rows behind it"});
}

TEST_F(SmallThings, init_tells_of_records_that_calibrate_will_refuse) {
  auto samples = record();
  samples[150].force_kN += 60.0;
  write("spike.csv", csv(samples));
  auto const o = isolaw({"init", "a.csv", "spike.csv"});
  EXPECT_EQ(o.code, 0) << o;
  EXPECT_TRUE(contains(o.err, "spike: isolaw calibrate will leave it out: the force has a single-sample spike")) << o;
  EXPECT_EQ(count_of("will leave it out", o.err), 1u) << o;
  // This record has two blocks, and only the second has a spike. init must say that laws will not be fitted to block 2.
  auto stages = record();
  auto const whole = stages.size() - 1;
  for (std::size_t i = 1; i <= whole; ++i) {
    auto next = stages[i];
    next.time_s += stages[whole].time_s;
    next.disp_mm *= 2.0, next.force_kN *= 2.0;
    stages.push_back(next);
  }
  stages[whole + 150].force_kN += 120.0;
  write("stages.csv", csv(stages));
  auto const of_two = isolaw({"init", "a.csv", "stages.csv", "--out", "two.toml"});
  EXPECT_TRUE(contains(of_two.err, "stages: isolaw calibrate will not fit laws to block 2: the force has a")) << of_two;
}

// The velocity falls to zero before each reversal, so a force that depends on it falls too. This happens within the
// tested range as well as beyond it, so an export must not warn that the law extrapolates badly.
TEST_F(SmallThings, a_fall_of_the_force_before_a_reversal_is_no_extrapolation) {
  std::string text = "time [s],disp [mm],force [kN]\n";
  for (int i = 0; i <= 600; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / 200.0, x = 100.0 * std::sin(phase);
    text += fmt::format("{:.4f},{:.5f},{:.5f}\n", 0.01 * i, x, 0.5 * x + 60.0 * std::cos(phase));
  }
  write("v.csv", text);
  auto const fit = isolaw({"calibrate", "v.csv", "--laws", "jankowski", "--runs", "1", "--out", "o", "--figures",
                           "none", "--analysis", "none"});
  ASSERT_TRUE(exists("o/campaign.sqlite")) << fit;
  auto const o = isolaw({"export", "o", "--law", "jankowski", "--device", "v", "--to", "opensees-cpp", "--anyway"});
  EXPECT_FALSE(contains(o.err, "stiffness is below zero")) << o;
  EXPECT_TRUE(contains(o.out, "Equations: F = ")) << o.out.substr(0, 3000);
  EXPECT_TRUE(contains(o.out, "at the fastest of all samples")) << o.out.substr(0, 3000);
}

TEST_F(SmallThings, a_sheet_that_is_refused_says_itself_how_far_its_link_is_off) {
  std::string text = "time [s],disp [mm],force [kN]\n";
  for (int i = 0; i <= 600; ++i) {
    double const phase = 2.0 * std::numbers::pi * i / 200.0, x = 100.0 * std::sin(phase);
    text += fmt::format("{:.4f},{:.5f},{:.5f}\n", 0.01 * i, x, 1e-4 * x * x * x + 2.0 * std::cos(phase));
  }
  write("h.csv", text);
  auto const fit = isolaw({"calibrate", "h.csv", "--laws", "jankowski", "--runs", "1", "--out", "o", "--figures",
                           "none", "--analysis", "none"});
  ASSERT_TRUE(exists("o/campaign.sqlite")) << fit;
  auto const o = isolaw({"export", "o", "--law", "jankowski", "--device", "h", "--to", "sheet", "--anyway"});
  EXPECT_FALSE(contains(o.err, "the sheet says")) << o;
  EXPECT_TRUE(contains(o.err, "is far off it: largest ")) << o;
}

}  // namespace
}  // namespace isolaw::cli_test
