// Tests the reading of text files in every dialect: delimiter and decimal sign, line ends, encodings, text above the
// data.
#include "data_fixture.hpp"
#include "isolaw/base/hash.hpp"

namespace isolaw::data::testing {
namespace {

using Read = Files;
using Values = std::vector<double>;

// --- every dialect gives the same record ---

struct Style {
  std::string delimiter;
  char decimal;
  std::string end = "\n";
  std::string before = {};  // text before the header
};

class Dialects : public Files, public ::testing::WithParamInterface<Style> {};

TEST_P(Dialects, GivesTheSameRecord) {
  auto const& style = GetParam();
  Ellipse const loop;
  auto const header = fmt::format("Time [s]{0}Displacement [mm]{0}Force [kN]", style.delimiter);
  auto const record = read(style.before + header + style.end + rows(loop, style.delimiter, style.decimal, style.end));
  ASSERT_EQ(record.size(), 601u);
  ASSERT_EQ(record.time_s.size(), 601u);
  for (int i = 0; i < loop.size(); ++i) {
    auto const k = static_cast<std::size_t>(i);
    EXPECT_NEAR(record.time_s[k], 0.01 * i, 1e-12);
    EXPECT_NEAR(record.disp_mm[k], loop.disp(i), 0.5001e-4);
    EXPECT_NEAR(record.force_kN[k], loop.force(i), 0.5001e-4);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Dialects,
                         ::testing::Values(Style{",", '.'}, Style{";", '.'}, Style{"\t", '.'}, Style{"  ", '.'},
                                           Style{";", ','}, Style{"\t", ','}, Style{" ; ", ','}, Style{", ", '.'},
                                           Style{" \t ", '.'}, Style{"   ", ','}, Style{";", ',', "\r\n"},
                                           Style{";", ',', "\r"}, Style{"\t", ',', "\r\n", "Specimen\tD07\r\n\r\n"},
                                           Style{",", '.', "\n", "\xEF\xBB\xBF"}));

// --- a comma is either a delimiter or a decimal sign ---

struct Trap {
  std::string text;
  Values disp;
  Values force;
};

class Traps : public Files, public ::testing::WithParamInterface<Trap> {};

TEST_P(Traps, AreReadAsMeant) {
  auto const record = read(GetParam().text, with("disp=1,force=2", "disp=mm,force=kN"));
  EXPECT_EQ(record.disp_mm, GetParam().disp);
  EXPECT_EQ(record.force_kN, GetParam().force);
}

Values const read_disp{1.5, 2.5, -3.25};
Values const read_force{2.0, 4.5, 1.0};

INSTANTIATE_TEST_SUITE_P(
    All, Traps,
    ::testing::Values(Trap{"1,5;2,0\n2,5;4,5\n-3,25;1,0\n", read_disp, read_force},
                      Trap{"1.5,2.0\n2.5,4.5\n-3.25,1.0\n", read_disp, read_force},
                      Trap{"1,5\t2,0\n2,5\t4,5\n-3,25\t1,0\n", read_disp, read_force},
                      Trap{"1,5 2,0\n2,5 4,5\n-3,25 1,0\n", read_disp, read_force},
                      Trap{"1.5 2.0\n2.5 4.5\n-3.25 1.0\n", read_disp, read_force},
                      Trap{"\"1,5\",\"2,0\"\n\"2,5\",\"4,5\"\n\"-3,25\",\"1,0\"\n", read_disp, read_force},
                      Trap{"\"1,5\";\"2,0\"\n\"2,5\";\"4,5\"\n\"-3,25\";\"1,0\"\n", read_disp, read_force},
                      // Some cells hold whole numbers, others decimals.
                      Trap{"1,5;2\n2,5;4,5\n-3,25;1\n", read_disp, read_force},
                      // Each row ends with a delimiter.
                      Trap{"1.5;2;\n2.5;4.5;\n-3.25;1;\n", read_disp, read_force},
                      Trap{"+1.5,2\r\n+25e-1,4.5\r\n-3.25,1E0\r\n", read_disp, read_force},
                      // Here point and comma are decimal signs, although three digits follow, as in thousands.
                      Trap{"1.234;5\n5.678;6\n9.123;4\n", {1.234, 5.678, 9.123}, {5, 6, 4}},
                      Trap{"1,234;5\n5,678;6\n9,123;4\n", {1.234, 5.678, 9.123}, {5, 6, 4}}));

TEST_F(Read, AnEmptyColumnBetweenTabsIsAColumn) {
  auto const record = read("1\t\t7\n2\t\t9\n3\t\t8\n", with("disp=1,force=3", "disp=mm,force=kN"));
  EXPECT_EQ(record.force_kN, (Values{7, 9, 8}));
}

// The encoding is recognised from the first bytes of the file, up to a line end. A cut elsewhere could split a
// character of two bytes.
TEST_F(Read, ShiftJisOfAnyLengthAndLineEnd) {
  for (std::string const end : {"\n", "\r\n", "\r"})
    for (std::size_t shift = 0; shift < 4; ++shift) {
      // The Japanese names mean time, displacement, horizontal load and remark.
      std::string text =
          std::string(shift, 'x') + end +
          "\x8E\x9E\x8A\xD4(s),\x95\xCF\x88\xCA(mm),\x90\x85\x95\xBD\x89\xD7\x8F\x64(kN),\x94\xF5\x8D\x6C" + end;
      std::string remark;
      for (int k = 0; k < 40; ++k) remark += "\x90\xB3\x8F\xED";
      for (int i = 0; i < 200; ++i) text += fmt::format("{},{},{},", i, i % 7, i % 5) + remark + end;
      auto const record = read(text);
      EXPECT_EQ(record.size(), 200u);
      EXPECT_TRUE(says(record.recognised, "read as Shift-JIS")) << shift;
    }
}

// A logger may skip samples while the device rests. The gap is then part of the test's time. If the clock jumps during
// motion, isolaw warns.
TEST_F(Read, ARestThatWasNotRecordedIsNoJumpOfTheClock) {
  for (bool const at_rest : {true, false}) {
    data::Values values;
    double time = 0.0;
    Ellipse const loop;
    for (int i = 0; i < loop.size(); ++i) {
      for (int k = 0; k < (at_rest && i == 200 ? 10 : 1); ++k) {
        time += i == (at_rest ? 200 : 210) && k == (at_rest ? 5 : 0) ? 100.0 : 0.01;
        values.time_s.push_back(time);
        values.disp_mm.push_back(loop.disp(i));
        values.force_kN.push_back(loop.force(i));
      }
    }
    EXPECT_EQ(says(record_of_values("values", values).warnings, "of that as motion"), !at_rest);
  }
}

TEST_F(Read, TextColumnsThatAreNotAskedForDoNotMatter) {
  auto const record = read(
      "Date;Disp [mm];Force [kN];State\n"
      "2024-05-02 10:00:00,25;1,5;2;OK\n2024-05-02 10:00:00,50;2,5;3;OK now\n"
      "2024-05-02 10:00:00,75;3,5;1;OK\n");
  EXPECT_EQ(record.disp_mm, (Values{1.5, 2.5, 3.5}));
  EXPECT_EQ(record.force_kN, (Values{2, 3, 1}));
}

// --- text above and between the rows ---

TEST_F(Read, MetadataNamesAndUnitsAboveTheData) {
  auto const record = read(
      "Specimen;D07\nDate: 2024-05-02\nLoad: 1632 kN\n\nTempo;Spostamento;Forza;Temperatura\n"
      "s;cm;N;\xC2\xB0"
      "C\n0;0;100;20\n1;1,5;200;20\n2;1;150;20\n");
  EXPECT_EQ(record.time_s, (Values{0, 1, 2}));
  EXPECT_EQ(record.disp_mm, (Values{0, 15, 10}));
  EXPECT_EQ(record.force_kN, (Values{0.1, 0.2, 0.15}));
  EXPECT_TRUE(says(record.recognised, "line 5 is the header, line 6 gives the units"));
  EXPECT_TRUE(says(record.recognised, "above the data, line 1, 2, 3 are passed over"));
  EXPECT_TRUE(says(record.recognised, "columns are separated by semicolons, decimals by a comma"));
  EXPECT_TRUE(says(record.recognised, "disp: column 2 'Spostamento', by its name; unit cm from line 6"));
  EXPECT_TRUE(says(record.recognised, "3 samples, lines 7 to 9"));
  EXPECT_TRUE(says(record.recognised, "sampling interval 1 s (1 Hz)"));
}

TEST_F(Read, MetadataWithAsManyCellsAsTheData) {
  auto const record = read("Specimen;D07\nLoad;1632\nDisp [mm];Force [kN]\n1;2\n2;3\n3;1\n");
  EXPECT_EQ(record.disp_mm, (Values{1, 2, 3}));
  EXPECT_TRUE(says(record.recognised, "line 3 is the header"));
}

TEST_F(Read, GroupLineAboveTheNames) {
  auto const record = read("Rig;Actuator;Cell\nTime;Displacement;Force\n[s];[mm];[kN]\n0;1;2\n1;2;3\n2;3;1\n");
  EXPECT_TRUE(says(record.recognised, "line 2 is the header, line 3 gives the units"));
  EXPECT_EQ(record.disp_mm, (Values{1, 2, 3}));
}

TEST_F(Read, UnknownNamesAreTheLastLineOfTheRightSizeAboveTheData) {
  auto const record = read("Rig;B\nCH1;CH2\n1;2\n2;3\n3;1\n", with("disp=CH2,force=CH1", "disp=mm,force=kN"));
  EXPECT_EQ(record.disp_mm, (Values{2, 3, 1}));
}

TEST_F(Read, ATitleThatNamesChannelsIsNoHeaderOfTheWrongSize) {
  auto const record = read("Force;Displacement;Time\nDisp [mm];Force [kN]\n1;2\n2;3\n3;1\n");
  EXPECT_EQ(record.disp_mm, (Values{1, 2, 3}));
}

TEST_F(Read, CommentsAndBlankLinesArePassedOver) {
  auto const record = read("# lab 7\n% more\nDisp [mm],Force [kN]\n1,2\n\n# gap\n2,3\n,\n3,1\n");
  EXPECT_EQ(record.disp_mm, (Values{1, 2, 3}));
  EXPECT_TRUE(says(record.recognised, "1 comment line among the rows is passed over"));
}

TEST_F(Read, NamesInACommentServeWhereThereAreNoOthers) {
  auto const record = read("# time[s] disp[mm] force[kN]\n0 1.5 2\n1 2.5 3\n2 3.5 1\n");
  EXPECT_EQ(record.time_s, (Values{0, 1, 2}));
  EXPECT_EQ(record.disp_mm, (Values{1.5, 2.5, 3.5}));
}

TEST_F(Read, NamesWithBlanksInAFileSeparatedByBlanks) {
  EXPECT_EQ(read("Displacement [mm] Force [kN]\n1.5 2\n2.5 3\n3.5 1\n").disp_mm, (Values{1.5, 2.5, 3.5}));
  EXPECT_EQ(read("Shear displacement mm   Shear force kN\n1.5   2\n2.5   3\n3.5   1\n").disp_mm,
            (Values{1.5, 2.5, 3.5}));
}

TEST_F(Read, Windows1252Names) {
  auto const record = read(
      "Spostamento [mm] \xB1;Forza [kN];T [\xB0"
      "C]\n1,5;2;20\n2,5;3;20\n3,5;1;20\n");
  EXPECT_EQ(record.disp_mm, (Values{1.5, 2.5, 3.5}));
  EXPECT_TRUE(says(record.recognised, "read as Windows-1252"));
  EXPECT_TRUE(says(record.recognised, "column 1 'Spostamento [mm] \xC2\xB1'"));
  EXPECT_FALSE(record.has_time());
}

TEST_F(Read, ByteOrderMarkIsNoPartOfTheFirstName) {
  auto const record = read(
      "\xEF\xBB\xBF"
      "Disp [mm];Force [kN]\n1;2\n2;3\n3;1\n");
  EXPECT_EQ(record.layout.columns.at(Channel::disp), "Disp [mm]");
}

// --- the time channel and the contents of a record ---

TEST_F(Read, WithoutTimeSaysWhatIsMissing) {
  auto const record = read("Disp [mm];Force [kN]\n1;2\n2;3\n3;1\n");
  EXPECT_FALSE(record.has_time());
  EXPECT_TRUE(says(record.recognised, "no time column: rate-dependent laws need --dt SECONDS"));
}

TEST_F(Read, IntervalGivesTime) {
  ReadOptions options;
  options.dt_s = 0.25;
  auto const record = read("Disp [mm];Force [kN]\n1;2\n2;3\n3;1\n", options);
  EXPECT_EQ(record.time_s, (Values{0, 0.25, 0.5}));
  EXPECT_EQ(record.layout.dt_s, 0.25);
  EXPECT_TRUE(says(record.recognised, "sampling interval 0.25 s (4 Hz), as asked for"));
}

TEST_F(Read, FlippedForceIsNegatedAndSaid) {
  ReadOptions options;
  options.flip_force = true;
  auto const record = read("Disp [mm];Force [kN]\n1;2\n2;3\n3;1\n", options);
  EXPECT_EQ(record.force_kN, (Values{-2, -3, -1}));
  EXPECT_TRUE(record.layout.flip_force);
  EXPECT_TRUE(says(record.recognised, "the force is multiplied by -1"));
}

TEST_F(Read, KeepsThePathAsGivenAndTheDigestOfTheBytes) {
  std::string const bytes = "Disp [mm];Force [kN]\r\n1;2\r\n2;3\r\n3;1\r\n";
  auto const file = write(bytes);
  auto const record = read_record(file);
  EXPECT_EQ(record.file, file.generic_string());
  EXPECT_EQ(record.sha256, sha256(bytes));
}

TEST_F(Read, LayoutReadsTheFileTheSameWay) {
  std::string const bytes = "t;Disp [mm];Disp [mm];Force [N];N [kN]\ns;;;;\n0;1;9;2;5\n1;2;9;3;5\n2;3;9;1;5\n";
  auto const record = read(bytes, with("disp=2"));
  EXPECT_EQ(record.layout.columns, (std::map<Channel, std::string>{{Channel::time, "t"},
                                                                   // Both columns are "Disp [mm]".
                                                                   {Channel::disp, "2"},
                                                                   {Channel::force, "Force [N]"},
                                                                   {Channel::load, "N [kN]"}}));
  EXPECT_EQ(record.layout.units,
            (std::map<Channel, std::string>{
                {Channel::time, "s"}, {Channel::disp, "mm"}, {Channel::force, "N"}, {Channel::load, "kN"}}));
  ReadOptions options;
  options.columns = record.layout.columns;
  options.units = record.layout.units;
  auto const again = read(bytes, options);
  EXPECT_EQ(again.time_s, record.time_s);
  EXPECT_EQ(again.disp_mm, record.disp_mm);
  EXPECT_EQ(again.force_kN, record.force_kN);
  EXPECT_EQ(again.load_kN, record.load_kN);
}

// --- warnings about a record ---

TEST_F(Read, NoWarningsForACleanRecord) {
  auto const record = read("Time [s];Disp [mm];Force [kN]\n" + rows({}, ";"));
  EXPECT_EQ(record.warnings, std::vector<Finding>{});
}

TEST_F(Read, WarnsOfUnevenSampling) {
  auto const record = read("t [s];Disp [mm];Force [kN]\n0;0;2\n1;2;3\n2.5;3;1\n4;3;2\n");
  EXPECT_TRUE(says(record.warnings, "sampling is not uniform: intervals from 1 to 1.5 s, 1.33333 s on average"));
}

TEST_F(Read, WarnsOfFewSamples) {
  Ellipse const loop{.samples_per_cycle = 50};
  auto const record = read("Time [s];Disp [mm];Force [kN]\n" + rows(loop, ";"));
  EXPECT_TRUE(says(record.warnings, "50.0 samples per cycle: energy comes out 0.26 % too small"));
}

TEST_F(Read, WarnsOfOffsetsAndOfAStartAwayFromZero) {
  std::string text = "Disp [mm];Force [kN]\n";
  Ellipse const loop;
  for (int i = 0; i < loop.size(); ++i) text += fmt::format("{};{}\n", loop.disp(i) + 10.0, loop.force(i) + 40.0);
  auto const record = read(text);
  EXPECT_TRUE(says(record.warnings, "the first sample is at 10 mm, 10 % of the half range of 100 mm"));
  EXPECT_TRUE(says(record.warnings, "displacement is off centre by 10 mm"));
  EXPECT_TRUE(says(record.warnings, "force is off centre by 40"));
}

TEST_F(Read, WarnsOfAForceThatStandsStillWhileTheDeviceMoves) {
  std::string clipped = "Disp [mm];Force [kN]\n", honest = clipped;
  Ellipse const loop;
  double highest = 0.0;
  for (int i = 0; i < loop.size(); ++i) highest = std::max(highest, loop.force(i));
  for (int i = 0; i < loop.size(); ++i) {
    clipped += fmt::format("{};{}\n", loop.disp(i), std::min(loop.force(i), 0.8 * highest));
    honest += fmt::format("{};{}\n", loop.disp(i), loop.force(i));
  }
  EXPECT_TRUE(says(read(clipped).warnings, "the force is clipped at "));
  EXPECT_TRUE(read(honest).faults.empty());
}

TEST_F(Read, WarnsOfStagesOfSeveralAmplitudes) {
  std::string text = "Disp [mm];Force [kN]\n";
  Ellipse const loop;
  for (double const scale : {0.5, 1.0})
    for (int i = 0; i < loop.size(); ++i) text += fmt::format("{};{}\n", scale * loop.disp(i), scale * loop.force(i));
  EXPECT_TRUE(says(read(text).warnings, "cycles of several amplitudes, the smallest 50 mm and the largest 100 mm"));
}

TEST_F(Read, WarnsOfAUnitThatContradictsTheFile) {
  ReadOptions options;
  options.units[Channel::force] = "lbf";
  auto const record = read("t [s];Disp [mm];Force [kN]\n0;0;2\n1;2;3\n2;3;1\n3;3;2\n", options);
  EXPECT_TRUE(says(record.warnings, "states kN, but is read in lbf as --units asks"));
}

}  // namespace
}  // namespace isolaw::data::testing
