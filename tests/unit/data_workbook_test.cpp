// Tests the reading of records in Excel workbooks: every kind of cell, sheets, gaps, dates, and what is refused.
#include "data_writers.hpp"

namespace isolaw::data::testing {
namespace {

class Workbook : public Files {
 protected:
  std::filesystem::path place() { return write("", "made.xlsx"); }
  std::string book(std::vector<std::pair<std::string, Named>> const& sheets) { return workbook_of(place(), sheets); }
  std::string book_with(std::string const& rows, std::vector<std::pair<std::string, std::string>> more = {}) {
    return workbook_with(place(), rows, std::move(more));
  }
};

std::string cell(std::string const& text, std::string const& attributes = "") {
  return "<c" + attributes + "><v>" + text + "</v></c>";
}
std::string text_cell(std::string const& text) {
  return "<c t=\"inlineStr\"><is><t>" + text + "</t></is></c>";
}
std::string row(std::string const& cells) {
  return "<row>" + cells + "</row>";
}

std::string const header_cells = row(text_cell("Disp [mm]") + text_cell("Force [kN]"));
std::string const three = row(cell("0") + cell("1")) + row(cell("1.5") + cell("-2E0")) + row(cell("2") + cell("1"));

TEST_F(Workbook, IsReadAsExcelWritesIt) {
  Ellipse const loop;
  auto const record = read(book({{"Prüfung 1", columns_of(loop)}}));
  ASSERT_EQ(record.size(), static_cast<std::size_t>(loop.size()));
  EXPECT_NEAR(record.disp_mm[50], 100.0, 1e-12);
  EXPECT_EQ(record.layout.columns.at(Channel::disp), "Disp [mm]");
  EXPECT_EQ(record.layout.sheet, std::nullopt);  // a workbook of one sheet needs no option --sheet
  EXPECT_TRUE(says(record.recognised, "an Excel workbook, sheet 'Prüfung 1'"));
  EXPECT_TRUE(says(record.recognised, "row 1 is the header"));
  EXPECT_TRUE(says(record.recognised, "disp: column B 'Disp [mm]', by its name; unit mm from its name"));
  EXPECT_TRUE(says(record.recognised, "601 samples, rows 2 to 602"));
}

TEST_F(Workbook, FormulasSharedTextsTitlesAndUnitRows) {
  auto const file = place();
  auto* workbook = workbook_new(file.c_str());
  auto* sheet = workbook_add_worksheet(workbook, nullptr);
  worksheet_write_string(sheet, 0, 0, "Shear test of bearing 7", nullptr);
  worksheet_write_string(sheet, 1, 0, "Operator", nullptr);
  worksheet_write_string(sheet, 1, 1, "N.N.", nullptr);
  char const* titles[] = {"Time", "Displacement", "Force", "Remark"};
  char const* units[] = {"s", "cm", "kN", ""};
  for (lxw_col_t c = 0; c < 4; ++c) {
    worksheet_write_string(sheet, 3, static_cast<lxw_col_t>(c + 1), titles[c], nullptr);
    worksheet_write_string(sheet, 4, static_cast<lxw_col_t>(c + 1), units[c], nullptr);
  }
  for (lxw_row_t i = 0; i < 4; ++i) {
    worksheet_write_number(sheet, 5 + i, 1, i, nullptr);
    worksheet_write_formula_num(sheet, 5 + i, 2, "=B6/2", nullptr, 0.5 * i);
    worksheet_write_number(sheet, 5 + i, 3, i % 2, nullptr);
  }
  worksheet_write_string(sheet, 7, 4, "noise", nullptr);
  worksheet_write_string(sheet, 6, 9, "far to the right", nullptr);
  workbook_close(workbook);
  auto const record = read(bytes_of(file));
  EXPECT_EQ(record.disp_mm, (std::vector{0.0, 5.0, 10.0, 15.0}));
  EXPECT_EQ(record.force_kN, (std::vector{0.0, 1.0, 0.0, 1.0}));
  EXPECT_TRUE(says(record.recognised, "row 4 is the header, row 5 gives the units"));
  EXPECT_TRUE(says(record.recognised, "above the data, row 1, 2 are passed over"));
  auto const by_letter = read(bytes_of(file), with("time=none,disp=C,force=d"));
  EXPECT_EQ(by_letter.disp_mm, record.disp_mm);
  EXPECT_EQ(by_letter.layout.columns.at(Channel::disp), "Displacement");
  EXPECT_EQ(read(bytes_of(file), with("time=none,disp=3,force=Force")).force_kN, record.force_kN);
}

TEST_F(Workbook, RowsAndCellsMayBeLeftOut) {
  auto const text = book_with(
      "<row r=\"3\"><c r=\"B3\" t=\"inlineStr\"><is><t>Disp [mm]</t></is></c><c r=\"D3\" t=\"inlineStr\"><is><r><t>Force</t></r><r><t> [kN]</t></r></is></c></row><row r=\"5\"><c r=\"B5\"><v>1</v></c><c r=\"D5\"><v>2</v></c></row><row r=\"8\"><c r=\"B8\"><v>2</v></c><c r=\"D8\"><v>3</v></c></row><row r=\"9\"><c r=\"B9\"><v>1</v></c><c r=\"D9\"><v>0</v></c></row>");
  auto const record = read(text);
  EXPECT_EQ(record.disp_mm, (std::vector{1.0, 2.0, 1.0}));
  EXPECT_EQ(record.force_kN, (std::vector{2.0, 3.0, 0.0}));
  EXPECT_TRUE(says(record.recognised, "3 samples, rows 5 to 9"));
  EXPECT_TRUE(says(record.recognised, "force: column D 'Force [kN]'"));
}

TEST_F(Workbook, ValuesAreThoseOfTheFileToTheLastBit) {
  auto const record = read(book_with(header_cells + three + row(cell("0.1") + cell("2.2250738585072014E-308"))));
  EXPECT_EQ(record.disp_mm, (std::vector{0.0, 1.5, 2.0, 0.1}));
  EXPECT_EQ(record.force_kN[3], 2.2250738585072014E-308);
}

TEST_F(Workbook, SheetsAreChosenByNameOrNumber) {
  Ellipse const loop, small{.amplitude_mm = 50.0};
  auto const text = book({{"Info", {{"Device", {}}}}, {"Test 1", columns_of(loop)}, {"Test 2", columns_of(small)}});
  EXPECT_EQ(
      refusal(text),
      "FILE: tables 'Test 1', 'Test 2' may each be the test; allowed: one of them; try: --sheet \"Test 1\", or isolaw init, which makes a device of each");
  ReadOptions options;
  for (auto const* name : {"Test 2", "test 2", "3"}) {
    options.sheet = name;
    auto const record = read(text, options);
    EXPECT_NEAR(record.disp_mm[50], 50.0, 1e-12) << name;
    EXPECT_EQ(record.layout.sheet, "Test 2");
  }
  options.sheet = "Test 3";
  EXPECT_EQ(refusal(text, options),
            "FILE: no sheet 'Test 3'; allowed: sheets 'Info', 'Test 1', 'Test 2'; try: --sheet NAME, or its number");
  options.sheet = "Info";
  EXPECT_EQ(refusal(text, options), "FILE:Info: no rows of numbers; allowed: sheets 'Info', 'Test 1', 'Test 2'");
  EXPECT_EQ(
      refusal(book({{"Info", {{"Device", {}}}}})),
      "FILE: no rows of numbers in sheets 'Info'; allowed: two or more columns of numbers; try: a sheet with displacement and force");
}

TEST_F(Workbook, SheetsOfOtherNumbersArePassedOverBesideATest) {
  Ellipse const loop;
  Named const chart{{"a", {1.0, 2.0, 3.0}}, {"b", {2.0, 4.0, 6.0}}};
  for (auto const& sheets : {std::vector<std::pair<std::string, Named>>{{"Test", columns_of(loop)}, {"Grafici", chart}},
                             {{"Grafici", chart}, {"Test", columns_of(loop)}}}) {
    auto const file = place();
    auto const record = read(workbook_of(file, sheets));
    EXPECT_EQ(record.size(), static_cast<std::size_t>(loop.size()));
    EXPECT_EQ(record.layout.sheet, "Test");
    EXPECT_TRUE(says(record.recognised, "an Excel workbook, sheet 'Test', the only test"));
    EXPECT_TRUE(says(record.recognised, "sheet 'Grafici' names no time, displacement or force, passed over"));
    auto const listed = list_tests(file);
    ASSERT_EQ(listed.size(), 1u);
    EXPECT_EQ(listed.front().sheet, "Test");
    EXPECT_EQ(listed.front().passed_over, std::vector<std::string>{"Grafici"});
  }
  auto const text = book({{"Test", columns_of(loop)}, {"Grafici", chart}});
  EXPECT_EQ(
      // If --columns gives letters, a sheet without names of channels may be the test too.
      refusal(text, with("disp=B,force=C")),
      "FILE: tables 'Test', 'Grafici' may each be the test; allowed: one of them; try: --sheet Test, or isolaw init, which makes a device of each");
  EXPECT_EQ(
      refusal(book({{"One", chart}, {"Two", chart}})),
      "FILE: tables 'One', 'Two' may each be the test; allowed: one of them; try: --sheet One, or isolaw init, which makes a device of each");
}

// The letter F means column F, although column C comes first and is called "F [kN]" too. Only a column whose whole name
// is "F" goes before the letter.
TEST_F(Workbook, ALetterIsTheColumnUnlessANameReadsJustSo) {
  Ellipse const loop, small{.amplitude_mm = 50.0};
  auto const named = [&](Ellipse const& of) { return columns_of(of, "t [s]", "d [mm]", "F [kN]"); };
  auto side = named(loop);
  for (auto const& column : named(small)) side.push_back(column);
  auto const record = read(book({{"Test", side}}), with("time=D,disp=E,force=F"));
  EXPECT_NEAR(record.disp_mm[50], 50.0, 1e-12);
  EXPECT_EQ(record.force_kN, read(book({{"Test", named(small)}})).force_kN);
  EXPECT_EQ(record.layout.columns.at(Channel::force), "6");
  auto const exact = columns_of(loop, "F", "B", "D [kN]");
  auto const by_name = read(book({{"Test", exact}}), with("time=F,disp=B,force=D", "time=s,disp=mm"));
  EXPECT_EQ(by_name.force_kN, read(book({{"Test", named(loop)}})).force_kN);
  auto twice = columns_of(loop, "t [s]", "F", "C");
  twice.push_back({"F", twice.back().second});
  EXPECT_EQ(
      refusal(book({{"Test", twice}}), with("disp=F,force=3", "disp=mm,force=kN")),
      "FILE:Test:1: 2 columns are named 'F'; allowed: a unique column; try: --columns disp=B or --columns disp=D");
  std::swap(twice[2].first, twice[3].first);
  EXPECT_EQ(
      refusal(book({{"Test", twice}}), with("disp=F,force=3", "disp=mm,force=kN")),
      "FILE:Test:1: 2 columns are named 'F'; allowed: a unique column; try: --columns disp=B or --columns disp=3");
}

TEST_F(Workbook, SeveralTestsInOneSheet) {
  auto const text = book_with(header_cells + three + header_cells + three + row(cell("5") + cell("5")));
  EXPECT_EQ(
      refusal(text),
      "FILE:Test: 2 tests in one file: they start at rows 1, 5; allowed: one of them, or all as one history; try: --test all, or --test 2, or isolaw init, which makes a device of each");
  ReadOptions options;
  options.test = "2";
  EXPECT_EQ(read(text, options).size(), 4u);
  options.test = "all";
  EXPECT_EQ(read(text, options).size(), 7u);
}

TEST_F(Workbook, FaultsAreAtTheirSheetAndRow) {
  auto const at_row_5 = [&](std::string const& bad) {
    return refusal(book_with(header_cells + three + row(bad + cell("1"))));
  };
  auto const rest = "; allowed: a number; try: --rows 1:3, the rows before it";
  EXPECT_EQ(at_row_5(text_cell("1,5")),
            std::string("FILE:Test:5: '1,5' in column A 'Disp [mm]' is text, not a number") + rest);
  EXPECT_EQ(at_row_5(text_cell("1,234.5")),  // the option --thousands applies to text files only
            std::string("FILE:Test:5: '1,234.5' in column A 'Disp [mm]' is text, not a number") + rest);
  EXPECT_EQ(at_row_5(cell("#DIV/0!", " t=\"e\"")),
            std::string("FILE:Test:5: 'error #DIV/0!' in column A 'Disp [mm]' is text, not a number") + rest);
  EXPECT_EQ(
      at_row_5("<c><f>A1</f></c>"),
      std::string("FILE:Test:5: 'a formula saved without its value' in column A 'Disp [mm]' is text, not a number") +
          rest);
  EXPECT_EQ(
      at_row_5(cell("99", " t=\"s\"")),
      std::string("FILE:Test:5: 'a text that the file lacks' in column A 'Disp [mm]' is text, not a number") + rest);
  EXPECT_EQ(
      at_row_5("<c/>"),
      "FILE:Test:5: column A 'Disp [mm]' is empty; allowed: a number; try: --rows 1:3, the rows before it; --missing leave-out or --missing interpolate");
  EXPECT_EQ(
      refusal(book_with(header_cells + three + row(cell("2")))),
      "FILE:Test:5: column B 'Force [kN]' is empty; allowed: a number; try: --rows 1:3, the rows before it; --missing leave-out or --missing interpolate");
}

TEST_F(Workbook, DatesAndTimesOfDayAreNoSeconds) {
  std::string const styles =
      "<styleSheet><numFmts><numFmt numFmtId=\"170\" formatCode=\"[Red]0.00;&quot;day&quot;0\"/><numFmt numFmtId=\"171\" formatCode=\"mm:ss.0\"/></numFmts><cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"22\"/><xf numFmtId=\"170\"/><xf numFmtId=\"171\"/><xf numFmtId=\"11\"/></cellXfs></styleSheet>";
  auto const head = row(text_cell("Time [s]") + text_cell("Disp [mm]") + text_cell("Force [kN]"));
  auto const styled = [&](int style) {
    std::string rows = head;
    for (int i = 0; i < 3; ++i)
      rows += row(cell(std::to_string(i), fmt::format(" s=\"{}\"", style)) + cell(std::to_string(i)) +
                  cell(std::to_string(i % 2)));
    return book_with(rows, {{"xl/styles.xml", styles}});
  };
  for (int const number : {0, 2, 4}) EXPECT_EQ(read(styled(number)).size(), 3u) << number;
  // Dates without times of day cannot be the time of a test.
  for (int const date : {1, 3})
    EXPECT_TRUE(
        refusal(styled(date))
            .starts_with(
                "FILE:Test:2: '0 (a date or time of day)' in column A 'Time [s]' is a date or time of day, not a number"))
        << refusal(styled(date));
}

TEST_F(Workbook, DateCellsAreSecondsFromTheFirst) {
  std::string const styles =
      "<styleSheet><cellXfs><xf numFmtId=\"0\"/><xf numFmtId=\"22\"/><xf numFmtId=\"14\"/><xf numFmtId=\"21\"/></cellXfs></styleSheet>";
  auto const head = text_cell("Disp [mm]") + text_cell("Force [kN]");
  std::string stamps = row(text_cell("Time") + head), parts = row(text_cell("Date") + text_cell("Clock") + head);
  for (int i = 0; i < 4; ++i) {
    double const seconds = 86398.5 + i;  // the time of day passes midnight
    auto const values = cell(std::to_string(i)) + cell(std::to_string(i % 2));
    stamps += row(cell(fmt::format("{:.12f}", 45414.0 + seconds / 86400.0), " s=\"1\"") + values);
    parts += row(cell(std::to_string(45414 + (seconds >= 86400.0 ? 1 : 0)), " s=\"2\"") +
                 cell(fmt::format("{:.12f}", std::fmod(seconds / 86400.0, 1.0)), " s=\"3\"") + values);
  }
  for (auto const& rows : {stamps, parts}) {
    auto const record = read(book_with(rows, {{"xl/styles.xml", styles}}));
    ASSERT_EQ(record.time_s.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(record.time_s[i], static_cast<double>(i), 1e-6);
    EXPECT_TRUE(says(record.recognised, "2024-05-02 at 23:59:58.500"));
  }
}

TEST_F(Workbook, AColumnThatIsNotThere) {
  EXPECT_EQ(
      refusal(book_with(header_cells + three), with("disp=D,force=Force")),
      "FILE:Test:1: no column 'D' for disp; allowed: columns A 'Disp [mm]', B 'Force [kN]'; try: --columns disp=LETTER");
  EXPECT_EQ(
      refusal(book_with(three)),
      "FILE:Test: no row names the 2 columns, so isolaw cannot know which is the displacement and which the force; allowed: columns A to B; try: --columns disp=1,force=2 --units disp=mm,force=kN, with your numbers and units");
}

// --- files that are meant to do harm ---

TEST_F(Workbook, ABombIsRefused) {
  std::string const blanks(std::size_t{70} << 20, ' ');
  EXPECT_EQ(refusal(book_with(header_cells + blanks + three)).substr(0, 61),
            "FILE:xl/worksheets/sheet1.xml: grows beyond 64 MiB when unpac");
}

TEST_F(Workbook, EntitiesAndDeepElements) {
  EXPECT_TRUE(refusal(book_with("<!DOCTYPE x [<!ENTITY a \"aaaa\">]><worksheet>&a;</worksheet>"))
                  .starts_with("FILE:xl/worksheets/sheet1.xml: declares a document type"));
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<a>";
  EXPECT_TRUE(refusal(book_with(deep)).starts_with("FILE:xl/worksheets/sheet1.xml: elements nested more than 64 deep"));
  EXPECT_TRUE(refusal(book_with("<row " + std::string(4 << 20, 'a') + "=\"\"/>"))
                  .starts_with("FILE:xl/worksheets/sheet1.xml: a tag longer than 1 MiB"));
  EXPECT_TRUE(refusal(book_with("<row>")).starts_with("FILE:xl/worksheets/sheet1.xml: is no XML: mismatched tag"));
}

TEST_F(Workbook, CellsThatSayTheyAreElsewhere) {
  auto const advice = "; try: open it in a spreadsheet program and save it again as .xlsx";
  EXPECT_EQ(refusal(book_with(header_cells + "<row r=\"1048577\"/>")),
            std::string("FILE:Test: row '1048577'; allowed: 1 to 1048576") + advice);
  EXPECT_EQ(refusal(book_with("<row r=\"7\"/><row r=\"6\"/>")),
            std::string("FILE:Test: row 6 below row 7; allowed: rows in their order") + advice);
  EXPECT_EQ(refusal(book_with("<row r=\"1\"><c r=\"B1\"/><c r=\"A1\"/></row>")),
            std::string("FILE:Test: cell A1 twice, or behind another; allowed: cells in their order") + advice);
  EXPECT_EQ(refusal(book_with("<row r=\"1\"><c r=\"B2\"/></row>")),
            std::string("FILE:Test: cell 'B2' in row 1; allowed: cells in the row they name") + advice);
  EXPECT_EQ(refusal(book_with("<row r=\"1\"><c r=\"ALM1\"><v>1</v></c></row>")),
            std::string("FILE:Test: a cell in column ALM; allowed: 1000 columns, to ALL") + advice);
}

// In this small file a great many cells refer to one text of 30 000 characters. isolaw must refuse the file.
TEST_F(Workbook, OneTextSaidManyTimesIsCut) {
  std::string const shared = "<sst><si><t>" + std::string(30'000, 'x') + "</t></si></sst>";
  std::string rows = header_cells;
  for (int i = 0; i < 100'000; ++i) rows += row(cell("0", " t=\"s\"") + cell("0", " t=\"s\""));
  EXPECT_NE(refusal(book_with(rows + three, {{"xl/sharedStrings.xml", shared}})), "");
}

TEST_F(Workbook, OtherArchives) {
  auto const allowed = "; allowed: delimited text, .xlsx, .mat or JSON; try: ";
  EXPECT_EQ(refusal(zip_of(place(), {{"d01.csv", "1;2\n"}})),
            std::string("FILE: is a zip archive") + allowed + "unpack it first");
  EXPECT_EQ(refusal(zip_of(place(), {{"xl/workbook.bin", "1"}})),
            std::string("FILE: is an .xlsb workbook") + allowed + "save it as .xlsx, or the sheet as CSV");
  EXPECT_EQ(refusal(zip_of(place(), {{"mimetype", "a"}, {"content.xml", "1"}})),
            std::string("FILE: is an OpenDocument file") + allowed + "save it as .xlsx, or the sheet as CSV");
  auto damaged = book({{"Test", columns_of({})}});
  damaged.resize(damaged.size() / 2);
  EXPECT_EQ(refusal(damaged),
            "FILE: the archive is damaged; allowed: a workbook as Excel writes it; try: save it again");
  auto flipped = book_with(header_cells + three);
  flipped[flipped.find("sheet1.xml") + 30] ^= 0x55;
  EXPECT_NE(refusal(flipped).find("the archive is damaged"), std::string::npos) << refusal(flipped);
}

}  // namespace
}  // namespace isolaw::data::testing
