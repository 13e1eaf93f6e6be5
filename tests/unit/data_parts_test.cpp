// Tests time stamps, and records that are read from a part of a file or from two files: rows, spans of time, text below
// the rows, channels in two files.
#include "data_fixture.hpp"
#include "isolaw/base/hash.hpp"
#include "isolaw/data/files/time_stamp.hpp"

namespace isolaw::data::testing {
namespace {

// --- time stamps ---

double seconds(std::string_view text) {
  auto const stamp = parse_stamp(text);
  return stamp && stamp->clocked ? stamp->clock_s : -1.0;
}

TEST(Stamp, TimesOfDay) {
  EXPECT_NEAR(seconds("10:00:00.250"), 36000.25, 1e-9);
  EXPECT_NEAR(seconds("10:00:00,250"), 36000.25, 1e-9);
  EXPECT_NEAR(seconds("10:00:00:250"), 36000.25, 1e-9);
  EXPECT_NEAR(seconds("1:02:03 PM"), 46923.0, 1e-9);
  EXPECT_NEAR(seconds("12:00:01 AM"), 1.0, 1e-9);
  EXPECT_NEAR(seconds("24:00:00"), 86400.0, 1e-9);
  EXPECT_NEAR(seconds("59:58.5"), 3598.5, 1e-9);  // 59 minutes and 58.5 seconds
  for (auto const* none :
       {"10:30", "25:00:00", "24:59:00", "10:61:00", "10:00:0x", "1.5", "100000", "abcde", "10:00:00 XM"})
    EXPECT_FALSE(parse_stamp(none)) << none;
}

TEST(Stamp, Dates) {
  for (auto const* same :
       {"2024-05-02T10:00:00", "2024/05/02 10:00:00", "20240502T100000", "02-May-2024 10:00:00",
        "2024-05-02T12:00:00+02:00", "2024-05-02 10:00:00Z", "45414.416666666667 (a date or time of day)"}) {
    auto const stamp = parse_stamp(same);
    ASSERT_TRUE(stamp && stamp->days) << same;
    EXPECT_EQ(*stamp->days, 19845) << same;  // days from 1970-01-01 to 2024-05-02
    EXPECT_NEAR(stamp->clock_s - stamp->zone_s.value_or(0.0), 36000.0, 1e-5) << same;
  }
  auto const open = parse_stamp("03.04.2024 10:00:00");
  ASSERT_TRUE(open);
  EXPECT_FALSE(open->days);
  for (auto const* none : {"2024-13-02 10:00:00", "2024-02-30 10:00:00", "32/32/2024", "2024-05-02T", "1.2.3.4"})
    EXPECT_FALSE(parse_stamp(none)) << none;
}

class Stamps : public Files {
 protected:
  static std::string file(std::vector<std::string> const& stamps) {
    std::string text = "Time;Disp [mm];Force [kN]\n";
    for (std::size_t i = 0; i < stamps.size(); ++i) text += fmt::format("{};{};{}\n", stamps[i], i, i % 2);
    return text;
  }
  void expect_times(std::vector<std::string> const& stamps, std::vector<double> const& times,
                    ReadOptions const& options = {}) {
    auto const record = read(file(stamps), options);
    ASSERT_EQ(record.time_s.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(record.time_s[i], times[i], 1e-6) << stamps[i];
  }
};

TEST_F(Stamps, AreSecondsFromTheFirst) {
  expect_times({"23:59:59.0", "23:59:59.5", "00:00:00.0", "00:00:00.5"}, {0, 0.5, 1, 1.5});
  expect_times({"2024-03-31T01:59:59+01:00", "2024-03-31T03:00:00+02:00", "2024-03-31T03:00:01+02:00"}, {0, 1, 2});
  expect_times({"31/12/2023 23:59:59", "01/01/2024 00:00:00", "01/01/2024 00:00:01"}, {0, 1, 2});
  expect_times({"12/31/2023 23:59:59", "01/01/2024 00:00:00", "01/01/2024 00:00:01"}, {0, 1, 2});
  // If the day is read first, the second stamp follows the first by a second. If the month is read first, a month lies
  // between them.
  expect_times({"03/04/2024 23:59:59", "04/04/2024 00:00:00", "04/04/2024 00:00:01"}, {0, 1, 2});
  // All stamps have the same date, so the times do not depend on the order of day and month.
  expect_times({"03/04/2024 10:00:00", "03/04/2024 10:00:01", "03/04/2024 10:00:02"}, {0, 1, 2});
}

TEST_F(Stamps, OfAnOpenOrderAreRefusedWithBothReadings) {
  std::vector<std::string> const open{"01/02/2024 10:00:00", "02/03/2024 10:00:00", "03/04/2024 10:00:00"};
  EXPECT_EQ(
      refusal(file(open)),
      "FILE:2: date 01/02/2024 may be 2024-02-01 (day first) or 2024-01-02 (month first); allowed: dates of which one has a day above 12, which shows the order; try: --date-order dmy, or --date-order mdy");
  ReadOptions options;
  options.date_order = DateOrder::day_first;
  expect_times(open, {0, 30 * 86400.0, 62 * 86400.0}, options);
  options.date_order = DateOrder::month_first;
  expect_times(open, {0, 32 * 86400.0, 62 * 86400.0}, options);
}

TEST_F(Stamps, CoarserThanTheSamplingAreRefusedWithTheInterval) {
  std::vector<std::string> coarse;
  for (int i = 0; i < 30; ++i) coarse.push_back(fmt::format("10:00:{:02}", i / 10));
  EXPECT_EQ(
      refusal(file(coarse)),
      "FILE: 27 of 30 time stamps repeat the one before: they are coarser than the sampling; allowed: a time that increases from row to row; try: --columns time=none --dt SECONDS, the sampling interval (about 0.069 s on average)");
}

TEST_F(Stamps, ADateAndATimeOfDayAreJoinedAndWhatIsNotUsedIsSaid) {
  auto const record = read(
      "Datum;Uhrzeit;Weg [mm];Kraft [kN];Raumtemp\n02.05.2024;23:59:59,5;0;1;20\n03.05.2024;00:00:00,0;1;2;20\n"
      "03.05.2024;00:00:00,5;2;1;20\n");
  EXPECT_EQ(record.time_s, (std::vector{0.0, 0.5, 1.0}));
  EXPECT_TRUE(says(record.recognised, "time: column 2 'Uhrzeit' with the dates of column 1 'Datum', by its values"));
  EXPECT_TRUE(says(record.recognised, "not used: column 5 'Raumtemp'"));
}

// --- a part of a file ---

class Parts : public Files {
 protected:
  static inline Ellipse const loop{};
  std::string text_ = header_row + rows(loop, ";");
};

TEST_F(Parts, RowsAreCountedBelowTheHeader) {
  ReadOptions options;
  options.rows = parse_rows("101:400");
  auto const whole = read(text_), part = read(text_, options);
  ASSERT_EQ(part.size(), 300u);
  EXPECT_EQ(part.disp_mm.front(), whole.disp_mm[100]);
  EXPECT_EQ(part.time_s.front(), whole.time_s[100]);
  EXPECT_EQ(part.sha256, sha256(text_));
  EXPECT_TRUE(says(part.recognised, "rows 101 to 400 of 601 are read (--rows 101:400)"));
  options.rows = parse_rows("101:");
  EXPECT_EQ(read(text_, options).size(), 501u);
  options.rows = parse_rows(":50");
  EXPECT_EQ(read(text_, options).size(), 50u);
  options.rows = parse_rows("101:602");
  EXPECT_EQ(refusal(text_, options), "--rows: '101:602', but there are 601 rows; allowed: 1 to 601");
  for (auto const* bad : {"", ":", "0:3", "5:4", "3", "a:b", "1:2:3", "-1:3"})
    EXPECT_THROW(parse_rows(bad), Error) << bad;
}

TEST_F(Parts, RowsOfOtherFormatsAreTheirElements) {
  ReadOptions options;
  options.rows = parse_rows("2:4");
  auto const part = read(R"({"Disp [mm]": [0, 1, 2, 1, null], "Force [kN]": [9, 1, 2, 3, 1]})", options);
  EXPECT_EQ(part.disp_mm, (std::vector{1.0, 2.0, 1.0}));
  EXPECT_TRUE(says(part.recognised, "rows 2 to 4 of 5 are read (--rows 2:4)"));
}

TEST_F(Parts, WhatStandsOutsideTheRowsIsNotLookedAt) {
  auto const broken = text_ + "6.02;1e37;1\n6.03;NaN;x\nend\n";
  EXPECT_FALSE(refusal(broken).empty());
  ReadOptions options;
  options.rows = parse_rows("1:601");
  EXPECT_EQ(read(broken, options).size(), 601u);
}

TEST_F(Parts, TimeIsThatOfTheFile) {
  ReadOptions options;
  options.from_s = 1.0;
  options.to_s = 4.0;
  auto const part = read(text_, options);
  EXPECT_EQ(part.size(), 301u);
  EXPECT_DOUBLE_EQ(part.time_s.front(), 1.0);
  EXPECT_DOUBLE_EQ(part.time_s.back(), 4.0);
  EXPECT_TRUE(says(part.recognised, "samples 101 to 401 of 601 are read (--from 1 --to 4)"));
  options.columns = parse_columns("time=none");
  EXPECT_EQ(
      refusal(text_, options),
      "FILE: --from 1 --to 4 is given, but no time is read; allowed: a time column, or --dt SECONDS; try: --rows A:B");
  options.dt_s = 0.01;
  EXPECT_EQ(read(text_, options).disp_mm, part.disp_mm);
  options.rows = parse_rows("51:");  // a row has the same time, whichever rows are read
  EXPECT_EQ(read(text_, options).disp_mm, part.disp_mm);
  options.from_s = 7.0;
  options.to_s.reset();
  EXPECT_EQ(refusal(text_, options), "FILE: no sample lies within --from 7; allowed: times of the file, 0.5 to 6 s");
}

TEST_F(Parts, TextBelowTheRowsIsLeftOutOnRequest) {
  std::string const footer = "\nMax;100;95\nMin;-100;-95\n\nTested by A. Smith\n----\n";
  EXPECT_EQ(
      refusal(text_ + footer),
      "FILE:604: text below the rows of numbers, lines 604 to 608: 'Max;100;95'; allowed: rows of numbers to the end of the file; try: --footer skip, which leaves it out and the file as it is");
  ReadOptions options;
  options.skip_footer = true;
  auto const record = read(text_ + footer, options);
  EXPECT_EQ(record.disp_mm, read(text_).disp_mm);
  EXPECT_EQ(record.sha256, sha256(text_ + footer));
  EXPECT_TRUE(says(record.recognised,
                   "below the rows, lines 604 to 608 are text, 'Max;100;95' and so on, and left out (--footer skip)"));
  // An incomplete row of numbers is an error, not text below the rows.
  EXPECT_EQ(
      refusal(text_ + "6.01;3.1\n", options),
      "FILE:603: 2 columns: '6.01;3.1'; allowed: 3 columns, as in most rows; try: --rows 1:601, the rows before it");
}

// The column Point is not read, so the values below the rows look like another sample.
TEST_F(Parts, StatisticsBelowTheRowsAreNoSample) {
  std::string table = "Point;Time [s];Displacement [mm];Force [kN]\n";
  for (int i = 0; i < 40; ++i) table += fmt::format("{};{};{};{}\n", i, 0.1 * i, i % 7, i % 5);
  for (auto const* label : {"Mean", "Max:", "Std. Dev."})
    EXPECT_TRUE(refusal(table + label + ";4.2;3;2\n").starts_with("FILE:42: text below the rows of numbers")) << label;
}

TEST_F(Parts, DigitsAreGroupedAsTheUserSays) {
  auto const read_with = [&](std::string_view rows, char mark) {
    auto options = with("disp=1,force=2", "disp=mm,force=N");
    options.thousands = mark;
    return read(rows, options).force_kN;
  };
  std::vector<double> const expected{1.2345, 0.5, -1234.5675};
  auto const expect = [&](std::string_view rows, char mark) {
    auto const found = read_with(rows, mark);
    ASSERT_EQ(found.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << rows;
  };
  expect("1.5;1,234.5\n2.5;500\n1.5;-1,234,567.5\n", ',');
  expect("1,5;1.234,5\n2,5;500\n1,5;-1.234.567,5\n", '.');
  expect("1.5;1'234.5\n2.5;500\n1.5;-1'234'567.5\n", '\'');
  expect("1,5;1 234,5\n2,5;500\n1,5;-1 234 567,5\n", ' ');
  expect(
      "1,5;1\xC2\xA0"
      "234,5\n2,5;500\n1,5;-1\xE2\x80\xAF"
      "234\xE2\x80\xAF"
      "567,5\n",
      ' ');
  // A mark of thousands also works for a displacement history (a file with one column).
  ReadOptions one;
  one.dt_s = 0.1;
  one.thousands = ',';
  EXPECT_EQ(read_motion(write("Displacement [mm]\n1,000.5\n2,000.25\n-1,500\n"), one).disp_mm,
            (std::vector{1000.5, 2000.25, -1500.0}));
  // The user has stated that the comma marks thousands. But every number with a comma in this file could also be a
  // decimal number, and isolaw reads it as a decimal number.
  EXPECT_EQ(read_with("1;1,234\n2;2,345\n3;3,456\n", ','), (std::vector{1.234, 2.345, 3.456}));
}

// --- the channels in two files ---

class TwoFiles : public Files {
 protected:
  static inline Ellipse const loop{};
  // Returns a file with one channel: every `step`-th sample from sample `first` on, with `shift_s` added to the times.
  static std::string channel(bool of_force, double shift_s = 0.0, int first = 0, int step = 1, bool timed = true) {
    std::string text = fmt::format("{}{}\n", timed ? "Time [s];" : "", of_force ? "Force [kN]" : "Disp [mm]");
    for (int i = first; i < loop.size(); i += step)
      text += fmt::format("{}{:.6f}\n", timed ? fmt::format("{:.4f};", 0.01 * i + shift_s) : "",
                          of_force ? loop.force(i) : loop.disp(i));
    return text;
  }
  TestRecord joined(std::string const& main, std::string const& more, ReadOptions options = {}) {
    auto const other = write(more, "force.csv");
    options.columns[Channel::force] = other.generic_string() + ":Force";
    return read_record(write(main, "disp.csv"), options);
  }
};

TEST_F(TwoFiles, OfAsManyRowsAreJoinedRowByRow) {
  for (bool const timed : {true, false}) {
    auto const record = joined(channel(false), channel(true, 0.0, 0, 1, timed));
    ASSERT_EQ(record.size(), 601u);
    EXPECT_EQ(record.time_s.size(), 601u);
    for (int i = 0; i < loop.size(); ++i)
      EXPECT_NEAR(record.force_kN[static_cast<std::size_t>(i)], loop.force(i), 1e-6);
    EXPECT_TRUE(says(record.recognised,
                     timed ? "row by row, at the same times (--columns force=" : "row by row (--columns force="));
    EXPECT_TRUE(says(record.recognised, sha256(channel(false))));  // the record states the hash of each file
    EXPECT_TRUE(says(record.recognised, sha256(channel(true, 0.0, 0, 1, timed))));
  }
  try {
    joined(channel(false), channel(true, 0.0, 10, 1, false));
    FAIL();
  } catch (Error const& error) {
    EXPECT_NE(std::string(error.what()).find("force.csv: 591 rows, 601 in"), std::string::npos) << error.what();
  }
}

TEST_F(TwoFiles, OfOtherTimesAreJoinedByTime) {
  auto const record = joined(channel(false), channel(true, 0.0, 100, 2));
  ASSERT_EQ(record.size(), 501u);
  EXPECT_DOUBLE_EQ(record.time_s.front(), 1.0);
  for (std::size_t i = 0; i < record.size(); ++i)
    EXPECT_NEAR(record.force_kN[i], loop.force(static_cast<int>(i) + 100),
                0.0385);  // linear interpolation over 0.02 s misses a sine of 78 kN by w^2 dt^2 / 8
  EXPECT_TRUE(says(record.recognised, "501 of 601 samples lie in the time of both"));
  EXPECT_TRUE(says(record.warnings, "only 501 of 601 samples are used"));
}

TEST_F(TwoFiles, TakeTheSameRowsOrTimes) {
  ReadOptions options;
  options.rows = parse_rows("101:500");
  auto const record = joined(channel(false), channel(true, 0.0, 0, 1, false), options);
  ASSERT_EQ(record.size(), 400u);
  EXPECT_NEAR(record.force_kN.front(), loop.force(100), 1e-6);
  ReadOptions span;
  span.from_s = 1.0;
  span.to_s = 5.0;
  EXPECT_EQ(joined(channel(false), channel(true), span).size(), 401u);
}

// Returns the first line of an error message, without the folder.
std::string first_line(Error const& error) {
  std::string text = error.what();
  text.resize(std::min(text.find('\n'), text.size()));
  auto const name = text.find(".csv");
  auto const slash = text.rfind('/', name);
  return slash == std::string::npos ? text : text.substr(slash + 1);
}

TEST_F(TwoFiles, WhatLiesOutsideTheRowsOrTheTimeOfEitherDoesNotMatter) {
  auto const spoilt = [](std::string text, int row, std::string_view with) {
    std::size_t at = 0;
    for (int i = 0; i < row; ++i) at = text.find('\n', at) + 1;
    auto const cell = text.find(';', at) + 1;
    return text.replace(cell, text.find('\n', cell) - cell, with);
  };
  auto const refused = [&](std::string const& main, std::string const& more, ReadOptions const& options = {}) {
    try {
      joined(main, more, options);
    } catch (Error const& error) {
      return first_line(error);
    }
    return std::string();
  };
  ReadOptions rows, to;
  rows.rows = parse_rows("1:400");
  to.to_s = 4.0;
  EXPECT_TRUE(refused(channel(false), spoilt(channel(true), 501, "NaN")).starts_with("force.csv:502: 'NaN'"));
  EXPECT_EQ(joined(channel(false), spoilt(channel(true), 501, "NaN"), rows).size(), 400u);
  EXPECT_TRUE(refused(channel(false), spoilt(channel(true), 501, "9.9e37")).starts_with("force.csv:502: "));
  EXPECT_EQ(joined(channel(false), spoilt(channel(true), 501, "9.9e37"), to).size(), 401u);
  EXPECT_EQ(joined(spoilt(channel(false), 501, "9.9e37"), channel(true), to).size(), 401u);
  EXPECT_EQ(joined(channel(false), spoilt(channel(true), 501, "9.9e37"), rows).size(), 400u);
}

TEST_F(TwoFiles, AHoleOutsideTheTimeAskedForDoesNotMatter) {
  auto text = channel(true);
  auto const cut = [&](double from, double to) {
    auto const begin = text.find(fmt::format("\n{:.4f};", from)), end = text.find(fmt::format("\n{:.4f};", to));
    text.erase(begin, end - begin);
  };
  cut(1.0, 2.0);
  EXPECT_THROW(joined(channel(false), text), Error);
  ReadOptions beyond;
  beyond.from_s = 2.0;
  EXPECT_EQ(joined(channel(false), text, beyond).size(), 401u);
  ReadOptions before;
  before.to_s = 0.9;
  ReadOptions across;
  across.from_s = 0.5;
  EXPECT_THROW(joined(channel(false), text, across), Error);
  EXPECT_EQ(joined(channel(false), text, before).size(), 91u);
}

TEST_F(TwoFiles, WithTimeStampsAreCutByTheStampsOfTheFirst) {
  auto const stamped = [](bool of_force, int first) {
    std::string text = of_force ? "Time;Force [kN]\n" : "Time;Disp [mm]\n";
    for (int i = first; i < loop.size(); ++i)
      text += fmt::format("10:00:{:06.3f};{:.6f}\n", 10.0 + 0.01 * i, of_force ? loop.force(i) : loop.disp(i));
    return text;
  };
  ReadOptions span;
  span.from_s = 2.0;
  span.to_s = 5.0;
  auto const record = joined(stamped(false, 0), stamped(true, 100), span);
  ASSERT_EQ(record.size(), 301u);
  for (std::size_t i = 0; i < record.size(); ++i)
    EXPECT_NEAR(record.force_kN[i], loop.force(static_cast<int>(i) + 200), 1e-4);
}

TEST_F(TwoFiles, UnitsOfTimeAreGivenToBoth) {
  auto bare = channel(true);
  bare.replace(0, bare.find(';'), "Time");
  EXPECT_THROW(joined(channel(false), bare), Error);
  ReadOptions options;
  options.units[Channel::time] = "s";
  EXPECT_EQ(joined(channel(false), bare, options).size(), 601u);
  auto own = channel(false);
  own.replace(0, own.find(';'), "Time");
  EXPECT_EQ(joined(own, bare, options).size(), 601u);
  // The file of the force states ms as its unit of time, so isolaw does not use the unit given for the other file.
  std::string milliseconds = "Time [ms];Force [kN]\n";
  for (int i = 0; i < loop.size(); ++i) milliseconds += fmt::format("{};{:.6f}\n", 10 * i, loop.force(i));
  EXPECT_EQ(joined(own, milliseconds, options).size(), 601u);
}

TEST_F(TwoFiles, TheTestIsChosenInTheFileThatHasSeveral) {
  auto const two = channel(true) + channel(true);
  EXPECT_THROW(joined(channel(false), two), Error);
  ReadOptions options;
  options.test = "2";
  auto const record = joined(channel(false), two, options);
  EXPECT_EQ(record.size(), 601u);
  EXPECT_EQ(record.layout.test, "2");
  EXPECT_THROW(joined(channel(false), channel(true), options), Error) << "which neither file has";
}

TEST_F(TwoFiles, OneColumnIsEnough) {
  ReadOptions options;
  options.dt_s = 0.01;
  auto const motion = read_motion(write("Displacement [mm]\n0\n1.5\n2.5\n"), options);
  EXPECT_EQ(motion.disp_mm, (std::vector{0.0, 1.5, 2.5}));
  EXPECT_EQ(motion.time_s, (std::vector{0.0, 0.01, 0.02}));
  EXPECT_EQ(joined(channel(false, 0.0, 0, 1, false), channel(true, 0.0, 0, 1, false)).size(), 601u);
}

}  // namespace
}  // namespace isolaw::data::testing
