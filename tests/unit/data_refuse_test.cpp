// Tests which files isolaw refuses, and the message about each.
#include <sys/stat.h>

#include <algorithm>

#include "data_fixture.hpp"
#include "isolaw/base/units.hpp"
#include "isolaw/data/files/text.hpp"
#include "refusal.hpp"

namespace isolaw::data::testing {
namespace {

using Refuse = Files;
using namespace std::string_literals;

std::string thrown_for(std::filesystem::path const& file) {
  return refusal_of([&] { read_record(file); });
}

// --- files that are not text ---

TEST_F(Refuse, WhatIsNoFile) {
  EXPECT_EQ(thrown_for("nowhere/D07.csv"),
            "nowhere/D07.csv: no such file; allowed: delimited text, .xlsx, .mat or JSON");
  auto const folder = write("x").parent_path();
  EXPECT_EQ(thrown_for(folder),
            folder.generic_string() + ": is a directory; allowed: delimited text, .xlsx, .mat or JSON");
}

TEST_F(Refuse, WhatIsNotText) {
  auto const expect = [&](std::string const& bytes, std::string const& found, std::string const& advice) {
    EXPECT_EQ(refusal(bytes), "FILE: " + found + "; allowed: delimited text, .xlsx, .mat or JSON" +
                                  (advice.empty() ? "" : "; try: " + advice));
  };
  expect("", "is empty", "");
  expect("\xD0\xCF\x11\xE0....", "is an .xls workbook, or one with a password",
         "save it as .xlsx without a password, or the sheet as CSV");
  expect("%PDF-1.7\n1;2\n", "is a PDF document", "export the channels as CSV");
  expect("\x89HDF\r\n\x1A\n", "is an HDF5 file", "export the channels as CSV");
  // This text is UTF-16 without a byte order mark.
  expect("1\0;\0"s, "is a binary file (byte 2 is 0)", "export the channels as CSV");
  expect("1;2\n3;\0\n"s, "is a binary file (byte 7 is 0)", "export the channels as CSV");
}

TEST_F(Refuse, AFileAboveOneGiB) {
  auto const file = write("x");
  std::filesystem::resize_file(file, (std::uintmax_t{3} << 29));  // a sparse file, which takes no space on disk
  EXPECT_EQ(
      thrown_for(file),
      file.generic_string() +
          ": is 1.50 GiB large, above 1 GiB; allowed: delimited text, .xlsx, .mat or JSON; try: export one test per file, or fewer samples per second");
}

TEST_F(Refuse, WhatIsNoPlainFile) {
  std::string const rest = "; allowed: delimited text, .xlsx, .mat or JSON";
  EXPECT_EQ(thrown_for("/dev/zero"), "/dev/zero: is a device" + rest);
  auto const pipe = write("x").parent_path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(thrown_for(pipe), pipe.generic_string() + ": is a pipe" + rest);
  EXPECT_EQ(thrown_for(std::string(5000, 'x')).substr(4990), "xxxxxxxxxx: cannot be read: File name too long" + rest);
}

TEST_F(Refuse, MoreRowsThanAnyTestHas) {
  EXPECT_EQ(
      refusal(std::string(most_lines + 1, '\n')),
      "FILE: 10000001 rows; allowed: 10000000 or fewer; try: thin the record, every tenth row for example, or export one test per file");
}

TEST_F(Refuse, ALineWithoutEnd) {
  EXPECT_EQ(
      refusal("1,2\n" + std::string(longest_line + 1, '1') + "\r\n3,4"),
      "FILE:2: a line of 32769 characters; allowed: 32768 or fewer; try: export the channels as CSV, one sample a line");
}

TEST_F(Refuse, MoreColumnsThanAnyTestHas) {
  std::string row = "1";
  for (int i = 1; i < 1001; ++i) row += ";" + std::to_string(i % 10);
  EXPECT_EQ(
      refusal(row + "\n" + row + "\n" + row + "\n"),
      "FILE: 1001 columns separated by semicolons; allowed: 1000 or fewer; try: export time, displacement and force alone, one sample a line");
}

TEST_F(Refuse, ControlCharactersAreSpelledOut) {
  auto const text = refusal("Disp\x1b[31m [mm];For\x07 \xe2\x80\xae[kN];\x9b\n1;2;3\n2;3;4\n3;x\x1b;1\n");
  EXPECT_NE(text.find("1 'Disp\\x1b[31m [mm]'"), std::string::npos) << text;
  for (char const c : {'\x1b', '\x07', '\x9b'}) EXPECT_EQ(text.find(c), std::string::npos) << text;
}

TEST_F(Refuse, NoNumbers) {
  std::string const rest =
      "; allowed: two or more columns of numbers, separated by commas, semicolons, tabs or blanks; try: export displacement and force as CSV";
  EXPECT_EQ(refusal("Time;Disp;Force\ns;mm;kN\n"), "FILE: no rows of numbers in 2 lines" + rest);
  EXPECT_EQ(refusal("\n \n"), "FILE: no rows of numbers in 2 lines" + rest);
  std::string const one =
      "FILE: one column of numbers; allowed: two or more columns of numbers, separated by commas, semicolons, tabs or blanks; try: displacement beside force; --columns force=FILE:COLUMN where each is in a file of its own; --dt SECONDS for a motion";
  EXPECT_EQ(refusal("1.5\n2.5\n3.5\n"), one);
  EXPECT_EQ(refusal("Displacement [mm]\n1.5\n2.5e1\n-3\n+4\n"), one);
}

TEST_F(Refuse, FewerThanThreeSamples) {
  EXPECT_EQ(refusal(header_row + "0;1;2\n1;2;3\n"), "FILE: 2 samples; allowed: 3 or more");
}

// --- commas and thousands ---

TEST_F(Refuse, DecimalCommasBetweenCommas) {
  EXPECT_EQ(
      refusal("Disp [mm],Force [kN]\n1,5,2,0\n2,5,3,0\n3,5,1,0\n", with("disp=1,force=3", "disp=mm,force=kN")),
      "FILE:1: 2 names, but the rows have 4 columns: commas seem to be both delimiter and decimal separator; allowed: one name per column; try: export with semicolons or tabs between the columns");
  EXPECT_EQ(
      refusal("1,5,2,0\n2,5,3,0\n3,5,1,0\n", with("disp=1,force=3", "disp=mm,force=kN")),
      "FILE:1: 4 columns of whole numbers, or 2 of numbers with a decimal comma: nothing shows which; allowed: a delimiter that is not the decimal separator, or a line of names; try: export with semicolons or tabs between the columns");
}

TEST_F(Refuse, NamesAndColumnsThatDoNotMatch) {
  EXPECT_EQ(
      refusal("Disp [mm];Force [kN]\n1;2;3\n2;3;4\n3;1;5\n", with("disp=1,force=3", "disp=mm,force=kN")),
      "FILE:1: 2 names, but the rows have 3 columns; allowed: one name per column; try: give every column one name");
}

TEST_F(Refuse, ThousandsSeparators) {
  EXPECT_EQ(
      refusal("Disp [mm];Force [kN]\n1,5;1.234,56\n2,5;3,0\n3,5;1,0\n"),
      "FILE:2: '1.234,56' in column 2 'Force [kN]' has thousands separators; allowed: a number with a decimal comma and no other separator; try: --thousands .");
  EXPECT_EQ(
      refusal("Disp [mm];Force [N]\n1.5;1,234.56\n2.5;3.0\n3.5;1.0\n"),
      "FILE:2: '1,234.56' in column 2 'Force [N]' has thousands separators; allowed: a number with a decimal point and no other separator; try: --thousands ,");
}

// Seconds since a logger was switched on may be as large as the day numbers of a spreadsheet. They must not be read as
// days.
TEST_F(Refuse, NumbersBelowTimeAreNoDaysOfASpreadsheet) {
  for (std::string const name : {"Time", "Zeit", "Tempo", "Timestamp", "Uhrzeit"}) {
    std::string text = name + ";Disp [mm];Force [kN]\n";
    for (int i = 0; i < 20; ++i) text += fmt::format("{:.2f};{};{}\n", 40000.0 + 0.08 * i, i, i % 5);
    auto const said = refusal(text);
    if (name == "Timestamp" || name == "Uhrzeit")  // a column of this name need not be the time of the test
      EXPECT_EQ(read(text).has_time(), false) << name;
    else
      EXPECT_EQ(
          said,
          fmt::format(
              "FILE:1: column 1 '{}' (time) has no unit; allowed: {}; try: --units time=s, with the column's unit",
              name, known_units(Dimension::time)));
    ReadOptions seconds;
    seconds.columns[Channel::time] = "1";
    seconds.units[Channel::time] = "s";
    EXPECT_NEAR(read(text, seconds).time_s.back(), 40001.52, 1e-9) << name;
  }
}

// --- errors in rows ---

TEST_F(Refuse, CellsThatAreNoNumbersAllAtOnce) {
  EXPECT_EQ(
      refusal(header_row + "0;1;2\n1;NaN;3\n2;3;-inf\n3;x;1\n4;;1\n5;1,5;1\n6;1;1;9\n7;#N/A;1\n8;2;3\n9;2.5;4\n"),
      "FILE:8: 4 columns: '6;1;1;9'; allowed: 3 columns, as in most rows; try: export the record again with a number in every cell, or delete these 7 rows from a copy\n"
      "FILE:3: 'NaN' in column 2 'Disp [mm]' is not a finite number; allowed: a finite number; try: export the record again with a number in every cell, or delete these 7 rows from a copy; --missing leave-out or --missing interpolate\n"
      "FILE:4: '-inf' in column 3 'Force [kN]' is not a finite number; allowed: a finite number; try: export the record again with a number in every cell, or delete these 7 rows from a copy; --missing leave-out or --missing interpolate\n"
      "FILE:5: 'x' in column 2 'Disp [mm]' is not a number; allowed: a number with a decimal point; try: export the record again with a number in every cell, or delete these 7 rows from a copy\n"
      "FILE:6: column 2 'Disp [mm]' is empty; allowed: a number; try: export the record again with a number in every cell, or delete these 7 rows from a copy; --missing leave-out or --missing interpolate\n"
      "FILE:7: '1,5' in column 2 'Disp [mm]' is not a number; allowed: a number with a decimal point; try: export the record again with a number in every cell, or delete these 7 rows from a copy\n"
      "FILE: and 1 more cells that are no number");
}

// The message suggests rows to read instead: those before or those behind the error, whichever are more, within the
// rows that the user asked for.
TEST_F(Refuse, TheAdviceLeavesEnoughRowsOfThoseAskedFor) {
  auto const text = header_row + "0;1;2\n1;3;3\n2;2;1\n3;1;2\n4;x;1\n5;2;3\n6;1;2\n7;0;1\n8;2;3\n9;3;1\n";
  auto const advice = [&](char const* rows) {
    ReadOptions options;
    if (*rows != '\0') options.rows = parse_rows(rows);
    auto const said = refusal(text, options);
    return said.substr(std::min(said.find("try: "), said.size()));
  };
  EXPECT_EQ(advice(""), "try: --rows 6:, the rows behind it");
  EXPECT_EQ(advice("2:10"), "try: --rows 6:10, the rows behind it");
  EXPECT_EQ(advice("2:8"), "try: --rows 2:4, the rows before it");
  EXPECT_EQ(advice("5:9"), "try: --rows 6:9, the rows behind it");
  EXPECT_EQ(advice("4:7"), "try: export the record again");
  EXPECT_EQ(advice("6:10"), "") << "which does not hold it";
}

TEST_F(Refuse, ABrokenFirstRowIsNoHeader) {
  EXPECT_EQ(
      refusal(header_row + "0;x;2\n1;2;3\n2;3;1\n3;1;2\n"),
      "FILE:2: 'x' in column 2 'Disp [mm]' is not a number; allowed: a number with a decimal point; try: --rows 2:, the rows behind it");
}

TEST_F(Refuse, LinesAreCountedAlikeForEveryLineEnd) {
  for (std::string const end : {"\n", "\r\n", "\r"}) {
    auto const text =
        refusal("Disp [mm];Force [kN]" + end + end + "1;2" + end + "x;3" + end + "3;1" + end + "4;2" + end);
    EXPECT_TRUE(text.starts_with("FILE:4: 'x' in column 1")) << text;
  }
}

TEST_F(Refuse, ProblemsOfColumnsAndRowsTogether) {
  EXPECT_EQ(
      refusal("Time [s];Disp;Force [kN]\n0;1;2\n1;x;3\n2;3;1\n3;4;2\n"),
      "FILE:1: column 2 'Disp' (disp) has no unit; allowed: mm, cm, m, in, ft, dm, um; try: --units disp=mm, with the column's unit\n"
      "FILE:3: 'x' in column 2 'Disp' is not a number; allowed: a number with a decimal point; try: export the record again");
}

// --- impossible values of a channel ---

TEST_F(Refuse, TimeThatDoesNotIncrease) {
  EXPECT_EQ(
      refusal(header_row + "0;1;2\n1;2;3\n1;3;1\n0.5;3;2\n2;1;1\n"),
      "FILE:4: time 1 s is repeated; allowed: time that increases from row to row; try: --rows A:B for one test of several, or leave time out with --columns time=none and give --dt\n"
      "FILE:5: time goes back from 1 to 0.5 s; allowed: time that increases from row to row; try: --rows A:B for one test of several, or leave time out with --columns time=none and give --dt");
}

TEST_F(Refuse, IntervalBesideATimeColumn) {
  ReadOptions options;
  options.dt_s = 0.01;
  EXPECT_EQ(
      refusal(header_row + "0;1;2\n1;2;3\n2;3;1\n", options),
      "FILE: --dt 0.01 is given, but column 1 'Time [s]' is the time; allowed: --dt for a file without a time column; try: leave --dt out, or leave the column out with --columns time=none");
  options.columns[Channel::time] = "none";
  EXPECT_EQ(refusal(header_row + "0;1;2\n1;2;3\n2;3;1\n", options), "");
  options.dt_s = -1.0;
  EXPECT_EQ(refusal(header_row + "0;1;2\n1;2;3\n2;3;1\n", options),
            "--dt: -1; allowed: a positive number of seconds, 1e-9 to 1e6");
}

TEST_F(Refuse, ChannelsThatDoNotMove) {
  EXPECT_EQ(
      refusal(header_row + "0;1.5;2\n1;1.5;2\n2;1.5;2\n"),
      "FILE: disp is constant: column 2 'Disp [mm]' holds 1.5 mm in all 3 samples; allowed: a channel that moves; try: --columns disp=NUMBER with the column that was measured\n"
      "FILE: force is constant: column 3 'Force [kN]' holds 2 kN in all 3 samples; allowed: a channel that moves; try: --columns force=NUMBER with the column that was measured");
}

// Returns the rows of a sound loop, with some forces replaced.
std::string loop_with(std::vector<std::pair<int, std::string>> const& replaced, Ellipse const& loop = {}) {
  std::string text = header_row;
  for (int i = 0; i < loop.size(); ++i) {
    auto force = fmt::format("{:.4f}", loop.force(i));
    for (auto const& [at, value] : replaced)
      if (at == i) force = value;
    text += fmt::format("{:.4f};{:.4f};{}\n", 0.01 * i, loop.disp(i), force);
  }
  return text;
}

TEST_F(Refuse, Overloads) {
  std::string const rest =
      "; allowed: measured values; try: --rows A:B or --to SECONDS, which end before the overload, or test again";
  EXPECT_EQ(
      refusal(loop_with({{10, "1e30"}})),
      "FILE:12: 1e+30 kN in column 3 'Force [kN]' looks like an overload of the sensor (all but a few values stay within 77.62 kN)" +
          rest);
  EXPECT_NE(refusal(loop_with({{10, "-9999"}, {11, "-9999"}})).find("FILE:13: -9999 kN"), std::string::npos);
  EXPECT_NE(refusal(loop_with({{10, "999.9"}})).find("FILE:12: 999.9 kN"), std::string::npos);
  // The largest of the other forces is 78 kN. A force of more than 50 times this value is an overload.
  EXPECT_NE(refusal(loop_with({{10, "4321"}})).find("FILE:12: 4321 kN"), std::string::npos);
}

TEST_F(Refuse, ManyOverloadsAreCounted) {
  std::vector<std::pair<int, std::string>> replaced;
  for (int i = 100; i < 120; ++i) replaced.emplace_back(i, "99999");
  auto const text = refusal(loop_with(replaced));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 5);
  EXPECT_TRUE(text.ends_with("\nFILE: and 15 more values beyond the sensor's range"));
}

TEST_F(Refuse, LegitimateValuesAreNoOverloads) {
  EXPECT_EQ(refusal(loop_with({{10, "999"}}, {.amplitude_mm = 1000.0})), "");  // the other forces reach 776 kN
  EXPECT_EQ(refusal(loop_with({{10, "9999"}}, {.amplitude_mm = 12000.0})), "");
  // 700 kN is nine times the largest of the other forces. Only a force of more than 50 times that value is an overload.
  EXPECT_EQ(refusal(loop_with({{10, "700"}})), "");
  std::string held = "Disp [mm];Force [kN]\n";  // a long hold before the test
  for (int i = 0; i < 20000; ++i) held += "0.001;0.01\n";
  Ellipse const loop;
  for (int i = 0; i < loop.size(); ++i) held += fmt::format("{:.4f};{:.4f}\n", loop.disp(i), loop.force(i));
  EXPECT_EQ(refusal(held), "");
}

// --- loops that no device can have ---

std::string const positive =
    "; allowed: a device that dissipates energy and resists displacement: both positive; try: ";

TEST_F(Refuse, SwappedForceAndDisplacement) {
  Ellipse const loop;
  auto const table = "t [s];Force [mm];Disp [kN]\n" + rows(loop, ";");
  EXPECT_EQ(refusal(table, with("disp=3,force=2", "disp=mm,force=kN")),
            "FILE: force and displacement seem swapped: energy per cycle -6282 kN mm, stiffness 1.245 kN/mm" +
                positive + "--columns disp=2,force=3 --units disp=mm,force=kN, with the units these columns have");
  EXPECT_EQ(refusal(table, with("disp=2,force=3", "disp=mm,force=kN")), "");
}

TEST_F(Refuse, FlippedForce) {
  auto const table = header_row + rows({.K = -0.75, .C = -0.2}, ";");
  EXPECT_EQ(refusal(table), "FILE: the force's sign is flipped: energy per cycle -6282 kN mm, stiffness -0.75 kN/mm" +
                                positive + "--flip-force");
  ReadOptions options;
  options.flip_force = true;
  EXPECT_EQ(refusal(table, options), "");
  EXPECT_NE(refusal(header_row + rows({}, ";"), options).find("try: leave --flip-force out"), std::string::npos);
}

TEST_F(Refuse, PureFrictionWithTheWrongSignMayBeEither) {
  auto const text = refusal(header_row + rows({.K = 0.0, .C = -0.2}, ";"));
  EXPECT_NE(text.find("the force's sign is flipped, or force and displacement are swapped"), std::string::npos) << text;
}

TEST_F(Refuse, NoPhysicsWithoutACompleteCycle) {
  EXPECT_EQ(refusal(header_row + "0;0;0\n1;1;-2\n2;2;-3\n3;3;-3\n"), "");
}

TEST_F(Refuse, AnAlmostElasticDeviceIsNotRefusedForItsSkew) {
  EXPECT_EQ(refusal(header_row + rows({.K = 0.75, .C = -0.002}, ";")), "");
}

}  // namespace
}  // namespace isolaw::data::testing
