// Tests files that hold several tests: how these are told apart by repeated headers, chosen, joined and listed.
#include <algorithm>

#include "data_writers.hpp"

namespace isolaw::data::testing {
namespace {

using SeveralTests = Files;

Ellipse const loop{.samples_per_cycle = 100, .cycles = 2};
Ellipse const small{.amplitude_mm = 50.0, .samples_per_cycle = 100, .cycles = 1};

ReadOptions test(std::string which) {
  ReadOptions options;
  options.test = std::move(which);
  return options;
}

std::string two_tests() {
  return "Test A\n" + header_row + rows(loop, ";") + "\nTest B\n" + header_row + rows(small, ";");
}

TEST_F(SeveralTests, AreRefusedWithoutAWord) {
  EXPECT_EQ(
      refusal(two_tests()),
      "FILE: 2 tests in one file: they start at lines 2, 206; allowed: one of them, or all as one history; try: --test all, or --test 2, or isolaw init, which makes a device of each");
}

TEST_F(SeveralTests, OneIsReadByItsNumber) {
  auto const first = read(two_tests(), test("1"));
  EXPECT_EQ(first.size(), 201u);
  EXPECT_EQ(first.layout.test, "1");
  auto const second = read(two_tests(), test("2"));
  EXPECT_EQ(second.size(), 101u);
  EXPECT_DOUBLE_EQ(second.disp_mm[25], 50.0);
  EXPECT_DOUBLE_EQ(second.time_s[25], 0.25);
  EXPECT_TRUE(says(second.recognised, "line 206 is the header"));
  EXPECT_TRUE(says(second.recognised, "above the data, line 205 is passed over"));
  EXPECT_TRUE(says(second.recognised, "101 samples, lines 207 to 307"));
  EXPECT_TRUE(says(second.recognised, "2 tests in the file, test 2 is read"));
}

TEST_F(SeveralTests, AllAreOneHistory) {
  auto const record = read(two_tests(), test("all"));
  ASSERT_EQ(record.size(), 302u);
  EXPECT_EQ(record.layout.test, "all");
  EXPECT_DOUBLE_EQ(record.time_s[200], 2.0);
  EXPECT_NEAR(record.time_s[201], 2.01, 1e-12);  // the second test follows after one sampling interval
  EXPECT_NEAR(record.time_s[301], 3.01, 1e-12);
  EXPECT_DOUBLE_EQ(record.disp_mm[201 + 25], 50.0);
  EXPECT_EQ(record.sha256, read(two_tests(), test("1")).sha256);  // both hashes are those of the whole file
  EXPECT_TRUE(says(record.recognised, "test 2 continues the history with 101 samples"));
}

TEST_F(SeveralTests, AWrongNumberOrWord) {
  EXPECT_EQ(refusal(two_tests(), test("3")), "FILE: no test 3; allowed: 1 to 2, at lines 2, 206; try: --test 1");
  EXPECT_EQ(refusal(header_row + rows(loop, ";"), test("2")),
            "FILE: no test 2; allowed: 1, the only one; try: --test 1");
  for (auto const* word : {"0", "first", "-1", "1001", ""})
    EXPECT_EQ(refusal(two_tests(), test(word)),
              fmt::format("--test: '{}'; allowed: all, or the number of a test, from 1 to 1000", word));
}

TEST_F(SeveralTests, ASingleTestNeedsNoWordAndKeepsNone) {
  auto const record = read(header_row + rows(loop, ";"), test("all"));
  EXPECT_EQ(record.size(), 201u);
  EXPECT_EQ(record.layout.test, std::nullopt);
}

TEST_F(SeveralTests, MayHaveOtherNamesUnitsAndOrder) {
  auto const text =
      header_row + rows(loop, ";") + "Force [N];Zeit [s];Weg [cm]\n" + "0;0;0\n1000;1;1\n0;2;2\n-500;3;0\n";
  auto const record = read(text, test("2"));
  EXPECT_EQ(record.disp_mm, (std::vector{0.0, 10.0, 20.0, 0.0}));
  EXPECT_EQ(record.force_kN, (std::vector{0.0, 1.0, 0.0, -0.5}));
}

TEST_F(SeveralTests, UnitRowsAndCommentedNames) {
  auto const block = "# Time;Disp;Force\n# s;mm;kN\n" + rows(loop, ";");
  auto const record = read(block + block, test("2"));
  EXPECT_EQ(record.size(), 201u);
  EXPECT_TRUE(says(record.recognised, "line 204 is the header, line 205 gives the units"));
}

// Text between the rows starts another test only if it names channels. Other text is an error at its line.
TEST_F(SeveralTests, AreNotMadeOfOtherText) {
  EXPECT_EQ(
      refusal(header_row + "0;1;2\n1;2;3\nstop;stop;stop\n2;3;1\n"),
      "FILE:4: 'stop' in column 1 'Time [s]' is not a number; allowed: a number with a decimal point; try: export the record again");
}

TEST_F(SeveralTests, FaultsAreAtTheirLineOfTheFile) {
  EXPECT_EQ(
      refusal(header_row + "0;1;2\n1;2;3\n2;3;1\n" + header_row + "0;1;2\n1;x;3\n2;3;1\n", test("2")),
      "FILE:7: 'x' in column 2 'Disp [mm]' is not a number; allowed: a number with a decimal point; try: export the record again");
}

TEST_F(SeveralTests, BeyondAnyNumberOfThem) {
  std::string text;
  for (int i = 0; i < 1001; ++i) text += header_row + "0;1;2\n1;2;3\n";
  EXPECT_EQ(refusal(text, test("1")),
            "FILE: 1001 tests, each with a row of names; allowed: 1000 or fewer; try: split the file");
}

TEST_F(SeveralTests, AreListed) {
  auto const file = write(two_tests());
  auto const tests = list_tests(file);
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_EQ(tests[0].test, "1");
  EXPECT_EQ(tests[1].test, "2");
  EXPECT_EQ(tests[1].sheet, std::nullopt);
  EXPECT_EQ(tests[1].place, file.generic_string() + ":206");
  EXPECT_EQ(list_tests(file, test("all")).size(), 1u);
  EXPECT_EQ(list_tests(file, test("2")).front().test, "2");
  auto const one = list_tests(write(header_row + rows(loop, ";"), "one.csv"));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one.front().test, std::nullopt);
}

// Returns the first of the two headers of a LabVIEW file. lvm_part() returns the second, which has a row of units, then
// the names of channels and the rows. One column is for comments.
std::string lvm_head(std::string const& x_columns = "One") {
  return "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\nMulti_Headings\tNo\n"
         "X_Columns\t" +
         x_columns + "\nTime_Pref\tAbsolute\nDate\t2024/07/03\nTime\t10:11:12,123\n***End_of_Header***\t\n\t\n";
}
std::string lvm_part(Ellipse const& of, bool x = true) {
  auto text = fmt::format(
      "Channels\t2\t\nSamples\t{0}\t{0}\nDate\t2024/07/03\t2024/07/03\nY_Unit_Label\tmm\tkN\n"
      "X_Dimension\tTime\tTime\nX0\t0\t0\nDelta_X\t0,01\t0,01\n***End_of_Header***\n"
      "X_Value\tDisplacement\tForce\tComment\n",
      of.size());
  for (int i = 0; i < of.size(); ++i) {
    auto line = fmt::format("{}\t{:.9f}\t{:.9f}\n", x ? fmt::format("{:.2f}", 0.01 * i) : "", of.disp(i), of.force(i));
    std::ranges::replace(line, '.', ',');
    text += line;
  }
  return text;
}

TEST_F(SeveralTests, LabViewFilesAreReadAfterTheirEndOfHeader) {
  auto const record = read(lvm_head() + lvm_part(loop));
  ASSERT_EQ(record.size(), 201u);
  EXPECT_DOUBLE_EQ(record.time_s[200], 2.0);
  EXPECT_NEAR(record.disp_mm[25], 100.0, 1e-8);
  EXPECT_TRUE(says(record.recognised, "line 20 is the header"));
  EXPECT_TRUE(says(record.recognised, "time: column 1 'X_Value', by its name; unit s as the file states beside it"));
  EXPECT_TRUE(says(record.recognised, "force: column 3 'Force', by its name; unit kN as the file states beside it"));
  auto const two = lvm_head() + lvm_part(loop) + "\n" + lvm_part(small);
  auto const second = read(two, test("2"));
  ASSERT_EQ(second.size(), 101u);
  EXPECT_NEAR(second.disp_mm[25], 50.0, 1e-8);
  auto const without = read(lvm_head("No") + lvm_part(loop, false));
  ASSERT_TRUE(without.has_time());
  EXPECT_DOUBLE_EQ(without.time_s[200], 2.0);
  EXPECT_TRUE(
      says(without.recognised, "sampling interval 0.01 s (100 Hz), as the header of the file has it (Delta_X)"));
  EXPECT_EQ(without.disp_mm, record.disp_mm);
  ReadOptions told;
  told.dt_s = 0.02;
  EXPECT_DOUBLE_EQ(read(lvm_head("No") + lvm_part(loop, false), told).time_s[200], 4.0);
  told = {};
  told.columns[Channel::time] = "none";
  EXPECT_FALSE(read(lvm_head("No") + lvm_part(loop, false), told).has_time());
  for (std::string const other : {"Delta_X\t0,01\t0,02\n", "Delta_X\t\t\n"}) {
    auto part = lvm_part(loop, false);
    std::string const line = "Delta_X\t0,01\t0,01\n";
    part.replace(part.find(line), line.size(), other);
    auto const open = read(lvm_head("No") + part);
    EXPECT_FALSE(open.has_time()) << other;
    EXPECT_TRUE(says(open.recognised, "no time column: rate-dependent laws need --dt SECONDS")) << other;
  }
  auto const later = read(lvm_head("No") + lvm_part(small, false) + "\n" + lvm_part(loop, false), test("2"));
  EXPECT_EQ(later.disp_mm, record.disp_mm);
}

TEST_F(SeveralTests, OfAWorkbookAreListedSheetBySheet) {
  auto const file = write("", "book.xlsx");
  workbook_of(file, {{"Large", columns_of(loop)}, {"Notes", {{"a", {1.0}}}}, {"Small", columns_of(small)}});
  auto const tests = list_tests(file);
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_EQ(tests[0].sheet, "Large");
  EXPECT_EQ(tests[1].sheet, "Small");
  EXPECT_EQ(tests[1].test, std::nullopt);
  EXPECT_EQ(tests[1].place, file.generic_string() + ":Small:1");
}

TEST_F(SeveralTests, SheetsAreNotForText) {
  ReadOptions options;
  options.sheet = "1";
  EXPECT_EQ(
      refusal(header_row + rows(loop, ";"), options),
      "--sheet: '1', but FILE is delimited text; allowed: a sheet of a workbook, a struct of a .mat file, a key of JSON; try: leave --sheet out");
}

TEST(History, TimeChannelsOfAllPartsOrNone) {
  TestRecord with_time, without;
  with_time.time_s = {0.0, 1.0};
  with_time.disp_mm = without.disp_mm = {0.0, 1.0};
  with_time.force_kN = without.force_kN = {0.0, 1.0};
  EXPECT_THROW(continue_with(with_time, without, "b.csv"), Error);
  auto history = with_time;
  with_time.time_s = {5.0, 6.0};
  continue_with(history, with_time, "b.csv");
  EXPECT_EQ(history.time_s, (std::vector{0.0, 1.0, 2.0, 3.0}));
  EXPECT_EQ(history.size(), 4u);
}

}  // namespace
}  // namespace isolaw::data::testing
