// Tests the reading of records in JSON: the shapes of a table, names and units, and what is refused.
#include <fmt/ranges.h>

#include "data_writers.hpp"

namespace isolaw::data::testing {
namespace {

using Json = Files;

std::string const three_rows = "[0, 0.0, 1.5], [1, 2.5, -2.0e0], [2, 5, 3]";
std::vector const disp{0.0, 2.5, 5.0};
std::vector const force{1.5, -2.0, 3.0};
auto const units = [] { return with("", "time=s,disp=mm,force=kN"); }();

void expect_three_rows(TestRecord const& record) {
  EXPECT_EQ(record.time_s, (std::vector{0.0, 1.0, 2.0}));
  EXPECT_EQ(record.disp_mm, disp);
  EXPECT_EQ(record.force_kN, force);
}

TEST_F(Json, AnObjectOfArrays) {
  std::string const arrays = R"("time": [0, 1, 2], "disp": [0.0, 2.5, 5], "force": [1.5, -2.0, 3])";
  auto const record = read("{" + arrays + "}", units);
  expect_three_rows(record);
  EXPECT_TRUE(says(record.recognised, "JSON: arrays that are columns"));
  EXPECT_TRUE(says(record.recognised, "disp: column 2 'disp', by its name; unit mm as asked for"));
  EXPECT_TRUE(says(record.recognised, "3 samples, elements 1 to 3"));
  expect_three_rows(read("\xEF\xBB\xBF {" + arrays + "}", units));
  expect_three_rows(read("{\"device\": \"D07\", \"test\": {\"n\": 3, " + arrays + "}, \"list\": [1]}", units));
}

TEST_F(Json, AnArrayOfObjects) {
  std::string const objects =
      R"([{"time": 0, "disp": 0.0, "force": 1.5}, {"disp": 2.5, "force": -2.0, "time": 1}, {"time": 2, "force": 3, "disp": 5}])";
  expect_three_rows(read(objects, units));
  expect_three_rows(read("{\"data\": " + objects + ", \"n\": 3}", units));
}

TEST_F(Json, AnArrayOfRows) {
  auto told = units;
  told.columns = parse_columns("time=1,disp=2,force=3");
  expect_three_rows(read("[" + three_rows + "]", told));
  auto const record = read("{\"data\": [" + three_rows + "], \"dt\": 1}", told);
  expect_three_rows(record);
  EXPECT_TRUE(says(record.recognised, "JSON: an array whose elements are rows, under 'data'"));
  EXPECT_EQ(record.layout.columns.at(Channel::disp), "2");
  EXPECT_EQ(
      refusal("[" + three_rows + "]"),
      "FILE: no row names the 3 columns, so isolaw cannot know which is the displacement and which the force; allowed: column numbers 1 to 3; try: --columns time=1,disp=2,force=3 --units time=s,disp=mm,force=kN, with your numbers and units");
}

TEST_F(Json, NamesAndUnitsBesideTheRows) {
  expect_three_rows(read("[[\"t\", \"x\", \"F\"], [\"s\", \"mm\", \"kN\"], " + three_rows + "]"));
  expect_three_rows(read("[[\"time_s\", \"disp_mm\", \"force_kN\"], " + three_rows + "]"));
  expect_three_rows(
      read("{\"columns\": [\"time\", \"disp\", \"force\"], \"units\": [\"s\", \"mm\", \"kN\"], \"data\": [" +
           three_rows + "]}"));
  std::string const arrays = R"("time": [0, 1, 2], "disp": [0.0, 0.25, 0.5], "force": [1500, -2000, 3000])";
  expect_three_rows(read("{" + arrays + R"(, "units": {"time": "s", "disp": "cm", "force": "N"}})"));
  auto const record = read("{" + arrays + R"(, "time unit": "s", "disp_units": "cm", "ForceUnit": "N"})");
  expect_three_rows(record);
  EXPECT_TRUE(says(record.recognised, "disp: column 2 'disp', by its name; unit cm as the file states beside it"));
}

TEST_F(Json, AUnitIsNeverAssumed) {
  EXPECT_EQ(
      refusal(R"({"disp": [0, 1, 2], "force": [1, 2, 1]})"),
      "FILE: column 1 'disp' (disp) has no unit; allowed: mm, cm, m, in, ft, dm, um; try: --units disp=mm, with the column's unit\n"
      "FILE: column 2 'force' (force) has no unit; allowed: kN, N, MN, tonf, kgf, daN, kip, lbf, Mp; try: --units force=kN, with the column's unit");
  EXPECT_EQ(
      refusal(R"({"disp_mm": [0, 1, 2], "force": [1, 2, 1], "units": {"force": "furlong"}})"),
      "FILE: unknown unit 'furlong' of column 2 'force' (force); allowed: kN, N, MN, tonf, kgf, daN, kip, lbf, Mp; try: --units force=kN --channel-scale force=FACTOR, if a value of 1 is FACTOR kN");
}

// isolaw cannot use a list of units without names of columns, but its advice must name these units.
TEST_F(Json, UnitsInAListAreProposed) {
  std::string const test = R"("test": {"disp": [0, 1, 2], "force": [1, 2, 1]})";
  for (auto const* source :
       {R"("source": [{"title": "x", "units": ["inches", "lbf"]}], )", R"("units": ["inches", "lbf"], )"}) {
    auto const said = refusal("{" + std::string(source) + test + "}");
    EXPECT_NE(said.find("--units disp=in, which the file states in a list of units"), std::string::npos) << said;
    EXPECT_NE(said.find("--units force=lbf"), std::string::npos) << said;
  }
}

TEST_F(Json, SeveralTablesAreChosenByTheirKey) {
  auto told = units;
  told.columns = parse_columns("time=1,disp=2,force=3");
  auto const text = "{\"first\": [" + three_rows + "], \"second\": [" + three_rows + ", [3, 1, 1]]}";
  EXPECT_EQ(
      refusal(text, told),
      "FILE: tables 'first', 'second' may each be the test; allowed: one of them; try: --sheet first, or isolaw init, which makes a device of each");
  told.sheet = "second";
  auto const record = read(text, told);
  EXPECT_EQ(record.size(), 4u);
  EXPECT_EQ(record.layout.sheet, "second");
  told.sheet = "1";
  expect_three_rows(read(text, told));
  told.sheet = "third";
  EXPECT_EQ(refusal(text, told),
            "FILE: no table 'third'; allowed: tables 'first', 'second'; try: --sheet NAME, or its number");
}

TEST_F(Json, AListOfTestsHoldsAsManyTests) {
  auto const one = [](std::string const& name, std::string const& force_of_row_2) {
    return R"({"name": ")" + name + R"(", "time": [0, 1, 2], "disp": [0.0, 2.5, 5], "force": [1.5, )" + force_of_row_2 +
           ", 3]}";
  };
  auto const list = "[" + one("A", "-2") + ", " + one("B", "-4") + "]";
  for (auto const& text : {list, R"({"lab": "X", "tests": )" + list + "}", R"({"lot": {"tests": )" + list + "}}"}) {
    auto told = units;
    told.test = "1";
    expect_three_rows(read(text, told));
    told.test = "2";
    auto const second = read(text, told);
    EXPECT_EQ(second.force_kN, (std::vector{1.5, -4.0, 3.0})) << text;
    EXPECT_TRUE(says(second.recognised, "2 tests in the file, test 2 is read"));
    EXPECT_EQ(second.layout.test, "2");
    told.test = "all";
    EXPECT_EQ(read(text, told).size(), 6u);
  }
  auto const text = R"({"tests": )" + list + "}";
  EXPECT_EQ(
      refusal(text, units),
      "FILE: 2 tests in one file: tests(1) 'A', tests(2) 'B'; allowed: one of them, or all as one history; try: --test all, or --test 2, or isolaw init, which makes a device of each");
  auto told = units;
  told.test = "3";
  EXPECT_EQ(refusal(text, told), "FILE: no test 3; allowed: 1 to 2: tests(1) 'A', tests(2) 'B'; try: --test 1");
  told.test = std::nullopt;
  auto const listed = list_tests(write(text, "list.json"), told);
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed[1].test, "2");
  EXPECT_EQ(listed[1].sheet, std::nullopt);
  expect_three_rows(read("[" + one("A", "-2") + "]", told));  // a list of one test needs no option --test
}

TEST_F(Json, TestsOfAListSpeakForThemselvesAlone) {
  auto const one = [](std::string const& disp_unit, std::string const& more) {
    return R"({"units": {"time": "s", "disp": ")" + disp_unit + R"(", "force": "kN"}, "name": "T", )" + more + "}";
  };
  std::string const arrays = R"("time": [0, 1, 2], "disp": [0.0, 2.5, 5], "force": [1.5, -2.0, 3])";
  ReadOptions second;
  second.test = "2";
  EXPECT_EQ(read("[" + one("mm", arrays) + "," + one("cm", arrays) + "]", second).disp_mm,
            (std::vector{0.0, 25.0, 50.0}));
  auto const rows = R"("columns": ["time", "disp", "force"], "data": [)" + three_rows + "]";
  expect_three_rows(read(R"({"tests": [)" + one("cm", rows) + "," + one("mm", rows) + "]}", second));
  auto const record = read(R"({"tests": [)" + one("mm", arrays) + R"(, {"name": "broken off", "disp": [0, 1, 2]}, )" +
                               one("mm", arrays) + "]}",
                           second);
  expect_three_rows(record);
  EXPECT_TRUE(says(record.recognised, "element 'tests(2)' of the list holds no table of numbers, is passed over"));
  EXPECT_EQ(
      refusal("[" + one("mm", arrays) + R"(, {"a": 1, "b": 2}, {"a": 1, "b": 3}, {"a": 1, "b": 2}])", second),
      "FILE: a list of rows of numbers and of tests; allowed: elements of one kind; try: a list of the tests alone");
}

// A row may hold short arrays. A list of 2000 such rows is one table, not 2000 tests.
TEST_F(Json, RowsMayHoldShortArrays) {
  std::string rows = "[";
  for (int i = 0; i < 2000; ++i)
    rows += fmt::format(R"({}{{"time": {}, "disp": {}, "tags": ["a"], "xy": [1, 2], "force": {}}})", i == 0 ? "" : ",",
                        i, i % 7, i % 3);
  EXPECT_EQ(read(rows + "]", units).size(), 2000u);
  std::string tests = "[";
  for (int i = 0; i < 1001; ++i) tests += fmt::format(R"({}{{"d": [1, 2, 3], "f": [1, 2, 3]}})", i == 0 ? "" : ",");
  EXPECT_NE(refusal(tests + "]").find("more than 1000 tests"), std::string::npos);
}

TEST_F(Json, TimeStampsAreReadAsInText) {
  auto const record =
      read(R"({"t": ["10:00:00.1", "10:00:00.2", "10:00:00.3"], "disp_mm": [0, 1, 2], "force_kN": [1, 2, 3]})",
           with("time=t"));
  ASSERT_EQ(record.time_s.size(), 3u);
  EXPECT_NEAR(record.time_s[2], 0.2, 1e-9);
  EXPECT_TRUE(says(record.recognised, "time: column 1 't', as asked for; time stamps, read in s"));
  auto const rows = R"([{"when": "31.05.2024 23:59:59.9", "disp_mm": 0, "force_kN": 1},
    {"when": "01.06.2024 00:00:00.0", "disp_mm": 1, "force_kN": 2}, {"when": "01.06.2024 00:00:00.1", "disp_mm": 2, "force_kN": 3}])";
  EXPECT_NEAR(read(rows).time_s[2], 0.2, 1e-6);
  // Dates and times of day stand in two columns. isolaw joins them, here for a part of the rows.
  auto options = with("time=clock");
  options.rows = RowRange{.first = 2, .last = 4};
  auto const joined = read(
      R"({"day": ["2024-05-02", "2024-05-02", "2024-05-03", "2024-05-03"],
          "clock": ["23:59:59.8", "23:59:59.9", "00:00:00.0", "00:00:00.1"], "disp_mm": [0, 1, 2, 1], "force_kN": [1, 2, 3, 2]})",
      options);
  ASSERT_EQ(joined.time_s.size(), 3u);
  EXPECT_NEAR(joined.time_s[2], 0.2, 1e-6);
  EXPECT_NE(
      refusal(R"({"t": ["10:00:00.1", 0.2, "10:00:00.3"], "disp_mm": [0, 1, 2], "force_kN": [1, 2, 3]})",
              with("time=t", "time=s"))
          .find("FILE:1: '10:00:00.1' in column 1 't' is a time stamp; allowed: numbers, or time stamps of one kind in "
                "the whole column; try: --columns time=none --dt SECONDS"),
      std::string::npos);
  EXPECT_NE(
      refusal(R"({"t": ["03/04/24 23:59:59.9", "04/04/24 00:00:00.0", "05/04/24 00:00:00.1"], "disp_mm": [0, 1, 2],
                       "force_kN": [1, 2, 3]})",
              with("time=t"))
          .find("--date-order dmy"),
      std::string::npos);
}

