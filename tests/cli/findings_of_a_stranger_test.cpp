// Small faults that a first-time user found: isolaw accepted wrong input without a message, or quoted it oddly.
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

// A device is named after its file. Blanks around the name are removed. A name that a lot file cannot hold is refused.
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
    expect_refused(inspected(std::string(device) + "test-date = \"" + date + "\"\n"),
                   {"lot.toml:4: test-date: '", "is no date", "2024-03-17"});
  for (auto const* date : {"2024-02-29", "29.02.2024", "02/29/2024", "20240229", "17 May 2024", "spring 2024"}) {
    auto const o = inspected(std::string(device) + "test-date = \"" + date + "\"\n");
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

// Damping divides by the stiffness. This force has practically none, so the quotient would be rounding error.
TEST_F(SmallThings, damping_without_stiffness_is_not_defined) {
  write("v.csv", csv(record(), "Time [s],Displacement [mm],Force [kN]", [](std::size_t i, Sample const& s) {
          double const phase = std::asin(std::clamp(s.disp_mm / 100.0, -1.0, 1.0));
          bool const rises = i % 200 < 50 || i % 200 >= 150;
          return fmt::format("{:.4f},{:.4f},{:.9f}", s.time_s, s.disp_mm,
                             (rises ? 50.0 : -50.0) * std::cos(phase) + 1e-7 * s.disp_mm);
        }));
  auto const o = isolaw({"inspect", "v.csv"});
  EXPECT_TRUE(contains(o.out, "equivalent damping is not defined")) << o.out;
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

}  // namespace
}  // namespace isolaw::cli_test
