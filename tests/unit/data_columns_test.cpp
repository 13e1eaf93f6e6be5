// Tests how channels and units are recognised in the names that laboratories write, or given by options. If a channel
// or unit cannot be known, isolaw must ask for it and not guess.
#include "data_fixture.hpp"
#include "isolaw/data/channels/columns.hpp"
#include "isolaw/data/files/column_names.hpp"
#include "isolaw/data/files/unit_text.hpp"
#include "refusal.hpp"

namespace isolaw::data::testing {
namespace {

using ColumnsTest = Files;

// --- names of columns ---

TEST(ColumnNames, AreTakenApart) {
  auto const parts = [](std::string_view text) {
    auto const name = dissect_name(text);
    return name.base + "|" + name.unit;
  };
  EXPECT_EQ(parts("Displacement [mm]"), "Displacement|mm");
  EXPECT_EQ(parts("Force (kN)"), "Force|kN");
  EXPECT_EQ(parts("displacement_cm"), "displacement|cm");
  EXPECT_EQ(parts("force_tonf"), "force|tonf");
  EXPECT_EQ(parts("Kraft in kN"), "Kraft|kN");
  EXPECT_EQ(parts("F / kN"), "F|kN");
  EXPECT_EQ(parts("Force, kN"), "Force|kN");
  EXPECT_EQ(parts("Force (horizontal) [kN]"), "Force (horizontal)|kN");
  EXPECT_EQ(parts("Force (horizontal)"), "Force (horizontal)|");
  EXPECT_EQ(parts("Force [kNm]"), "Force|kNm");
  EXPECT_EQ(parts("Weg"), "Weg|");
  EXPECT_EQ(parts("mm"), "mm|");
}

struct NamedCase {
  std::string header;  // names the columns of time, displacement, force and vertical load
};

class Languages : public Files, public ::testing::WithParamInterface<NamedCase> {};

TEST_P(Languages, NameTheChannels) {
  auto const record = read(GetParam().header + "\n0;1;2;1632\n1;2;3;1631\n2;3;1;1633\n");
  EXPECT_EQ(record.time_s, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(record.disp_mm, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(record.force_kN, (std::vector<double>{2, 3, 1}));
  EXPECT_EQ(record.load_kN, (std::vector<double>{1632, 1631, 1633}));
}

INSTANTIATE_TEST_SUITE_P(
    All, Languages,
    ::testing::Values(NamedCase{"Time [s];Displacement [mm];Force [kN];Vertical load [kN]"},
                      NamedCase{"TIME (s);HORIZ. DISP. (mm);SHEAR FORCE (kN);AXIAL LOAD (kN)"},
                      NamedCase{"Tempo [s];Spostamento orizzontale [mm];Forza orizzontale [kN];Carico verticale [kN]"},
                      NamedCase{"Tempo [s];Spost. [mm];Taglio [kN];Carico [kN]"},
                      NamedCase{"Zeit [s];Weg [mm];Kraft [kN];Vertikallast [kN]"},
                      NamedCase{"Zeit in s;Verschiebung in mm;Horizontalkraft in kN;Normalkraft in kN"},
                      NamedCase{"Pr\xC3\xBC"
                                "fzeit [s];Standardweg [mm];Standardkraft [kN];Vertikallast [kN]"},
                      NamedCase{"Temps [s];D\xC3\xA9placement [mm];Force [kN];Charge verticale [kN]"},
                      NamedCase{"Temps [s];D\xE9placement [mm];Effort tranchant [kN];Charge [kN]"},
                      NamedCase{"Tiempo [s];Desplazamiento [mm];Fuerza [kN];Carga vertical [kN]"},
                      NamedCase{"Tempo [s];Deslocamento [mm];For\xC3\xA7"
                                "a [kN];Carga vertical [kN]"},
                      NamedCase{"时间(s);水平位移(mm);水平力(kN);竖向荷载(kN)"},
                      NamedCase{"시간 [s];변위 [mm];수평 하중 [kN];수직 하중 [kN]"},
                      NamedCase{"Время, с;Перемещение, мм;Сила, кН;Вертикальная нагрузка, кН"},
                      NamedCase{"t [s];x [mm];F [kN];N [kN]"}, NamedCase{"t [s];u [mm];H [kN];V [kN]"},
                      NamedCase{"t_s;d_mm;F_kN;N_kN"}, NamedCase{"T [s];dx [mm];Fx [kN];Fz [kN]"},
                      NamedCase{"Time s;DispH mm;ForceH kN;ForceV kN"},
                      NamedCase{"time_s;disp_mm;load horizontal kN;load kN"}));

TEST_F(ColumnsTest, VerticalAndCommandedMotionIsNotTheDisplacement) {
  auto const record = read(
      "Command displacement [mm];Vertical displacement [mm];Displacement [mm];Velocity [mm/s];Force [kN]\n"
      "7;8;1;9;2\n7;8;2;9;3\n7;8;3;9;1\n");
  EXPECT_EQ(record.disp_mm, (std::vector<double>{1, 2, 3}));
}

TEST_F(ColumnsTest, AnEmptyNameInAFileSeparatedByBlanks) {
  auto const record = read("\"\" \"Disp [mm]\" \"Force [kN]\"\n0 1 2\n1 2 3\n2 3 1\n");
  EXPECT_EQ(record.disp_mm, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(
      refusal("\"\" Disp [mm] Force [kN]\n1 2\n2 3\n3 1\n", with("disp=1,force=2", "disp=mm,force=kN")),
      "FILE:1: 5 names, but the rows have 2 columns; allowed: one name per column; try: give every column one name");
}

TEST_F(ColumnsTest, ACounterIsNoTime) {
  for (auto const* counter : {"sample", "Index", "n.", "No", "Nr.", "n", "#"}) {
    auto const record = read(fmt::format("{};Disp [mm];Force [kN]\n0;1;2\n1;2;3\n2;3;1\n", counter));
    EXPECT_FALSE(record.has_time()) << counter;
    EXPECT_TRUE(record.load_kN.empty()) << counter;
  }
}

// --- columns and units given by options ---

constexpr std::string_view three_forces =
    "Time [s];Disp [mm];Force 1 [kN];Force 2 [N];force 2\n0;1;2;3;4\n1;2;3;4;5\n2;3;1;2;6\n";

TEST_F(ColumnsTest, ByNumberAndByName) {
  EXPECT_EQ(read(three_forces, with("force=3")).force_kN, (std::vector<double>{2, 3, 1}));
  EXPECT_EQ(read(three_forces, with("force=Force 1 [kN]")).force_kN, (std::vector<double>{2, 3, 1}));
  // The option may leave out a column's unit and use other capitals.
  EXPECT_EQ(read(three_forces, with("force=FORCE 1")).force_kN, (std::vector<double>{2, 3, 1}));
  EXPECT_EQ(read(three_forces, with("force=Force 2 [N]")).force_kN, (std::vector<double>{0.003, 0.004, 0.002}));
  // Both "Force 2 [N]" and "force 2" match. The column whose whole name is "force 2" is taken.
  EXPECT_EQ(read(three_forces, with("force=force 2", "force=kN")).force_kN, (std::vector<double>{4, 5, 6}));
}

TEST_F(ColumnsTest, UnitOptionWinsOverTheHeader) {
  auto const record = read(three_forces, with("force=3", "force=N"));
  EXPECT_EQ(record.force_kN, (std::vector<double>{0.002, 0.003, 0.001}));
  EXPECT_TRUE(says(record.recognised, "force: column 3 'Force 1 [kN]', as asked for; unit N as asked for"));
}

TEST_F(ColumnsTest, NoneLeavesTimeOut) {
  auto const record = read(three_forces, with("force=3,time=none"));
  EXPECT_FALSE(record.has_time());
  EXPECT_EQ(record.layout.columns.at(Channel::time), "none");
}

TEST_F(ColumnsTest, LoadWithoutUnitIsLeftOutWithAWarning) {
  auto const record = read("Disp [mm];Force [kN];Vertical load\n1;2;3\n2;3;3\n3;1;3\n");
  EXPECT_TRUE(record.load_kN.empty());
  EXPECT_TRUE(says(record.warnings, "the vertical load is not read; state its unit with --units load=kN"));
}

TEST_F(ColumnsTest, UnitsOfEveryKind) {
  auto const record = read("Time [ms];Displacement [in];Force [kip]\n0;1;1\n500;2;3\n1000;3;2\n");
  EXPECT_DOUBLE_EQ(record.time_s[1], 0.5);
  EXPECT_DOUBLE_EQ(record.disp_mm[1], 50.8);
  EXPECT_DOUBLE_EQ(record.force_kN[1], 13.3446648457815);
}

TEST(UnitTexts, WithAFactor) {
  auto const text = [](std::string_view written) {
    auto const unit = parse_unit_text(written);
    return unit ? fmt::format("{} {:g}{}", unit->unit.symbol, unit->factor, unit->is_certain ? "" : "?") : "none";
  };
  EXPECT_EQ(text("kN"), "kN 1");
  for (auto const* ten : {"x10 kN", "[x10 kN]", "X 10 kN", "×10 kN", "10*kN", "10 x kN", "10^1 kN", "(10·kN)"})
    EXPECT_EQ(text(ten), "kN 10") << ten;
  for (auto const* thousand : {"10^3 N", "10³ N", "x1000 N", "1e3 N", "10**3 N", "×10^3 N"})
    EXPECT_EQ(text(thousand), "N 1000") << thousand;
  for (auto const* hundredth : {"1/100 mm", "x0.01 mm", "10^-2 mm", "10⁻² mm", "x0,01 mm"})
    EXPECT_EQ(text(hundredth), "mm 0.01") << hundredth;
  EXPECT_EQ(text("1 kN"), "kN 1");
  for (auto const* range : {"10 kN", "100 kN", "0.1 kN", "kN x10", "kN*10"})  // the range of a sensor, or a factor
    EXPECT_EQ(text(range).back(), '?') << range;
  EXPECT_EQ(text("kN/10"), "kN 0.1?");
  EXPECT_EQ(text("µm"), "um 1");
  EXPECT_EQ(text("Mp"), "Mp 1");
  EXPECT_EQ(text("klbf"), "kip 1");
  for (auto const* none : {"", "10", "x10", "kNm", "kN/mm", "-10 kN", "0 kN", "10^400 kN", "1/0 kN", "x", "mm/V"})
    EXPECT_EQ(text(none), "none") << none;
}

TEST(ScaleHints, AreFoundInNames) {
  auto const force = [](std::string_view name) { return scale_hint(dissect_name(name).base, Dimension::force); };
  auto const disp = [](std::string_view name) { return scale_hint(dissect_name(name).base, Dimension::length); };
  EXPECT_EQ(force("Force/2 [kN]"), "/2");
  EXPECT_EQ(force("Force [kN] x10"), "x10");
  EXPECT_EQ(force("Force (x2) [kN]"), "x2");
  EXPECT_EQ(force("2 x Force [kN]"), "2 x");
  EXPECT_EQ(force("0.5*F [kN]"), "0.5*");
  EXPECT_EQ(force("Half force [kN]"), "half");
  EXPECT_EQ(force("Force per bearing [kN]"), "per bearing");
  EXPECT_EQ(force("Avg. force [kN]"), "avg");
  EXPECT_EQ(force("Force of two bearings [kN]"), "two bearings");
  EXPECT_EQ(force("Total force (2 isolators) [kN]"), "2 isolators");
  EXPECT_EQ(force("Shear force of bearing pair [kN]"), "pair");
  EXPECT_EQ(force("Force (scaled 1:2) [kN]"), "1:2");
  EXPECT_EQ(force("Force Dev1:3 [kN]"), "");
  EXPECT_EQ(force("Force 10:30 [kN]"), "");
  EXPECT_EQ(disp("Scaled displacement [mm]"), "scaled");
  EXPECT_EQ(force("Forza media [kN]"), "media");
  EXPECT_EQ(force("Kraft (doppelt) [kN]"), "doppelt");
  EXPECT_EQ(disp("Double amplitude displacement [mm]"), "double");
  EXPECT_EQ(disp("Mean displacement [mm]"), "");  // the mean of several sensors is accepted
  for (auto const* plain : {"Force [kN]", "Force 1 [kN]", "Fx [kN]", "F / kN", "Force x2 [kN]",
                            "Shear force (Cell 3) [kN]", "Force of bearing 2 [kN]", "Force at 12:30:00 [kN]"})
    EXPECT_EQ(force(plain), "") << plain;
}

TEST_F(ColumnsTest, TwoUnitsInOneNameAreRefused) {
  auto const text = [](std::string_view disp) { return fmt::format("{};Force [kN]\n1;2\n2;3\n3;1\n", disp); };
  for (auto const* name : {"Displacement mm [in]", "Displacement [mm] (cm)", "Disp_cm [mm]"}) {
    EXPECT_NE(refusal(text(name)).find("states two units"), std::string::npos) << name;
    EXPECT_EQ(read(text(name), with("", "disp=cm")).disp_mm, (std::vector<double>{10, 20, 30})) << name;
  }
  for (auto const* name : {"Displacement in mm [mm]", "Displacement (LVDT 50 cm) [mm]", "Displacement m [mm]"})
    EXPECT_EQ(read(text(name)).disp_mm, (std::vector<double>{1, 2, 3})) << name;
}

TEST_F(ColumnsTest, AFactorInTheHeaderIsUsedAndSaid) {
  for (auto const* header : {"Disp [mm];Force [x10 kN]", "Disp [mm];Force x10 kN", "Disp;Force\nmm;x10 kN"}) {
    auto const record = read(fmt::format("{}\n1;2\n2;3\n3;1\n", header));
    EXPECT_EQ(record.force_kN, (std::vector<double>{20, 30, 10})) << header;
    EXPECT_TRUE(says(record.recognised, "each value times 10")) << header;
    EXPECT_EQ(record.layout.scales, (std::map<Channel, std::string>{{Channel::force, "10"}}));
    EXPECT_EQ(read(fmt::format("{}\n1;2\n2;3\n3;1\n", header), record.layout).force_kN, record.force_kN);
  }
}

TEST_F(ColumnsTest, AFactorThatMayBeSomethingElseIsAskedFor) {
  auto const text = [](std::string_view force) { return fmt::format("Disp [mm];{}\n1;2\n2;3\n3;1\n", force); };
  for (auto const* name : {"Force [10 kN]", "Force [kN] x10", "Force/2 [kN]", "Force per bearing [kN]"}) {
    EXPECT_NE(refusal(text(name)).find("--channel-scale force=FACTOR"), std::string::npos) << name;
    auto told = with("", "force=kN");
    told.scales = parse_scales("force=10");
    EXPECT_EQ(read(text(name), told).force_kN, (std::vector<double>{20, 30, 10})) << name;
  }
  ReadOptions of_two;
  of_two.corrections.force_factor = 0.5;
  EXPECT_NO_THROW(read(text("Force of two bearings [kN]"), of_two));
  EXPECT_EQ(read("Disp [mm];Load cell force (100 kN)\nmm;kN\n1;2\n2;3\n3;1\n").force_kN,
            (std::vector<double>{2, 3, 1}));  // the row of units tells that 100 kN is the sensor's range
}

TEST_F(ColumnsTest, AVoltageNeedsItsSensitivity) {
  EXPECT_EQ(read("Disp [V] (25 mm/V);Force [mV], 0.5 kN/mV\n1;2\n2;3\n3;1\n").disp_mm,
            (std::vector<double>{25, 50, 75}));
  auto told = with("", "disp=mm,force=kN");
  std::string const volts = "Disp [V];Force [V]\n1;2\n2;3\n3;1\n";
  EXPECT_NE(refusal(volts, told).find("mm, but the unit of column 1 'Disp [V]' is 'V', which is no length"),
            std::string::npos);
  told.scales = parse_scales("disp=25,force=10");
  EXPECT_EQ(read(volts, told).disp_mm, (std::vector<double>{25, 50, 75}));
}

TEST_F(ColumnsTest, TwoDirectionsAreAskedFor) {
  std::string const text = "Dx [mm];Dy [mm];Fx [kN];Fy [kN]\n1;7;2;9\n2;8;3;7\n3;9;1;8\n";
  EXPECT_EQ(refusal(text),
            "FILE:1: column 1 'Dx [mm]' and column 3 'Fx [kN]' are one horizontal direction, column 2 'Dy [mm]' and "
            "column 4 'Fy [kN]' another; allowed: one direction; try: --columns disp=1,force=3,second-disp=2, or "
            "disp=2,force=4,second-disp=1");
  auto const along_y = read(text, with("disp=Dy,force=Fy"));
  EXPECT_EQ(along_y.disp_mm, (std::vector<double>{7, 8, 9}));
  EXPECT_TRUE(says(along_y.warnings, "hold a second direction, whose force is not read"));
  EXPECT_TRUE(says(along_y.warnings, "--columns disp=2,force=4,second-disp=1 reads its displacement too"));
  EXPECT_TRUE(along_y.second_disp_mm.empty());
  auto const both = read(text, with("disp=Dy,force=Fy,second-disp=Dx"));
  EXPECT_EQ(both.second_disp_mm, (std::vector<double>{1, 2, 3}));
  EXPECT_FALSE(says(both.warnings, "reads its displacement too"));
  // A unit or scale of the displacement holds for both directions.
  auto told = with("disp=2,force=4,second-disp=1", "disp=cm,force=kN");
  EXPECT_EQ(read("Dx;Dy;Fx;Fy\n1;7;2;9\n2;8;3;7\n3;9;1;8\n", told).second_disp_mm, (std::vector<double>{10, 20, 30}));
}

TEST_F(ColumnsTest, RowsWithMissingValues) {
  std::string const text = "Time [s];Disp [mm];Force [kN]\n0;1;\n1;2;4\n2;3;NaN\n4;4;10\n5;5;3\n";
  EXPECT_NE(refusal(text).find("--missing leave-out or --missing interpolate"), std::string::npos);
  ReadOptions told;
  told.missing = MissingValues::left_out;
  EXPECT_EQ(read(text, told).force_kN, (std::vector<double>{4, 10, 3}));
  told.missing = MissingValues::interpolated;
  auto const filled = read(text, told);
  EXPECT_EQ(filled.disp_mm, (std::vector<double>{2, 3, 4, 5}));
  EXPECT_EQ(filled.force_kN, (std::vector<double>{4, 6, 10, 3}));  // interpolated over time, not over rows
  EXPECT_TRUE(says(filled.recognised, "2 of 5 rows lack a value, at most 1 in a row: 1 left out, 1 filled"));
}

// The time of a row that is left out must pass all the same, so later samples keep their times.
TEST_F(ColumnsTest, RowsWithMissingValuesTakeTime) {
  ReadOptions told;
  told.dt_s = 0.5;
  for (auto const missing : {MissingValues::left_out, MissingValues::interpolated}) {
    told.missing = missing;
    auto const record = read("Disp [mm];Force [kN]\n1;\n2;4\n3;\n4;10\n5;3\n", told);
    EXPECT_EQ(record.time_s, missing == MissingValues::left_out ? (std::vector<double>{0.5, 1.5, 2.0})
                                                                : (std::vector<double>{0.5, 1.0, 1.5, 2.0}));
    EXPECT_TRUE(says(record.recognised, "sampling interval 0.5 s"));
  }
  told.from_s = 1.2;
  EXPECT_EQ(read("Disp [mm];Force [kN]\n1;\n2;4\n3;1\n4;10\n5;3\n6;4\n", told).time_s,
            (std::vector<double>{1.5, 2.0, 2.5}));
}

TEST_F(ColumnsTest, ARowWithoutTimeFillsNoOther) {
  ReadOptions told;
  told.missing = MissingValues::interpolated;
  auto const record = read("Disp [mm];Force [kN];Time [s]\n1;2;0\n2;9;\n3;;2\n4;8;3\n5;3;4\n", told);
  EXPECT_EQ(record.force_kN, (std::vector<double>{2, 6, 8, 3}));
  EXPECT_EQ(record.time_s, (std::vector<double>{0, 2, 3, 4}));
}

TEST_F(ColumnsTest, ALastColumnThatIsMostlyEmpty) {
  for (char const delimiter : {',', '\t'}) {
    std::string text = "Time [s],Disp [mm],Force [kN]\n";
    for (int i = 0; i <= 40; ++i)
      text += i % 5 == 0 ? fmt::format("{},{},{}\n", i, i % 7, i) : fmt::format("{},{},\n", i, i % 7);
    std::ranges::replace(text, ',', delimiter);
    ReadOptions told;
    told.missing = MissingValues::interpolated;
    told.checks_physics = false;
    auto const record = read(text, told);
    ASSERT_EQ(record.size(), 41u);
    EXPECT_DOUBLE_EQ(record.force_kN[13], 13.0);
  }
}

TEST_F(ColumnsTest, ThatNumberTheCyclesMayBeLeftOut) {
  auto const record = read("Cycle;Cycle no;Disp [mm];Force [kN]\n1;1;1;2\n1;1;2;3\n1;1;3;1\n");
  EXPECT_TRUE(record.logged_cycle.empty());
  EXPECT_TRUE(says(record.recognised, "may each number the cycles, so neither is read: --columns cycle=1 or"));
  EXPECT_NE(refusal("Cycle;Disp [mm];Force [kN]\n1;1;2\n;2;3\n1;3;1\n").find("--columns cycle=none"),
            std::string::npos);
  EXPECT_NE(refusal("Cycle;Disp [mm];Force [kN]\n1;1;2\n3e9;2;3\n1;3;1\n")
                .find("in column 1 'Cycle' is no number of a cycle"),
            std::string::npos);
}

TEST_F(ColumnsTest, AScaleThatWouldHaveNoEffectIsRefused) {
  ReadOptions told;
  told.scales = parse_scales("time=0.001");
  EXPECT_NE(refusal("Time;Disp [mm];Force [kN]\n10:00:00;1;2\n10:00:01;2;3\n10:00:02;3;1\n", told)
                .find("--channel-scale time: a factor, but column 1 'Time' holds time stamps"),
            std::string::npos);
}

// --- refusals, whose message names the option to type ---

TEST_F(ColumnsTest, SeveralForcesAreAskedFor) {
  EXPECT_EQ(
      refusal(three_forces),
      "FILE:1: column 3 'Force 1 [kN]', column 4 'Force 2 [N]', column 5 'force 2' may each be the horizontal force; allowed: one column for force; try: --columns force=3 or --columns force=4 or --columns force=5");
}

TEST_F(ColumnsTest, MissingColumnListsWhatThereIs) {
  EXPECT_EQ(
      refusal("Time [s];Disp [mm];Temp [C]\n0;1;2\n1;2;3\n2;3;1\n"),
      "FILE:1: no column is recognised as the horizontal force; allowed: columns 1 'Time [s]', 2 'Disp [mm]', 3 'Temp [C]'; try: --columns force=NUMBER");
}

TEST_F(ColumnsTest, ALoneLoadMayBeEither) {
  EXPECT_EQ(
      refusal("Disp [mm];Load [kN]\n1;2\n2;3\n3;1\n"),
      "FILE:1: no column is recognised as the horizontal force (column 2 'Load [kN]' may be the horizontal force or the vertical load); allowed: columns 1 'Disp [mm]', 2 'Load [kN]'; try: --columns force=2");
}

TEST_F(ColumnsTest, ColumnsWithoutNamesAreNotGuessed) {
  EXPECT_EQ(
      refusal("0.0,1.5,2\n0.1,2.5,3\n0.2,3.5,1\n"),
      "FILE: no line names the 3 columns, so isolaw cannot know which is the displacement and which the force; allowed: column numbers 1 to 3; try: --columns time=1,disp=2,force=3 --units time=s,disp=mm,force=kN, with your numbers and units");
  EXPECT_EQ(
      refusal("1.5 2\n2.5 3\n3.5 1\n", with("disp=1", "disp=mm")),
      "FILE: no line names the 2 columns, so isolaw cannot know which is the horizontal force; allowed: column numbers 1 to 2; try: --columns force=NUMBER");
}

TEST_F(ColumnsTest, MissingAndUnknownUnitsAreAskedForTogether) {
  EXPECT_EQ(
      refusal("Time [s];Disp;Force [kNm]\n0;1;2\n1;2;3\n2;3;1\n"),
      "FILE:1: column 2 'Disp' (disp) has no unit; allowed: mm, cm, m, in, ft, dm, um; try: --units disp=mm, with the column's unit\n"
      "FILE:1: unknown unit 'kNm' of column 3 'Force [kNm]' (force); allowed: kN, N, MN, tonf, kgf, daN, kip, lbf, Mp; try: --units force=kN --channel-scale force=FACTOR, if a value of 1 is FACTOR kN");
}

TEST_F(ColumnsTest, UnknownUnitInTheRowOfUnits) {
  EXPECT_EQ(
      refusal("Time;Disp;Force\ns;mm;kNN\n0;1;2\n1;2;3\n2;3;1\n"),
      "FILE:2: unknown unit 'kNN' of column 3 'Force' (force); allowed: kN, N, MN, tonf, kgf, daN, kip, lbf, Mp; try: --units force=kN --channel-scale force=FACTOR, if a value of 1 is FACTOR kN");
}

TEST_F(ColumnsTest, UnitOfAnotherQuantity) {
  EXPECT_EQ(
      refusal("Disp [kN];Force [kN]\n1;2\n2;3\n3;1\n"),
      "FILE:1: unit kN of column 1 'Disp [kN]' is a force, not a length; allowed: mm, cm, m, in, ft, dm, um; try: --units disp=mm, with the column's unit");
}

TEST_F(ColumnsTest, UnitsThatContradictEachOther) {
  EXPECT_EQ(
      refusal("Disp [mm];Force [kN]\ncm;kN\n1;2\n2;3\n3;1\n"),
      "FILE:2: column 1 'Disp [mm]' is in mm by its name and in cm by the row of units; allowed: mm, cm, m, in, ft, dm, um; try: --units disp=mm, with the column's unit");
}

TEST_F(ColumnsTest, AskedForColumnsThatDoNotExist) {
  EXPECT_EQ(
      refusal("Disp [mm];Force [kN]\n1;2\n2;3\n3;1\n", with("disp=4,force=Taglio")),
      "FILE:1: no column 4 for disp; allowed: 1 to 2; columns 1 'Disp [mm]', 2 'Force [kN]'; try: --columns disp=NUMBER\n"
      "FILE:1: no column 'Taglio' for force; allowed: columns 1 'Disp [mm]', 2 'Force [kN]'; try: --columns force=NUMBER");
}

TEST_F(ColumnsTest, OneColumnForTwoChannels) {
  EXPECT_EQ(
      refusal("Disp [mm];Force [kN]\n1;2\n2;3\n3;1\n", with("disp=2,force=2", "disp=mm")),
      "FILE:1: column 2 'Force [kN]' is asked for as disp and as force; allowed: one column per channel; try: --columns disp=NUMBER,force=NUMBER");
}

TEST_F(ColumnsTest, NameThatIsNotUnique) {
  EXPECT_EQ(
      refusal("Disp [mm];Force [kN];Force [kN]\n1;2;3\n2;3;3\n3;1;3\n", with("force=Force")),
      "FILE:1: 2 columns are named 'Force'; allowed: a unique column; try: --columns force=2 or --columns force=3");
}

// A channel named after an axis of the machine is used only if the file says which machine wrote it and no other
// channel could be meant.
TEST_F(ColumnsTest, OfAMachineMayBeNamedAfterItsAxis) {
  std::string const mts = "MTS793|MPT|ENU|1|2|.|/|:|1|0|0|A\n\n";
  std::string const rows = "\n0\t1\t2\t5\n1\t2\t3\t6\n2\t3\t1\t7\n";
  std::string const axial = "Time [s]\tAxial Displacement [mm]\tAxial Force [kN]\tCount";
  auto const record = read(mts + axial + rows);
  EXPECT_EQ(record.disp_mm, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(record.force_kN, (std::vector<double>{2, 3, 1}));
  EXPECT_TRUE(
      says(record.warnings, "'Axial Force [kN]' is named after the machine's axis and used as the horizontal force"));
  EXPECT_NE(refusal(axial + rows).find("no column is recognised as the horizontal displacement"), std::string::npos);
  auto const both = read(mts + "Time [s]\tDisplacement [mm]\tForce [kN]\tAxial Force [kN]" + rows);
  EXPECT_EQ(both.force_kN, (std::vector<double>{2, 3, 1}));
  EXPECT_EQ(both.load_kN, (std::vector<double>{5, 6, 7}));
}

TEST_F(ColumnsTest, TwoVerticalLoadsAreAWarning) {
  auto const record = read("Disp [mm];Force [kN];N1 vertical [kN];N2 vertical [kN]\n1;2;3;4\n2;3;3;4\n3;1;3;4\n");
  EXPECT_TRUE(record.load_kN.empty());
  EXPECT_TRUE(says(record.warnings, "none is read; choose one with --columns load=3 or --columns load=4"));
}

// --- options that are wrong themselves ---

TEST(ColumnOptions, AreParsed) {
  EXPECT_EQ(parse_columns("time=1, disp=Displacement [mm],FORCE=3"),
            (std::map<Channel, std::string>{
                {Channel::time, "1"}, {Channel::disp, "Displacement [mm]"}, {Channel::force, "3"}}));
  EXPECT_EQ(parse_units("disp=CM,force=[tonf],time=sec"),
            (std::map<Channel, std::string>{{Channel::disp, "cm"}, {Channel::force, "tonf"}, {Channel::time, "s"}}));
  EXPECT_TRUE(parse_columns("").empty());
}

TEST(ColumnOptions, AreRefused) {
  EXPECT_EQ(refusal_of([] { parse_columns("displ=1,force,disp=2,disp=3"); }),
            "--columns: unknown channel 'displ'; allowed: time, disp, force, load, cycle, second-disp\n"
            "--columns: force has no value; allowed: CHANNEL=VALUE,...\n"
            "--columns: disp is given twice; allowed: one value per channel");
  EXPECT_EQ(refusal_of([] { parse_units("disp=furlong,force=mm"); }),
            "--units disp: unknown unit 'furlong'; allowed: mm, cm, m, in, ft, dm, um\n"
            "--units force: mm is a length; allowed: kN, N, MN, tonf, kgf, daN, kip, lbf, Mp");
}

}  // namespace
}  // namespace isolaw::data::testing