// An option for text files has no effect on JSON. It is refused, so that no user believes that it was applied.
TEST_F(Json, OptionsOfTextAreRefused) {
  auto const text = R"({"disp_mm": [0, 1, 2, 1], "force_kN": [1, 2, 3, 2]})";
  ReadOptions options;
  options.thousands = ' ';
  options.skip_footer = true;
  auto const rest =
      ": FILE holds numbers, not their text; allowed: delimited text; try: leave it out, or give it to other files alone";
  EXPECT_EQ(refusal(text, options), fmt::format("--thousands blank{0}\n--footer skip{0}", rest));
}

TEST_F(Json, WhatIsNoNumberIsAtItsRow) {
  EXPECT_EQ(
      refusal(R"({"disp_mm": [0, null, 2, "3"], "force_kN": [1, 2, 3, 4]})"),
      "FILE:2: 'null' in column 1 'disp_mm' is not a number; allowed: a number; try: export the record again with a number in every cell, or delete these 2 rows from a copy\n"
      "FILE:4: '3' in column 1 'disp_mm' is not a number; allowed: a number; try: export the record again with a number in every cell, or delete these 2 rows from a copy");
  EXPECT_EQ(
      refusal(R"({"a": [[0, 1], [1, 2], [2], [3, 4]]})", with("disp=1,force=2", "disp=mm,force=kN")),
      "FILE:a:3: 1 values, not 2 as in the first row; allowed: one number for each column in every row; try: correct the row, or export the test again");
  EXPECT_EQ(
      refusal(R"([{"disp_mm": 0, "force_kN": 1}, {"disp_mm": 1}, {"disp_mm": 2, "force_kN": 2}])"),
      "FILE:2: 'a key that is not there' in column 2 'force_kN' is not a number; allowed: a number; try: export the record again");
  EXPECT_EQ(
      refusal(R"({"disp_mm": [0, 1, 2], "force_kN": [1, 2, 1, 4]})"),
      "FILE: the channels differ in length: column 1 'disp_mm' has 3 values, column 2 'force_kN' has 4 values; allowed: columns of equal length; try: --columns time=...,disp=...,force=... with columns that belong together");
}

TEST_F(Json, ChecksOfTheValuesAreThoseOfText) {
  EXPECT_EQ(
      refusal(R"({"time_s": [0, 1, 1], "disp_mm": [0, 1, 2], "force_kN": [1, 1, 1]})"),
      "FILE:3: time 1 s is repeated; allowed: time that increases from row to row; try: --rows A:B for one test of several, or leave time out with --columns time=none and give --dt\n"
      "FILE: force is constant: column 3 'force_kN' holds 1 kN in all 3 samples; allowed: a channel that moves; try: --columns force=NUMBER with the column that was measured");
}

TEST_F(Json, WhatIsNoTable) {
  auto const allowed = "; allowed: an object of arrays, an array of objects or an array of rows";
  EXPECT_EQ(
      refusal("{\"disp\": [1, 2,\n 3"),
      std::string("FILE:2: is no JSON: syntax error while parsing array - unexpected end of input; expected ']'") +
          allowed + "; try: export the channels as CSV");
  EXPECT_EQ(refusal(R"({"a": 1, "b": "text", "c": [1, 2, 3], "d": {"e": {"f": [[1, 2]]}}})"),
            std::string("FILE: JSON without a table of numbers") + allowed +
                ", at the top or under one key; try: {\"time\": [...], \"disp\": [...], \"force\": [...]}");
  EXPECT_EQ(refusal(R"({"disp_mm": [1e999, 2, 3], "force_kN": [1, 2, 3]})"),
            std::string("FILE:1: is no JSON: number overflow parsing '1e999'") + allowed +
                "; try: export the channels as CSV");
}

TEST_F(Json, HostileTexts) {
  auto const says_of = [&](std::string const& text, std::string_view part) {
    EXPECT_NE(refusal(text).find(part), std::string::npos) << refusal(text).substr(0, 300);
  };
  says_of(std::string(10'000'000, '['), "nested more than 64 deep");
  std::string keys;
  for (int i = 0; i < 1'000'000; ++i) keys += "{\"a\":";
  says_of(keys, "nested more than 64 deep");
  std::string sparse = "[";  // a million rows with one key each, which would make a table of 900 columns
  for (int i = 0; i < 1'000'000; ++i) sparse += fmt::format("{}{{\"{}\":1}}", i == 0 ? "" : ",", i % 900);
  says_of(sparse + "]", "far larger than the file");
  std::string wide = "[[1";
  for (int i = 0; i < 1001; ++i) wide += ",1";
  says_of(wide + "],[1]]", "a row of more than 1000 values");
  std::string arrays = "{";
  for (int i = 0; i < 1001; ++i) arrays += fmt::format("\"{}\":[1],", i);
  says_of(arrays + "\"x\":[1]}", "more than 1000 arrays");
}

// A line of text in brackets is not JSON. The file below such a line must be read as delimited text.
TEST_F(Json, IsToldFromText) {
  std::string const data = "Time [s];Disp [mm];Force [kN]\n0;0;1\n1;1;2\n2;2;1\n";
  for (auto const* line : {"[Header]\n", "[ test D07 ]\n", "{D07}\n", "[]\n"})
    EXPECT_EQ(read(line + data).size(), 3u) << line;
}

}  // namespace
}  // namespace isolaw::data::testing
